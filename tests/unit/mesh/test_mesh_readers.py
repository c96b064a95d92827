"""Mesh files of every format, written by other programs."""

import numpy as np
import pygltflib
import pytest
import trimesh

import shapes
import tolerances as tol
from skinshade._core.errors import UnitError
from skinshade.mesh import load_mesh, mesh_curvature

BALL = shapes.ellipsoid("icosphere", 2, (0.15, 0.1, 0.12))
UVS = np.random.default_rng(3).random((len(BALL.positions), 2))
SUFFIXES = [".glb", ".gltf", ".obj", ".ply", ".stl"]
WITH_UVS = [".glb", ".gltf", ".obj", ".ply"]
UNITLESS = [".obj", ".ply", ".stl"]


def exported(folder, suffix, *, uvs=UVS, scale=1.0):
    """Write the ball. In trimesh v goes up; it writes every format in that format's convention."""
    visual = None if uvs is None else trimesh.visual.TextureVisuals(uv=uvs)
    mesh = trimesh.Trimesh(
        BALL.positions * scale,
        BALL.faces,
        vertex_normals=BALL.normals,
        visual=visual,
        process=False,
    )
    file = folder / f"ball{suffix}"
    if suffix == ".gltf":
        for name, content in trimesh.exchange.gltf.export_gltf(trimesh.Scene(mesh)).items():
            (folder / ("ball.gltf" if name.endswith(".gltf") else name)).write_bytes(content)
    else:
        options = {"include_normals": True} if suffix in (".glb", ".obj") else {}
        mesh.export(file, **options)
    return file


def original_vertices(mesh):
    """Return the indices of the exported vertices at the positions of the read ones."""
    gap = np.linalg.norm(mesh.positions[:, None] - BALL.positions[None], axis=-1)
    assert gap.min(axis=1).max() <= tol.FLOAT32_FILE.value
    return gap.argmin(axis=1)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_positions_and_triangles_are_those_of_the_file(tmp_path, suffix):
    mesh = load_mesh(exported(tmp_path, suffix), unit_mm=1000.0)
    original = original_vertices(mesh)
    read = {tuple(np.roll(f, -np.argmin(f))) for f in original[mesh.faces]}
    assert read == {tuple(np.roll(f, -np.argmin(f))) for f in BALL.faces}
    assert mesh.unit_mm == 1000.0


@pytest.mark.parametrize("suffix", [".glb", ".obj", ".ply"])
def test_normals_are_those_of_the_file(tmp_path, suffix):
    mesh = load_mesh(exported(tmp_path, suffix), unit_mm=1000.0)
    assert "normals computed" not in mesh.repairs
    error = mesh.normals - BALL.normals[original_vertices(mesh)]
    assert np.abs(error).max() <= tol.FLOAT32_FILE.value


@pytest.mark.parametrize("suffix", WITH_UVS)
def test_uvs_have_v_down(tmp_path, suffix):
    mesh = load_mesh(exported(tmp_path, suffix), unit_mm=1000.0)
    expected = UVS[original_vertices(mesh)] * (1.0, -1.0) + (0.0, 1.0)
    assert np.abs(mesh.uvs - expected).max() <= tol.FLOAT32_FILE.value


def test_uvs_of_a_glb_are_the_stored_numbers(tmp_path):
    file = exported(tmp_path, ".glb")
    gltf = pygltflib.GLTF2().load(str(file))
    accessor = gltf.accessors[gltf.meshes[0].primitives[0].attributes.TEXCOORD_0]
    view = gltf.bufferViews[accessor.bufferView]
    start = (view.byteOffset or 0) + (accessor.byteOffset or 0)
    raw = np.frombuffer(gltf.binary_blob(), np.float32, 2 * accessor.count, start).reshape(-1, 2)
    assert np.abs(load_mesh(file, unit_mm=1000.0).uvs - raw).max() <= tol.FLOAT32_FILE.value


@pytest.mark.parametrize("suffix", [".glb", ".obj"])
def test_a_file_without_uvs_gives_a_mesh_without_uvs(tmp_path, suffix):
    assert load_mesh(exported(tmp_path, suffix, uvs=None), unit_mm=1000.0).uvs is None


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_every_format_gives_the_same_curvature(tmp_path, suffix):
    mesh = load_mesh(exported(tmp_path, suffix), unit_mm=1000.0)
    own = mesh_curvature(mesh.positions, mesh.faces)
    expected = mesh_curvature(BALL.positions, BALL.faces)[original_vertices(mesh)]
    assert np.abs(own - expected).max() <= tol.CURVATURE_OF_ROUNDED.value * np.abs(expected).max()


OBJ_WITH_SEAM = """\
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 2 0 0
v 2 1 0
vt 0.0 0.0
vt 0.5 0.0
vt 0.5 1.0
vt 0.0 1.0
vt 0.6 0.0
vt 1.0 0.0
vt 1.0 1.0
vt 0.6 1.0
vn 0 0 1
f 1/1/1 2/2/1 3/3/1 4/4/1
f 2/5/1 5/6/1 6/7/1 3/8/1
"""


def test_an_obj_with_a_uv_seam_keeps_uvs_and_normals(tmp_path):
    file = tmp_path / "seam.obj"
    file.write_text(OBJ_WITH_SEAM)
    mesh = load_mesh(file, unit_mm=10.0)
    assert mesh.uvs is not None
    assert "normals computed" not in mesh.repairs
    assert np.allclose(mesh.normals, (0.0, 0.0, 1.0))
    left = mesh.positions[mesh.faces].mean(axis=1)[:, 0] < 1.0
    for face, is_left in zip(mesh.faces, left, strict=True):
        x, y = mesh.positions[face, 0], mesh.positions[face, 1]
        u = 0.5 * x if is_left else 0.6 + 0.4 * (x - 1.0)
        assert np.allclose(mesh.uvs[face], np.stack([u, 1.0 - y], axis=1), atol=1e-6)


def test_a_face_of_four_corners_becomes_two_triangles(tmp_path):
    file = tmp_path / "quad.obj"
    file.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
    mesh = load_mesh(file, unit_mm=10.0)
    assert len(mesh.faces) == 2
    assert np.allclose(mesh.normals, (0.0, 0.0, 1.0))
    assert mesh.repairs["open edges"] == 4


# -- scenes ----------------------------------------------------------------------------------------


def scene_of_two(folder, *, transform, other_uvs=UVS, attributes=(None, None)):
    parts = []
    for uvs, attribute in zip((UVS, other_uvs), attributes, strict=True):
        visual = None if uvs is None else trimesh.visual.TextureVisuals(uv=uvs)
        part = trimesh.Trimesh(
            BALL.positions, BALL.faces, vertex_normals=BALL.normals, visual=visual, process=False
        )
        if attribute is not None:
            part.vertex_attributes["_mask"] = attribute.astype(np.float32)
        parts.append(part)
    scene = trimesh.Scene()
    scene.add_geometry(parts[0])
    scene.add_geometry(parts[1], transform=transform)
    file = folder / "two.glb"
    file.write_bytes(trimesh.exchange.gltf.export_glb(scene, include_normals=True))
    return file


def translation(x, y, z):
    matrix = np.eye(4)
    matrix[:3, 3] = x, y, z
    return matrix


def test_all_parts_are_joined_in_the_axes_of_the_scene(tmp_path):
    file = scene_of_two(tmp_path, transform=translation(1.0, 2.0, 3.0))
    mesh = load_mesh(file, unit_mm=1000.0)
    n = len(BALL.positions)
    assert mesh.positions.shape == (2 * n, 3)
    assert mesh.faces.shape == (2 * len(BALL.faces), 3)
    extent = np.stack([mesh.positions.min(axis=0), mesh.positions.max(axis=0)])
    half = np.array([0.15, 0.1, 0.12])
    assert np.allclose(extent, [-half, half + np.array([1.0, 2.0, 3.0])], atol=0.02)
    assert mesh.uvs is not None
    assert mesh.repairs == {}


def test_uvs_that_one_part_lacks_are_zero_and_those_of_the_other_are_kept(tmp_path):
    moved = translation(1.0, 0.0, 0.0)
    uvs = load_mesh(scene_of_two(tmp_path, transform=moved, other_uvs=None), unit_mm=1000.0).uvs
    complete = load_mesh(scene_of_two(tmp_path, transform=moved), unit_mm=1000.0).uvs
    zero = ~uvs.any(axis=1)
    assert zero.sum() == len(BALL.positions)
    np.testing.assert_array_equal(uvs[~zero], complete[~zero])


def test_attributes_whose_shapes_differ_between_parts_are_left_out(tmp_path):
    n = len(BALL.positions)
    file = scene_of_two(
        tmp_path,
        transform=translation(1.0, 0.0, 0.0),
        attributes=(np.ones(n), np.ones((n, 3))),
    )
    mesh = load_mesh(file, unit_mm=1000.0)
    assert len(mesh.positions) == 2 * n
    assert "_mask" not in mesh.attributes


@pytest.mark.parametrize(
    "linear",
    [
        np.diag([-1.0, 1.0, 1.0]),
        np.diag([1.0, 3.0, 0.5]),
        np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]]),
    ],
    ids=["mirrored", "stretched", "turned"],
)
def test_normals_and_winding_follow_the_transform(tmp_path, linear):
    matrix = np.eye(4)
    matrix[:3, :3] = linear
    scene = trimesh.Scene()
    ball = trimesh.Trimesh(BALL.positions, BALL.faces, vertex_normals=BALL.normals, process=False)
    scene.add_geometry(ball, transform=matrix)
    file = tmp_path / "placed.glb"
    file.write_bytes(trimesh.exchange.gltf.export_glb(scene, include_normals=True))
    mesh = load_mesh(file, unit_mm=1000.0)
    truth = BALL.normals @ np.linalg.inv(linear)
    truth /= np.linalg.norm(truth, axis=1)[:, None]
    assert "normals computed" not in mesh.repairs
    placed = BALL.positions @ linear.T
    assert np.abs(mesh.positions - placed).max() <= tol.FLOAT32_FILE.value
    assert np.abs(mesh.normals - truth).max() <= 2.0 * tol.FLOAT32_FILE.value
    corners = mesh.positions[mesh.faces]
    outward = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (np.einsum("ij,ij->i", outward, corners.mean(axis=1)) > 0.0).all()


# -- units -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("suffix", UNITLESS)
def test_a_format_without_a_unit_needs_unit_mm(tmp_path, suffix):
    file = exported(tmp_path, suffix)
    with pytest.raises(UnitError, match="give unit_mm") as caught:
        load_mesh(file)
    assert str(file) in str(caught.value)


@pytest.mark.parametrize("suffix", [".glb", ".gltf"])
def test_gltf_is_in_metres(tmp_path, suffix):
    mesh = load_mesh(exported(tmp_path, suffix))
    assert mesh.unit_mm == 1000.0
    assert np.ptp(mesh.positions_mm, axis=0) == pytest.approx([300.0, 200.0, 240.0], rel=0.05)


@pytest.mark.parametrize("unit_mm", [0.0, -10.0, np.nan, np.inf, "cm"])
@pytest.mark.parametrize("suffix", [".glb", ".obj"])
def test_an_invalid_unit_is_refused(tmp_path, suffix, unit_mm):
    file = exported(tmp_path, suffix)
    with pytest.raises(UnitError) as caught:
        load_mesh(file, unit_mm=unit_mm)
    assert str(file) in str(caught.value)
