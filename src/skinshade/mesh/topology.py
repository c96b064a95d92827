"""Who is whose neighbour: welding by position, edges, areas."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from .._core.arrays import FloatArray, IntArray

__all__ = ["Neighbours", "corner_areas", "face_areas", "half_edges", "open_edge_counts", "weld"]

BLOCK = 1 << 14
"""Faces at once: what they need stays in a cache."""
Index = TypeVar("Index", np.int32, np.int64)


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


def half_edges(faces: NDArray[Index]) -> tuple[NDArray[Index], NDArray[Index]]:
    """Return both ends (3F,), (3F,) of every side of every face: an inner edge once each way."""
    return faces.ravel(), faces[:, [1, 2, 0]].ravel()


@dataclass(frozen=True)
class Neighbours:
    """Who stands at the other end of the edges of each vertex, vertex by vertex.

    An edge counts at both its ends, half for each face beside it.

    Attributes
    ----------
    starts
        (V + 1,) where the edges of each vertex begin.
    ends
        (E,) the other end of each.
    shares
        (E,) how much each counts, or None where every one has two faces.
    first
        Number of the first vertex; not 0 in a block of a larger mesh.
    """

    starts: NDArray[np.int32]
    ends: NDArray[np.int32]
    shares: FloatArray | None
    first: int = 0

    @classmethod
    def of(cls, faces: IntArray, count: int) -> Neighbours:
        """Return the neighbours of each of a number of vertices."""
        alone = _perhaps_alone(*half_edges(faces), count)
        one, other = half_edges(faces.astype(np.int32))
        shares = np.ones(one.size)
        if alone.size:
            # Between two faces an edge is met once from each end; these are seen from both.
            shares[alone] = 0.5
            one, other = np.append(one, other[alone]), np.append(other, one[alone])
            shares = np.append(shares, shares[alone])
        table = sparse.coo_array((shares, (one, other)), shape=(count, count)).tocsr()
        uneven = bool((table.data != 1.0).any())
        return cls(table.indptr, table.indices, table.data if uneven else None)

    def block(self, first: int, last: int) -> Neighbours:
        """Return the edges of the vertices from first to last, the last one left out."""
        inside = slice(self.starts[first], self.starts[last])
        shares = None if self.shares is None else self.shares[inside]
        starts = self.starts[first : last + 1] - self.starts[first]
        return Neighbours(starts, self.ends[inside], shares, first)

    def differences(self, values: FloatArray) -> FloatArray:
        """Return (E,) how much a value of the whole mesh (V,) is more at the other end."""
        here = values[self.first : self.first + self.starts.size - 1]
        return values[self.ends] - np.repeat(here, np.diff(self.starts))

    def sums(self, values: FloatArray) -> FloatArray:
        """Return (V,) sums of values (E,) over the edges of each vertex."""
        starts, degree = self.starts[:-1], np.diff(self.starts)
        counted = values if self.shares is None else values * self.shares
        padded = np.append(counted, 0.0)
        found: FloatArray = np.add.reduceat(padded, starts)
        found[degree == 0] = 0.0
        return found


def _perhaps_alone(one: IntArray, other: IntArray, count: int) -> IntArray:
    """Half-edges among which are all that have no partner the other way.

    A number for each vertex, summed over where its edges go and over where they come from, tells those
    apart whose edges do not pair: sums of whole numbers below 2^53 are exact.
    """
    number = np.random.default_rng(1).integers(1, 1 << 40, count).astype(np.float64)
    there = np.bincount(one, number[other], count)
    back = np.bincount(other, number[one], count)
    unpaired = there != back
    if not unpaired.any():
        return np.zeros(0, dtype=np.int64)
    return np.flatnonzero(unpaired[one] & unpaired[other])


def face_areas(positions: FloatArray, faces: IntArray) -> FloatArray:
    """Return (F,) areas in the square of the positions' unit."""
    axes = [np.ascontiguousarray(axis) for axis in positions.T]
    result = np.empty(len(faces))
    for first in range(0, len(faces), BLOCK):
        # An axis at a time: NumPy's cross product of rows takes three times as long.
        a, b, c = faces[first : first + BLOCK].T
        origin = [axis[a] for axis in axes]
        x, y, z = (axis[b] - start for axis, start in zip(axes, origin, strict=True))
        u, v, w = (axis[c] - start for axis, start in zip(axes, origin, strict=True))
        square = np.square(y * w - z * v) + np.square(z * u - x * w) + np.square(x * v - y * u)
        result[first : first + BLOCK] = 0.5 * np.sqrt(square)
    return result


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
