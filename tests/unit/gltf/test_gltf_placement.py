"""Placement of meshes: malformed nodes are refused, and the default scene selects the nodes."""

import struct
import time

import numpy as np
import pytest

import gltf_shapes
from malformed import assert_refused, plain_with
from skinshade.baking import bake
from skinshade.mesh import load_mesh
from tolerances import FLOAT32_FILE


def plain_with_nodes(folder, *nodes):
    """Write the plain model with other nodes, the first of which is the root."""
    return plain_with(folder, nodes=list(nodes), scenes=[{"nodes": [0]}])


@pytest.mark.parametrize(
    "cycle",
    [
        [{"mesh": 0, "children": [0]}],
        [{"mesh": 0, "children": [1]}, {"children": [0]}],
        [{"mesh": 0}, {"children": [2]}, {"children": [3]}, {"children": [1]}],
    ],
)
def test_a_cycle_of_nodes_is_refused(tmp_path, cycle):
    assert_refused(plain_with_nodes(tmp_path, *cycle), "its own ancestor")


def test_a_node_with_two_parents_is_refused(tmp_path):
    both = [{"children": [2]}, {"children": [2]}, {"mesh": 0}]
    assert_refused(plain_with_nodes(tmp_path, *both), "node 2 has two parents")
    twice = [{"children": [1, 1]}, {"mesh": 0}]
    assert_refused(plain_with_nodes(tmp_path, *twice), "node 1 has two parents")


@pytest.mark.parametrize("key", ["rotation", "scale", "translation", "matrix"])
@pytest.mark.parametrize(
    "value",
    [True, None, "1", {}, [], [1, 2], ["1"] * 3, [True] * 3, [1, 1, None], [10**400] * 3, ["x"] * 4,
     [1e300] * 3, [[1], [1], [1]], [[1, 2, 3]] * 4, [False] * 16, ["0"] * 16],
)  # fmt: skip
def test_a_transform_that_is_not_of_numbers_in_range_is_refused(tmp_path, key, value):
    assert_refused(plain_with_nodes(tmp_path, {"mesh": 0, key: value}), f"node 0: {key}")


@pytest.mark.parametrize("scale", [[0, 0, 0], [1, 0, 1], [1e-12] * 3, [1e11] * 3])
def test_a_scale_of_zero_or_out_of_range_of_the_only_mesh_is_refused(tmp_path, scale):
    path = plain_with_nodes(tmp_path, {"mesh": 0, "scale": scale})
    assert_refused(
        path, "mesh 0: its node scales it by .*; give it a scale within 1e-09 to 1e\\+09"
    )


def test_a_chain_of_scales_that_overflows_is_refused(tmp_path):
    chain = [{"scale": [1e12] * 3, "children": [i + 1]} for i in range(40)]
    path = plain_with_nodes(tmp_path, *chain, {"mesh": 0})
    assert_refused(path, "the matrix of node 40 is not finite")


def test_a_bind_pose_that_is_not_finite_is_refused(tmp_path):
    model = gltf_shapes.skinned()
    bind = model.document["skins"][0]["inverseBindMatrices"]
    view = model.document["bufferViews"][model.document["accessors"][bind]["bufferView"]]
    model.binary[view["byteOffset"] : view["byteOffset"] + 4] = struct.pack("<f", np.nan)
    path = gltf_shapes.write(model, tmp_path)
    assert_refused(path, "the matrix of node 0 is not finite")


def test_the_time_for_many_nodes_is_proportional_to_their_number(tmp_path):
    """A search of all nodes for each reference would take an hour for a megabyte."""
    count = 30_000
    many = [{"children": list(range(1, count))}, {"mesh": 0}, *[{} for _ in range(count - 2)]]
    started = time.process_time()
    bake(plain_with_nodes(tmp_path, *many), tmp_path / "out.glb")
    assert time.process_time() - started < 20.0


def test_load_mesh_reads_the_default_scene_and_a_bake_every_mesh(tmp_path):
    model = gltf_shapes.several_primitives()
    model.document["scenes"] = [{"nodes": [0]}, {"nodes": [1]}]
    model.document["scene"] = 1
    path = gltf_shapes.write(model, tmp_path)
    size = np.ptp(load_mesh(path).positions_mm, axis=0)
    np.testing.assert_allclose(size, 2.0 * 20.0 * sphere_extent(1), rtol=FLOAT32_FILE.value)
    assert len(bake(path, tmp_path / "out.glb").meshes) == 2


def sphere_extent(level):
    """Return the size (3,) of the coarse sphere of radius 1/2."""
    return np.ptp(gltf_shapes.sphere(0.5, level)[0], axis=0)
