"""The 2014 tables, faults included, for comparison and migration (MODEL §8)."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, as_floats
from .._core.errors import ArgumentError
from .._core.version import __version__
from ..profile import GaussianMixture, Profile
from .shadow import diffused_smoothstep, shadow_axes
from .table import Axis, Lut, checked_size

__all__ = ["CLASSIC_DIFFUSION_RADIUS_MM", "classic_curvature_lut", "classic_shadow_lut"]

CLASSIC_DIFFUSION_RADIUS_MM = 2.7
"""σ of the widest Gaussian: the length by which the 2014 system scaled its profile."""
CUT_MM = 10.0
"""The ring integral stopped at this distance from the point shaded."""
RING_NODES = 400
FADED_SHARE = 0.04
"""The leftmost columns of the shadow table fade to black over this share of its width."""


def classic_curvature_lut(
    profile: Profile,
    *,
    size: tuple[int, int] = (512, 512),
    radius_mm: tuple[float, float] = (1.0, 100.0),
) -> Lut:
    """Return the 2014 curvature table, decoded: rows linear in κ, cut at 10 mm, 8 bits.

    The 8 bits store (D − max(0, N·L))·2 + ½, which clips red light on radii below 1.1 mm.
    """
    width, height = checked_size(size)
    least, greatest = as_floats("radius_mm", radius_mm, (2,))
    if not 0.0 < least < greatest:
        raise ArgumentError(f"radius_mm is ({least:g}, {greatest:g}); needs 0 < least < greatest")
    columns = Axis("n_dot_l", "1", -1.0, 1.0)
    rows = Axis("curvature", "1/mm", 1.0 / greatest, 1.0 / least)
    n_dot_l = columns.centres(width)
    theta = np.arccos(n_dot_l)
    light = np.empty((height, width, 3))
    nodes, gauss = np.polynomial.legendre.leggauss(RING_NODES)
    for y, curvature in enumerate(rows.centres(height)):
        reach = min(np.pi / curvature, CUT_MM)
        # x = reach·t³ crowds the nodes where the narrow lobes of the profile are.
        x, weight = reach * nodes**3, 3.0 * reach * nodes**2 * gauss
        spread = _line_profile(profile.mixture, x) * weight[:, None]
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
    """Return the 2014 shadow table, decoded: approximate position, faded dark end, sRGB in 8 bits."""
    width, height = checked_size(size)
    sharpening = float(as_floats("sharpening", sharpening, (), low=1.0, high=100.0))
    columns, rows = shadow_axes(width_mm)
    u = columns.centres(width)
    p = (0.5 * (np.sqrt(u) - np.sqrt(1.0 - u))) * sharpening + 0.5
    light = np.zeros((height, width, 3))
    mixture = profile.mixture
    for sigma, weights in zip(mixture.sigmas_mm, mixture.weights, strict=True):
        step = diffused_smoothstep(p, (sigma * sharpening * rows.centres(height))[:, None])
        light += step[..., None] * weights
    light *= np.clip(u / FADED_SHARE, 0.0, 1.0)[:, None]
    encoded = np.rint(_srgb(np.clip(light, 0.0, 1.0)) * 255.0) / 255.0
    return Lut(_linear(encoded).astype(np.float32), "shadow", columns, rows, _provenance(profile))


def _line_profile(mixture: GaussianMixture, x_mm: FloatArray) -> FloatArray:
    """The profile integrated along a line: what diffuses across a ring (n, 3), per mm."""
    v = mixture.variances_mm2
    lobes = np.exp(-0.5 * np.square(x_mm)[:, None] / v) / np.sqrt(2.0 * np.pi * v)
    result: FloatArray = lobes @ mixture.weights
    return result


def _provenance(profile: Profile) -> dict[str, object]:
    return {"profile": profile.name, "kernel": "classic", "version": __version__}


def _srgb(x: FloatArray) -> FloatArray:
    return np.where(x <= 0.0031308, 12.92 * x, 1.055 * np.maximum(x, 1e-12) ** (1 / 2.4) - 0.055)


def _linear(x: FloatArray) -> FloatArray:
    return np.where(x <= 0.04045, x / 12.92, ((x + 0.055) / 1.055) ** 2.4)
