"""Who is whose neighbour: welding by position, edges, areas."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, IntArray, dot

__all__ = ["corner_areas", "face_areas", "half_edges", "open_edge_counts", "weld"]


def weld(positions: FloatArray) -> tuple[IntArray, IntArray]:
    """Group vertices that stand at the same position, as those on both sides of a UV seam do.

    Returns
    -------
    group, first
        (V,) group of each vertex, and (G,) one vertex of each group.
    """
    # One sort of an irrational mixture of the coordinates finds equal positions; the check after it
    # makes sure that no two different ones fell together.
    mixed = positions @ np.array([1.0, np.sqrt(2.0), np.pi])
    _, first, group = np.unique(mixed, return_index=True, return_inverse=True)
    if not np.array_equal(positions[first[group]], positions):
        _, first, group = np.unique(positions, axis=0, return_index=True, return_inverse=True)
    return group.astype(np.int64).ravel(), first.astype(np.int64)


def half_edges(faces: IntArray) -> tuple[IntArray, IntArray]:
    """Return both ends (3F,), (3F,) of every side of every face: an inner edge once each way."""
    return faces.ravel(), faces[:, [1, 2, 0]].ravel()


def face_areas(positions: FloatArray, faces: IntArray) -> FloatArray:
    """Return (F,) areas in the square of the positions' unit."""
    p = positions[faces]
    normal = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
    return 0.5 * np.sqrt(dot(normal, normal))


def corner_areas(positions: FloatArray, faces: IntArray, vertex_count: int) -> FloatArray:
    """Return (V,) a third of the area of the faces around each vertex."""
    thirds = np.repeat(face_areas(positions, faces) / 3.0, 3)
    return np.bincount(faces.ravel(), thirds, vertex_count).astype(np.float64)


def open_edge_counts(positions: FloatArray, faces: IntArray) -> dict[str, int]:
    """Count open and non-manifold edges and those whose faces disagree on winding, after welding."""
    group, _ = weld(positions)
    welded = group[faces]
    start, end = half_edges(welded)
    low, high = np.minimum(start, end), np.maximum(start, end)
    keys = low * positions.shape[0] + high
    order = np.argsort(keys)
    starts = np.flatnonzero(np.diff(keys[order], prepend=-1))
    count = np.diff(starts, append=keys.size)
    forward = np.add.reduceat((start < end)[order].astype(np.int64), starts)
    return {
        "open edges": int((count == 1).sum()),
        "non-manifold edges": int((count > 2).sum()),
        "edges of opposite winding": int(((count == 2) & (forward != 1)).sum()),
    }
