"""Bakes into GLB, PLY, USD and texture maps are read back by independent readers."""

import json

import numpy as np
import OpenImageIO as oiio  # noqa: N813
import pytest
import trimesh

import gltf_shapes
import shapes
from gltf_validator import assert_valid
from skinshade._core.errors import ArgumentError, DependencyError, MeshError, UnitError
from skinshade._core.files import atomic_files
from skinshade.baking import BakeSettings, bake, formats
from skinshade.baking.analysis import analyse
from skinshade.baking.maps import texture_maps, write_maps
from skinshade.mesh import Mesh
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


def write_sphere(path):
    """Write a sphere of radius 8 units, with normals and UVs if the format has them."""
    p, n, t, faces = gltf_shapes.sphere(RADIUS_CM)
    if path.suffix == ".stl":
        trimesh.Trimesh(p, faces, process=False).export(path)
    elif path.suffix == ".ply":
        visual = trimesh.visual.TextureVisuals(uv=t * (1.0, -1.0) + (0.0, 1.0))
        mesh = trimesh.Trimesh(p, faces, vertex_normals=n, visual=visual, process=False)
        path.write_bytes(mesh.export(file_type="ply", vertex_normal=True))
    else:
        rows = [f"v {x:.9f} {y:.9f} {z:.9f}" for x, y, z in p]
        rows += [f"vn {x:.9f} {y:.9f} {z:.9f}" for x, y, z in n]
        rows += [f"vt {u:.9f} {1.0 - v:.9f}" for u, v in t]  # v of OBJ counts from below
        rows += ["f " + " ".join(f"{i}/{i}/{i}" for i in face + 1) for face in faces]
        path.write_text("\n".join(rows) + "\n")
    return path


def column(path, name, width):
    """Return an attribute of the first primitive from its bytes."""
    document, buffers = gltf_shapes.read(path)
    accessor = document["accessors"][document["meshes"][0]["primitives"][0]["attributes"][name]]
    data = gltf_shapes.view_bytes(document, buffers)[accessor["bufferView"]]
    return np.frombuffer(data, "<f4").reshape(-1, width)


def sorted_rows(table):
    return table[np.lexsort(np.round(table, 4).T)]


@pytest.mark.parametrize("suffix", [".obj", ".ply", ".stl"])
def test_a_model_in_another_unit_is_baked_to_a_glb_in_metres(tmp_path, suffix):
    source, out = write_sphere(tmp_path / f"in{suffix}"), tmp_path / "out.glb"
    baked = bake(source, out, EVERYTHING)
    assert baked.written == [out]
    assert_valid(out)
    (mesh,) = trimesh.load_scene(out, process=False).geometry.values()
    radius = np.linalg.norm(mesh.vertices, axis=1)
    np.testing.assert_allclose(radius, 0.08, rtol=FLOAT32_FILE.value)
    curvature = np.asarray(mesh.vertex_attributes["_CURVATURE"]).ravel()
    if suffix != ".stl":  # normals that are computed on a mesh this coarse are inexact
        np.testing.assert_allclose(80.0 * curvature, 1.0, rtol=CURVATURE_OF_ROUNDED.value)
        p, _, t, _ = gltf_shapes.sphere(0.08)
        stored = sorted_rows(np.column_stack([mesh.vertices, column(out, "TEXCOORD_0", 2)]))
        expected = sorted_rows(np.column_stack([p, t]))
        np.testing.assert_allclose(stored, expected, atol=10.0 * FLOAT32_FILE.value)
    document, _ = gltf_shapes.read(out)
    note = document["meshes"][0]["extras"]["skinshade"]
    assert note["unit_mm"] == 1000.0
    assert note["profile"] == "skin-deon2007"
    np.testing.assert_array_equal(
        curvature, baked.meshes[0].analysis.attributes["curvature"][:, 0].astype("f4")
    )


@pytest.mark.parametrize("suffix", [".obj", ".ply", ".stl"])
def test_without_a_unit_the_error_asks_for_unit_mm(tmp_path, suffix):
    with pytest.raises(UnitError, match="unit_mm"):
        bake(write_sphere(tmp_path / f"in{suffix}"), tmp_path / "out.glb")
    assert not (tmp_path / "out.glb").exists()


# -- PLY -------------------------------------------------------------------------------------------


def test_a_ply_has_every_vertex_property_in_its_unit(tmp_path):
    baked = bake(write_sphere(tmp_path / "in.obj"), tmp_path / "out.ply", EVERYTHING)
    mesh = trimesh.load(tmp_path / "out.ply", process=False)
    (result,) = baked.meshes
    np.testing.assert_allclose(
        mesh.vertices, result.mesh.positions_mm / 10.0, atol=RADIUS_CM * FLOAT32_FILE.value
    )
    np.testing.assert_array_equal(mesh.faces, result.mesh.faces)
    columns = mesh.metadata["_ply_raw"]["vertex"]["data"]
    expected = result.analysis.attributes
    for name, values in [
        ("curvature", expected["curvature"]),
        ("thickness", expected["thickness"]),
    ]:
        np.testing.assert_array_equal(columns[name].ravel(), values[:, 0].astype("f4"))
    for index, name in enumerate(TENSOR):
        np.testing.assert_array_equal(
            columns[name].ravel(), expected["tensor"][:, index].astype("f4")
        )
    uvs = np.column_stack([columns["s"].ravel(), columns["t"].ravel()])
    np.testing.assert_allclose(uvs, result.mesh.uvs * (1, -1) + (0, 1), atol=FLOAT32_FILE.value)
    assert b"one unit is 10.0 mm" in (tmp_path / "out.ply").read_bytes()[:200]


def test_a_baked_ply_can_be_baked_again(tmp_path):
    bake(write_sphere(tmp_path / "in.obj"), tmp_path / "once.ply", EVERYTHING)
    again = bake(tmp_path / "once.ply", tmp_path / "twice.ply", EVERYTHING)
    curvature = 80.0 * again.meshes[0].analysis.attributes["curvature"]
    np.testing.assert_allclose(curvature, 1.0, rtol=CURVATURE_OF_ROUNDED.value)


# -- glTF scenes as one mesh -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "radii_mm"),
    [
        ("plain", [80.0]),
        ("skinned", [80.0]),
        ("quantised", [80.0]),
        ("instances", [80.0, 160.0, 10.0]),
        ("several_primitives", [80.0, 20.0]),
    ],
)
def test_a_gltf_scene_is_baked_to_one_placed_mesh(tmp_path, name, radii_mm):
    source = gltf_shapes.write(gltf_shapes.SHAPES[name](), tmp_path)
    mesh = bake(source, tmp_path / "out.ply").meshes[0].mesh
    parts = trimesh.Trimesh(mesh.positions_mm, mesh.faces).split(only_watertight=True)
    assert len(parts) == len(radii_mm)
    extents = sorted(float(part.extents.max()) / 2.0 for part in parts)
    np.testing.assert_allclose(extents, sorted(radii_mm), rtol=COARSE_EXTENT.value)
    assert all(part.volume > 0.0 for part in parts)  # the winding of a mirror image is reversed
    corners = mesh.positions_mm[mesh.faces]
    outward = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (np.einsum("fi,fki->fk", outward, mesh.normals[mesh.faces]) > 0.0).all()
    np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1.0, rtol=ROUNDING_SUMS.value)


# -- USD -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("suffix", [".usda", ".usdc"])
def test_usd_has_the_attributes_as_primvars_in_millimetres(tmp_path, suffix):
    pxr = pytest.importorskip("pxr", reason="usd-core is not installed")
    assert pxr
    from pxr import Usd, UsdGeom

    baked = bake(write_sphere(tmp_path / "in.obj"), tmp_path / f"out{suffix}", EVERYTHING)
    (result,) = baked.meshes
    stage = Usd.Stage.Open(str(tmp_path / f"out{suffix}"))
    assert UsdGeom.GetStageMetersPerUnit(stage) == 0.001
    assert UsdGeom.GetStageUpAxis(stage) == "Y"
    mesh = UsdGeom.Mesh(stage.GetDefaultPrim())
    points = np.array(mesh.GetPointsAttr().Get())
    np.testing.assert_array_equal(points, result.mesh.positions_mm.astype("f4"))
    corners = np.array(mesh.GetFaceVertexIndicesAttr().Get()).reshape(-1, 3)
    np.testing.assert_array_equal(corners, result.mesh.faces)
    assert set(mesh.GetFaceVertexCountsAttr().Get()) == {3}
    assert mesh.GetSubdivisionSchemeAttr().Get() == "none"
    primvars = UsdGeom.PrimvarsAPI(mesh)
    columns = {"curvature": result.analysis.attributes["curvature"][:, 0]}
    columns |= {"thickness": result.analysis.attributes["thickness"][:, 0]}
    columns |= dict(zip(TENSOR, result.analysis.attributes["tensor"].T, strict=True))
    for name, values in columns.items():
        primvar = primvars.GetPrimvar(name)
        assert primvar.GetInterpolation() == "vertex"
        np.testing.assert_array_equal(np.array(primvar.Get()), values.astype("f4"))
    uvs = np.array(primvars.GetPrimvar("st").Get())
    np.testing.assert_allclose(uvs, result.mesh.uvs * (1, -1) + (0, 1), atol=FLOAT32_FILE.value)


def test_without_usd_the_error_states_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setattr(formats, "find_spec", lambda name: None)
    with pytest.raises(DependencyError, match=r"skinshade\[usd\]"):
        bake(write_sphere(tmp_path / "in.obj"), tmp_path / "out.usdc", EVERYTHING)


@pytest.mark.parametrize("name", ["out.obj", "out.gltf", "out", "out.stl"])
def test_an_unknown_suffix_is_refused_with_the_choices(tmp_path, name):
    source = write_sphere(tmp_path / "in.obj")
    with pytest.raises(ArgumentError, match=r"\.glb, \.ply, \.usda or \.usdc"):
        bake(source, tmp_path / name, EVERYTHING)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["in.obj"]


# -- maps ------------------------------------------------------------------------------------------


def read_map(path):
    """Return the pixels of a map and its description."""
    image = oiio.ImageBuf(str(path))
    description = json.loads(image.spec().get_string_attribute("ImageDescription") or "{}")
    return np.asarray(image.get_pixels(oiio.FLOAT)), description


@pytest.mark.parametrize("size", [4, 64])
def test_the_curvature_map_of_a_sphere_is_constant(tmp_path, size):
    source = gltf_shapes.write(gltf_shapes.plain(), tmp_path)
    settings = BakeSettings(thickness=True, rays=64, map_size=size, tracing="builtin")
    baked = bake(source, tmp_path / "out.glb", settings)
    names = [f"out.{name}.exr" for name in ("uv_density", "curvature", "thickness")]
    assert [path.name for path in baked.written] == [*names, "out.glb"]
    curvature, description = read_map(tmp_path / "out.curvature.exr")
    assert curvature.shape == (size, size, 3)
    assert (curvature[..., 0] == curvature[..., 2]).all()
    np.testing.assert_allclose(80.0 * curvature, 1.0, rtol=CURVATURE_OF_ROUNDED.value)
    values = baked.meshes[0].analysis.attributes["thickness"]
    thickness, _ = read_map(tmp_path / "out.thickness.exr")
    assert thickness.min() >= values.min() * (1.0 - FLOAT32_FILE.value)
    assert thickness.max() <= values.max() * (1.0 + FLOAT32_FILE.value)
    assert description == {"kind": "curvature", "unit": "1/mm"}


def unwrapped_square(corner, side):
    """Return a square of 50 mm whose UVs are a square at a corner with a side."""
    flat = shapes.square(50.0, 4)
    uvs = np.array(corner) + side * flat.positions[:, :2] / 50.0
    return Mesh.checked(flat.positions, flat.faces, unit_mm=1.0, normals=flat.normals, uvs=uvs)


def analysed(mesh, curvature=None):
    """Return the analysis of a mesh, with its curvature (V,) replaced if one is given."""
    analysis = analyse(mesh, BakeSettings(), "square")
    if curvature is not None:
        analysis.attributes["curvature"][:, 0] = curvature
    return analysis


def test_a_linear_function_of_uv_has_its_values_at_the_texel_centres():
    mesh = unwrapped_square((0.0, 0.0), 1.0)
    ramp = mesh.uvs @ (3.0, 5.0)
    curvature = texture_maps(mesh, analysed(mesh, ramp), 16)["curvature"]
    centre = (np.arange(16) + 0.5) / 16.0
    truth = 3.0 * centre[None, :] + 5.0 * centre[:, None]  # v counts down, as rows do
    np.testing.assert_allclose(curvature, truth, atol=MAP_INTERPOLATED.value)


def test_texels_without_a_face_take_the_nearest_value():
    mesh = unwrapped_square((0.25, 0.25), 0.25)
    maps = texture_maps(mesh, analysed(mesh, 1.0 + mesh.uvs[:, 0]), 32)
    assert (maps["curvature"] >= 1.25).all()
    assert (maps["curvature"] <= 1.5).all()
    inside = maps["curvature"][8:16, 8:16]
    np.testing.assert_array_equal(maps["curvature"][8:16, 20], inside[:, -1])
    np.testing.assert_array_equal(maps["curvature"][2, 8:16], inside[0])
    # 50 mm over a quarter of the map
    np.testing.assert_allclose(maps["uv_density"], 200.0, rtol=UV_DENSITY.value)


@pytest.mark.parametrize("tile", [(3.0, 0.0), (-2.0, 5.0)])
def test_faces_in_other_tiles_are_moved_to_the_first_tile(tile):
    moved, first = (
        texture_maps(mesh, analysed(mesh), 8)["uv_density"]
        for mesh in (unwrapped_square(tile, 1.0), unwrapped_square((0.0, 0.0), 1.0))
    )
    np.testing.assert_allclose(moved, first, rtol=UV_DENSITY.value)


def written_maps(maps, base):
    with atomic_files() as files:
        write_maps(files, maps, base, ".png")
    return files.written


def test_the_values_of_a_png_map_follow_from_its_range(tmp_path):
    values = np.linspace(-0.3, 0.7, 64).reshape(8, 8)
    (path,) = written_maps({"curvature": values}, tmp_path / "head.v2")
    assert path.name == "head.v2.curvature.png"
    pixels, description = read_map(path)
    assert description["kind"] == "curvature"
    assert description["unit"] == "1/mm"
    low, span = description["value_low"], description["value_span"]
    assert (low, span) == pytest.approx((-0.3, 1.0))
    np.testing.assert_allclose(
        low + span * pixels[..., 0], values, atol=1.01 * PNG_HALF_STEP.value / 65535.0
    )
    (path,) = written_maps({"thickness": np.full((4, 4), 7.5)}, tmp_path / "head")
    pixels, description = read_map(path)
    assert path.name == "head.thickness.png"
    assert description["value_low"] == 7.5
    assert (pixels == 0.0).all()


def test_each_of_several_meshes_has_its_own_maps(tmp_path):
    source = gltf_shapes.write(gltf_shapes.several_primitives(), tmp_path)
    baked = bake(source, tmp_path / "out.glb", BakeSettings(map_size=8, map_format="png"))
    names = [path.name for path in baked.written]
    assert names[:-1] == [
        f"out.{name}.{i}.png" for i in (0, 1) for name in ("uv_density", "curvature")
    ]


def test_maps_of_a_mesh_without_usable_uvs_are_refused(tmp_path):
    source = gltf_shapes.write(gltf_shapes.positions_only(), tmp_path)
    with pytest.raises(MeshError, match=r"head\.glb: mesh 0: maps: the mesh has no UVs"):
        bake(source, tmp_path / "out.glb", BakeSettings(map_size=8))
    assert not (tmp_path / "out.glb").exists()
    mesh = unwrapped_square((0.5, 0.5), 0.0)
    with pytest.raises(MeshError, match="unwrap"):
        texture_maps(mesh, analysed(mesh), 8)
