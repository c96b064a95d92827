"""Tables of the system of 2014, errors included, for comparison and migration (MODEL §8)."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, as_floats
from .._core.srgb import linear_from_srgb, srgb_from_linear
from .._core.version import __version__
from ..profile import GaussianMixture, Profile
from .shadow import diffused_smoothstep, shadow_axes
from .table import Axis, Lut, checked_range, checked_size

__all__ = ["CLASSIC_DIFFUSION_RADIUS_MM", "classic_curvature_lut", "classic_shadow_lut"]

CLASSIC_DIFFUSION_RADIUS_MM = 2.7
"""Standard deviation of the widest Gaussian, the length by which the 2014 system scales its profile, mm."""
CUT_MM = 10.0
"""Distance from the shaded point at which the 2014 system ends the ring integral, mm."""
RING_NODES = 400
FADED_SHARE = 0.04
"""Share of the shadow table's width over which its leftmost columns fade to black."""


def classic_curvature_lut(
    profile: Profile,
    *,
    size: tuple[int, int] = (512, 512),
    radius_mm: tuple[float, float] = (1.0, 100.0),
) -> Lut:
    """Return the 2014 curvature table, decoded: rows linear in κ, integral cut at 10 mm, 8 bits.

    The 8 bits store (D − max(0, N·L))·2 + ½, which clips red light on radii below 1.1 mm.

    Parameters
    ----------
    profile
        Any profile.
    size
        (width, height) in texels, 2..16384.
    radius_mm
        Least and greatest radius of curvature, mm.

    Raises
    ------
    ArgumentError
        If a size or radius is out of range.
    """
    width, height = checked_size(size)
    least, greatest = checked_range("radius_mm", radius_mm)
    columns = Axis("n_dot_l", "1", -1.0, 1.0)
    rows = Axis("curvature", "1/mm", 1.0 / greatest, 1.0 / least)
    n_dot_l = columns.centres(width)
    theta = np.arccos(n_dot_l)
    mixture, _ = profile.gaussian_fit()
    light = np.empty((height, width, 3))
    nodes, gauss = np.polynomial.legendre.leggauss(RING_NODES)
    for y, curvature in enumerate(rows.centres(height)):
        reach = min(np.pi / curvature, CUT_MM)
        # x = reach·t³ concentrates the nodes at the narrow lobes of the profile.
        x, weight = reach * nodes**3, 3.0 * reach * nodes**2 * gauss
        spread = _line_profile(mixture, x) * weight[:, None]
        cosine = np.maximum(np.cos(theta[:, None] + x * curvature), 0.0)
        light[y] = cosine @ spread
    lit = np.maximum(n_dot_l, 0.0)[:, None]
    stored = np.rint(np.clip((light - lit) * 2.0 + 0.5, 0.0, 1.0) * 255.0) / 255.0
    values = (stored - 0.5) / 2.0 + lit
    return Lut(values.astype(np.float32), "curvature", columns, rows, _provenance(profile))


def classic_shadow_lut(
    profile: Profile,
    *,
    size: tuple[int, int] = (512, 512),
    width_mm: tuple[float, float] = (8.0, 100.0),
    sharpening: float = 10.0,
) -> Lut:
    """Return the 2014 shadow table, decoded: approximate position, faded dark end, sRGB in 8 bits.

    Parameters
    ----------
    profile
        Any profile.
    size
        (width, height) in texels, 2..16384.
    width_mm
        Least and greatest width of the filter on the surface, mm.
    sharpening
        Factor by which the shadow's edge is narrower than the filter, 1..100.

    Raises
    ------
    ArgumentError
        If a size, width or sharpening is out of range.
    """
    width, height = checked_size(size)
    sharpening = float(as_floats("sharpening", sharpening, (), low=1.0, high=100.0))
    columns, rows = shadow_axes(width_mm)
    u = columns.centres(width)
    p = (0.5 * (np.sqrt(u) - np.sqrt(1.0 - u))) * sharpening + 0.5
    light = np.zeros((height, width, 3))
    mixture, _ = profile.gaussian_fit()
    for sigma, weights in zip(mixture.sigmas_mm, mixture.weights, strict=True):
        step = diffused_smoothstep(p, (sigma * sharpening * rows.centres(height))[:, None])
        light += step[..., None] * weights
    light *= np.clip(u / FADED_SHARE, 0.0, 1.0)[:, None]
    encoded = np.rint(srgb_from_linear(light) * 255.0) / 255.0
    return Lut(
        linear_from_srgb(encoded).astype(np.float32), "shadow", columns, rows, _provenance(profile)
    )


def _line_profile(mixture: GaussianMixture, x_mm: FloatArray) -> FloatArray:
    """Return the profile integrated along a line (n, 3), per mm, at distances (n,) from the line."""
    v = mixture.variances_mm2
    lobes = np.exp(-0.5 * np.square(x_mm)[:, None] / v) / np.sqrt(2.0 * np.pi * v)
    result: FloatArray = lobes @ mixture.weights
    return result


def _provenance(profile: Profile) -> dict[str, object]:
    return {"profile": profile.name, "kernel": "classic", "version": __version__}
