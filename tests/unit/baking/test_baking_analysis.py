"""Bakes of meshes with faults: doubled faces, and fans whose curvature is bounded."""

import numpy as np
import pytest

import gltf_shapes
from skinshade.baking import BakeSettings, bake
from skinshade.mesh import load_mesh
from tolerances import CURVATURE_OF_ROUNDED, FLOAT32_FILE

EVERYTHING = BakeSettings(tensor=True, thickness=True, rays=8, tracing="builtin")
RADIUS_MM = 80.0
COUNT = len(gltf_shapes.sphere()[0])
DOUBLED = "faces doubled with opposite winding dropped"


def ball(two_sided):
    """Return a model of a ball, whose faces have a second side with separate vertices if requested."""
    p, n, t, faces = gltf_shapes.sphere()
    if two_sided:
        faces = np.concatenate([faces, faces[:, ::-1] + len(p)])
        p, n, t = np.concatenate([p, p]), np.concatenate([n, -n]), np.concatenate([t, t])
    model = gltf_shapes.empty_model()
    attributes = gltf_shapes.add_attributes(model, p, n, t)
    model.add_mesh(gltf_shapes.primitive(model, faces, **attributes), name="ball")
    return model.with_nodes({"mesh": 0})


@pytest.fixture(scope="module")
def bakes(tmp_path_factory):
    """The single-sided ball and the two-sided one, baked to GLB."""
    folder = tmp_path_factory.mktemp("sides")
    results = []
    for stem, two_sided in (("single", False), ("double", True)):
        source = gltf_shapes.write(ball(two_sided), folder, stem=stem)
        results.append(bake(source, folder / f"{stem}-baked.glb", EVERYTHING))
    return results


@pytest.mark.parametrize("name", ["curvature", "tensor", "thickness"])
def test_both_sides_of_a_two_sided_ball_have_the_values_of_the_single_sided_one(bakes, name):
    single, double = (result.meshes[0].analysis.attributes[name] for result in bakes)
    assert double.shape == (2 * COUNT, single.shape[1])
    gap = np.abs(double.reshape(2, COUNT, -1) - single).max()
    assert gap <= FLOAT32_FILE.value * np.abs(single).max()


def test_the_curvature_of_a_two_sided_ball_is_that_of_the_ball(bakes):
    curvature = bakes[1].meshes[0].analysis.attributes["curvature"]
    np.testing.assert_allclose(curvature * RADIUS_MM, 1.0, rtol=CURVATURE_OF_ROUNDED.value)


def test_the_faces_of_the_second_side_are_counted_and_stay_in_the_file(bakes):
    single, double = bakes
    (mesh,) = double.meshes
    assert single.meshes[0].all_notes == {}
    assert mesh.all_notes == {DOUBLED: 320}
    document, _ = gltf_shapes.read(double.written[-1])
    indices = document["meshes"][0]["primitives"][0]["indices"]
    assert document["accessors"][indices]["count"] == 3 * 2 * 320


def test_load_mesh_reads_one_side_of_a_baked_two_sided_ball(bakes):
    mesh = load_mesh(bakes[1].written[-1])
    assert mesh.repairs == {DOUBLED: 320, "unreferenced vertices dropped": COUNT}
    np.testing.assert_allclose(
        mesh.attributes["curvature"] * RADIUS_MM, 1.0, rtol=CURVATURE_OF_ROUNDED.value
    )


def test_vertices_with_bounded_curvature_are_counted(tmp_path):
    """One vertex is moved along an edge to a millionth of its length, and keeps its normal."""
    p, n, t, faces = gltf_shapes.sphere()
    one, other = faces[0, :2]
    p = p.copy()
    p[other] = p[one] + 1e-6 * (p[other] - p[one])
    model = gltf_shapes.empty_model()
    attributes = gltf_shapes.add_attributes(model, p, n, t)
    model.add_mesh(gltf_shapes.primitive(model, faces, **attributes))
    source = gltf_shapes.write(model.with_nodes({"mesh": 0}), tmp_path)
    (mesh,) = bake(source, tmp_path / "out.glb", BakeSettings(smoothing=0)).meshes
    assert 2 <= mesh.all_notes["vertices with bounded curvature"] <= 12
    size = np.linalg.norm(np.ptp(mesh.mesh.positions_mm, axis=0))
    assert np.abs(mesh.analysis.attributes["curvature"]).max() * size < 2000.0
