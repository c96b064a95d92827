"""Topology of meshes: welding by position, edges, neighbours, areas."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import FloatArray, IntArray
from . import compiled

__all__ = [
    "Neighbours",
    "corner_areas",
    "edge_counts",
    "face_areas",
    "face_normals",
    "half_edges",
    "open_edge_counts",
    "used_vertices",
    "weld",
]

BLOCK = 1 << 14
"""Faces in a block, whose data fit in a cache."""
Index = TypeVar("Index", np.int32, np.int64)


def weld(positions: FloatArray) -> tuple[IntArray, IntArray]:
    """Group vertices at equal positions, such as those on both sides of a UV seam.

    Returns
    -------
    group, first
        (V,) groups of the vertices, and (G,) the first vertex of every group.
    """
    if compiled.serves(positions):
        return compiled.weld(positions)
    # Sorting one irrational combination of the coordinates finds equal positions; the check that follows
    # ensures that different positions have not the same combination.
    mixed = positions @ np.array([1.0, np.sqrt(2.0), np.pi])
    _, first, group = np.unique(mixed, return_index=True, return_inverse=True)
    if not np.array_equal(positions[first[group]], positions):
        _, first, group = np.unique(positions, axis=0, return_index=True, return_inverse=True)
    return group.astype(np.int64).ravel(), first.astype(np.int64)


def half_edges(faces: NDArray[Index]) -> tuple[NDArray[Index], NDArray[Index]]:
    """Return both ends (3F,), (3F,) of the sides of the faces; an inner edge occurs in both directions."""
    return faces.ravel(), faces[:, [1, 2, 0]].ravel()


def used_vertices(faces: IntArray, count: int) -> NDArray[np.bool_]:
    """Return which of `count` vertices (V,) a face uses."""
    if compiled.serves(faces):
        return compiled.used_vertices(faces, count)
    used = np.zeros(count, dtype=bool)
    used[faces] = True
    return used


@dataclass(frozen=True)
class Neighbours:
    """Edges of every vertex, in one table. An edge occurs at both its ends, with half a share per face.

    Attributes
    ----------
    starts
        (V + 1,) index of the first edge of every vertex.
    ends
        (E,) other ends of the edges.
    shares
        (E,) weights of the edges, or None if all edges have two faces.
    first
        Index of the first vertex; not 0 in a block of a larger mesh.
    """

    starts: NDArray[np.int32]
    ends: NDArray[np.int32]
    shares: FloatArray | None
    first: int = 0

    @classmethod
    def of(cls, faces: IntArray, count: int) -> Neighbours:
        """Return the neighbours of `count` vertices."""
        from scipy import sparse  # costs .1 s, and the compiled kernels need no matrix

        alone = _perhaps_alone(*half_edges(faces), count)
        one, other = half_edges(faces.astype(np.int32))
        shares = np.ones(one.size)
        if alone.size:
            # Sides between two faces occur once from both ends; the others are added from the other end.
            shares[alone] = 0.5
            one, other = np.append(one, other[alone]), np.append(other, one[alone])
            shares = np.append(shares, shares[alone])
        table = sparse.coo_array((shares, (one, other)), shape=(count, count)).tocsr()
        uneven = bool((table.data != 1.0).any())
        return cls(table.indptr, table.indices, table.data if uneven else None)

    def block(self, first: int, last: int) -> Neighbours:
        """Return the edges of the vertices `first` to `last` − 1."""
        inside = slice(self.starts[first], self.starts[last])
        shares = None if self.shares is None else self.shares[inside]
        starts = self.starts[first : last + 1] - self.starts[first]
        return Neighbours(starts, self.ends[inside], shares, first)

    def differences(self, values: FloatArray) -> FloatArray:
        """Return the differences (E,) of values (V,) between the other end and the vertex."""
        own = values[self.first : self.first + self.starts.size - 1]
        return values[self.ends] - np.repeat(own, np.diff(self.starts))

    def sums(self, values: FloatArray) -> FloatArray:
        """Return the sums (V,) of values (E,) over the edges of every vertex."""
        starts, degree = self.starts[:-1], np.diff(self.starts)
        counted = values if self.shares is None else values * self.shares
        padded = np.append(counted, 0.0)
        result: FloatArray = np.add.reduceat(padded, starts)
        result[degree == 0] = 0.0
        return result

    def greatest(self, values: FloatArray) -> FloatArray:
        """Return the greatest (V,) of values (E,) ≥ 0 over the edges of every vertex; 0 without edges."""
        starts, degree = self.starts[:-1], np.diff(self.starts)
        result: FloatArray = np.maximum.reduceat(np.append(values, 0.0), starts)
        result[degree == 0] = 0.0
        return result


def _perhaps_alone(one: IntArray, other: IntArray, count: int) -> IntArray:
    """Return sides that include all sides without a partner in the other direction.

    Every vertex has a random number. Its sums over the ends of outgoing and incoming sides differ where
    sides are unpaired; sums of whole numbers below 2^53 are exact.
    """
    number = np.random.default_rng(1).integers(1, 1 << 40, count).astype(np.float64)
    outgoing = np.bincount(one, number[other], count)
    incoming = np.bincount(other, number[one], count)
    unpaired = outgoing != incoming
    if not unpaired.any():
        return np.zeros(0, dtype=np.int64)
    return np.flatnonzero(unpaired[one] & unpaired[other])


def face_areas(positions: FloatArray, faces: IntArray) -> FloatArray:
    """Return the areas (F,) of the faces, in the square of the positions' unit."""
    if compiled.serves(faces):
        return compiled.face_areas(positions, faces)
    axes = [np.ascontiguousarray(axis) for axis in positions.T]
    result = np.empty(len(faces))
    for first in range(0, len(faces), BLOCK):
        # One axis at a time: NumPy's cross product of rows takes three times as long.
        a, b, c = faces[first : first + BLOCK].T
        origin = [axis[a] for axis in axes]
        x, y, z = (axis[b] - start for axis, start in zip(axes, origin, strict=True))
        u, v, w = (axis[c] - start for axis, start in zip(axes, origin, strict=True))
        square = np.square(y * w - z * v) + np.square(z * u - x * w) + np.square(x * v - y * u)
        result[first : first + BLOCK] = 0.5 * np.sqrt(square)
    return result


def face_normals(positions: FloatArray, faces: IntArray) -> FloatArray:
    """Return the normals (F, 3) of faces, whose lengths are twice their areas."""
    p = positions[faces]
    return np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])


def corner_areas(positions: FloatArray, faces: IntArray, vertex_count: int) -> FloatArray:
    """Return a third of the area of the faces around every vertex (V,)."""
    if compiled.serves(faces):
        return compiled.corner_areas(positions, faces, vertex_count)
    thirds = np.repeat(face_areas(positions, faces) / 3.0, 3)
    return np.bincount(faces.ravel(), thirds, vertex_count).astype(np.float64)


def open_edge_counts(
    positions: FloatArray, faces: IntArray, welded: IntArray | None = None
) -> dict[str, int]:
    """Return counts of open edges, non-manifold edges, and edges of opposite winding, after welding.

    `welded` has the groups of `weld` at the corners (F, 3), if they are known.
    """
    if compiled.serves(positions, faces):
        return compiled.open_edge_counts(positions, faces)
    return edge_counts(weld(positions)[0][faces] if welded is None else welded)


def edge_counts(welded: IntArray) -> dict[str, int]:
    """Return the counts of `open_edge_counts` for faces (F, 3) whose corners are groups of `weld`."""
    start, end = half_edges(welded)
    low, high = np.minimum(start, end), np.maximum(start, end)
    keys = low * (int(welded.max()) + 1) + high
    order = np.argsort(keys)
    starts = np.flatnonzero(np.diff(keys[order], prepend=-1))
    count = np.diff(starts, append=keys.size)
    forward = np.add.reduceat((start < end)[order].astype(np.int64), starts)
    return {
        "open edges": int((count == 1).sum()),
        "non-manifold edges": int((count > 2).sum()),
        "edges of opposite winding": int(((count == 2) & (forward != 1)).sum()),
    }
