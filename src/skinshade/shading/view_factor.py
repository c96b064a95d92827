"""View factor: how much of the diffuse light leaves towards the eye (MODEL §10)."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray
from ..lut.coat import GREATEST_REFLECTANCE

__all__ = ["closure_view_factor", "root_absorption", "view_factor"]

COSINE_NODES = (0.3550510257, 0.8449489743)
"""Nodes of the quadrature of two points for means over 0..1 with the weight 2μ (Gauss-Jacobi). It is exact
for polynomials of degree 3. The mean of the factor is within 2e-4 of 1 for skin, and within .0032 for any
index of refraction and any albedo."""
COSINE_WEIGHTS = (0.3639172365, 0.6360827635)
"""Weights of these nodes; their sum is 1."""
ROUGH_ENTRY = (0.13, 0.75)
"""Cosine inside, over N·V, for light that enters through a rough interface (GGX with α = 1): .13 + .75 N·V.
The light at this cosine is within .0011 of the mean over all that enter."""


def root_absorption(albedo: FloatArray) -> FloatArray:
    """Return γ = √(1 − α) (...), α the single scattering albedo of a half-space of an albedo A (...), 0..1.

    With s = γ/(1+γ), A = (1−2s)(1−s/3) [Hapke1981], hence s = (7 − √(25+24A))/4. γ is 0 at A = 1 and 1 at
    A = 0.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.view_factor import root_absorption
    >>> root_absorption(np.array([0.0, 0.5, 1.0])).round(3)
    array([1.   , 0.298, 0.   ])
    """
    bounded = np.clip(albedo, 0.0, 1.0)
    s = (
        6.0 * (1.0 - bounded) / (7.0 + np.sqrt(25.0 + 24.0 * bounded))
    )  # no difference of equal numbers
    result: FloatArray = s / (1.0 - s)
    return result


def view_factor(albedo: FloatArray, n_dot_v: FloatArray, reflectance: FloatArray) -> FloatArray:
    """Return the factor f (..., 3) on diffuse light that leaves a half-space through a smooth boundary.

    f is 1/(1 + 2γμ), normalised to 2∫fμdμ = 1 [Chandrasekhar1960, Hapke1981]. μ is the cosine inside, before
    refraction towards the eye.

    Parameters
    ----------
    albedo
        (..., 3) albedo of the surface, 0..1.
    n_dot_v
        (...) cosine between the sharp normal and the direction towards the eye.
    reflectance
        (...) reflectance of the boundary at normal incidence, which gives the index of refraction; 0 for a
        matched boundary.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.view_factor import view_factor
    >>> albedo = np.array([0.55, 0.32, 0.26])
    >>> view_factor(albedo, np.array([0.15, 1.0]), np.array(0.028)).round(3)
    array([[1.056, 1.083, 1.09 ],
           [0.951, 0.93 , 0.924]])
    """
    slope = 2.0 * root_absorption(albedo)
    mu = _inner_cosine(np.clip(n_dot_v, 0.0, 1.0), reflectance)[..., None]
    low, high = (_inner_cosine(np.array(node), reflectance)[..., None] for node in COSINE_NODES)
    result: FloatArray = 1.0 / ((1.0 + slope * mu) * _mean_escape(slope, low, high))
    return result


def closure_view_factor(albedo: FloatArray, n_dot_v: FloatArray) -> FloatArray:
    """Return the factor (..., 3) of Blender's closure "random walk (skin)", normalised to 2∫fμdμ = 1.

    Its light enters half by the cosine and half through a rough interface. In reverse, the same shares leave.

    Parameters
    ----------
    albedo
        (..., 3) albedo of the surface, 0..1.
    n_dot_v
        (...) cosine between the sharp normal and the direction towards the eye.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.view_factor import closure_view_factor
    >>> closure_view_factor(np.array([0.55, 0.32, 0.26]), np.array([0.15, 1.0])).round(3)
    array([[1.086, 1.142, 1.159],
           [0.953, 0.93 , 0.924]])
    """
    slope = 2.0 * root_absorption(albedo)
    diffuse = _mean_escape(slope, *(np.array(node) for node in COSINE_NODES))
    offset, gain = ROUGH_ENTRY
    mu = (offset + gain * np.clip(n_dot_v, 0.0, 1.0))[..., None]
    low, high = (np.array(offset + gain * node) for node in COSINE_NODES)
    rough = 1.0 / (1.0 + slope * mu)
    result: FloatArray = (diffuse + rough) / (diffuse + _mean_escape(slope, low, high))
    return result


def _inner_cosine(cosine: FloatArray, reflectance: FloatArray) -> FloatArray:
    """Return the cosine inside (...) of a direction with a cosine outside (...)."""
    root = np.sqrt(np.clip(reflectance, 0.0, GREATEST_REFLECTANCE))
    inverse_ior = (1.0 - root) / (1.0 + root)
    result: FloatArray = np.sqrt(
        np.maximum(1.0 - (1.0 - np.square(cosine)) * np.square(inverse_ior), 0.0)
    )
    return result


def _mean_escape(slope: FloatArray, low: FloatArray, high: FloatArray) -> FloatArray:
    """Return the mean of 1/(1 + slope·μ) (...), from the cosines at the two nodes."""
    mixed = COSINE_WEIGHTS[0] * high + COSINE_WEIGHTS[1] * low
    result: FloatArray = (1.0 + slope * mixed) / ((1.0 + slope * low) * (1.0 + slope * high))
    return result
