"""Curvature at vertices: mean and shape operator, and the measure of 2014 for comparison."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import FloatArray, FloatRows, FloatVector, IntArray, dot
from .._core.errors import ArgumentError
from .shape_operator import (
    ShapeOperator,
    checked_mesh,
    checked_smoothing,
    fitted_mean_curvature,
    unit_normals,
)
from .tensors import tensor_to_world
from .topology import half_edges

__all__ = ["CurvatureMethod", "mesh_curvature", "mesh_curvature_tensor", "tensor_to_world"]

CurvatureMethod = Literal["shape-operator", "edges"]


def mesh_curvature(
    positions: ArrayLike,
    faces: ArrayLike,
    normals: ArrayLike | None = None,
    *,
    method: CurvatureMethod = "shape-operator",
    smoothing: int = 2,
) -> FloatVector:
    """Return the mean curvature at every vertex, positive where the surface is convex.

    Parameters
    ----------
    positions
        (V, 3) in any unit.
    faces
        (F, 3) indices.
    normals
        (V, 3) outward unit normals; computed if None.
    method
        ``shape-operator``, or ``edges`` for the unsigned curvature of the system of 2014.
    smoothing
        Passes of averaging with the neighbours, 0..100; the normals of scans need two.

    Returns
    -------
    (V,)
        Curvature in 1 per unit of `positions`. Vertices at one position have equal values. The error is
        2 % RMS on smooth shapes whose edges span a tenth of a radian, and of first order in the length
        of edges on random meshes. It is bounded by what the edges of a vertex resolve; see
        `skinshade.mesh.shape_operator`.

    Raises
    ------
    ArgumentError
        If an array has a wrong shape, a value is not finite or an index out of range.

    Examples
    --------
    >>> import skinshade as sk
    >>> mesh = sk.builtin_head().mesh
    >>> curvature = sk.mesh_curvature(mesh.positions_mm, mesh.faces, mesh.normals)
    >>> tip = mesh.positions_mm[:, 2].argmax()
    >>> bool(0.03 < curvature[tip] < 0.3)  # the tip of the nose, 1/mm
    True
    """
    checked_smoothing(smoothing)
    if method == "edges":
        p, f, n = checked_mesh(positions, faces, normals)
        return _edge_curvature(p, f, unit_normals(p, f, n), smoothing)
    if method != "shape-operator":
        raise ArgumentError(f"method is {method!r}; it must be shape-operator or edges")
    return fitted_mean_curvature(positions, faces, normals, smoothing)


def mesh_curvature_tensor(
    positions: ArrayLike,
    faces: ArrayLike,
    normals: ArrayLike | None = None,
    *,
    smoothing: int = 2,
) -> FloatRows:
    """Return the shape operator at every vertex: three numbers in its tangent plane.

    Parameters
    ----------
    positions, faces, normals, smoothing
        As in `mesh_curvature`.

    Returns
    -------
    (V, 3)
        k_uu, k_uv, k_vv in the frame of `skinshade.mesh.normals.tangent_frame`, in 1 per unit of
        `positions`, positive where convex. Convert them with `skinshade.mesh.curvature.tensor_to_world`
        before they are interpolated.

    Raises
    ------
    ArgumentError
        As in `mesh_curvature`.

    Examples
    --------
    >>> import skinshade as sk
    >>> mesh = sk.builtin_head().mesh
    >>> sk.mesh_curvature_tensor(mesh.positions_mm, mesh.faces, mesh.normals).shape
    (20560, 3)
    """
    checked_smoothing(smoothing)
    return ShapeOperator.fit(positions, faces, normals).tensor(smoothing)


def _edge_curvature(p: FloatArray, faces: IntArray, normals: FloatArray, passes: int) -> FloatArray:
    """Return the mean of least and greatest |ΔN|/|ΔP| over the edges of a vertex; seams stay split."""
    count = p.shape[0]
    one, other = half_edges(faces)
    step, turn = p[other] - p[one], normals[other] - normals[one]
    length = np.sqrt(dot(step, step))
    real = length > 0.0
    one, other = one[real], other[real]
    ratio = np.sqrt(dot(turn, turn))[real] / length[real]
    least, greatest = np.full(count, np.inf), np.zeros(count)
    for end in (one, other):
        np.minimum.at(least, end, ratio)
        np.maximum.at(greatest, end, ratio)
    result = np.where(np.isfinite(least), 0.5 * (least + greatest), 0.0)
    corners = faces.ravel()
    uses = np.maximum(2 * np.bincount(corners, minlength=count), 1)
    for _ in range(passes):
        around = result[faces].sum(axis=1, keepdims=True) - result[faces]
        result = np.bincount(corners, around.ravel(), count) / uses
    return result
