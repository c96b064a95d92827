"""Where the meshes of a glTF scene stand: the unit of each, for a skin in its bind pose too."""

from __future__ import annotations

from typing import Any

import numpy as np

from .._core.arrays import FloatArray
from .._core.errors import MeshFileError
from .accessors import read_matrices
from .gltf import GltfFile

__all__ = ["Placement", "placements", "scale_of"]

Placement = FloatArray
"""(4, 4) from a mesh's own axes to the world's."""

UNEVEN = 1.001
"""Ratio of the longest to the shortest axis of a scale that is still taken for even."""
LARGEST = 1e12
"""Metres to a place, or times a size, beyond which nothing is meant."""


def placements(gltf: GltfFile) -> dict[int, list[Placement]]:
    """Return where each mesh stands, by its index; nowhere for one that no node shows.

    A skinned mesh stands where its joints put it, whatever its node says.

    Raises
    ------
    MeshFileError
        If nodes form a cycle, or a node is malformed.
    """
    nodes = gltf.items("nodes")
    world = _world_matrices(gltf, nodes)
    found: dict[int, list[Placement]] = {}
    for index, node in enumerate(nodes):
        if "mesh" not in node:
            continue
        gltf.item("meshes", node["mesh"], f"node {index}")
        matrix = world[index]
        if "skin" in node:
            matrix = _bind_pose(gltf, node["skin"], world, index)
        if not np.isfinite(matrix).all():
            raise MeshFileError(f"{gltf.path}: node {index} does not stand at a finite place")
        found.setdefault(node["mesh"], []).append(matrix)
    return found


def scale_of(matrix: Placement) -> tuple[float, bool]:
    """Return how much longer lengths become, and whether evenly so in all directions."""
    lengths = np.linalg.svd(matrix[:3, :3], compute_uv=False)
    with np.errstate(over="ignore"):
        mean = float(np.cbrt(np.prod(lengths)))
    if abs(mean - 1.0) < 1e-6:  # a rotation in single precision
        mean = 1.0
    return mean, bool(lengths[0] <= UNEVEN * lengths[-1])


def _world_matrices(gltf: GltfFile, nodes: list[dict[str, Any]]) -> dict[int, Placement]:
    parents = _parents(gltf, nodes)
    local = [_local_matrix(gltf, node, index) for index, node in enumerate(nodes)]
    world: dict[int, Placement] = {}
    for index in range(len(nodes)):
        chain: list[int] = []
        at: int | None = index
        while at is not None and at not in world:
            chain.append(at)
            if len(chain) > len(nodes):
                raise MeshFileError(f"{gltf.path}: node {index} is its own ancestor")
            at = parents.get(at)
        matrix = np.eye(4) if at is None else world[at]
        for each in reversed(chain):
            with np.errstate(over="ignore", invalid="ignore"):  # what comes of it is checked
                matrix = matrix @ local[each]
            world[each] = matrix
    return world


def _parents(gltf: GltfFile, nodes: list[dict[str, Any]]) -> dict[int, int]:
    parents: dict[int, int] = {}
    for index, node in enumerate(nodes):
        children = node.get("children", [])
        if not isinstance(children, list):
            raise MeshFileError(f"{gltf.path}: node {index}: children is no array")
        for child in children:
            gltf.item("nodes", child, f"node {index}: children")
            if child in parents:
                raise MeshFileError(f"{gltf.path}: node {child} has two parents")
            parents[child] = index
    return parents


def _local_matrix(gltf: GltfFile, node: dict[str, Any], index: int) -> Placement:
    here = f"{gltf.path}: node {index}"
    if "matrix" in node:
        return _numbers(node["matrix"], 16, f"{here}: matrix").reshape(4, 4).T
    x, y, z, w = _numbers(node.get("rotation", [0, 0, 0, 1]), 4, f"{here}: rotation")
    length = max(float(np.sqrt(x * x + y * y + z * z + w * w)), 1e-12)
    x, y, z, w = x / length, y / length, z / length, w / length
    matrix = np.eye(4)
    matrix[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    matrix[:3, :3] *= _numbers(node.get("scale", [1, 1, 1]), 3, f"{here}: scale")
    matrix[:3, 3] = _numbers(node.get("translation", [0, 0, 0]), 3, f"{here}: translation")
    return matrix


def _bind_pose(
    gltf: GltfFile, skin_index: Any, world: dict[int, Placement], node: int
) -> Placement:
    skin = gltf.item("skins", skin_index, f"node {node}")
    joints = skin.get("joints")
    if not isinstance(joints, list) or not joints:
        raise MeshFileError(f"{gltf.path}: skin {skin_index} has no joints")
    gltf.item("nodes", joints[0], f"skin {skin_index}: joints")
    matrix = world[joints[0]]
    if "inverseBindMatrices" in skin:
        where = f"skin {skin_index}: inverseBindMatrices"
        with np.errstate(over="ignore", invalid="ignore"):
            matrix = matrix @ read_matrices(gltf, skin["inverseBindMatrices"], where)[0]
    return matrix


def _numbers(value: Any, count: int, here: str) -> FloatArray:
    fits = (
        isinstance(value, list)
        and len(value) == count
        and all(isinstance(each, (int, float)) and not isinstance(each, bool) for each in value)
        and all(abs(each) <= LARGEST for each in value)  # NaN is not
    )
    if not fits:
        raise MeshFileError(
            f"{here} is {value!r:.200}; it must be {count} numbers within ±{LARGEST:g}"
        )
    return np.array(value, dtype=np.float64)
