"""Compiled hierarchy of boxes for rays: the twin of the one in `skinshade.mesh.rays`."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .._core import native
from .._core.arrays import FloatArray, FloatRows, FloatVector, IntArray
from .._core.scratch import Scratch
from . import compiled
from .ray_frame import RayFrame, RayHits

__all__ = ["CompiledHierarchy", "serves"]

NODE = 128
"""Bytes of a node of bvh.h."""
LEAF = 4
"""Most triangles of a leaf, as in bvh.h."""
CELL_BITS = 15
"""Bits of the cell of a triangle, as in bvh.c."""
MOST_FACES = 1 << 29
"""Limit of faces: leaves have places of 29 bits."""
EMPTY = 0x7FFFFFFF
"""Root of a hierarchy without faces."""
RAYS = 1 << 9
"""Least rays of a range: they take about a tenth of a millisecond."""
BLOCK = 8
"""Points whose rays are cast together, as in packet.h."""
BLOCKS = 1 << 3
"""Least blocks of a range."""


def serves(positions: FloatArray, faces: IntArray) -> bool:
    """Return whether the compiled kernels are in use and can work on as many vertices and faces."""
    return compiled.serves(positions, faces) and len(faces) < MOST_FACES


@dataclass(frozen=True)
class CompiledHierarchy:
    """Hierarchy of boxes with eight children per node, by the surface area heuristic [Wald2007].

    Results do not depend on the tree, and no ray passes between faces that share an edge [Woop2013].

    Attributes
    ----------
    frame
        Coordinates of the triangles.
    nodes
        (N, 128) nodes as in bvh.h.
    corners
        (F·9 + 4,) corners of the triangles, leaf by leaf.
    order
        (F,) indices of the faces in the order of `corners`.
    root
        Reference of the root.
    """

    frame: RayFrame
    nodes: NDArray[np.uint8]
    corners: FloatVector
    order: NDArray[np.uint32]
    root: int

    @classmethod
    def of(cls, positions: FloatArray, faces: IntArray) -> CompiledHierarchy:
        """Return the hierarchy of a mesh: positions (V, 3), faces (F, 3)."""
        frame = RayFrame.of(positions, faces)
        count = len(faces)
        # Kernels read the rows of four triangles at once, also of the last one.
        corners = Scratch(8 * (9 * count + LEAF)).take(9 * count + LEAF)
        corners[9 * count :] = 0.0
        order = np.empty(count, dtype=np.uint32)
        if not count:
            return cls(frame, np.empty((0, NODE), dtype=np.uint8), corners, order, EMPTY)
        points, faces = frame.points(positions), np.ascontiguousarray(faces)
        boxes = np.empty((count, 8), dtype=np.float32)
        entries = np.empty(count, dtype=np.uint64)
        native.run("bvh_boxes", native.blocks(count), points, faces, boxes, entries)
        entries, starts = _by_cell(entries)
        # Nodes of a subtree have eight children or only leaves: they are at most a quarter of the triangles.
        spaces = np.concatenate([[0], np.cumsum((np.diff(starts) + LEAF - 1) // LEAF)])
        cells = len(starts) - 1
        shape = int(spaces[-1]) + cells, NODE
        nodes = Scratch(shape[0] * NODE).take(shape, np.uint8)  # begins at a line of the cache
        leaves = np.empty(count, dtype=np.uint8)
        roots, cell_boxes = np.empty(cells, dtype=np.uint32), np.empty((cells, 8), dtype=np.float32)
        tables = boxes, entries, starts, spaces
        results = order, leaves, nodes, roots, cell_boxes
        native.run("bvh_subtrees", _even_ranges(starts), *tables, *results)
        root, cell_order = np.empty(1, dtype=np.uint32), np.empty(cells, dtype=np.uint32)
        top = int(spaces[-1]), cell_order, nodes, root
        native.run("bvh_top", [0, cells], cell_boxes, roots, *top)
        ranges = native.blocks(count)
        native.run("bvh_corners", ranges, points, faces, order, leaves, corners)
        return cls(frame, nodes, corners, order, int(root[0]))

    @property
    def _tree(self) -> tuple[NDArray[np.uint8], FloatVector, NDArray[np.uint32], int]:
        return self.nodes, self.corners, self.order, self.root

    def exit_distances(self, origins: FloatArray, directions: FloatArray) -> FloatVector:
        """Return the distance (N,) to the first face that a ray leaves through; infinite without one."""
        start, along = (
            self.frame.points(origins),
            np.ascontiguousarray(directions, dtype=np.float64),
        )
        distances = np.empty(len(start))
        ranges = native.blocks(len(start), RAYS)
        native.run("ray_exits", ranges, *self._tree, start, along, distances)
        return distances / self.frame.scale

    def nearest(self, origins: FloatArray, directions: FloatArray) -> RayHits:
        """Return the nearest faces on rays, from either side."""
        start, along = (
            self.frame.points(origins),
            np.ascontiguousarray(directions, dtype=np.float64),
        )
        count = len(start)
        distances, faces = np.empty(count), np.empty(count, dtype=np.int64)
        weights = np.empty((count, 3))
        ranges = native.blocks(count, RAYS)
        native.run("ray_hits", ranges, *self._tree, start, along, distances, faces, weights)
        return RayHits(distances / self.frame.scale, faces, weights)

    def occluded(
        self, origins: FloatArray, directions: FloatArray, distances: FloatArray
    ) -> NDArray[np.bool_]:
        """Return whether (N,) rays hit a face, from either side, within their distances (N,)."""
        start, along = (
            self.frame.points(origins),
            np.ascontiguousarray(directions, dtype=np.float64),
        )
        limits = np.asarray(distances, dtype=np.float64) * self.frame.scale
        limits = np.ascontiguousarray(np.broadcast_to(limits, len(start)))
        blocked = np.empty(len(start), dtype=np.uint8)
        ranges = native.blocks(len(start), RAYS)
        native.run("ray_blocks", ranges, *self._tree, start, along, limits, blocked)
        return blocked.view(np.bool_)

    def exit_sums(self, origins: FloatRows, normals: FloatRows, sets: FloatArray) -> FloatRows:
        """Return for points (P, 2) the sum of d·cos θ over the rays that leave the body, and their number.

        Parameters
        ----------
        origins, normals
            (P, 3) starts of rays, and unit normals. Successive points should be near each other.
        sets
            (S, R, 3) directions of rays: along both tangents of `tangent_frame`, and against the normal.
            Blocks of eight points take turns with the sets.
        """
        start, count = self.frame.points(origins), len(origins)
        sums = np.empty((count, 2))
        ranges = native.blocks(-(-count // BLOCK), BLOCKS)
        rays = np.ascontiguousarray(sets), len(sets), sets.shape[1]
        own = np.ascontiguousarray(normals)
        native.run("ray_sums", ranges, *self._tree, start, own, count, *rays, sums)
        sums[:, 0] /= self.frame.scale
        return sums


def _by_cell(
    entries: NDArray[np.uint64],
) -> tuple[NDArray[np.uint64], NDArray[np.int64]]:
    """Return entries sorted by cell, and the bounds of the cells that have any."""
    bounds = native.parts(len(entries))
    counts = np.zeros((len(bounds) - 1, 1 << CELL_BITS), dtype=np.uint32)
    native.run("radix_count", bounds, entries, 32, CELL_BITS, list(counts))
    sizes = counts.sum(axis=0, dtype=np.int64)
    ends = np.cumsum(counts.T.ravel(), dtype=np.uint64)
    places = np.concatenate([np.zeros(1, dtype=np.uint64), ends[:-1]])
    counts[...] = places.reshape(counts.T.shape).T
    ordered = np.empty_like(entries)
    native.run("radix_scatter", bounds, entries, 32, CELL_BITS, list(counts), ordered)
    return ordered, np.concatenate([[0], np.cumsum(sizes[sizes > 0])])


def _even_ranges(starts: NDArray[np.int64]) -> list[int]:
    """Return bounds of ranges of cells with about as many triangles in all of them."""
    wanted = native.blocks(int(starts[-1]))
    return sorted({0, *np.searchsorted(starts, wanted).tolist(), len(starts) - 1})
