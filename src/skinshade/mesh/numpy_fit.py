"""Fit of the shape operator by NumPy: the twin of compiled_fit.py."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import FloatArray, FloatRows, FloatVector, IntArray, dot, unit_vectors
from .normals import tangent_frame
from .tensors import SYMMETRIC, apply_symmetric, tensor_to_world
from .topology import Neighbours, corner_areas, used_vertices, weld

__all__ = ["NumpyFit"]

BLOCK = 1 << 13
"""Vertices or faces in a block, whose data fit in a cache."""
FIT_RIDGE = 1e-9
"""Relative ridge, which keeps the fit solvable at a vertex with parallel edges only."""
LEAST_SQUARE = 8.0 * float(np.finfo(np.float64).tiny)
"""Least divisor: the square of a change of normal, which is up to 4, divided by it is finite."""


@dataclass(frozen=True)
class NumpyFit:
    """Bounded fit of the shape operator at the points of a surface, by NumPy. Create it with `of`.

    Attributes
    ----------
    normals
        (V, 3) unit normals of the vertices.
    group
        (V,) index of the point at each vertex.
    points, faces
        (P, 3) positions of the points, and (F, 3) their indices.
    outward
        (P, 3) unit normals of the points.
    fitted
        (P, 3) k_uu, k_uv, k_vv of the fit in the tangent frame of `outward`, bounded, without smoothing.
    bounded
        (P,) whether a bound reduced the fit.
    """

    normals: FloatArray
    group: IntArray
    points: FloatArray
    faces: IntArray
    outward: FloatArray
    fitted: FloatArray
    bounded: NDArray[np.bool_]

    @classmethod
    def of(cls, p: FloatArray, f: IntArray, normals: FloatArray, bounds: FloatVector) -> NumpyFit:
        """Return the fit to a checked mesh with unit normals.

        `bounds` (3,) are the greatest principal curvature relative to the greatest turn per length, its
        greatest product with the shortest edge, and the length as which shorter edges count.
        """
        group, first = weld(p)
        points, triangles = p[first], group[f]
        outward = _point_normals(normals, f, group, first.size)
        fitted, bounded = _fit(points, triangles, outward, bounds)
        return cls(normals, group, points, triangles, outward, fitted, bounded)

    def mean(self, passes: int) -> FloatVector:
        """Return the mean curvature (V,) after smoothing."""
        mean = 0.5 * (self.fitted[:, 0] + self.fitted[:, 2])
        return self._smoothed(mean[:, None], passes)[:, 0][self.group]

    def tensor(self, passes: int) -> FloatRows:
        """Return k_uu, k_uv, k_vv (V, 3) in the tangent frames of the vertices, after smoothing."""
        world = tensor_to_world(self.fitted, self.outward)
        world = self._smoothed(world, passes)[self.group]
        u, v = tangent_frame(self.normals)
        su, sv = apply_symmetric(world, u), apply_symmetric(world, v)
        return np.stack([dot(su, u), dot(su, v), dot(sv, v)], axis=1)

    def _smoothed(self, values: FloatArray, passes: int) -> FloatArray:
        return _smoothed(values, self.points, self.faces, passes)


def _point_normals(normals: FloatArray, faces: IntArray, group: IntArray, count: int) -> FloatArray:
    """Return unit normals (P, 3) of points: the sum over the vertices that faces use."""
    if count == normals.shape[0]:
        welded = np.empty_like(normals)
        welded[group] = normals
        return welded
    used = used_vertices(faces, len(normals))
    if not used.all():
        normals, group = normals[used], group[used]
    sums = [np.bincount(group, normals[:, axis], count) for axis in range(3)]
    return unit_vectors(np.stack(sums, axis=1))


def _fit(
    p: FloatArray, faces: IntArray, normals: FloatArray, bounds: FloatVector
) -> tuple[FloatArray, NDArray[np.bool_]]:
    """Fit S·edge = change of normal in the tangent plane of every point, with weights 1/edge²."""
    count = p.shape[0]
    neighbours = Neighbours.of(faces, count)
    points = [np.ascontiguousarray(axis) for axis in p.T]
    outward = [np.ascontiguousarray(axis) for axis in normals.T]
    tensor, bounded = np.empty((3, count)), np.empty(count, dtype=bool)

    def fit(first: int) -> None:
        last = min(first + BLOCK, count)
        block = neighbours.block(first, last)
        step = [block.differences(axis) for axis in points]
        turn = [block.differences(axis) for axis in outward]
        square = step[0] ** 2 + step[1] ** 2 + step[2] ** 2
        weight = 1.0 / np.maximum(square, LEAST_SQUARE)
        fitted = _fit_block(block, step, turn, weight, normals[first:last])
        if not square.all():
            weight[square == 0.0] = 0.0
        limit = _limits(block, turn, weight, bounds)
        tensor[:, first:last], bounded[first:last] = _bounded(fitted, limit)

    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        list(pool.map(fit, range(0, count, BLOCK)))
    return tensor.T, bounded


def _fit_block(
    block: Neighbours,
    step: list[FloatArray],
    turn: list[FloatArray],
    weight: FloatArray,
    normals: FloatArray,
) -> FloatArray:
    """Return k_uu, k_uv, k_vv (3, N) of the points of a block, from edges of a weight (E,)."""
    weighted = [weight * axis for axis in step]
    # Both moments are summed in world axes and then converted to the frame of the vertex: a third of the
    # work of converting every edge. Their columns are contiguous.
    spread, response = (np.empty((6, len(normals))).T for _ in range(2))
    for entry, (i, j) in enumerate(SYMMETRIC):
        spread[:, entry] = block.sums(weighted[i] * step[j])
        product = weighted[i] * turn[j] + weighted[j] * turn[i]
        response[:, entry] = 0.5 * block.sums(product)
    u, v = tangent_frame(normals)
    along_u, along_v = apply_symmetric(spread, u), apply_symmetric(spread, v)
    xx, xy, yy = dot(along_u, u), dot(along_u, v), dot(along_v, v)
    along_u, along_v = apply_symmetric(response, u), apply_symmetric(response, v)
    a, b, c = dot(along_u, u), 2.0 * dot(along_u, v), dot(along_v, v)
    # [[xx, xy, 0], [xy, xx+yy, xy], [0, xy, yy]] · (k_uu, k_uv, k_vv) = (a, b, c), by Cramer's rule
    total = xx + yy
    ridge = FIT_RIDGE * total + np.finfo(np.float64).tiny
    xx, yy, middle = xx + ridge, yy + ridge, total + ridge
    determinant = xx * middle * yy - xy * xy * (xx + yy)
    # The curvature of a vertex without edges is 0.
    determinant = np.where(determinant > 0.0, determinant, np.inf)
    k_uu = (a * (middle * yy - xy * xy) - xy * (b * yy - xy * c)) / determinant
    k_uv = (xx * (b * yy - xy * c) - xy * a * yy) / determinant
    k_vv = (c * (xx * middle - xy * xy) - xy * (xx * b - xy * a)) / determinant
    return np.stack([k_uu, k_uv, k_vv])


def _limits(
    block: Neighbours, turn: list[FloatArray], weight: FloatArray, bounds: FloatVector
) -> FloatArray:
    """Return the greatest principal curvature (N,) that the edges of each point resolve.

    Parameters
    ----------
    block
        Edges of the points.
    turn
        Change of normal (E,) along the edges, one array per axis.
    weight
        (E,) 1/edge²; 0 for edges without length.
    bounds
        (3,) as in `NumpyFit.of`.
    """
    square = turn[0] ** 2 + turn[1] ** 2 + turn[2] ** 2
    square *= weight
    steepest = np.sqrt(block.greatest(square))
    shortest = 1.0 / np.sqrt(np.maximum(block.greatest(weight), LEAST_SQUARE))
    conditioning, resolved_turn, least_length = bounds
    return np.minimum(conditioning * steepest, resolved_turn / np.maximum(shortest, least_length))


def _bounded(fitted: FloatArray, limit: FloatArray) -> tuple[FloatArray, NDArray[np.bool_]]:
    """Return tensors (3, N) whose principal curvatures are within limits (N,), and which were reduced.

    A tensor is scaled as a whole, which keeps its directions and signs.
    """
    k_uu, k_uv, k_vv = fitted
    greatest = 0.5 * np.abs(k_uu + k_vv) + np.hypot(0.5 * (k_uu - k_vv), k_uv)
    exceeds: NDArray[np.bool_] = np.asarray(greatest > limit)
    if exceeds.any():
        fitted = fitted * np.where(exceeds, limit / np.where(exceeds, greatest, 1.0), 1.0)
    return fitted, exceeds


def _smoothed(values: FloatArray, p: FloatArray, faces: IntArray, passes: int) -> FloatArray:
    if passes == 0:
        return values
    count = p.shape[0]
    area = corner_areas(p, faces, count)
    corners = [np.ascontiguousarray(column) for column in faces.T]
    uses = np.maximum(np.bincount(faces.ravel(), minlength=count), 1)
    result = values.copy()
    mean = np.empty(len(faces))

    def average(first: int, value: FloatArray) -> None:
        part = slice(first, first + BLOCK)
        vertices = [column[part] for column in corners]
        shares = [area[column] for column in vertices]
        total = np.maximum(shares[0] + shares[1] + shares[2], np.finfo(np.float64).tiny)
        a, b, c = (share * value[column] for share, column in zip(shares, vertices, strict=True))
        mean[part] = (a + b + c) / total

    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        for _ in range(passes):
            for column in range(values.shape[1]):
                value = np.ascontiguousarray(result[:, column])
                list(pool.map(partial(average, value=value), range(0, len(faces), BLOCK)))
                a, b, c = (np.bincount(corner, mean, count) for corner in corners)
                result[:, column] = (a + b + c) / uses
    return result
