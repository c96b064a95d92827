"""Diffusion over a surface by a profile's transfer function (MODEL §7).

The square of a frequency of the plane corresponds to an eigenvalue of the Laplacian of the mesh, so that a
profile acts as the matrix function T(√(M⁻¹L)). Lanczos' iteration applies it to a vector with a few dozen
products with the sparse matrix [Higham2008], without time steps, factorisations or a Gaussian fit.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike
from scipy.linalg import eigh_tridiagonal
from scipy.sparse import coo_array, csr_array, dia_array
from scipy.sparse.csgraph import connected_components

from .._core.arrays import FloatArray, IntArray, as_faces, as_floats, as_positions, dot
from .._core.errors import MeshError
from .._core.progress import Progress, silent
from ..profile import Profile
from .topology import corner_areas, used_vertices, weld

__all__ = ["diffuse_on_mesh", "mesh_diffused_normals"]

CHECK_EVERY = 12
"""Steps of the iteration between tests of its convergence."""
MOST_STEPS = 3000
"""Steps after which the iteration counts as divergent."""


def diffuse_on_mesh(
    positions_mm: ArrayLike,
    faces: ArrayLike,
    values: ArrayLike,
    profile: Profile,
    *,
    tolerance: float = 1e-8,
    progress: Progress = silent,
) -> FloatArray:
    """Diffuse values at vertices over the surface by the three channels of a profile.

    Parameters
    ----------
    positions_mm, faces
        (V, 3) mm and (F, 3). Vertices at one position are one point of the surface.
    values
        (V, ...) any quantity, such as irradiance or normals. Values at vertices that no face uses do
        not count.
    profile
        Any profile.
    tolerance
        Change of the coefficients of the result, relative to the norm of the input, at which the
        iteration stops, 1e-12..1e-1. Needle-like faces and profiles with a sharp peak need many steps.
    progress
        Called with the name of the work and the fraction that is done.

    Returns
    -------
    (V, ..., 3)
        Diffused values; the last axis is the channel. Constants and the integral over the surface are
        kept within 1e-7. The result is exact up to the resolution of the mesh.

    Raises
    ------
    ArgumentError, MeshError
        If an array is malformed, the mesh has no area, or the iteration does not converge.

    Examples
    --------
    >>> import numpy as np
    >>> import skinshade as sk
    >>> mesh = sk.builtin_head().mesh
    >>> light = np.maximum(mesh.normals @ [0.0, 0.0, 1.0], 0.0)
    >>> skin = sk.Profile.preset("skin-deon2007")
    >>> sk.diffuse_on_mesh(mesh.positions_mm, mesh.faces, light, skin, tolerance=1e-4).shape
    (20560, 3)
    """
    p = as_positions("positions_mm", positions_mm)
    if p.shape[0] == 0:
        raise MeshError("positions_mm: there are no vertices")
    f = as_faces("faces", faces, p.shape[0])
    v = as_floats("values", values)
    as_floats("tolerance", tolerance, (), low=1e-12, high=0.1)
    if v.ndim == 0 or v.shape[0] != p.shape[0]:
        raise MeshError(f"values: shape is {v.shape} for {p.shape[0]} vertices")
    group, first = weld(p)
    flat = v.reshape(v.shape[0], -1)
    used = used_vertices(f, len(p)).astype(np.float64)
    welded = (
        np.stack([np.bincount(group, used * column, first.size) for column in flat.T], axis=1)
        / np.maximum(np.bincount(group, used, first.size), 1.0)[:, None]
    )
    stiffness, mass = _laplacian(p[first], group[f])
    result = np.zeros((*welded.shape, 3))
    for column in range(welded.shape[1]):
        progress("diffusing over the surface", column / welded.shape[1])
        result[:, column] = _transferred(
            stiffness,
            mass,
            profile.kernel.transfer,
            welded[:, column],
            tolerance,
            float(profile.rms_radius_mm.max()),
        )
    progress("diffusing over the surface", 1.0)
    return result[group].reshape(*v.shape, 3)


def mesh_diffused_normals(
    positions_mm: ArrayLike, faces: ArrayLike, normals: ArrayLike, profile: Profile
) -> FloatArray:
    """Return normals, diffused by the channels of a profile and not normalised [Kolchin2007].

    They are shorter than 1 where the surface curves within the reach of the profile: their length is the
    contrast that diffusion leaves.

    Parameters
    ----------
    positions_mm, faces
        (V, 3) mm and (F, 3), as in `diffuse_on_mesh`.
    normals
        (V, 3) unit.
    profile
        Any profile.

    Returns
    -------
    (V, 3, 3)
        Diffused normals; the second axis is the channel.

    Raises
    ------
    ArgumentError, MeshError
        As in `diffuse_on_mesh`.

    Examples
    --------
    >>> import skinshade as sk
    >>> mesh = sk.builtin_head().mesh
    >>> skin = sk.Profile.preset("skin-deon2007")
    >>> sk.mesh_diffused_normals(mesh.positions_mm, mesh.faces, mesh.normals, skin).shape
    (20560, 3, 3)
    """
    return np.swapaxes(diffuse_on_mesh(positions_mm, faces, normals, profile), -1, -2)


def _laplacian(p: FloatArray, faces: IntArray) -> tuple[csr_array, FloatArray]:
    """Return the cotangent stiffness matrix, and the lumped mass: a third of the areas of faces around."""
    count = p.shape[0]
    corners = p[faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    double_area = np.sqrt(dot(normal, normal))
    mass = corner_areas(p, faces, count)
    if not (mass > 0.0).all():
        vertex = int(np.argmin(mass))
        raise MeshError(f"vertex {vertex} at {p[vertex]}: the faces around it have no area")
    rows, columns, entries = [], [], []
    # Cotangents are bounded: those of needle-like faces would exceed the precision of their neighbours.
    floor = 1e-12 * double_area.max()
    for corner in range(3):
        i, j = faces[:, (corner + 1) % 3], faces[:, (corner + 2) % 3]
        a = corners[:, (corner + 1) % 3] - corners[:, corner]
        b = corners[:, (corner + 2) % 3] - corners[:, corner]
        half_cotangent = 0.5 * dot(a, b) / np.maximum(double_area, floor)
        rows += [i, j, i, j]
        columns += [j, i, i, j]
        entries += [-half_cotangent, -half_cotangent, half_cotangent, half_cotangent]
    matrix = coo_array(
        (np.concatenate(entries), (np.concatenate(rows), np.concatenate(columns))), (count, count)
    )
    return csr_array(matrix), mass


def _transferred(
    stiffness: csr_array,
    mass: FloatArray,
    transfer: Callable[[FloatArray], FloatArray],
    values: FloatArray,
    tolerance: float,
    reach_mm: float,
) -> FloatArray:
    """Return T(√(M⁻¹L)) times a column (n,), for the three channels (n, 3), by Lanczos' iteration."""
    # Diffusion keeps the mean over a connected part: it is subtracted here and added at the end.
    part = connected_components(stiffness, directed=False)[1]
    mean = (np.bincount(part, mass * values) / np.bincount(part, mass))[part]
    values = values - mean
    root = np.sqrt(mass)
    scale = dia_array((1.0 / root[None, :], 0), shape=stiffness.shape)
    symmetric = csr_array(scale @ stiffness @ scale)
    # A polynomial of this degree in the matrix resolves waves as long as the width of the profile.
    enough = 2.0 * reach_mm * np.sqrt(symmetric.diagonal().max())
    start = root * values
    norm = float(np.linalg.norm(start))
    if norm <= 1e-14 * float(np.linalg.norm(root * mean)) or norm == 0.0:
        return np.repeat(mean[:, None], 3, axis=1)
    basis = np.empty((CHECK_EVERY, values.size))
    basis[0] = start / norm
    diagonal: list[float] = []
    beside: list[float] = []
    previous = np.zeros((0, 3))
    for step in range(MOST_STEPS):
        if step + 1 >= basis.shape[0]:
            basis = np.concatenate([basis, np.empty_like(basis[:CHECK_EVERY])])
        vector = symmetric @ basis[step]
        diagonal.append(float(vector @ basis[step]))
        for _ in range(2):  # two passes keep the basis orthogonal
            vector -= basis[: step + 1].T @ (basis[: step + 1] @ vector)
        length = float(np.linalg.norm(vector))
        exhausted = length <= 1e-12 * max(map(abs, diagonal))
        if exhausted or (step + 1) % CHECK_EVERY == 0:
            weights, uncertainty = _small_function(diagonal, beside, transfer, length)
            padded = np.zeros_like(weights)
            padded[: previous.shape[0]] = previous
            resolved = uncertainty < tolerance or step + 1 >= enough
            settled = np.abs(weights - padded).max() < tolerance and resolved
            if exhausted or settled:
                break
            previous = weights
        beside.append(length)
        basis[step + 1] = vector / length
    else:
        raise MeshError(
            f"diffusion has not converged in {MOST_STEPS} steps; remove needle-like faces, or give"
            " a greater tolerance"
        )
    combined: FloatArray = basis[: weights.shape[0]].T @ weights
    return mean[:, None] + norm * combined / root[:, None]


def _small_function(
    diagonal: list[float],
    beside: list[float],
    transfer: Callable[[FloatArray], FloatArray],
    next_length: float,
) -> tuple[FloatArray, float]:
    """Return T(√H) e₁ (m, 3) of the tridiagonal matrix H of the iteration, and its uncertainty.

    Until the lowest frequency has converged, a profile that passes only lower frequencies seems to pass
    none. The residual of that frequency, times its share of the input, bounds what further steps add.
    """
    squares, vectors = eigh_tridiagonal(np.array(diagonal), np.array(beside[: len(diagonal) - 1]))
    response = transfer(np.sqrt(np.maximum(squares, 0.0)))
    weights: FloatArray = vectors @ (vectors[0][:, None] * response)
    residual = next_length * abs(float(vectors[-1, 0])) / max(float(np.abs(squares).max()), 1e-300)
    return weights, residual * abs(float(vectors[0, 0]))
