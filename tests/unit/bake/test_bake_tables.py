"""OBJ, PLY, STL and glTF into GLB, PLY, USD and texture maps: read again by the formats' own readers."""

import json

import numpy as np
import OpenImageIO as oiio  # noqa: N813
import pytest
import trimesh

import gltf_shapes
import shapes
from gltf_validator import assert_valid
from skinshade._core.errors import ArgumentError, DependencyError, MeshError, UnitError
from skinshade.bake import BakeSettings, bake, tables
from skinshade.bake.analysis import Body, analyse
from skinshade.bake.maps import texture_maps, write_maps
from tolerances import (
    COARSE_EXTENT,
    CURVATURE_OF_ROUNDED,
    FLOAT32_FILE,
    MAP_INTERPOLATED,
    PNG_HALF_STEP,
    ROUNDING_SUMS,
    UV_DENSITY,
)

RADIUS_CM = 8.0
EVERYTHING = BakeSettings(unit_mm=10.0, tensor=True, thickness=True, rays=4, tracing="builtin")
TENSOR = ["tensor_xx", "tensor_xy", "tensor_xz", "tensor_yy", "tensor_yz", "tensor_zz"]


def write_ball(path):
    """A ball of 8 units, with normals and UVs where the format has them."""
    p, n, t, faces = gltf_shapes.ball(RADIUS_CM)
    if path.suffix == ".stl":
        trimesh.Trimesh(p, faces, process=False).export(path)
    elif path.suffix == ".ply":
        visual = trimesh.visual.TextureVisuals(uv=t * (1.0, -1.0) + (0.0, 1.0))
        ball = trimesh.Trimesh(p, faces, vertex_normals=n, visual=visual, process=False)
        path.write_bytes(ball.export(file_type="ply", vertex_normal=True))
    else:
        rows = [f"v {x:.9f} {y:.9f} {z:.9f}" for x, y, z in p]
        rows += [f"vn {x:.9f} {y:.9f} {z:.9f}" for x, y, z in n]
        rows += [f"vt {u:.9f} {1.0 - v:.9f}" for u, v in t]  # OBJ counts v from below
        rows += ["f " + " ".join(f"{i}/{i}/{i}" for i in face + 1) for face in faces]
        path.write_text("\n".join(rows) + "\n")
    return path


def column(path, name, width):
    """An attribute of the first primitive, as its bytes say."""
    document, buffers = gltf_shapes.read(path)
    accessor = document["accessors"][document["meshes"][0]["primitives"][0]["attributes"][name]]
    data = gltf_shapes.view_bytes(document, buffers)[accessor["bufferView"]]
    return np.frombuffer(data, "<f4").reshape(-1, width)


def sorted_rows(table):
    return table[np.lexsort(np.round(table, 4).T)]


@pytest.mark.parametrize("suffix", [".obj", ".ply", ".stl"])
def test_a_model_without_a_unit_becomes_a_glb_in_metres(tmp_path, suffix):
    source, out = write_ball(tmp_path / f"in{suffix}"), tmp_path / "out.glb"
    baked = bake(source, out, EVERYTHING)
    assert baked.written == [out]
    assert_valid(out)
    (mesh,) = trimesh.load_scene(out, process=False).geometry.values()
    radius = np.linalg.norm(mesh.vertices, axis=1)
    np.testing.assert_allclose(radius, 0.08, rtol=FLOAT32_FILE.value)
    curvature = np.asarray(mesh.vertex_attributes["_CURVATURE"]).ravel()
    if suffix != ".stl":  # computed normals of an STL are exact on no mesh as coarse as this
        np.testing.assert_allclose(80.0 * curvature, 1.0, rtol=CURVATURE_OF_ROUNDED.value)
        truth = gltf_shapes.ball(0.08)
        read, known = (
            np.column_stack([p, t])
            for p, t in ((mesh.vertices, column(out, "TEXCOORD_0", 2)), (truth[0], truth[2]))
        )
        np.testing.assert_allclose(
            sorted_rows(read), sorted_rows(known), atol=10.0 * FLOAT32_FILE.value
        )
    document, _ = gltf_shapes.read(out)
    told = document["meshes"][0]["extras"]["skinshade"]
    assert told["unit_mm"] == 1000.0
    assert told["profile"] == "skin-deon2007"
    np.testing.assert_array_equal(
        curvature, baked.meshes[0].analysed.attributes["curvature"][:, 0].astype("f4")
    )


@pytest.mark.parametrize("suffix", [".obj", ".ply", ".stl"])
def test_a_unit_that_is_unknown_is_asked_for(tmp_path, suffix):
    with pytest.raises(UnitError, match="unit_mm"):
        bake(write_ball(tmp_path / f"in{suffix}"), tmp_path / "out.glb")
    assert not (tmp_path / "out.glb").exists()


# -- PLY -------------------------------------------------------------------------------------------


def test_a_ply_holds_every_property_in_the_files_unit(tmp_path):
    baked = bake(write_ball(tmp_path / "in.obj"), tmp_path / "out.ply", EVERYTHING)
    mesh = trimesh.load(tmp_path / "out.ply", process=False)
    (told,) = baked.meshes
    np.testing.assert_allclose(
        mesh.vertices, told.body.positions_mm / 10.0, atol=RADIUS_CM * FLOAT32_FILE.value
    )
    np.testing.assert_array_equal(mesh.faces, told.body.faces)
    columns = mesh.metadata["_ply_raw"]["vertex"]["data"]
    expected = told.analysed.attributes
    for name, values in [
        ("curvature", expected["curvature"]),
        ("thickness", expected["thickness"]),
    ]:
        np.testing.assert_array_equal(columns[name].ravel(), values[:, 0].astype("f4"))
    for index, name in enumerate(TENSOR):
        np.testing.assert_array_equal(
            columns[name].ravel(), expected["tensor"][:, index].astype("f4")
        )
    upward = np.column_stack([columns["s"].ravel(), columns["t"].ravel()])
    np.testing.assert_allclose(upward, told.body.uvs * (1, -1) + (0, 1), atol=FLOAT32_FILE.value)
    assert b"one unit is 10.0 mm" in (tmp_path / "out.ply").read_bytes()[:200]


def test_a_ply_that_was_baked_is_baked_again(tmp_path):
    bake(write_ball(tmp_path / "in.obj"), tmp_path / "once.ply", EVERYTHING)
    again = bake(tmp_path / "once.ply", tmp_path / "twice.ply", EVERYTHING)
    curvature = 80.0 * again.meshes[0].analysed.attributes["curvature"]
    np.testing.assert_allclose(curvature, 1.0, rtol=CURVATURE_OF_ROUNDED.value)


# -- glTF scenes as one mesh -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "radii_mm"),
    [
        ("plain", [80.0]),
        ("skinned", [80.0]),
        ("quantised", [80.0]),
        ("instances", [80.0, 160.0, 10.0]),
        ("several", [80.0, 20.0]),
    ],
)
def test_a_gltf_scene_is_placed_as_it_is_shown(tmp_path, name, radii_mm):
    source = gltf_shapes.write(gltf_shapes.SHAPES[name](), tmp_path)
    baked = bake(source, tmp_path / "out.ply")
    body = baked.meshes[0].body
    bodies = trimesh.Trimesh(body.positions_mm, body.faces).split(only_watertight=True)
    assert len(bodies) == len(radii_mm)
    extents = sorted(float(each.extents.max()) / 2.0 for each in bodies)
    np.testing.assert_allclose(extents, sorted(radii_mm), rtol=COARSE_EXTENT.value)
    assert all(each.volume > 0.0 for each in bodies)  # a mirror image is wound outwards too
    corners = body.positions_mm[body.faces]
    outward = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (np.einsum("fi,fki->fk", outward, body.normals[body.faces]) > 0.0).all()
    np.testing.assert_allclose(np.linalg.norm(body.normals, axis=1), 1.0, rtol=ROUNDING_SUMS.value)


# -- USD -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("suffix", [".usda", ".usdc"])
def test_usd_holds_primvars_in_millimetres(tmp_path, suffix):
    pxr = pytest.importorskip("pxr", reason="usd-core is not installed")
    assert pxr
    from pxr import Usd, UsdGeom

    baked = bake(write_ball(tmp_path / "in.obj"), tmp_path / f"out{suffix}", EVERYTHING)
    (told,) = baked.meshes
    stage = Usd.Stage.Open(str(tmp_path / f"out{suffix}"))
    assert UsdGeom.GetStageMetersPerUnit(stage) == 0.001
    assert UsdGeom.GetStageUpAxis(stage) == "Y"
    mesh = UsdGeom.Mesh(stage.GetDefaultPrim())
    points = np.array(mesh.GetPointsAttr().Get())
    np.testing.assert_array_equal(points, told.body.positions_mm.astype("f4"))
    corners = np.array(mesh.GetFaceVertexIndicesAttr().Get()).reshape(-1, 3)
    np.testing.assert_array_equal(corners, told.body.faces)
    assert set(mesh.GetFaceVertexCountsAttr().Get()) == {3}
    assert mesh.GetSubdivisionSchemeAttr().Get() == "none"
    primvars = UsdGeom.PrimvarsAPI(mesh)
    columns = {"curvature": told.analysed.attributes["curvature"][:, 0]}
    columns |= {"thickness": told.analysed.attributes["thickness"][:, 0]}
    columns |= dict(zip(TENSOR, told.analysed.attributes["tensor"].T, strict=True))
    for name, values in columns.items():
        primvar = primvars.GetPrimvar(name)
        assert primvar.GetInterpolation() == "vertex"
        np.testing.assert_array_equal(np.array(primvar.Get()), values.astype("f4"))
    upward = np.array(primvars.GetPrimvar("st").Get())
    np.testing.assert_allclose(upward, told.body.uvs * (1, -1) + (0, 1), atol=FLOAT32_FILE.value)


def test_usd_that_is_not_installed_is_named(tmp_path, monkeypatch):
    monkeypatch.setattr(tables, "find_spec", lambda name: None)
    with pytest.raises(DependencyError, match=r"skinshade\[usd\]"):
        bake(write_ball(tmp_path / "in.obj"), tmp_path / "out.usdc", EVERYTHING)


@pytest.mark.parametrize("name", ["out.obj", "out.gltf", "out", "out.stl"])
def test_a_suffix_that_is_not_written_is_refused_with_the_choices(tmp_path, name):
    source = write_ball(tmp_path / "in.obj")
    with pytest.raises(ArgumentError, match=r"\.glb, \.ply, \.usda or \.usdc"):
        bake(source, tmp_path / name, EVERYTHING)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["in.obj"]


# -- maps ------------------------------------------------------------------------------------------


def pixels(path):
    image = oiio.ImageBuf(str(path))
    told = json.loads(image.spec().get_string_attribute("ImageDescription") or "{}")
    return np.asarray(image.get_pixels(oiio.FLOAT)), told


@pytest.mark.parametrize("size", [4, 64])
def test_curvature_of_a_sphere_is_one_value_over_the_whole_map(tmp_path, size):
    source = gltf_shapes.write(gltf_shapes.plain(), tmp_path)
    settings = BakeSettings(thickness=True, rays=64, map_size=size, tracing="builtin")
    baked = bake(source, tmp_path / "out.glb", settings)
    names = [f"out.{name}.exr" for name in ("uv_density", "curvature", "thickness")]
    assert [path.name for path in baked.written] == [*names, "out.glb"]
    curvature, told = pixels(tmp_path / "out.curvature.exr")
    assert curvature.shape == (size, size, 3)
    assert (curvature[..., 0] == curvature[..., 2]).all()
    np.testing.assert_allclose(80.0 * curvature, 1.0, rtol=CURVATURE_OF_ROUNDED.value)
    values = baked.meshes[0].analysed.attributes["thickness"]
    thickness, _ = pixels(tmp_path / "out.thickness.exr")
    assert thickness.min() >= values.min() * (1.0 - FLOAT32_FILE.value)
    assert thickness.max() <= values.max() * (1.0 + FLOAT32_FILE.value)
    assert told == {"kind": "curvature", "unit": "1/mm"}


def flat_body(corner, side):
    """A square of 50 mm whose UVs fill a part of the map."""
    flat = shapes.square(50.0, 4)
    return Body(
        flat.positions, flat.faces, flat.normals, corner + side * flat.positions[:, :2] / 50
    )


def test_a_ramp_over_the_uvs_lies_where_the_uvs_say():
    body = flat_body(np.array([0.0, 0.0]), 1.0)
    analysed = analyse(body, BakeSettings(), "flat")
    ramp = body.uvs @ (3.0, 5.0)
    analysed.attributes["curvature"][:, 0] = ramp
    found = texture_maps(body, analysed, 16)["curvature"]
    centre = (np.arange(16) + 0.5) / 16.0
    truth = 3.0 * centre[None, :] + 5.0 * centre[:, None]  # v counts down, as rows do
    np.testing.assert_allclose(found, truth, atol=MAP_INTERPOLATED.value)


def test_texels_outside_take_the_nearest_value_and_none_stays_empty():
    body = flat_body(np.array([0.25, 0.25]), 0.25)
    analysed = analyse(body, BakeSettings(), "flat")
    analysed.attributes["curvature"][:, 0] = 1.0 + body.uvs[:, 0]
    found = texture_maps(body, analysed, 32)
    assert (found["curvature"] >= 1.25).all()
    assert (found["curvature"] <= 1.5).all()
    inside = found["curvature"][8:16, 8:16]
    np.testing.assert_array_equal(found["curvature"][8:16, 20], inside[:, -1])
    np.testing.assert_array_equal(found["curvature"][2, 8:16], inside[0])
    # 50 mm over a quarter of the map
    np.testing.assert_allclose(found["uv_density"], 200.0, rtol=UV_DENSITY.value)


@pytest.mark.parametrize("tile", [(3.0, 0.0), (-2.0, 5.0)])
def test_faces_in_other_tiles_are_moved_to_the_first(tile):
    there, here = (flat_body(np.array(corner), 1.0) for corner in (tile, (0.0, 0.0)))
    found, known = (
        texture_maps(each, analyse(each, BakeSettings(), "flat"), 8)["uv_density"]
        for each in (there, here)
    )
    np.testing.assert_allclose(found, known, rtol=UV_DENSITY.value)


def test_a_png_gives_its_range_back(tmp_path):
    values = np.linspace(-0.3, 0.7, 64).reshape(8, 8)
    (path,) = write_maps({"curvature": values}, tmp_path / "head.x", ".png")
    assert path.name == "head.curvature.png"
    found, told = pixels(path)
    assert told["kind"] == "curvature"
    assert told["unit"] == "1/mm"
    assert (told["value_low"], told["value_span"]) == pytest.approx((-0.3, 1.0))
    back = told["value_low"] + told["value_span"] * found[..., 0]
    np.testing.assert_allclose(back, values, atol=1.01 * PNG_HALF_STEP.value / 65535.0)
    (path,) = write_maps({"thickness": np.full((4, 4), 7.5)}, tmp_path / "head.x", ".png")
    found, told = pixels(path)
    assert told["value_low"] == 7.5
    assert (found == 0.0).all()


def test_several_meshes_have_maps_of_their_own(tmp_path):
    source = gltf_shapes.write(gltf_shapes.several(), tmp_path)
    baked = bake(source, tmp_path / "out.glb", BakeSettings(map_size=8, map_format="png"))
    names = [path.name for path in baked.written]
    assert names[:-1] == [
        f"out-{i}.{name}.png" for i in (0, 1) for name in ("uv_density", "curvature")
    ]


def test_maps_of_what_is_not_unwrapped_are_refused(tmp_path):
    source = gltf_shapes.write(gltf_shapes.bare(), tmp_path)
    with pytest.raises(MeshError, match=r"head\.glb: mesh 0: maps: the mesh has no UVs"):
        bake(source, tmp_path / "out.glb", BakeSettings(map_size=8))
    body = flat_body(np.array([0.5, 0.5]), 0.0)
    with pytest.raises(MeshError, match="unwrap"):
        texture_maps(body, analyse(body, BakeSettings(), "flat"), 8)
    assert not (tmp_path / "out.glb").exists()
