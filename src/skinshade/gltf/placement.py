"""Placement of meshes in a glTF scene; a skinned mesh is placed by its skin, in the bind pose."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .._core.arrays import FloatArray
from .._core.errors import MeshFileError
from .accessors import read_matrices
from .document import GltfDocument

__all__ = ["Placement", "SkippedNode", "mesh_placements", "scale_of"]

UNEVEN = 1.001
"""Greatest ratio of the lengths of axes that counts as a uniform scale."""
LARGEST = 1e12
"""Greatest translation, m, and greatest scale of a node."""
SCALES = (1e-9, 1e9)
"""Usable scales of a node with its ancestors: a head in metres is between the sizes of an atom and of
the orbit of the Moon."""


@dataclass(frozen=True)
class SkippedNode:
    """Node whose matrix shrinks its mesh to nothing, or is not finite.

    Attributes
    ----------
    note
        Name of the count of such nodes.
    reason
        Reason, for an error message that begins with the file and the mesh.
    """

    note: str
    reason: str


@dataclass(frozen=True)
class Placement:
    """Nodes that show a mesh.

    Attributes
    ----------
    matrices
        (4, 4) from the mesh's axes to the scene's, of every node with a usable scale.
    skipped
        Other nodes.
    """

    matrices: list[FloatArray] = field(default_factory=list)
    skipped: list[SkippedNode] = field(default_factory=list)


def mesh_placements(gltf: GltfDocument, *, visible_only: bool = False) -> dict[int, Placement]:
    """Return the placement of every mesh that a node refers to, by the index of the mesh.

    The joints of a skin place its mesh; the transform of the node itself does not apply.

    Parameters
    ----------
    gltf
        Document.
    visible_only
        Leave out nodes that the default scene does not show.

    Raises
    ------
    MeshFileError
        If nodes form a cycle, or a node is malformed.
    """
    nodes = gltf.items("nodes")
    world = _world_matrices(gltf, nodes)
    visible = _visible_nodes(gltf) if visible_only else set(range(len(nodes)))
    placements: dict[int, Placement] = {}
    for index, node in enumerate(nodes):
        if "mesh" not in node:
            continue
        gltf.item("meshes", node["mesh"], f"node {index}")
        matrix = world[index]
        if "skin" in node:
            matrix = _bind_pose(gltf, node["skin"], world, index)
        if index not in visible:
            continue
        placement = placements.setdefault(node["mesh"], Placement())
        skipped = _skipped(matrix, index)
        if skipped is None:
            placement.matrices.append(matrix)
        else:
            placement.skipped.append(skipped)
    return placements


def _skipped(matrix: FloatArray, index: int) -> SkippedNode | None:
    """Return why the matrix of a node cannot place a mesh, or None if it can."""
    if not np.isfinite(matrix).all():
        reason = f"the matrix of node {index} is not finite"
        return SkippedNode("meshes of infinite scale skipped", reason)
    scale, _ = scale_of(matrix)
    least, greatest = SCALES
    if least < scale < greatest:
        return None
    return SkippedNode(
        f"meshes of {'scale 0' if scale <= least else 'infinite scale'} skipped",
        f"its node scales it by {scale:g}; give it a scale within {least:g} to {greatest:g}",
    )


def scale_of(matrix: FloatArray) -> tuple[float, bool]:
    """Return the factor by which a matrix scales lengths, and whether it is the same in all directions."""
    lengths = np.linalg.svd(matrix[:3, :3], compute_uv=False)
    with np.errstate(over="ignore"):
        mean = float(np.cbrt(np.prod(lengths)))
    if abs(mean - 1.0) < 1e-6:  # a rotation in single precision
        mean = 1.0
    return mean, bool(lengths[0] <= UNEVEN * lengths[-1])


def _visible_nodes(gltf: GltfDocument) -> set[int]:
    """Return the nodes of the default scene; all nodes if there is none."""
    scenes, nodes = gltf.items("scenes"), gltf.items("nodes")
    if not scenes:
        return set(range(len(nodes)))
    scene = gltf.item("scenes", gltf.json.get("scene", 0), "scene")
    roots = scene.get("nodes", [])
    if not isinstance(roots, list):
        raise MeshFileError(f"{gltf.path}: scene: nodes is not an array")
    visible: set[int] = set()
    waiting = list(roots)
    while waiting:
        index = waiting.pop()
        node = gltf.item("nodes", index, "scene: nodes")
        if index not in visible:
            visible.add(index)
            waiting += node.get("children", [])
    return visible


def _world_matrices(gltf: GltfDocument, nodes: list[dict[str, Any]]) -> dict[int, FloatArray]:
    parents = _parents(gltf, nodes)
    local = [_local_matrix(gltf, node, index) for index, node in enumerate(nodes)]
    world: dict[int, FloatArray] = {}
    for index in range(len(nodes)):
        chain: list[int] = []
        ancestor: int | None = index
        while ancestor is not None and ancestor not in world:
            chain.append(ancestor)
            if len(chain) > len(nodes):
                raise MeshFileError(f"{gltf.path}: node {index} is its own ancestor")
            ancestor = parents.get(ancestor)
        matrix = np.eye(4) if ancestor is None else world[ancestor]
        for descendant in reversed(chain):
            with np.errstate(over="ignore", invalid="ignore"):  # the result is checked
                matrix = matrix @ local[descendant]
            world[descendant] = matrix
    return world


def _parents(gltf: GltfDocument, nodes: list[dict[str, Any]]) -> dict[int, int]:
    parents: dict[int, int] = {}
    for index, node in enumerate(nodes):
        children = node.get("children", [])
        if not isinstance(children, list):
            raise MeshFileError(f"{gltf.path}: node {index}: children is not an array")
        for child in children:
            gltf.item("nodes", child, f"node {index}: children")
            if child in parents:
                raise MeshFileError(f"{gltf.path}: node {child} has two parents")
            parents[child] = index
    return parents


def _local_matrix(gltf: GltfDocument, node: dict[str, Any], index: int) -> FloatArray:
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
    gltf: GltfDocument, skin_index: Any, world: dict[int, FloatArray], node: int
) -> FloatArray:
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
    valid = (
        isinstance(value, list)
        and len(value) == count
        and all(isinstance(n, (int, float)) and not isinstance(n, bool) for n in value)
        and all(abs(n) <= LARGEST for n in value)  # false for NaN
    )
    if not valid:
        raise MeshFileError(
            f"{here} is {value!r:.200}; it must be {count} numbers within ±{LARGEST:g}"
        )
    return np.array(value, dtype=np.float64)
