"""Diffuse light on a uniformly curved surface, to rounding (MODEL §2).

The irradiance max(0, cosθ) on a sphere of curvature κ, diffused by a profile, is the zonal series
Σ a_l T(√(l(l+1))κ) P_l(cosθ); on a cylinder (the ring) it is the Fourier series Σ f_n T(nκ) cos nθ.

Both series converge as fast as T decays, so that lobes much narrower than the radius need thousands of
terms. A narrow Gaussian, however, only rounds the kink at the terminator: with x = π/2 − θ and s = σκ the
lit side becomes e^{−s²} sin x (ring: e^{−s²/2} sin x), and one even bump is added. Up to s⁴, the sphere's
heat kernel in x is the heat kernel of a line after the substitution u = w/√cos x, which gives the closed
form in `terminator_bump`. Lobes of a Gaussian mixture are therefore split at `NARROW_S`, and any other
profile is its Gaussian fit plus the series of the small remainder T − T_fit.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import FloatArray
from .._core.choice import Choice
from .._core.normal_cdf import normal_cdf
from ..profile import Profile

__all__ = ["DiffusionGeometry", "diffuse_grid"]


NARROW_S = 0.04
"""Value of s = σκ below which the closed form (error s⁵/8 < 2e-8) replaces the series."""
TERMS = 152
"""Terms of the series for lobes with s ≥ NARROW_S: e^{−(s·TERMS)²/2} < 1e-8."""
REMAINDER_TERMS = 768
"""Terms for T − T_fit, which is ≤ 5e-4: the omitted terms are below 5e-4/768."""
BUMP_REACH = 6.5
"""Distance in widths s beyond which the bump is below 1e-12."""


class DiffusionGeometry(Choice):
    """Body over which light diffuses: a sphere, or a cylinder lit across its axis."""

    SPHERE = "sphere"
    RING = "ring"


def diffuse_grid(
    profile: Profile,
    cos_theta: FloatArray,
    curvature_per_mm: FloatArray,
    kernel: DiffusionGeometry = DiffusionGeometry.SPHERE,
) -> FloatArray:
    """Return the diffused light D for every pair of curvature and N·L.

    Parameters
    ----------
    profile
        Any profile.
    cos_theta
        (n,) N·L, −1..1.
    curvature_per_mm
        (m,) 1/mm, ≥ 0.
    kernel
        ``sphere``, or ``ring``, a cylinder lit across its axis.

    Returns
    -------
    (m, n, 3)
        Irradiance relative to a surface that faces the light, within 1e-6 of the integral.
    """
    mixture, residual = profile.gaussian_fit()
    s = mixture.sigmas_mm * curvature_per_mm[:, None]
    narrow = s < NARROW_S
    exact = residual == 0.0
    terms = TERMS if exact else REMAINDER_TERMS
    order = np.arange(terms, dtype=np.float64)
    frequency = np.sqrt(order * (order + 1.0)) if kernel == DiffusionGeometry.SPHERE else order
    k = curvature_per_mm[:, None] * frequency

    transfer = np.zeros((curvature_per_mm.size, terms, 3))
    for lobe, variance in enumerate(mixture.variances_mm2):
        wide = np.flatnonzero(~narrow[:, lobe])
        head = slice(0, TERMS)
        decay = np.exp(-0.5 * variance * np.square(k[wide, head]))
        for channel in np.flatnonzero(mixture.weights[lobe]):
            transfer[wide, head, channel] += mixture.weights[lobe, channel] * decay
    if not exact:
        transfer += profile.transfer(k) - mixture.transfer(k)

    if kernel == DiffusionGeometry.SPHERE:
        series = _zonal_coefficients(terms)[:, None] * _legendre(terms, cos_theta)
    else:
        series = _cosine_coefficients(terms)[:, None] * np.cos(
            order[:, None] * np.arccos(np.clip(cos_theta, -1.0, 1.0))
        )
    flat = transfer.transpose(0, 2, 1).reshape(-1, terms) @ series
    light = np.ascontiguousarray(
        flat.reshape(curvature_per_mm.size, 3, cos_theta.size).transpose(0, 2, 1)
    )
    _add_narrow_lobes(light, s, narrow, mixture.weights, cos_theta, kernel)
    return light


def terminator_bump(x: FloatArray, s: FloatArray, kernel: DiffusionGeometry) -> FloatArray:
    """Return the light that a Gaussian of width s ≪ 1 adds to the lit side at x = π/2 − θ, in radians."""
    z = np.abs(x) / s
    density = np.exp(-0.5 * z * z) / np.sqrt(2.0 * np.pi)
    tail = normal_cdf(-z)
    first = density - z * tail
    third = (z * z + 2.0) * density - (z**3 + 3.0 * z) * tail
    if kernel == DiffusionGeometry.RING:
        # sin y = y − y³/6 + O(y⁵)
        return s * first - s**3 / 6.0 * third
    # sin y √cos y = y − 5y³/12 + O(y⁵); the potential ½ + ¼tan²x gives e^{s²/4}
    flat = s * first - 5.0 / 12.0 * s**3 * third
    result: FloatArray = np.exp(0.25 * s * s) / np.sqrt(np.cos(x)) * flat
    return result


def _add_narrow_lobes(
    light: FloatArray,
    s: FloatArray,
    narrow: NDArray[np.bool_],
    weights: FloatArray,
    cos_theta: FloatArray,
    kernel: DiffusionGeometry,
) -> None:
    decay = np.exp(-s * s if kernel == DiffusionGeometry.SPHERE else -0.5 * s * s)
    lit = np.maximum(cos_theta, 0.0)
    light += ((decay * narrow) @ weights)[:, None, :] * lit[:, None]
    x = np.arcsin(np.clip(cos_theta, -1.0, 1.0))
    for lobe in range(s.shape[1]):
        rows = np.flatnonzero(narrow[:, lobe] & (s[:, lobe] > 0.0))
        width = s[rows, lobe]
        i, j = np.nonzero(np.abs(x) < BUMP_REACH * width[:, None])
        bump = terminator_bump(x[j], width[i], kernel)
        for channel in np.flatnonzero(weights[lobe]):
            light[rows[i], j, channel] += weights[lobe, channel] * bump


def _zonal_coefficients(terms: int) -> FloatArray:
    """Return the coefficients a_l (terms,) of max(0, cosθ) in Legendre polynomials."""
    a = np.zeros(terms)
    a[:2] = (0.25, 0.5)[: min(terms, 2)]
    q = 1.0
    for l in range(2, terms, 2):  # noqa: E741 — the usual letter of the degree
        q *= (l - 1) / l
        a[l] = (-1.0) ** (l // 2 + 1) * (2 * l + 1) / 2.0 * q / ((l + 2) * (l - 1))
    return a


def _cosine_coefficients(terms: int) -> FloatArray:
    """Return the coefficients f_n (terms,) of max(0, cosθ) in cos nθ."""
    f = np.zeros(terms)
    f[:2] = (1.0 / np.pi, 0.5)[: min(terms, 2)]
    n = np.arange(2, terms, 2)
    f[2::2] = 2.0 / np.pi * (-1.0) ** (n // 2 + 1) / (n * n - 1.0)
    return f


def _legendre(terms: int, x: FloatArray) -> FloatArray:
    """Return P_l(x) (terms, n), by the three-term recurrence, which is stable on −1..1."""
    p = np.empty((terms, x.size))
    p[0] = 1.0
    if terms > 1:
        p[1] = x
    for degree in range(2, terms):
        p[degree] = ((2 * degree - 1) * x * p[degree - 1] - (degree - 1) * p[degree - 2]) / degree
    return p
