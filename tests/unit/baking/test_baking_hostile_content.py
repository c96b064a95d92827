"""Malformed geometry: a bake raises an error of skinshade, or its results are finite."""

import struct

import numpy as np
import pytest

import gltf_shapes
import shapes
from malformed import assert_bake_refuses, assert_refused, one_primitive
from skinshade._core.errors import ArgumentError, InputError, MeshError, UnitError
from skinshade.baking import BakeSettings, bake
from tolerances import CURVATURE_OF_ROUNDED

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], float)


def with_first_number(model, view, content):
    """Replace the first number of a view by other bytes."""
    model.binary[view["byteOffset"] : view["byteOffset"] + 4] = content
    return model


@pytest.mark.parametrize("output", ["out.glb", "out.ply"])
@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 3e38])
def test_a_position_that_is_not_finite_or_too_large_is_refused_by_index(tmp_path, value, output):
    corners = CORNERS.copy()
    corners[1, 2] = value
    path = one_primitive(tmp_path, corners, min=[0, 0, 0], max=[1, 1, 1])
    assert_refused(path, r"positions\[1, 2\]", InputError, output)


@pytest.mark.parametrize("output", ["out.glb", "out.ply"])
def test_the_error_of_a_position_too_large_in_mm_names_the_file(tmp_path, output):
    """In metres the positions are in range; in mm their fourth powers overflow."""
    path = one_primitive(tmp_path, CORNERS * 1e14)
    message = r"positions\[1, 0\] is 1\.0\S*e\+17"
    assert_bake_refuses(path, message, ArgumentError, output, unit_mm=1000.0)


@pytest.mark.parametrize("output", ["out.glb", "out.ply"])
@pytest.mark.parametrize("name", ["NORMAL", "TEXCOORD_0"])
def test_normals_that_are_not_finite_are_replaced_and_such_uvs_ignored(tmp_path, name, output):
    model = gltf_shapes.plain()
    index = model.document["meshes"][0]["primitives"][0]["attributes"][name]
    view = model.document["bufferViews"][model.document["accessors"][index]["bufferView"]]
    model = with_first_number(model, view, struct.pack("<f", np.nan))
    path = gltf_shapes.write(model, tmp_path)
    if output == "out.ply" and name == "TEXCOORD_0":  # a PLY file would contain the UVs
        assert_bake_refuses(path, "uvs", InputError, output)
        return
    (mesh,) = bake(path, tmp_path / output).meshes
    assert np.isfinite(mesh.analysis.attributes["curvature"]).all()
    assert np.isfinite(mesh.mesh.normals).all()
    notes = {"NORMAL": "normals computed", "TEXCOORD_0": "meshes whose UVs are not finite"}
    assert mesh.all_notes[notes[name]] == 1


def test_a_signalling_nan_is_refused_without_a_warning(tmp_path):
    """The processor warns when a signalling NaN is converted to another type."""
    model = gltf_shapes.plain()
    view = model.document["bufferViews"][0]
    path = gltf_shapes.write(with_first_number(model, view, bytes.fromhex("0100807f")), tmp_path)
    assert_bake_refuses(path, r"positions\[0, 0\] is nan", InputError)


@pytest.mark.parametrize("output", ["out.glb", "out.ply", "out.usda"])
def test_uvs_beyond_single_precision_are_refused(tmp_path, output):
    path = tmp_path / "in.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 1e200\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n")
    assert_bake_refuses(path, "uvs reach 1e\\+200", MeshError, output, unit_mm=1.0)


@pytest.mark.parametrize("output", ["out.glb", "out.ply"])
def test_a_curvature_beyond_single_precision_is_refused(tmp_path, output):
    p, _, _, faces = gltf_shapes.sphere(1.0, 1)
    model = gltf_shapes.empty_model()
    tiny = {"POSITION": model.add_accessor(p * 1e-42), "NORMAL": model.add_accessor(p)}
    model.add_mesh(gltf_shapes.primitive(model, faces, **tiny))
    path = gltf_shapes.write(model.with_nodes({"mesh": 0}), tmp_path)
    message = "curvature reaches|no face has an area"
    assert_bake_refuses(path, message, MeshError, output, unit_mm=1000.0)


@pytest.mark.parametrize("output", ["out.glb", "out.ply"])
def test_a_mesh_whose_faces_have_no_area_is_refused(tmp_path, output):
    path = one_primitive(tmp_path, CORNERS[[0, 1, 1]])
    assert_bake_refuses(path, "no face has an area", MeshError, output)
    line = one_primitive(tmp_path, [[0, 0, 0], [1, 1, 1], [2, 2, 2]])
    assert_bake_refuses(line, "no face has an area", MeshError, output)


def test_a_mesh_without_vertices_and_a_file_without_meshes_are_refused(tmp_path):
    model = gltf_shapes.plain()
    model.document["accessors"][0]["count"] = 0
    assert_bake_refuses(gltf_shapes.write(model, tmp_path), "count is 0")
    model = gltf_shapes.plain()
    model.document["meshes"] = []
    model.document["nodes"] = []
    assert_bake_refuses(gltf_shapes.write(model, tmp_path), "holds no triangles")


def test_a_mesh_may_have_more_vertices_than_16_bits_count(tmp_path):
    flat = shapes.square(1.0, 270)
    assert len(flat.positions) > 70_000
    path = one_primitive(tmp_path, flat.positions, flat.faces)
    (mesh,) = bake(path, tmp_path / "out.glb").meshes
    assert len(mesh.analysis.attributes["curvature"]) == len(flat.positions)
    np.testing.assert_allclose(
        mesh.analysis.attributes["curvature"], 0.0, atol=CURVATURE_OF_ROUNDED.value
    )
    assert mesh.mesh.faces.max() == len(flat.positions) - 1


def test_non_manifold_edges_and_opposite_faces_give_finite_results(tmp_path):
    hub = np.array([[0, 0, 0], [0, 0, 1], *([np.cos(a), np.sin(a), 0] for a in range(6))])
    faces = [[0, 1, i] for i in range(2, 8)] + [[1, 0, 2], [0, 1, 2]]
    path = one_primitive(tmp_path, hub, faces)
    settings = BakeSettings(thickness=True, tensor=True, rays=8)
    (mesh,) = bake(path, tmp_path / "out.glb", settings).meshes
    assert all(np.isfinite(values).all() for values in mesh.analysis.attributes.values())
    assert mesh.all_notes["non-manifold edges"] >= 1


@pytest.mark.parametrize("unit", [0, 0.0, -1.0, np.nan, np.inf, 1e300, "wide", None])
def test_a_unit_that_is_no_length_is_refused(unit):
    if unit is None:
        assert BakeSettings(unit_mm=unit).unit_mm is None
        return
    with pytest.raises(UnitError, match="unit_mm is"):
        BakeSettings(unit_mm=unit)
