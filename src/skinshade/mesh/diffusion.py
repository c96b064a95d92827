"""Heat diffusion over a surface: what multiplying by a transfer function means there (MODEL §7).

exp(−z) is replaced by its best rational approximation on the half line, in partial fractions, so that
each Gaussian costs a few sparse solves and no time steps.
"""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.linalg import hankel
from scipy.sparse import coo_array, csc_array, dia_array
from scipy.sparse.linalg import splu

from .._core.arrays import FloatArray, IntArray, as_faces, as_floats, dot
from .._core.errors import MeshError
from .._core.progress import Progress, silent
from ..profile import Profile
from .topology import weld

__all__ = ["diffuse_on_mesh", "mesh_diffused_normals"]

POLES = 6
"""Order of the rational approximation; its error is 9.3⁻⁶ ≈ 1.5e-6 for every z ≥ 0 [Trefethen2006]."""


def diffuse_on_mesh(
    positions_mm: ArrayLike,
    faces: ArrayLike,
    values: ArrayLike,
    profile: Profile,
    *,
    progress: Progress = silent,
) -> FloatArray:
    """Diffuse per-vertex values over the surface by each channel of a profile.

    Parameters
    ----------
    positions_mm, faces
        (V, 3) mm and (F, 3). Vertices at one position are one point of the surface.
    values
        (V, ...) any quantity; irradiance, say, or normals.
    profile
        Any; one that is no Gaussian mixture enters through its fit.

    Returns
    -------
    (V, ..., 3)
        The last axis is the channel. Constants stay what they are, and the integral over the surface
        is kept, both to 1e-6; beside that, exact up to the mesh's own resolution.

    Raises
    ------
    ArgumentError, MeshError
        If an array is malformed, or the mesh has no area.
    """
    p = as_floats("positions_mm", positions_mm, (None, 3))
    f = as_faces("faces", faces, p.shape[0])
    v = as_floats("values", values)
    if v.ndim == 0 or v.shape[0] != p.shape[0]:
        raise MeshError(f"values: shape is {v.shape} for {p.shape[0]} vertices")
    group, first = weld(p)
    flat = v.reshape(v.shape[0], -1)
    welded = np.stack(
        [np.bincount(group, column, first.size) for column in flat.T], axis=1
    ) / np.bincount(group)[:, None]
    stiffness, mass = _laplacian(p[first], group[f])
    mixture = profile.mixture
    result = np.zeros((*welded.shape, 3))
    for lobe, (variance, weights) in enumerate(
        zip(mixture.variances_mm2, mixture.weights, strict=True)
    ):
        progress("diffusing over the surface", lobe / mixture.variances_mm2.size)
        diffused = _heat(stiffness, mass, 0.5 * variance, welded)
        result += diffused[..., None] * weights
    progress("diffusing over the surface", 1.0)
    return result[group].reshape(*v.shape, 3)


def mesh_diffused_normals(
    positions_mm: ArrayLike, faces: ArrayLike, normals: ArrayLike, profile: Profile
) -> FloatArray:
    """Return the normals diffused by each channel, unnormalised, (V, 3 channels, 3) [Kolchin2007].

    Their length, below 1 where the surface bends within the mean free path, is the contrast that
    diffusion removes.
    """
    return np.swapaxes(diffuse_on_mesh(positions_mm, faces, normals, profile), -1, -2)


def _laplacian(p: FloatArray, faces: IntArray) -> tuple[csc_array, FloatArray]:
    """Return the cotangent stiffness matrix and the lumped mass (a third of the faces around)."""
    count = p.shape[0]
    corners = p[faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    double_area = np.sqrt(dot(normal, normal))
    mass = np.bincount(faces.ravel(), np.repeat(double_area / 6.0, 3), count)
    if not (mass > 0.0).all():
        at = int(np.argmin(mass))
        raise MeshError(f"vertex {at} at {p[at]}: the faces around it have no area")
    rows, columns, entries = [], [], []
    # A cotangent is bounded so that a needle-like face cannot drown its neighbours in rounding.
    floor = 1e-12 * double_area.max()
    for corner in range(3):
        i, j = faces[:, (corner + 1) % 3], faces[:, (corner + 2) % 3]
        a, b = corners[:, (corner + 1) % 3] - corners[:, corner], corners[:, (corner + 2) % 3] - corners[:, corner]
        half_cotangent = 0.5 * dot(a, b) / np.maximum(double_area, floor)
        rows += [i, j, i, j]
        columns += [j, i, i, j]
        entries += [-half_cotangent, -half_cotangent, half_cotangent, half_cotangent]
    matrix = coo_array(
        (np.concatenate(entries), (np.concatenate(rows), np.concatenate(columns))), (count, count)
    )
    return csc_array(matrix), mass


def _heat(stiffness: csc_array, mass: FloatArray, time: float, values: FloatArray) -> FloatArray:
    """exp(−time·M⁻¹L) values, by partial fractions over pairs of conjugate poles."""
    poles, residues = _exponential_fractions(POLES)
    diagonal = dia_array((mass[None, :], 0), shape=stiffness.shape)
    result = np.zeros_like(values)
    weighted = (mass[:, None] * values).astype(np.complex128)
    for pole, residue in zip(poles, residues, strict=True):
        # residue/(z − pole) with z = −time·M⁻¹L
        matrix = csc_array(-time * stiffness - pole * diagonal)
        solver = splu(matrix, permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True})
        result += 2.0 * np.real(residue * solver.solve(weighted))
    return result


@cache
def _exponential_fractions(order: int) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Poles and residues, upper half, of the near-best approximation of e^z on (−∞, 0].

    The method of Carathéodory and Fejér, as in [Trefethen2006]: map the half line to the circle, take
    the singular vector of the Hankel matrix of Chebyshev coefficients, keep its zeros outside.
    """
    terms, samples, scale = 75, 1024, 9.0
    w = np.exp(2j * np.pi * np.arange(samples) / samples)
    t = w.real
    with np.errstate(over="ignore"):
        f = np.exp(scale * (t - 1.0) / (t + 1.0 + 1e-16))
    c = np.fft.fft(f).real / samples
    analytic = np.polyval(c[terms::-1], w)
    u, singular, vh = np.linalg.svd(hankel(c[1 : terms + 1]))
    left, right = u[::-1, order], vh[order]
    padding = np.zeros(samples - terms)
    blaschke = np.fft.fft(np.concatenate([left, padding])) / np.fft.fft(
        np.concatenate([right, padding])
    )
    rational = analytic - singular[order] * w**terms * blaschke
    zeros = np.roots(right)
    q = zeros[np.abs(zeros) > 1.0]
    numerator = np.fft.fft(rational * np.polyval(np.poly(q), w)).real / samples
    numerator = numerator[order::-1]
    residues = np.array(
        [np.polyval(numerator, z) / np.polyval(np.poly(np.delete(q, k)), z) for k, z in enumerate(q)]
    )
    poles = scale * (q - 1.0) ** 2 / (q + 1.0) ** 2
    residues = 4.0 * residues * poles / (q * q - 1.0)
    upper = poles.imag > 0.0
    return poles[upper], residues[upper]
