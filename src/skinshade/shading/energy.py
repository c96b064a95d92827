"""Energy gain of a curved body: a convex body re-emits more light than a plane (MODEL §2)."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray

__all__ = ["energy_gain"]

GAIN_SLOPE = 1.2
"""Slope of the gain over (1−A)ρκ at small curvature, fitted to Monte Carlo spheres of radius 5 and 20 mm."""


def energy_gain(
    albedo: FloatArray, rms_radius_mm: FloatArray, curvature_per_mm: FloatArray
) -> FloatArray:
    """Return the gain g = 1 + u/√(1 + (uA/(1−A))²), u = 1.2(1−A)ρκ; at most 1/A.

    Parameters
    ----------
    albedo, rms_radius_mm
        (3,) or (..., 3) albedo A in (0, 1), and rms radius ρ of the profile, mm.
    curvature_per_mm
        Curvature κ, 1/mm, positive where convex: (..., 3) mean curvature diffused by each channel's
        profile, or (..., 1) mean curvature for all channels. The gain of a concave body is 1.

    Returns
    -------
    (..., 3)
        Gain ≥ 1. The light is within .015 A·E₀ of Monte Carlo at r = 5 mm, and .004 at 10 mm. No such
        model holds below r ≈ 2ρ.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.energy import energy_gain
    >>> flat_and_round = np.array([[0.0], [0.05]])  # a plane, and a radius of 20 mm
    >>> energy_gain(np.array([0.44, 0.23, 0.13]), np.array([1.66, 0.37, 0.22]), flat_and_round).round(3)
    array([[1.   , 1.   , 1.   ],
           [1.056, 1.017, 1.011]])
    """
    absorbed = 1.0 - albedo
    u = GAIN_SLOPE * absorbed * rms_radius_mm * np.maximum(curvature_per_mm, 0.0)
    result: FloatArray = 1.0 + u / np.sqrt(1.0 + np.square(u * albedo / absorbed))
    return result
