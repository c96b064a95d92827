"""Shadow edges under diffusion, from one wide filter of a constant radius (MODEL §3)."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray
from ..lut import Lut
from ..lut.shadow import inverse_smoothstep

__all__ = ["diffused_shadow", "sharpened_shadow", "smoothstep"]

LEAST_COSINE = 0.05
"""Below this N·L the filter's footprint on the surface is wider than any table and light is scarce."""


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
