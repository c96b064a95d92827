"""Files that are no mesh or a broken one raise errors of skinshade that name the file."""

import warnings

import numpy as np
import pytest
import trimesh
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import shapes
from skinshade._core.errors import (
    ArgumentError,
    InputError,
    MeshError,
    MeshFileError,
    SkinshadeError,
    UnitWarning,
)
from skinshade.mesh import load_mesh

SUFFIXES = [".glb", ".gltf", ".obj", ".ply", ".stl"]
EVERY_SUFFIX = pytest.mark.parametrize("suffix", SUFFIXES)
SAME_FOLDER = settings(suppress_health_check=[HealthCheck.function_scoped_fixture])


def small_ball(suffix):
    ball = shapes.sphere("icosphere", 1)
    uvs = ball.positions[:, :2] * 0.5 + 0.5
    mesh = trimesh.Trimesh(
        ball.positions,
        ball.faces,
        vertex_normals=ball.normals,
        visual=trimesh.visual.TextureVisuals(uv=uvs),
        process=False,
    )
    content = mesh.export(file_type=suffix.lstrip("."))
    return content.encode() if isinstance(content, str) else content


def assert_refused(file, kind=MeshFileError):
    with pytest.raises(kind) as caught:
        load_mesh(file, unit_mm=10.0)
    assert str(file) in str(caught.value)
    return str(caught.value)


@EVERY_SUFFIX
def test_a_missing_file_is_named(tmp_path, suffix):
    assert "no such file" in assert_refused(tmp_path / f"head{suffix}")


@EVERY_SUFFIX
def test_an_empty_file_is_named(tmp_path, suffix):
    (tmp_path / f"head{suffix}").touch()
    assert "empty" in assert_refused(tmp_path / f"head{suffix}")


def test_a_folder_is_named(tmp_path):
    assert "not a file" in assert_refused(tmp_path)


@EVERY_SUFFIX
@pytest.mark.parametrize(
    "content",
    [b"once upon a time there was a head\n" * 9, bytes(range(256)) * 8, b"\n", b"\x00" * 500],
    ids=["text", "noise", "one line", "zeros"],
)
def test_a_file_that_is_no_mesh_is_refused(tmp_path, suffix, content):
    file = tmp_path / f"head{suffix}"
    file.write_bytes(content)
    assert_refused(file)


@pytest.mark.parametrize("name", ["head.fbx", "head", "head.glb.zip", "head.usd"])
def test_an_unknown_suffix_is_refused_with_the_choices(tmp_path, name):
    (tmp_path / name).write_bytes(b"x")
    message = assert_refused(tmp_path / name)
    assert all(suffix in message for suffix in SUFFIXES)


@pytest.mark.parametrize("wrong", [".glb", ".obj", ".ply", ".stl"])
def test_a_mesh_with_the_suffix_of_another_format_is_refused(tmp_path, wrong):
    right = ".glb" if wrong != ".glb" else ".ply"
    file = tmp_path / f"head{wrong}"
    file.write_bytes(small_ball(right))
    assert_refused(file)


@pytest.mark.parametrize("suffix", [".GLB", ".Obj", ".PLY"])
def test_the_case_of_the_suffix_does_not_matter(tmp_path, suffix):
    file = tmp_path / f"head{suffix}"
    file.write_bytes(small_ball(suffix.lower()))
    assert len(load_mesh(file, unit_mm=10.0).faces) == 80


@pytest.mark.parametrize("suffix", [".glb", ".ply", ".stl"])
@pytest.mark.parametrize("share", [0.01, 0.2, 0.5, 0.8, 0.98])
def test_a_truncated_file_is_refused(tmp_path, suffix, share):
    whole = small_ball(suffix)
    file = tmp_path / f"head{suffix}"
    file.write_bytes(whole[: int(len(whole) * share)])
    assert_refused(file)


OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
PLY = """ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
{} 1 0
3 0 1 {}
"""

BROKEN = {
    "points only": (".obj", OBJ, MeshFileError, "no triangles"),
    "an index too high": (".obj", OBJ + "f 1 2 9\n", MeshFileError, "corner '9'; there are 3 "),
    "nan in a position": (
        ".obj",
        OBJ.replace("1 0 0", "1 nan 0") + "f 1 2 3\n",
        ArgumentError,
        "positions[1, 1] is nan",
    ),
    "infinity in a position": (
        ".obj",
        OBJ.replace("1 0 0", "1 inf 0") + "f 1 2 3\n",
        ArgumentError,
        "positions[1, 1] is inf",
    ),
    "an index of zero": (".obj", OBJ + "f 0 1 2\n", MeshFileError, "line 4 has vertex index 0"),
    "an index of zero in a later corner": (
        ".obj",
        OBJ + "f 1//1 2//1 0//1\n",
        MeshFileError,
        "line 4 has vertex index 0",
    ),
    "a face without area": (".obj", OBJ + "f 1 1 2\n", InputError, "area"),
    "words for numbers": (
        ".obj",
        OBJ.replace("1 0 0", "one 0 0") + "f 1 2 3\n",
        MeshFileError,
        "cannot be read",
    ),
    "a ply index too high": (".ply", PLY.format(0, 7), ArgumentError, "faces[0, 2] is 7"),
    "a ply index negative": (".ply", PLY.format(0, -2), ArgumentError, "faces[0, 2] is -2"),
    "a ply nan": (".ply", PLY.format("nan", 2), ArgumentError, "positions[2, 0] is nan"),
    "a ply of one line": (".ply", PLY.format(0, 1), MeshError, "no face has an area"),
}


@pytest.mark.parametrize(("suffix", "text", "kind", "complaint"), BROKEN.values(), ids=BROKEN)
def test_a_broken_mesh_is_refused_with_its_fault(tmp_path, suffix, text, kind, complaint):
    file = tmp_path / f"head{suffix}"
    file.write_text(text)
    assert complaint in assert_refused(file, kind)


def test_a_gltf_without_its_buffer_is_refused(tmp_path):
    mesh = trimesh.creation.icosphere(subdivisions=1)
    for name, content in trimesh.exchange.gltf.export_gltf(trimesh.Scene(mesh)).items():
        if name.endswith(".gltf"):
            (tmp_path / "head.gltf").write_bytes(content)
    assert_refused(tmp_path / "head.gltf")


@pytest.mark.parametrize("exponent", [60, 120, 250])
def test_extreme_sizes_are_refused_or_have_finite_normals(tmp_path, exponent):
    file = tmp_path / "head.obj"
    file.write_text(f"v 0 0 0\nv 1e{exponent} 0 0\nv 0 1e{exponent} 0\nf 1 2 3\n")
    try:
        mesh = load_mesh(file, unit_mm=1.0)
    except InputError as error:
        assert str(file) in str(error)
        return
    assert np.allclose(mesh.normals, (0.0, 0.0, 1.0))


@pytest.mark.parametrize("suffix", [".glb", ".obj", ".ply", ".stl"])
@settings(SAME_FOLDER, max_examples=150)
@given(data=st.data())
def test_wrong_bytes_raise_only_errors_of_skinshade(tmp_path, suffix, data):
    broken = bytearray(small_ball(suffix))
    for _ in range(data.draw(st.integers(1, 5), "faults")):
        at = data.draw(st.integers(0, len(broken) - 1), "at")
        match data.draw(st.sampled_from(["change", "flip", "cut", "insert"]), "fault"):
            case "change":
                broken[at] = data.draw(st.integers(0, 255))
            case "flip":
                broken[at] ^= 1 << data.draw(st.integers(0, 7))
            case "cut" if len(broken) > 16:
                del broken[at : at + data.draw(st.integers(1, 8))]
            case _:
                broken[at:at] = data.draw(st.binary(min_size=1, max_size=4))
    file = tmp_path / f"head{suffix}"
    file.write_bytes(broken)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UnitWarning)
        try:
            mesh = load_mesh(file, unit_mm=None if suffix == ".glb" else 10.0)
        except SkinshadeError as error:
            assert str(file) in str(error)
            return
    assert np.isfinite(mesh.positions).all()
    assert np.allclose(np.linalg.norm(mesh.normals, axis=1), 1.0)
    assert mesh.faces.max() < len(mesh.positions)
