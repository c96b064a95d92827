"""Tone curves from linear light to display values: sRGB, or a filmic curve [Hable2010]."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray
from .._core.srgb import linear_from_srgb, srgb_from_linear
from ..params.choices import ToneCurve

__all__ = ["filmic", "linear_from_srgb", "srgb_from_linear", "tonemap"]


def filmic(light: FloatArray) -> FloatArray:
    """Return display values 0..1 of linear light ≥ 0, including the gamma of the screen.

    The curve is a rational fit to the response of film. Light below .004 gives 0.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.tonemap import filmic
    >>> filmic(np.array([0.0, 0.18, 1.0, 16.0])).round(3)
    array([0.   , 0.508, 0.841, 0.988])
    """
    x = np.maximum(light - 0.004, 0.0)
    result: FloatArray = x * (6.2 * x + 0.5) / (x * (6.2 * x + 1.7) + 0.06)
    return result


def tonemap(light: FloatArray, curve: ToneCurve, exposure: float = 1.0) -> FloatArray:
    """Return display values 0..1 of linear light (...), multiplied by an exposure, through a tone curve."""
    exposed = light * exposure
    return filmic(exposed) if curve == ToneCurve.FILMIC else srgb_from_linear(exposed)
