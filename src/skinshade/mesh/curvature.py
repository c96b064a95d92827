"""Signed curvature per vertex: the shape operator from the change of normals along edges.

After [Rusinkiewicz2004], but fitted per vertex over its edges instead of per face and then averaged:
on random triangulations that halves the error, because an edge gives the curvature at its middle.
"""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import (
    FloatArray,
    IntArray,
    as_faces,
    as_floats,
    as_positions,
    dot,
    unit_vectors,
)
from .._core.errors import ArgumentError
from .normals import tangent_frame, vertex_normals
from .topology import Neighbours, corner_areas, half_edges, weld

__all__ = ["CurvatureMethod", "mesh_curvature", "mesh_curvature_tensor", "tensor_to_world"]

CurvatureMethod = Literal["shape-operator", "edges"]

SYMMETRIC = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))
"""Order in which the six numbers of a symmetric 3×3 tensor are kept."""
SYMMETRIC_ROWS = ((0, 1, 2), (1, 3, 4), (2, 4, 5))
"""Where the entries of a symmetric matrix stand among xx xy xz yy yz zz."""
BLOCK = 1 << 13
"""Vertices, or faces, worked on at once: what they need stays in a cache, however large the mesh."""
FIT_RIDGE = 1e-9
"""Relative; keeps the fit solvable at a vertex all of whose edges are parallel."""


def mesh_curvature(
    positions: ArrayLike,
    faces: ArrayLike,
    normals: ArrayLike | None = None,
    *,
    method: CurvatureMethod = "shape-operator",
    smoothing: int = 2,
) -> FloatArray:
    """Return the mean curvature of each vertex, positive where the surface is convex.

    Parameters
    ----------
    positions
        (V, 3) in any unit.
    faces
        (F, 3) indices.
    normals
        (V, 3) unit, outward; computed if not given.
    method
        ``shape-operator``, or ``edges`` for the unsigned figure of 2014.
    smoothing
        Passes of averaging with the neighbours, 0..100; noise in scanned normals needs two.

    Returns
    -------
    (V,)
        1 per unit of `positions`. Vertices at one position get one value. 2 % RMS on smooth shapes
        of which an edge spans a tenth of a radian, first order in the edge on random meshes.

    Raises
    ------
    ArgumentError
        If an array has a wrong shape, a value is not finite or an index out of range.
    """
    p, f, n = _checked(positions, faces, normals, smoothing)
    if method == "edges":
        return _edge_curvature(p, f, n, smoothing)
    if method != "shape-operator":
        raise ArgumentError(f"method is {method!r}; it must be shape-operator or edges")
    group, first = weld(p)
    welded, triangles, outward = p[first], group[f], _group_normals(n, group, first.size)
    xx, _, yy = _fit(welded, triangles, outward)
    mean = _smoothed(0.5 * (xx + yy)[:, None], welded, triangles, smoothing)[:, 0]
    return mean[group]


def mesh_curvature_tensor(
    positions: ArrayLike,
    faces: ArrayLike,
    normals: ArrayLike | None = None,
    *,
    smoothing: int = 2,
) -> FloatArray:
    """Return the shape operator of each vertex, three numbers in its tangent plane.

    Parameters
    ----------
    positions, faces, normals, smoothing
        As in `mesh_curvature`.

    Returns
    -------
    (V, 3)
        k_uu, k_uv, k_vv in the frame that `skinshade.mesh.normals.tangent_frame` gives for the
        vertex's normal; 1 per unit of `positions`, positive where convex. `tensor_to_world` turns
        them into what can be interpolated.
    """
    p, f, n = _checked(positions, faces, normals, smoothing)
    group, first = weld(p)
    outward = _group_normals(n, group, first.size)
    welded, triangles = p[first], group[f]
    world = _to_world(np.stack(_fit(welded, triangles, outward), axis=1), outward)
    world = _smoothed(world, welded, triangles, smoothing)[group]
    u, v = tangent_frame(n)
    su, sv = apply_symmetric(world, u), apply_symmetric(world, v)
    return np.stack([dot(su, u), dot(su, v), dot(sv, v)], axis=1)


def tensor_to_world(tensor: FloatArray, normals: FloatArray) -> FloatArray:
    """Return (..., 6) xx, xy, xz, yy, yz, zz of tensors (..., 3) at unit normals (..., 3)."""
    return _to_world(tensor, normals)


def apply_symmetric(world: FloatArray, vectors: FloatArray) -> FloatArray:
    """Return the tensors (..., 6) times vectors (..., 3)."""
    x, y, z = vectors[..., 0], vectors[..., 1], vectors[..., 2]
    return np.stack(
        [world[..., a] * x + world[..., b] * y + world[..., c] * z for a, b, c in SYMMETRIC_ROWS],
        axis=-1,
    )


def _checked(
    positions: ArrayLike, faces: ArrayLike, normals: ArrayLike | None, smoothing: int
) -> tuple[FloatArray, IntArray, FloatArray]:
    if not 0 <= smoothing <= 100:
        raise ArgumentError(f"smoothing is {smoothing}; it must be 0..100 passes")
    p = as_positions("positions", positions)
    if p.shape[0] == 0:
        raise ArgumentError("positions: there are no vertices")
    f = as_faces("faces", faces, p.shape[0])
    if f.shape[0] == 0:
        raise ArgumentError("faces: there are none")
    if normals is None:
        return p, f, vertex_normals(p, f)
    return p, f, unit_vectors(as_floats("normals", normals, p.shape))


def _group_normals(normals: FloatArray, group: IntArray, count: int) -> FloatArray:
    if count == normals.shape[0]:
        welded = np.empty_like(normals)
        welded[group] = normals
        return welded
    sums = [np.bincount(group, normals[:, axis], count) for axis in range(3)]
    return unit_vectors(np.stack(sums, axis=1))


def _fit(
    p: FloatArray, faces: IntArray, normals: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Least squares of S·edge = change of normal, in each vertex's tangent plane, weight 1/edge²."""
    count = p.shape[0]
    neighbours = Neighbours.of(faces, count)
    points = [np.ascontiguousarray(axis) for axis in p.T]
    outward = [np.ascontiguousarray(axis) for axis in normals.T]
    tensor = np.empty((3, count))

    def fit(first: int) -> None:
        last = min(first + BLOCK, count)
        block = neighbours.block(first, last)
        step = [block.differences(axis) for axis in points]
        turn = [block.differences(axis) for axis in outward]
        tensor[:, first:last] = _fit_block(block, step, turn, normals[first:last])

    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        list(pool.map(fit, range(0, count, BLOCK)))
    return tensor[0], tensor[1], tensor[2]


def _fit_block(
    block: Neighbours, step: list[FloatArray], turn: list[FloatArray], normals: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    weight = step[0] ** 2 + step[1] ** 2 + step[2] ** 2
    weight = 1.0 / np.maximum(weight, np.finfo(np.float64).tiny)
    weighted = [weight * axis for axis in step]
    # Both moments are summed in world axes and turned into each vertex's frame afterwards: a third of
    # the work of turning every edge. A column of each is in one piece.
    spread, response = (np.empty((6, len(normals))).T for _ in range(2))
    for entry, (i, j) in enumerate(SYMMETRIC):
        spread[:, entry] = block.sums(weighted[i] * step[j])
        each = weighted[i] * turn[j] + weighted[j] * turn[i]
        response[:, entry] = 0.5 * block.sums(each)
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
    # A vertex without an edge has no curvature.
    determinant = np.where(determinant > 0.0, determinant, np.inf)
    k_uu = (a * (middle * yy - xy * xy) - xy * (b * yy - xy * c)) / determinant
    k_uv = (xx * (b * yy - xy * c) - xy * a * yy) / determinant
    k_vv = (c * (xx * middle - xy * xy) - xy * (xx * b - xy * a)) / determinant
    return k_uu, k_uv, k_vv


def _to_world(tensor: FloatArray, normals: FloatArray) -> FloatArray:
    u, v = tangent_frame(normals)
    k_uu, k_uv, k_vv = tensor[..., 0], tensor[..., 1], tensor[..., 2]
    su = k_uu[..., None] * u + k_uv[..., None] * v
    sv = k_uv[..., None] * u + k_vv[..., None] * v
    return np.stack(
        [su[..., i] * u[..., j] + sv[..., i] * v[..., j] for i, j in SYMMETRIC], axis=-1
    )


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
        at = [column[part] for column in corners]
        shares = [area[column] for column in at]
        total = np.maximum(shares[0] + shares[1] + shares[2], np.finfo(np.float64).tiny)
        a, b, c = (share * value[column] for share, column in zip(shares, at, strict=True))
        mean[part] = (a + b + c) / total

    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        for _ in range(passes):
            for column in range(values.shape[1]):
                value = np.ascontiguousarray(result[:, column])
                list(pool.map(partial(average, value=value), range(0, len(faces), BLOCK)))
                a, b, c = (np.bincount(at, mean, count) for at in corners)
                result[:, column] = (a + b + c) / uses
    return result


def _edge_curvature(p: FloatArray, faces: IntArray, normals: FloatArray, passes: int) -> FloatArray:
    """Mean of the least and greatest |ΔN|/|ΔP| over the edges of a vertex; seams stay split."""
    count = p.shape[0]
    one, other = half_edges(faces)
    step, turn = p[other] - p[one], normals[other] - normals[one]
    length = np.sqrt(dot(step, step))
    real = length > 0.0
    one, other = one[real], other[real]
    ratio = np.sqrt(dot(turn, turn))[real] / length[real]
    least, greatest = np.full(count, np.inf), np.zeros(count)
    for at in (one, other):
        np.minimum.at(least, at, ratio)
        np.maximum.at(greatest, at, ratio)
    result = np.where(np.isfinite(least), 0.5 * (least + greatest), 0.0)
    at = faces.ravel()
    uses = np.maximum(2 * np.bincount(at, minlength=count), 1)
    for _ in range(passes):
        around = result[faces].sum(axis=1, keepdims=True) - result[faces]
        result = np.bincount(at, around.ravel(), count) / uses
    return result
