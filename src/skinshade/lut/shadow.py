"""Shadow tables: light that bleeds across the edge of a shadow (MODEL §3)."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, as_floats
from .._core.normal_cdf import normal_cdf
from .._core.version import __version__
from ..profile import Profile
from .table import Axis, Lut, checked_range, checked_size

__all__ = ["build_shadow_lut", "diffused_smoothstep", "inverse_smoothstep", "shadow_axes"]

FAR = 6.0
"""Distance from a kink of the smoothstep, in widths s, beyond which the blur is a polynomial within 1e-9."""


def inverse_smoothstep(u: FloatArray) -> FloatArray:
    """Return p with 3p² − 2p³ = u for u in 0..1: the exact inverse of a smoothstep."""
    result: FloatArray = 0.5 - np.sin(np.arcsin(np.clip(1.0 - 2.0 * u, -1.0, 1.0)) / 3.0)
    return result


def diffused_smoothstep(p: FloatArray, s: FloatArray) -> FloatArray:
    """Return a smoothstep, convolved with a Gaussian, at p.

    With H_n, the n-th repeated integral of the Gaussian, the result is 6H₃ − 12H₄ at the lower kink plus
    6H₃ + 12H₄ at the upper kink. The terms are collected into one Φ and one φ term per kink.

    Parameters
    ----------
    p
        Positions; the step is from 0 to 1.
    s
        Standard deviations of the Gaussian in widths of the step, > 0.
    """
    p, s = np.broadcast_arrays(p, s)
    result = _kink(p, s, -1.0)
    result += _kink(p - 1.0, s, 1.0)
    return result


def _kink(p: FloatArray, s: FloatArray, side: float) -> FloatArray:
    """Return the share of one kink at distances `p` from it; `side` is −1 for the lower, 1 for the upper."""
    # Beyond FAR widths Φ is 0 or 1 and φ is 0: the polynomial remains, or 0.
    z = p / s
    p2, s2 = p * p, s * s
    result: FloatArray = np.where(z > 0.0, 3.0 * (p2 + s2) + side * 2.0 * p * (p2 + 3.0 * s2), 0.0)
    near = np.abs(z) < FAR
    p, s, z = p[near], s[near], z[near]
    p2, s2 = p2[near], s2[near]
    area = 3.0 * (p2 + s2) + side * 2.0 * p * (p2 + 3.0 * s2)
    density = np.exp(-0.5 * z * z) / np.sqrt(2.0 * np.pi)
    result[near] = area * normal_cdf(z) + s * density * (3.0 * p + side * 2.0 * (p2 + 2.0 * s2))
    return result


def shadow_axes(width_mm: tuple[float, float]) -> tuple[Axis, Axis]:
    """Return the axes (columns, rows) of a table for filters of least to greatest width, mm.

    Raises
    ------
    ArgumentError
        If the widths are not positive and increasing.
    """
    least, greatest = checked_range("width_mm", width_mm)
    columns = Axis("shadow_filter", "1", 0.0, 1.0)
    rows = Axis("n_dot_l_over_filter_width", "1/mm", 1.0 / greatest, 1.0 / least)
    return columns, rows


def build_shadow_lut(
    profile: Profile,
    *,
    size: tuple[int, int] = (512, 512),
    width_mm: tuple[float, float] = (8.0, 100.0),
    sharpening: float = 10.0,
) -> Lut:
    """Tabulate the diffused shadow over the value of a wide filter (columns) and 1/width (rows).

    Parameters
    ----------
    profile
        Any profile; profiles other than Gaussians enter through `Profile.gaussian_fit`.
    size
        (width, height) in texels, 2..16384.
    width_mm
        Least and greatest width of the filter on the surface, mm.
    sharpening
        Factor by which the shadow's edge is narrower than the filter, 1..100.

    Returns
    -------
    Lut
        Rows increase from 0 to 1; values are within 1e-6 of the integral.

    Raises
    ------
    ArgumentError
        If a size, width or sharpening is out of range.

    Examples
    --------
    >>> import skinshade as sk
    >>> lut = sk.build_shadow_lut(sk.Profile.preset("skin-deon2007"), size=(256, 32))
    >>> lut.sample(0.5, 1 / 20).round(2)  # the middle of the edge of a filter of 20 mm
    array([0.5, 0.5, 0.5])
    """
    width, height = checked_size(size)
    sharp = float(as_floats("sharpening", sharpening, (), low=1.0, high=100.0))
    columns, rows = shadow_axes(width_mm)
    u = np.concatenate([columns.centres(width), [0.0, 1.0]])
    p = (inverse_smoothstep(u) - 0.5) * sharp + 0.5
    mixture, _ = profile.gaussian_fit()
    light = np.zeros((height, u.size, 3))
    for sigma, weights in zip(mixture.sigmas_mm, mixture.weights, strict=True):
        step = diffused_smoothstep(p[None, :], (sigma * sharp * rows.centres(height))[:, None])
        for channel in np.flatnonzero(weights):
            light[..., channel] += weights[channel] * step
    dark, full = light[:, -2, None], light[:, -1, None]
    values = np.clip((light[:, :width] - dark) / (full - dark), 0.0, 1.0)
    provenance = {
        "profile": profile.name,
        "rms_radius_mm": profile.rms_radius_mm.tolist(),
        "sharpening": sharp,
        "version": __version__,
    }
    return Lut(values.astype(np.float32), "shadow", columns, rows, provenance)
