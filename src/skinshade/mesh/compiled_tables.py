"""Compiled tables of meshes: groups of equal rows, an order that keeps neighbours near, corners."""

from __future__ import annotations

from dataclasses import dataclass
from math import prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._core import native
from .._core.scratch import Scratch

__all__ = ["Corners", "Faces", "Groups", "Points", "equal_rows", "is_disordered", "scratch_for"]

Points = NDArray[np.floating[Any]]
"""Rows of three float32 or float64."""
Faces = NDArray[np.integer[Any]]
"""Rows of three int32 or int64."""
Indices = NDArray[np.uint32]

BUCKET_ROWS = 1 << 11
"""Rows of a bucket of equal_rows: with its hash table it takes 32 KiB, as much as a first-level cache."""
SAMPLES = 1 << 10
"""Faces whose order is sampled; enough for a fraction of 1/8 to be certain within 1/30."""
NEAR = 1 << 14
"""Greatest distance of vertices that lie in a cache together: 16,384 positions and normals take 768 KiB."""
DISORDER = 1.0 / 8.0
"""Greatest fraction of distant steps in the faces of a mesh whose order is used as it is."""
LANES = 4
"""Vertices of a slab, as in kernels.h."""
ROWS_AHEAD = 8
"""Rows after the last one, which kernels read to fetch data ahead, as in fans.h."""
SLABS = 1 << 11
"""Least slabs of a range."""
AXIS_BITS = 8
"""Bits of every axis in the Morton codes of order.c."""
BLOCK_BITS = 12
"""Bits of the vertices whose faces are put together: 4096 positions and normals take 192 KiB."""


def scratch_for(points: Points, faces: Faces) -> Scratch:
    """Return memory for the analysis of a mesh; the corners of its vertices have a block of their own."""
    return Scratch(80 * len(points) + 24 * len(faces))


@dataclass(frozen=True)
class Groups:
    """Groups of equal rows, numbered by their first rows.

    Attributes
    ----------
    count
        Number of groups.
    group, first
        (n,) group of every row, and (count,) first row of every group; None where all rows differ.
    """

    count: int
    group: Indices | None
    first: Indices | None


def equal_rows(rows: Points | Faces, scratch: Scratch) -> Groups:
    """Return the groups of equal positions, or of faces with the same corners in the same order."""
    count = len(rows)
    match = scratch.take(count, np.uint32)
    with scratch.temporary():
        repeated = _matched(rows, match, scratch)
    if repeated == 0:
        scratch.give_back(match)
        return Groups(count, None, None)
    first = scratch.take(count, np.uint32)
    with scratch.temporary():
        numbers = scratch.take(count, np.uint32)
        ranges = native.blocks(count)
        firsts = np.cumsum([0, *native.run("equal_firsts", ranges, match)]).tolist()
        native.run("equal_number", ranges, match, firsts[:-1], numbers, first)
        native.run("equal_group", ranges, match, numbers, match)
    return Groups(firsts[-1], match, first[: firsts[-1]])


def _matched(rows: Points | Faces, match: Indices, scratch: Scratch) -> int:
    """Write the first equal row of every row, and return how many rows are not the first."""
    count = len(rows)
    bits = max(1, (count // BUCKET_ROWS).bit_length())
    bounds = native.parts(count)
    counts = np.zeros((len(bounds) - 1, 1 << bits), dtype=np.uint32)
    native.run("equal_count", bounds, rows, 64 - bits, list(counts))
    starts = _cursors(counts)
    entries = scratch.take(count, np.uint64)
    native.run("equal_scatter", bounds, rows, 64 - bits, list(counts), entries, match)
    largest = int(np.diff(starts).max(initial=0))
    buckets = native.blocks(1 << bits, 8)
    length = max(16, 1 << (2 * largest).bit_length())
    tables = scratch.take((len(buckets) - 1, length), np.uint32)
    return sum(native.run("equal_match", buckets, rows, entries, starts, list(tables), match))


@dataclass(frozen=True)
class Corners:
    """Corners of the faces around every vertex of a welded mesh, in an order that keeps neighbours near.

    Attributes
    ----------
    starts
        (S,) first row of every slab of four vertices.
    counts
        (G,) corners of every vertex.
    corners
        (R, 4, 2) next and previous vertex of every corner; a row has one corner of every vertex of a slab.
    remap, sources
        (V,) vertex of the welded mesh of every vertex, and (G,) first vertex of every welded vertex; None
        where they are the same.
    """

    starts: Indices
    counts: Indices
    corners: Indices
    remap: Indices | None
    sources: Indices | None

    @property
    def count(self) -> int:
        """Number of vertices of the welded mesh."""
        return len(self.counts)

    @property
    def slabs(self) -> list[int]:
        """Bounds of ranges of slabs."""
        return native.blocks(len(self.starts), SLABS)

    @property
    def arguments(self) -> tuple[Indices, Indices, Indices, int]:
        """Arguments of kernels that work on slabs."""
        return self.starts, self.counts, self.corners, self.count

    @classmethod
    def of(cls, points: Points, faces: Faces, scratch: Scratch) -> Corners:
        """Return the corners of a mesh after welding."""
        points, faces = np.ascontiguousarray(points), np.ascontiguousarray(faces)
        groups = equal_rows(points, scratch)
        remap, sources = groups.group, groups.first
        if not is_disordered(faces):
            return cls(*_corners(faces, remap, groups.count, scratch), remap, sources)
        remap, sources = _near_order(points, groups, scratch)
        with scratch.temporary():
            renumbered = _faces_by_block(faces, remap, groups.count, scratch)
            # The table outlives the faces: it gets memory of its own.
            table = _corners(renumbered, None, groups.count, Scratch(0))
        return cls(*table, remap, sources)


def is_disordered(faces: Faces) -> bool:
    """Return whether the corners of successive faces are often too far apart for a cache."""
    step = max(1, (len(faces) - 1) // SAMPLES)
    one, other = faces[: len(faces) - 1 : step], faces[1::step]
    far = sum(
        int((np.abs(after - before) > NEAR).sum())
        for before, after in (
            (one[:, 0], one[:, 1]),
            (one[:, 1], one[:, 2]),
            (one[:, 2], other[:, 0]),
        )
    )
    return far > DISORDER * 3 * len(one)


def _cursors(counts: Indices) -> Indices:
    """Replace counts (parts, buckets) by first places, and return the first place of every bucket."""
    ends = np.cumsum(counts.T.ravel(), dtype=np.uint64)
    places = np.concatenate([np.zeros(1, dtype=np.uint32), ends.astype(np.uint32)])
    counts[...] = places[:-1].reshape(counts.T.shape).T
    return np.ascontiguousarray(places[:: len(counts)])


def _near_order(points: Points, groups: Groups, scratch: Scratch) -> tuple[Indices, Indices]:
    """Return `remap` and `sources` of vertices sorted by the Morton codes of their positions."""
    ranks = scratch.take(groups.count, np.uint32)
    sources = scratch.take(groups.count, np.uint32)
    ranges = native.blocks(len(points))
    boxes = np.empty((len(ranges) - 1, 6))
    native.run("bounds", ranges, points, list(boxes))
    box = np.concatenate([boxes[:, :3].min(axis=0), boxes[:, 3:].max(axis=0)])
    with scratch.temporary():
        entries, other = (scratch.take(groups.count, np.uint64) for _ in range(2))
        bounds = native.parts(groups.count)
        native.run("order_keys", bounds, points, groups.first, box, entries)
        half = 3 * AXIS_BITS // 2
        for shift in (32, 32 + half):
            counts = np.zeros((len(bounds) - 1, 1 << half), dtype=np.uint32)
            native.run("radix_count", bounds, entries, shift, half, list(counts))
            _cursors(counts)
            native.run("radix_scatter", bounds, entries, shift, half, list(counts), other)
            entries, other = other, entries
        blocks = native.blocks(groups.count)
        native.run("order_ranks", blocks, entries, ranks)
        native.run("order_sources", blocks, entries, groups.first, sources)
    if groups.group is None:
        return ranks, sources
    native.run("look_up", ranges, ranks, groups.group)
    return groups.group, sources


def _faces_by_block(
    faces: Faces, remap: Indices, count: int, scratch: Scratch
) -> NDArray[np.int32]:
    """Return faces with new numbers of vertices, sorted by the block of their first vertex."""
    result = scratch.take((len(faces), 3), np.uint32)
    with scratch.temporary():
        renumbered = scratch.take((len(faces), 3), np.uint32)
        bounds = native.parts(len(faces))
        counts = np.zeros((len(bounds) - 1, (count >> BLOCK_BITS) + 1), dtype=np.uint32)
        native.run("faces_remap", bounds, faces, remap, BLOCK_BITS, renumbered, list(counts))
        _cursors(counts)
        native.run("faces_scatter", bounds, renumbered, BLOCK_BITS, list(counts), result)
    return result.view(np.int32)


def _corners(
    faces: Faces, remap: Indices | None, count: int, scratch: Scratch
) -> tuple[Indices, Indices, Indices]:
    """Return starts, counts and corners by a counting sort."""
    starts = scratch.take(-(-count // LANES), np.uint32)
    counts = scratch.take(count, np.uint32)
    with scratch.temporary():
        bounds = native.parts(len(faces))
        tables = scratch.take((len(bounds) - 1, count), np.uint32)
        native.run("corner_count", bounds, faces, remap, count, list(tables))
        ranges = native.blocks(len(starts), SLABS)
        sums = native.run("corner_sum", ranges, tables, len(tables), count, counts)
        rows = np.cumsum([0, *sums]).tolist()
        shape = (rows[-1] + ROWS_AHEAD, LANES, 2)
        corners = Scratch(4 * prod(shape)).take(shape, np.uint32)
        corners[rows[-1] :] = 0
        arguments = (tables, len(tables), count, counts, rows[:-1], starts, corners)
        native.run("corner_starts", ranges, *arguments)
        native.run("corner_fill", bounds, faces, remap, list(tables), corners)
    return starts, counts, corners
