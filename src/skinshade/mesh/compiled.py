"""Compiled mesh analysis: the twins of the NumPy functions of this folder, for checked arrays."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .._core import native
from .._core.arrays import FloatArray, FloatRows, FloatVector, IntArray
from .._core.scratch import Scratch
from .compiled_tables import Corners, Faces, Points, equal_rows, scratch_for

__all__ = [
    "corner_areas",
    "face_areas",
    "first_of_equal",
    "open_edge_counts",
    "own_normals",
    "packed_points",
    "serves",
    "side_squares",
    "unpacked",
    "used_vertices",
    "uv_log_scale",
    "vertex_normals",
    "weld",
]

MOST_ROWS = (1 << 32) // 12
"""Limit of vertices and faces: entries of compiled tables have indices of 32 bits."""
EQUAL_ROWS_BYTES = 24
"""Bytes per row that the search for equal rows takes."""
UV_BLOCK = 512
"""Faces of a block of uv_scale.c."""


def serves(*rows: NDArray[np.generic]) -> bool:
    """Return whether the compiled functions are in use and can work on as many vertices and faces.

    A slab of four vertices has as many rows as its vertex of most faces, which makes 12 entries per face at
    most.
    """
    return native.available() and max(map(len, rows)) < MOST_ROWS


def weld(points: Points) -> tuple[IntArray, IntArray]:
    """Return groups and first vertices as `skinshade.mesh.topology.weld`, numbered by first vertices."""
    groups = equal_rows(np.ascontiguousarray(points), Scratch(EQUAL_ROWS_BYTES * len(points)))
    if groups.group is None or groups.first is None:
        return np.arange(groups.count), np.arange(groups.count)
    return groups.group.astype(np.int64), groups.first.astype(np.int64)


def first_of_equal(faces: Faces) -> IntArray:
    """Return the increasing indices of the first of every set of equal faces."""
    groups = equal_rows(np.ascontiguousarray(faces), Scratch(EQUAL_ROWS_BYTES * len(faces)))
    return np.arange(groups.count) if groups.first is None else groups.first.astype(np.int64)


def used_vertices(faces: Faces, count: int) -> NDArray[np.bool_]:
    """Return which of `count` vertices (V,) a face uses."""
    used = np.zeros(count, dtype=np.uint8)
    native.run("mark_used", native.blocks(len(faces)), np.ascontiguousarray(faces), used)
    return used.view(np.bool_)


def face_areas(points: Points, faces: Faces) -> FloatVector:
    """Return the areas (F,) of the faces."""
    areas = np.empty(len(faces))
    rows, corners = np.ascontiguousarray(points), np.ascontiguousarray(faces)
    native.run("face_areas", native.blocks(len(faces)), rows, corners, areas)
    return areas


def corner_areas(points: Points, faces: Faces, count: int) -> FloatVector:
    """Return a third of the area of the faces around every vertex (V,)."""
    sums = np.zeros(count)
    areas, corners = face_areas(points, faces), np.ascontiguousarray(faces)
    native.run("add_thirds", native.parts(count), areas, corners, len(faces), sums)
    return sums


def side_squares(points: Points, faces: Faces, step: int) -> FloatVector:
    """Return the squares of the lengths of the sides of every `step`th face."""
    count = -(-len(faces) // step)
    squares = np.empty(3 * count)
    rows, corners = np.ascontiguousarray(points), np.ascontiguousarray(faces)
    native.run("side_squares", native.blocks(count), rows, corners, step, squares)
    return squares


def open_edge_counts(points: Points, faces: Faces) -> dict[str, int]:
    """Return counts of open edges, non-manifold edges, and edges of opposite winding, after welding."""
    table = Corners.of(points, faces, scratch_for(points, faces))
    ranges = table.slabs
    faults = np.zeros((len(ranges) - 1, 3), dtype=np.int64)
    keys = np.empty((len(ranges) - 1, 2 * int(table.counts.max(initial=0))), dtype=np.uint32)
    native.run("edge_faults", ranges, *table.arguments, list(keys), list(faults))
    names = ("open edges", "non-manifold edges", "edges of opposite winding")
    return dict(zip(names, faults.sum(axis=0).tolist(), strict=True))


def vertex_normals(points: Points, faces: Faces) -> FloatRows:
    """Return unit normals (V, 3); vertices at one position have equal normals."""
    scratch = scratch_for(points, faces)
    table = Corners.of(points, faces, scratch)
    normals, areas = np.empty((table.count, 3)), scratch.take(table.count)
    own_normals(packed_points(points, table, scratch), table, normals, areas)
    return unpacked(normals, table.remap)


def uv_log_scale(points: Points, uvs: FloatArray, faces: Faces) -> float | None:
    """Return the logarithm of `skinshade.mesh_uv_scale`, or None if no face has an extent in both."""
    count = -(-len(faces) // UV_BLOCK)
    products = np.empty((count, 4))
    arguments = (points, uvs, faces)
    rows, coordinates, corners = (np.ascontiguousarray(array) for array in arguments)
    ranges = native.blocks(count, 32)
    native.run("uv_ratios", ranges, rows, coordinates, corners, len(faces), products)
    space, plane, exponent, usable = products.T
    if not usable.any():
        return None
    logs = np.log(space) - np.log(plane) + np.log(2.0) * exponent
    return float(0.5 * logs.sum() / usable.sum())


def packed_points(points: Points, table: Corners, scratch: Scratch) -> FloatRows:
    """Return the positions (P, 3) of the points of a welded mesh."""
    rows = np.ascontiguousarray(points)
    if table.sources is None and points.dtype == np.float64:
        return rows.astype(np.float64, copy=False)
    packed: FloatRows = scratch.take((table.count, 3))
    native.run("pack", native.blocks(table.count), rows, table.sources, 0, packed)
    return packed


def own_normals(packed: FloatRows, table: Corners, normals: FloatRows, areas: FloatVector) -> None:
    """Write unit normals (P, 3) of points, and a third of the area of the faces around them (P,)."""
    native.run("vertex_normals", table.slabs, packed, *table.arguments, normals, areas)


def unpacked(values: FloatArray, remap: NDArray[np.uint32] | None) -> FloatArray:
    """Return the rows (V, ...) of vertices from those (P, ...) of points."""
    if remap is None:
        return values
    result = np.empty((len(remap), *values.shape[1:]))
    columns = values.size // len(values)
    native.run("unpack", native.blocks(len(result)), values, columns, remap, result)
    return result
