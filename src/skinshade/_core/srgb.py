"""The sRGB transfer curve (IEC 61966-2-1)."""

from __future__ import annotations

import numpy as np

from .arrays import FloatArray

__all__ = ["linear_from_srgb", "srgb_from_linear"]


def srgb_from_linear(light: FloatArray) -> FloatArray:
    """Return display values of linear light, clipped to 0..1 (IEC 61966-2-1)."""
    x = np.clip(light, 0.0, 1.0)
    curve = 1.055 * np.maximum(x, 1e-12) ** (1.0 / 2.4) - 0.055
    result: FloatArray = np.where(x <= 0.0031308, 12.92 * x, curve)
    return result


def linear_from_srgb(display: FloatArray) -> FloatArray:
    """Return linear light of display values 0..1 (IEC 61966-2-1)."""
    x = np.clip(display, 0.0, 1.0)
    result: FloatArray = np.where(x <= 0.04045, x / 12.92, ((x + 0.055) / 1.055) ** 2.4)
    return result
