"""Rays of neighbouring vertices, put together over the faces of a mesh."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .._core import native
from .._core.arrays import FloatArray, FloatRows, IntArray
from . import compiled
from .compiled_tables import Corners, is_disordered, scratch_for
from .ray_frame import morton_codes
from .topology import weld

__all__ = ["RayPool", "near_order"]

LEAST_COUNT = np.finfo(np.float64).tiny
"""Least divisor of a mean without rays."""


def near_order(points: FloatArray, vertices: IntArray, faces: IntArray) -> IntArray:
    """Return the order (G,) of points in which neighbours are near each other.

    It is that of the vertices (G,) of a mesh whose faces have near vertices, else that of the positions.
    """
    if not is_disordered(faces):
        return np.argsort(vertices, kind="stable")
    return np.lexsort((vertices, morton_codes(points)))


@dataclass(frozen=True)
class RayPool:
    """Welded mesh over which sums of rays are smoothed.

    Attributes
    ----------
    group
        (V,) welded vertex of every vertex.
    sources
        (G,) a vertex of every welded one.
    corners
        Faces around the welded vertices; None for NumPy.
    faces
        (F, 3) welded vertices of the faces, for NumPy.
    """

    group: IntArray
    sources: IntArray
    corners: Corners | None
    faces: IntArray

    @classmethod
    def of(cls, positions: FloatArray, faces: IntArray) -> RayPool:
        """Return the pool of a mesh: positions (V, 3), faces (F, 3)."""
        if not compiled.serves(positions, faces):
            group, first = weld(positions)
            return cls(group, first, None, group[faces])
        table = Corners.of(positions, faces, scratch_for(positions, faces))
        same = np.arange(len(positions))
        group = same if table.remap is None else table.remap.astype(np.int64)
        sources = same if table.sources is None else table.sources.astype(np.int64)
        return cls(group, sources, table, faces)

    def smoothed(self, sums: FloatRows, passes: int) -> FloatRows:
        """Return sums of values and numbers of rays (G, 2) with values that neighbours share.

        In a pass, the value of a vertex becomes the mean over the faces around it of the mean of all rays
        of the corners of a face. The numbers of rays stay.
        """
        sums = np.ascontiguousarray(sums)
        for _ in range(passes):
            if self.corners is None:
                sums = self._pass(sums)
                continue
            result = np.empty_like(sums)
            slabs, table = self.corners.slabs, self.corners.arguments
            native.run("smooth_mean", slabs, sums, *table, 0, result)
            sums = result
        return sums

    def none_near(self, marked: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Return whether (G,) a vertex is not marked (G,), nor the other corners of its faces."""
        shares = np.stack([marked, np.ones(len(marked))], axis=1)
        free: NDArray[np.bool_] = (self.smoothed(shares, 1)[:, 0] <= 0.0) & ~marked
        return free

    def _pass(self, sums: FloatRows) -> FloatRows:
        around = sums[self.faces].sum(axis=1)
        mean = np.repeat(around[:, 0] / np.maximum(around[:, 1], LEAST_COUNT), 3)
        corners = self.faces.ravel()
        uses = np.maximum(np.bincount(corners, minlength=len(sums)), 1)
        value = np.bincount(corners, mean, len(sums)) / uses
        return np.stack([value * sums[:, 1], sums[:, 1]], axis=1)
