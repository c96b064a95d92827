"""Units from comments of PLY and OBJ files, and the baked properties that depend on them."""

from __future__ import annotations

import numpy as np
import pytest

import shapes
import tolerances as tol
from skinshade._core.errors import MeshError, UnitError
from skinshade.baking import BakeSettings, bake
from skinshade.mesh import Mesh, load_mesh, vertex_attributes
from skinshade.mesh.baked import gathered_columns
from skinshade.mesh.shape_operator import ShapeOperator
from skinshade.profile import Profile

SKIN = Profile.preset("skin-deon2007")
BAKED = {"curvature", "tensor", "thickness"}
OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
PLY = """ply
format ascii 1.0
{}element vertex 3
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
3 0 1 2
"""
WRONG = ["nan", "inf", "-10", "0", "ten", "10 mm", "10,0", "", "1e999"]


def write(folder, suffix, comments):
    file = folder / f"in{suffix}"
    if suffix == ".obj":
        file.write_text("".join(f"# {comment}\n" for comment in comments) + OBJ)
    else:
        file.write_text(PLY.format("".join(f"comment {comment}\n" for comment in comments)))
    return file


@pytest.fixture(scope="module")
def baked(tmp_path_factory):
    """An ellipsoid of 60, 40 and 24 mm in units of 7.3 mm, baked to PLY."""
    folder = tmp_path_factory.mktemp("units")
    sphere = shapes.sphere("icosphere", 3)
    points = sphere.positions * np.array([30.0, 20.0, 12.0]) / 7.3
    lines = [f"v {x} {y} {z}" for x, y, z in points]
    lines += [f"f {a} {b} {c}" for a, b, c in sphere.faces + 1]
    (folder / "body.obj").write_text("\n".join(["# unit_mm 7.3", *lines]))
    bake(
        folder / "body.obj", folder / "body.ply", BakeSettings(tensor=True, thickness=True, rays=8)
    )
    return folder / "body.ply"


# -- comments --------------------------------------------------------------------------------------


@pytest.mark.parametrize("suffix", [".obj", ".ply"])
@pytest.mark.parametrize("text", ["unit_mm 25.4", " unit_mm   2.54e1 ", "unit_mm\t25.4"])
def test_a_comment_states_the_unit(tmp_path, suffix, text):
    file = write(tmp_path, suffix, ["made by hand", text, "unit_mmm 3"])
    assert load_mesh(file).unit_mm == 25.4
    assert load_mesh(file, unit_mm=2.0).unit_mm == 2.0


@pytest.mark.parametrize("suffix", [".obj", ".ply"])
def test_without_a_comment_the_error_asks_for_the_unit(tmp_path, suffix):
    with pytest.raises(UnitError, match=rf"in\{suffix}: states no unit; give unit_mm"):
        load_mesh(write(tmp_path, suffix, ["one unit is 10 mm"]))


def test_a_comment_of_an_obj_after_the_first_statement_does_not_count(tmp_path):
    (tmp_path / "in.obj").write_text(OBJ + "# unit_mm 10\n")
    with pytest.raises(UnitError, match="states no unit"):
        load_mesh(tmp_path / "in.obj")


@pytest.mark.parametrize("suffix", [".obj", ".ply"])
@pytest.mark.parametrize("text", WRONG)
def test_a_comment_without_a_valid_unit_is_an_error_unless_a_unit_is_given(tmp_path, suffix, text):
    file = write(tmp_path, suffix, [f"unit_mm {text}"])
    with pytest.raises(UnitError, match=r"states no positive number of mm.*give unit_mm") as caught:
        load_mesh(file)
    assert str(caught.value).startswith(f"{file}: the comment 'unit_mm")
    assert load_mesh(file, unit_mm=2.0).unit_mm == 2.0


@pytest.mark.parametrize("suffix", [".obj", ".ply"])
def test_comments_that_contradict_each_other_are_an_error_unless_a_unit_is_given(tmp_path, suffix):
    file = write(tmp_path, suffix, ["unit_mm 10", "unit_mm 25.4"])
    with pytest.raises(UnitError, match=r"state units of 10 and 25.4 mm; give unit_mm"):
        load_mesh(file)
    assert load_mesh(file, unit_mm=2.0).unit_mm == 2.0
    assert load_mesh(write(tmp_path, suffix, ["unit_mm 10"] * 2)).unit_mm == 10.0


# -- baked properties ------------------------------------------------------------------------------


def test_a_baked_ply_states_its_unit_and_has_the_size_of_its_source(baked):
    mesh = load_mesh(baked)
    assert mesh.unit_mm == 7.3
    assert set(mesh.attributes) == BAKED
    assert np.ptp(mesh.positions_mm, axis=0) == pytest.approx([60.0, 40.0, 24.0], rel=1e-3)
    assert mesh.attributes["tensor"].shape == (len(mesh.positions), 6)
    assert mesh.attributes["curvature"].shape == (len(mesh.positions),)


def test_baked_properties_are_used_for_shading_without_a_new_analysis(baked, monkeypatch):
    def refuse(*_, **__):
        raise AssertionError("the attribute is in the file")

    mesh = load_mesh(baked)
    without = Mesh.checked(mesh.positions, mesh.faces, unit_mm=mesh.unit_mm, normals=mesh.normals)
    computed = vertex_attributes(without, SKIN)
    monkeypatch.setattr(ShapeOperator, "fit", refuse)
    stored = vertex_attributes(mesh, SKIN)
    for name in ("curvature", "tensor"):
        error = np.abs(stored[name] - computed[name]).max()
        assert error <= tol.CURVATURE_OF_ROUNDED.value * np.abs(computed[name]).max()


def test_baked_properties_are_dropped_for_another_unit(baked):
    assert set(load_mesh(baked, unit_mm=7.3 * (1.0 + 1e-6)).attributes) == BAKED
    assert not BAKED & set(load_mesh(baked, unit_mm=7.31).attributes)


@pytest.mark.parametrize(
    "comment", [b"comment unit_xx 7.3", b"comment unit_mm nan", b"obj_info unit_mm 7.3"]
)
def test_baked_names_without_a_unit_of_the_file_are_dropped(baked, tmp_path, comment):
    content = baked.read_bytes()
    assert b"\ncomment unit_mm 7.3\n" in content
    (tmp_path / "other.ply").write_bytes(content.replace(b"comment unit_mm 7.3", comment))
    mesh = load_mesh(tmp_path / "other.ply", unit_mm=7.3)
    assert mesh.attributes == {}


def test_a_quantity_with_a_part_that_is_missing_or_not_finite_is_dropped(baked, tmp_path):
    content = baked.read_bytes()
    (tmp_path / "part.ply").write_bytes(content.replace(b"float tensor_zz", b"float tensor_yx"))
    assert set(load_mesh(tmp_path / "part.ply").attributes) == BAKED - {"tensor"} | {"tensor_yx"}
    start = content.index(b"end_header\n") + len(b"end_header\n")
    nan = np.float32(np.nan).tobytes()
    first = content[:start] + content[start : start + 24] + nan + content[start + 28 :]
    (tmp_path / "nan.ply").write_bytes(first)
    assert set(load_mesh(tmp_path / "nan.ply").attributes) == BAKED - {"curvature"}


def test_an_attribute_with_the_name_of_a_quantity_of_several_columns_is_dropped():
    columns = {"tensor": np.ones((4, 1)), "tensor_xx": np.ones((4, 1)), "depth": np.ones((4, 1))}
    assert list(gathered_columns(columns)) == ["depth"]


def test_the_bake_of_a_baked_ply_needs_no_unit_and_keeps_it(baked, tmp_path):
    bake(baked, tmp_path / "again.ply")
    assert load_mesh(tmp_path / "again.ply").unit_mm == 7.3
    bake(baked, tmp_path / "again.glb")
    np.testing.assert_allclose(
        np.ptp(load_mesh(tmp_path / "again.glb").positions_mm, axis=0),
        [60.0, 40.0, 24.0],
        rtol=1e-3,
    )


@pytest.mark.parametrize(("name", "shape"), [("curvature", (3, 1)), ("tensor", (3,))])
def test_an_attribute_of_a_wrong_shape_is_an_error_for_shading(name, shape):
    mesh = Mesh.checked(
        np.eye(3), [[0, 1, 2]], unit_mm=1.0, attributes={name: np.zeros(shape)}
    )  # fmt: skip
    with pytest.raises(MeshError, match=rf"attribute {name} has shape"):
        vertex_attributes(mesh, SKIN)
