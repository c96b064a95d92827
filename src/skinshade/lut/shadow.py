"""The shadow table: light that bleeds across the edge of a shadow (MODEL §3)."""

from __future__ import annotations

import numpy as np
from scipy.special import ndtr

from .._core.arrays import FloatArray, as_floats
from .._core.errors import ArgumentError
from .._core.version import __version__
from ..profile import Profile
from .table import Axis, Lut, checked_size

__all__ = ["build_shadow_lut", "diffused_smoothstep", "inverse_smoothstep", "shadow_axes"]

FAR = 6.0
"""Widths from the kinks of a smoothstep beyond which its blur is a polynomial to 1e-9."""


def inverse_smoothstep(u: FloatArray) -> FloatArray:
    """Return p with 3p² − 2p³ = u, exactly, for u in 0..1."""
    result: FloatArray = 0.5 - np.sin(np.arcsin(np.clip(1.0 - 2.0 * u, -1.0, 1.0)) / 3.0)
    return result


def diffused_smoothstep(p: FloatArray, s: FloatArray) -> FloatArray:
    """Return smoothstep ⊗ Gaussian of width s > 0, at p, both in units of the step's width.

    A smoothstep is 6H₃ − 12H₄ at its lower kink and 6H₃ + 12H₄ at its upper one, H_n being the n-th
    repeated integral of the Gaussian; each pair is gathered here into one Φ and one φ term.
    """
    p, s = np.broadcast_arrays(p, s)
    lower = _kink(p, s, -1.0)
    lower += _kink(p - 1.0, s, 1.0)
    return lower


def _kink(p: FloatArray, s: FloatArray, side: float) -> FloatArray:
    # Past FAR widths Φ is 0 or 1 and φ is 0, so only the polynomial is left, or nothing.
    z = p / s
    p2, s2 = p * p, s * s
    result: FloatArray = np.where(z > 0.0, 3.0 * (p2 + s2) + side * 2.0 * p * (p2 + 3.0 * s2), 0.0)
    near = np.abs(z) < FAR
    p, s, z = p[near], s[near], z[near]
    p2, s2 = p2[near], s2[near]
    area = 3.0 * (p2 + s2) + side * 2.0 * p * (p2 + 3.0 * s2)
    density = np.exp(-0.5 * z * z) / np.sqrt(2.0 * np.pi)
    result[near] = area * ndtr(z) + s * density * (3.0 * p + side * 2.0 * (p2 + 2.0 * s2))
    return result


def shadow_axes(width_mm: tuple[float, float]) -> tuple[Axis, Axis]:
    """Return the axes (columns, rows) of a table for filters of least to greatest width, mm.

    Raises
    ------
    ArgumentError
        If the widths are not positive and rising.
    """
    least, greatest = as_floats("width_mm", width_mm, (2,))
    if not 0.0 < least < greatest:
        raise ArgumentError(f"width_mm is ({least:g}, {greatest:g}); needs 0 < least < greatest")
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
    """Tabulate the shadow seen by the eye over that of a wide filter (columns) and 1/width (rows).

    Parameters
    ----------
    profile
        Any profile; one that is no Gaussian mixture enters through its fit.
    size
        (width, height) in texels, 2..16384.
    width_mm
        Least and greatest width of the filter on the surface, mm.
    sharpening
        How many times narrower than the filter the geometric shadow's edge shall be, 1..100.

    Returns
    -------
    Lut
        0 at one end of each row, 1 at the other, rising between; within 1e-6 of the integral.

    Raises
    ------
    ArgumentError
        If a size, width or sharpening is out of range.
    """
    width, height = checked_size(size)
    sharp = float(as_floats("sharpening", sharpening, (), low=1.0, high=100.0))
    columns, rows = shadow_axes(width_mm)
    u = np.concatenate([columns.centres(width), [0.0, 1.0]])
    p = (inverse_smoothstep(u) - 0.5) * sharp + 0.5
    mixture = profile.mixture
    light = np.zeros((height, u.size, 3))
    for sigma, weights in zip(mixture.sigmas_mm, mixture.weights, strict=True):
        step = diffused_smoothstep(p[None, :], (sigma * sharp * rows.centres(height))[:, None])
        for channel in np.flatnonzero(weights):
            light[..., channel] += weights[channel] * step
    dark, full = light[:, -2, None], light[:, -1, None]
    pinned = np.clip((light[:, :width] - dark) / (full - dark), 0.0, 1.0)
    provenance = {
        "profile": profile.name,
        "rms_radius_mm": profile.rms_radius_mm.tolist(),
        "sharpening": sharp,
        "version": __version__,
    }
    return Lut(pinned.astype(np.float32), "shadow", columns, rows, provenance)
