"""Corners of polygons: triangles of polygons and strips, and vertices from corners."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import FloatArray, IntArray

__all__ = ["fan_triangles", "first_of_equal_rows", "merged_corners", "strip_triangles"]

ODD = np.uint64(0x9E3779B97F4A7C15)
"""2^64 over the golden ratio, whose multiples spread evenly [Knuth1998, 6.4]."""


def fan_triangles(sizes: IntArray) -> IntArray:
    """Return the triangles (T, 3) of polygons as numbers of corners, fans around their first corners.

    A polygon of one or two corners gives one triangle without area.

    Parameters
    ----------
    sizes
        (P,) number of corners of every polygon, 1 or more. Corners are numbered through all polygons.
    """
    starts = np.cumsum(sizes) - sizes
    if (sizes == 3).all():
        return starts[:, None] + np.arange(3)
    counts = np.maximum(sizes - 2, 1)
    polygon = np.repeat(np.arange(sizes.size), counts)
    within = np.arange(polygon.size) - np.repeat(np.cumsum(counts) - counts, counts)
    first, last = starts[polygon], (starts + sizes - 1)[polygon]
    return np.stack(
        [first, np.minimum(first + within + 1, last), np.minimum(first + within + 2, last)], axis=1
    )


def strip_triangles(sizes: IntArray, values: IntArray) -> IntArray:
    """Return the triangles (T, 3) of triangle strips, without those that repeat a vertex.

    Parameters
    ----------
    sizes
        (S,) number of values of every strip.
    values
        (sum of sizes,) indices of vertices; −1 begins a new strip.
    """
    ended = np.full(values.size + sizes.size, -1, dtype=np.int64)  # −1 after every strip
    ended[np.arange(values.size) + np.repeat(np.arange(sizes.size), sizes)] = values
    restart = ended == -1
    numbers = np.arange(ended.size)
    begin = np.maximum.accumulate(np.where(restart, numbers + 1, 0))
    a, b, c = ended[:-2], ended[1:-1], ended[2:]
    reversed_ = ((numbers - begin)[:-2] % 2 == 1)[:, None]
    faces = np.where(reversed_, np.stack([a, c, b], axis=1), np.stack([a, b, c], axis=1))
    whole = ~(restart[:-2] | restart[1:-1] | restart[2:])
    return faces[whole & (a != b) & (b != c) & (c != a)]


def merged_corners(columns: Sequence[IntArray]) -> tuple[IntArray, IntArray]:
    """Merge corners that are equal in all columns.

    Parameters
    ----------
    columns
        (C,) each: indices of positions, >= 0, then any further indices.

    Returns
    -------
    kept, vertex
        (V,) the first corner of every vertex, in the order of positions, then of use; (C,) the vertex of
        every corner.
    """
    position = columns[0]
    count = position.size
    first = np.zeros(int(position.max(initial=-1)) + 1, dtype=np.int64)
    first[position[::-1]] = np.arange(count)[::-1]
    leader = first[position]
    differs = np.zeros(count, dtype=bool)
    for column in columns[1:]:
        differs |= column != column[leader]
    others = np.flatnonzero(differs)  # a position can have several normals and UVs; few have
    if others.size:
        rows = np.stack([column[others] for column in columns], axis=1)
        leader[others] = others[_first_of_equal(rows, np.lexsort(rows.T))]
    is_leader = np.zeros(count, dtype=bool)
    is_leader[leader] = True
    kept = np.flatnonzero(is_leader)
    kept = kept[np.argsort(position[kept], kind="stable")]
    vertex = np.zeros(count, dtype=np.int64)
    vertex[kept] = np.arange(kept.size)
    return kept, vertex[leader]


def first_of_equal_rows(rows: FloatArray) -> IntArray:
    """Return (N,) the index of the first row that equals each row (N, n); −0 equals 0."""
    bits = np.ascontiguousarray(rows + 0.0).view(np.uint64)
    mixed = np.zeros(len(bits), dtype=np.uint64)
    for column in bits.T:
        mixed = (mixed ^ column) * ODD
        mixed ^= mixed >> np.uint64(32)
    order = np.argsort(mixed, kind="stable")
    ordered = mixed[order]
    equal = np.flatnonzero(ordered[1:] == ordered[:-1])
    if not equal.size:
        return np.arange(len(bits))
    if not np.array_equal(bits[order[equal]], bits[order[equal + 1]]):
        order = np.lexsort(bits.T)  # some rows differ, but are mixed to the same number
    return _first_of_equal(bits, order)


def _first_of_equal(rows: NDArray[np.generic], order: IntArray) -> IntArray:
    """Return (N,) the index of the first row that equals each row.

    Parameters
    ----------
    rows
        (N, n).
    order
        (N,) a stable order of the rows, with equal ones side by side.
    """
    head = np.ones(order.size, dtype=bool)
    head[1:] = (rows[order[1:]] != rows[order[:-1]]).any(axis=1)
    result = np.empty(order.size, dtype=np.int64)
    result[order] = order[head][np.cumsum(head) - 1]
    return result
