"""From linear light to a screen: sRGB, or a filmic curve [Hable2010]."""

from __future__ import annotations

from typing import Literal

import numpy as np

from .._core.arrays import FloatArray

__all__ = ["ToneMap", "filmic", "linear_from_srgb", "srgb_from_linear", "tonemap"]

ToneMap = Literal["srgb", "filmic"]


def filmic(light: FloatArray) -> FloatArray:
    """Return display values 0..1, the screen's gamma included, of linear light ≥ 0.

    The rational fit of a film's response; .004 is its toe, below which it prints black.
    """
    x = np.maximum(light - 0.004, 0.0)
    result: FloatArray = x * (6.2 * x + 0.5) / (x * (6.2 * x + 1.7) + 0.06)
    return result


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


def tonemap(light: FloatArray, curve: ToneMap, exposure: float = 1.0) -> FloatArray:
    """Return display values 0..1 of linear light times an exposure."""
    exposed = light * exposure
    return filmic(exposed) if curve == "filmic" else srgb_from_linear(exposed)
