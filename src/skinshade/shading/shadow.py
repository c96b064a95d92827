"""Shadow edges under diffusion, from one wide filter of a constant radius (MODEL §3)."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray
from ..lut import Lut
from ..lut.shadow import inverse_smoothstep

__all__ = ["diffused_shadow", "sharpened_shadow", "smoothstep", "variance_shadow"]

LEAST_COSINE = 0.05
"""Below this N·L the filter's footprint on the surface is wider than any table and light is scarce."""
LEAST_VARIANCE_MM2 = 0.01
"""A tenth of a mm of spread: what rounding leaves of a flat wall's variance, and more."""


def smoothstep(p: FloatArray) -> FloatArray:
    """Return 3p² − 2p³ with p clamped to 0..1."""
    q = np.clip(p, 0.0, 1.0)
    result: FloatArray = q * q * (3.0 - 2.0 * q)
    return result


def diffused_shadow(
    lut: Lut, shadow_filter: FloatArray, n_dot_l: FloatArray, filter_width_mm: float
) -> FloatArray:
    """Return the light that each channel receives across a shadow's edge, (..., 3), 0..1.

    Parameters
    ----------
    lut
        Shadow table.
    shadow_filter
        (...) value of the wide filter, 0 in shadow, 1 in light.
    n_dot_l
        (...) of the mesh's normal; the filter spans width/(N·L) on the surface.
    filter_width_mm
        Width of the filter across the light, mm.
    """
    per_mm = np.maximum(n_dot_l, LEAST_COSINE) / filter_width_mm
    return lut.sample_at(lut.columns.coordinate(shadow_filter), lut.rows.coordinate(per_mm))


def sharpened_shadow(shadow_filter: FloatArray, sharpening: float) -> FloatArray:
    """Return the wide filter's edge made `sharpening` times narrower, about its middle (...)."""
    return smoothstep((inverse_smoothstep(shadow_filter) - 0.5) * sharpening + 0.5)


def variance_shadow(
    mean_depth_mm: FloatArray, mean_square_depth_mm2: FloatArray, depth_mm: FloatArray
) -> FloatArray:
    """Return the greatest share (...) of blurred occluders that can lie behind a receiver [Donnelly2006].

    Chebyshev's bound, which two walls reach: with a receiver on the far one it is the share of the far one.

    Parameters
    ----------
    mean_depth_mm, mean_square_depth_mm2
        (...) of depths and of their squares, blurred.
    depth_mm
        (...) of the receiver, from the same origin.
    """
    variance = mean_square_depth_mm2 - mean_depth_mm * mean_depth_mm
    variance = np.maximum(variance, LEAST_VARIANCE_MM2)
    behind = np.maximum(depth_mm - mean_depth_mm, 0.0)
    result: FloatArray = variance / (variance + behind * behind)
    return result
