"""Compiled twin of the fit of the shape operator, for checked arrays."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .._core import native
from .._core.arrays import FloatArray, FloatRows, FloatVector, IntArray
from .._core.scratch import Scratch
from .compiled import own_normals, packed_points, unpacked, used_vertices
from .compiled_tables import Corners, Faces, Points, scratch_for

__all__ = ["CompiledFit", "mean_curvature"]

WORLD = 8
"""Numbers of a weighted tensor: xx, xy, xz, yy, yz, zz, area, filler."""


@dataclass(frozen=True)
class CompiledFit:
    """Bounded fit of the shape operator at the points of a welded mesh. Create it with `of`.

    Attributes
    ----------
    table
        Corners of the faces around every point.
    normals
        (V, 3) normals of the vertices of any length, or None if they are computed.
    points, outward
        (P, 3) positions and unit normals.
    areas
        (P,) third of the area of the faces around every point.
    fitted
        (P, 3) k_uu, k_uv, k_vv in the tangent frame of `outward`.
    bounded
        (P,) whether a bound reduced the fit.
    """

    table: Corners
    normals: Points | None
    points: FloatRows
    outward: FloatRows
    areas: FloatVector
    fitted: FloatRows
    bounded: NDArray[np.bool_]

    @classmethod
    def of(
        cls, points: Points, faces: Faces, normals: Points | None, bounds: FloatVector
    ) -> CompiledFit:
        """Return the fit to a mesh; `bounds` (3,) are those of fit.c."""
        scratch = scratch_for(points, faces)
        table = Corners.of(points, faces, scratch)
        areas, fitted = np.empty(table.count), np.empty((table.count, 3))
        bounded = np.empty(table.count, dtype=np.uint8)
        packed = packed_points(points, table, scratch)
        outward = _fit(packed, faces, normals, table, scratch, bounds, fitted, areas, bounded)
        return cls(table, normals, packed, outward, areas, fitted, bounded.view(np.bool_))

    @property
    def group(self) -> IntArray:
        """(V,) index of the point at each vertex."""
        if self.table.remap is None:
            return np.arange(self.table.count)
        return self.table.remap.astype(np.int64)

    def mean(self, passes: int) -> FloatVector:
        """Return the mean curvature (V,) after passes of smoothing."""
        mean = 0.5 * (self.fitted[:, 0] + self.fitted[:, 2])
        scratch = Scratch(32 * self.table.count)
        smoothed = _smoothed_mean(mean, self.areas, self.table, passes, scratch)
        return unpacked(smoothed, self.table.remap)

    def tensor(self, passes: int) -> FloatRows:
        """Return k_uu, k_uv, k_vv (V, 3) in the tangent frames of the vertices, after smoothing."""
        table = self.table
        scratch = Scratch(16 * WORLD * table.count)
        one, other = (scratch.take((table.count, WORLD)) for _ in range(2))
        weights = self.areas if passes else np.ones(table.count)
        arguments = (self.fitted, weights, self.outward, one)
        native.run("weigh_world", native.blocks(table.count), *arguments)
        for left in range(passes, 0, -1):
            native.run("smooth_world", table.slabs, one, *table.arguments, int(left == 1), other)
            one, other = other, one
        given = self.normals
        frames = (
            unpacked(self.outward, table.remap) if given is None else np.ascontiguousarray(given)
        )
        result = np.empty((len(frames), 3))
        ranges = native.blocks(len(frames))
        native.run("project", ranges, one, WORLD, frames, table.remap, result)
        return result


def mean_curvature(
    points: Points, faces: Faces, normals: Points | None, bounds: FloatVector, passes: int
) -> FloatVector:
    """Return what `CompiledFit.mean` returns, without memory for the tensors."""
    scratch = scratch_for(points, faces)
    table = Corners.of(points, faces, scratch)
    areas = scratch.take(table.count)
    values = np.empty(table.count) if table.remap is None else scratch.take(table.count)
    with scratch.temporary():
        packed = packed_points(points, table, scratch)
        _fit(packed, faces, normals, table, scratch, bounds, values, areas, None)
    smoothed, remap = _smoothed_mean(values, areas, table, passes, scratch), table.remap
    del table  # its memory is not needed together with the result
    return unpacked(smoothed, remap)


def _fit(
    packed: FloatRows,
    faces: Faces,
    normals: Points | None,
    table: Corners,
    scratch: Scratch,
    bounds: FloatVector,
    fitted: FloatArray,
    areas: FloatVector,
    bounded: NDArray[np.uint8] | None,
) -> FloatRows:
    """Write the fit, areas and which points a bound reduced, and return the normals (P, 3) of points."""
    outward: FloatRows
    if normals is None:
        outward = scratch.take((table.count, 3))
        own_normals(packed, table, outward, areas)
    else:
        outward = _point_normals(normals, faces, table, scratch)
    wanted = areas if normals is not None else None
    arguments = (packed, outward, *table.arguments, bounds, fitted, wanted, bounded)
    native.run("fit", table.slabs, *arguments)
    return outward


def _point_normals(normals: Points, faces: Faces, table: Corners, scratch: Scratch) -> FloatRows:
    """Return unit normals (P, 3) of points: the sums over the vertices that faces use."""
    normals = np.ascontiguousarray(normals)
    are_unit = _are_unit(normals)
    if table.sources is None and are_unit:
        return normals.astype(np.float64, copy=False)
    packed: FloatRows = scratch.take((table.count, 3))
    if table.count == len(normals):
        native.run(
            "pack", native.blocks(table.count), normals, table.sources, int(not are_unit), packed
        )
        return packed
    used = used_vertices(faces, len(normals)).view(np.uint8)
    bounds = native.parts(table.count)
    native.run("sum_normals", bounds, normals, used, table.remap, len(normals), packed)
    return packed


def _are_unit(normals: Points) -> bool:
    """Return whether vectors are float64 and have length 1 within rounding."""
    if normals.dtype != np.float64:
        return False
    return sum(native.run("count_not_unit", native.blocks(len(normals)), normals)) == 0


def _smoothed_mean(
    values: FloatVector, areas: FloatVector, table: Corners, passes: int, scratch: Scratch
) -> FloatVector:
    """Return values (P,) after passes of smoothing, in the memory of `values`."""
    if passes == 0:
        return values
    one, other = (scratch.take((table.count, 2)) for _ in range(2))
    native.run("weigh_mean", native.blocks(table.count), values, areas, one)
    for left in range(passes, 0, -1):
        result = values if left == 1 else other
        native.run("smooth_mean", table.slabs, one, *table.arguments, int(left == 1), result)
        one, other = other, one
    return values
