"""A mesh that its node shrinks to nothing is skipped, and the others of the file are kept."""

import numpy as np
import pytest

import gltf_shapes
from malformed import assert_refused
from skinshade.baking import bake
from skinshade.mesh import load_mesh
from tolerances import CURVATURE_OF_ROUNDED

COUNT = 8
ZERO, INFINITE = "meshes of scale 0 skipped", "meshes of infinite scale skipped"
RADII_MM = [20.0 + 5.0 * number for number in range(COUNT)]
VERTICES = len(gltf_shapes.sphere()[0])


def eight_meshes(scales, shared=None):
    """Return a model of eight spheres side by side.

    Parameters
    ----------
    scales
        Scale of the node of a mesh, by its index; 1 for the others.
    shared
        Another node.
    """
    model = gltf_shapes.empty_model()
    nodes = []
    for number, radius_mm in enumerate(RADII_MM):
        parts = gltf_shapes.sphere(0.001 * radius_mm)
        attributes = gltf_shapes.add_attributes(model, *parts)
        model.add_mesh(gltf_shapes.primitive(model, parts[3], **attributes), name=f"ball {number}")
        nodes.append({"mesh": number, "translation": [0.25 * number, 0, 0]})
        if number in scales:
            nodes[-1]["scale"] = scales[number]
    return model.with_nodes(*nodes, *([shared] if shared else []))


def assert_seven_are_baked(path, output, missing):
    baked = bake(path, output)
    assert [mesh.name for mesh in baked.meshes] == [
        f"ball {number}" for number in range(COUNT) if number != missing
    ]
    radii = [radius for number, radius in enumerate(RADII_MM) if number != missing]
    for mesh, radius_mm in zip(baked.meshes, radii, strict=True):
        curvature = mesh.analysis.attributes["curvature"] * radius_mm
        np.testing.assert_allclose(curvature, 1.0, rtol=CURVATURE_OF_ROUNDED.value)
    document, _ = gltf_shapes.read(output)
    assert len(document["meshes"]) == COUNT
    for number, mesh in enumerate(document["meshes"]):
        names = mesh["primitives"][0]["attributes"]
        assert ("_CURVATURE" in names) == (number != missing)
    return [mesh.all_notes for mesh in baked.meshes]


SCALES = {
    "zero": ([0, 0, 0], ZERO),
    "flat": ([1, 0, 1], ZERO),
    "nearly zero": ([1e-12] * 3, ZERO),
    "huge": ([1e11] * 3, INFINITE),
}


@pytest.mark.parametrize(("scale", "note"), SCALES.values(), ids=SCALES)
@pytest.mark.parametrize("missing", [0, 3])
def test_seven_of_eight_meshes_are_kept_if_one_has_a_scale_of_zero(tmp_path, scale, note, missing):
    path = gltf_shapes.write(eight_meshes({missing: scale}), tmp_path)
    first, *others = assert_seven_are_baked(path, tmp_path / "out.glb", missing)
    assert first == {note: 1}
    assert others == [{}] * 6
    mesh = load_mesh(path)
    assert len(mesh.positions) == 7 * VERTICES
    assert mesh.repairs == {note: 1}


def test_a_matrix_that_is_not_finite_skips_only_its_mesh(tmp_path):
    model = eight_meshes({})
    nodes = model.document["nodes"]
    chain = [{"scale": [1e12] * 3, "children": [COUNT + i + 1]} for i in range(39)]
    nodes += [*chain, {"scale": [1e12] * 3, "children": [2]}]
    roots = [number for number in range(COUNT + 1) if number != 2]
    model.document["scenes"] = [{"nodes": roots}]
    path = gltf_shapes.write(model, tmp_path)
    assert assert_seven_are_baked(path, tmp_path / "out.glb", 2)[0] == {INFINITE: 1}
    assert load_mesh(path).repairs == {INFINITE: 1}


def test_a_bake_to_another_format_counts_the_skipped_mesh(tmp_path):
    path = gltf_shapes.write(eight_meshes({5: [0, 0, 0]}), tmp_path)
    (baked,) = bake(path, tmp_path / "out.ply").meshes
    assert baked.all_notes == {ZERO: 1}
    assert len(baked.mesh.positions) == 7 * VERTICES


def test_a_mesh_of_several_nodes_is_placed_by_those_of_usable_scale(tmp_path):
    again = {"mesh": 4, "scale": [2, 2, 2], "translation": [0, 1, 0]}
    path = gltf_shapes.write(eight_meshes({4: [0, 0, 0]}, again), tmp_path)
    baked = bake(path, tmp_path / "out.glb").meshes
    assert len(baked) == COUNT
    assert baked[4].mesh.unit_mm == pytest.approx(2000.0)
    assert baked[0].notes == {}
    mesh = load_mesh(path)
    assert len(mesh.positions) == COUNT * VERTICES
    assert mesh.repairs == {ZERO: 1}


def test_a_file_whose_meshes_all_have_scale_zero_is_refused(tmp_path):
    scales = {number: [0, 0, 0] for number in range(COUNT)}
    path = gltf_shapes.write(eight_meshes(scales), tmp_path)
    assert_refused(path, "mesh 0: its node scales it by 0; give it a scale within")
