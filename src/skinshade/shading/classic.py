"""The formulas of 2014, each named after the term that replaces it (MODEL §8)."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, dot, unit_vectors
from ..lut import Lut
from .deep_scatter import CLASSIC_WRAP, classic_transmittance
from .shadow import smoothstep

__all__ = [
    "ambient_normals",
    "blur_level",
    "deep_scatter",
    "direct",
    "sharpened_shadow",
]


def blur_level(
    radius_mm: float, uv_scale_mm: float, map_size: int, hardware_level: FloatArray
) -> FloatArray:
    """Return the mip level (...) of the blurred normal.

    Parameters
    ----------
    radius_mm
        Radius of the blur on the surface, mm; 2.7 for skin.
    uv_scale_mm, map_size, hardware_level
        As in `skinshade.shading.normals.blur_level`.
    """
    footprint = max(map_size * radius_mm, uv_scale_mm) / uv_scale_mm
    result: FloatArray = np.maximum(hardware_level, np.log2(footprint))
    return result


def direct(
    lut: Lut,
    sharp: FloatArray,
    blurred: FloatArray,
    light: FloatArray,
    curvature_per_mm: FloatArray,
) -> FloatArray:
    """Return direct diffuse light (..., 3), 0..1.

    Parameters
    ----------
    lut
        Curvature table of `skinshade.lut.classic`.
    sharp, blurred
        (..., 3) unit normals of the map, without and with blur.
    light
        (..., 3) unit vectors towards the light.
    curvature_per_mm
        (...) curvature, 1/mm; its sign has no effect.
    """
    blurred_cosine = dot(blurred, light)
    k = np.clip(1.0 - blurred_cosine, 0.0, 1.0)[..., None] ** 2
    green = unit_vectors(_mix(sharp, blurred, 0.3 + 0.7 * k))
    blue = unit_vectors(_mix(sharp, blurred, k))
    lambert = np.stack([blurred_cosine, dot(green, light), dot(blue, light)], axis=-1)
    u, v = lut.columns.coordinate(blurred_cosine), lut.rows.coordinate(np.abs(curvature_per_mm))
    difference = lut.sample_at(u, v) - np.maximum(blurred_cosine, 0.0)[..., None]
    result: FloatArray = np.clip(np.clip(lambert, 0.0, 1.0) + difference, 0.0, 1.0)
    return result


def ambient_normals(sharp: FloatArray, blurred: FloatArray) -> FloatArray:
    """Return the unit normal of each channel (..., 3 channels, 3) for ambient light."""
    green = unit_vectors(_mix(sharp, blurred, np.array(0.3)))
    return np.stack([blurred, green, sharp], axis=-2)


def sharpened_shadow(shadow_filter: FloatArray, sharpening: float) -> FloatArray:
    """Return the shadow of specular light (...): a smoothstep of .9 · sharpening · (filter − ½) + ½."""
    return smoothstep(0.9 * sharpening * (shadow_filter - 0.5) + 0.5)


def deep_scatter(
    thickness_mm: FloatArray, n_dot_l: FloatArray, radius_mm: float, strength: float
) -> FloatArray:
    """Return the light through the body (...), equal in all channels, before its colour and its texture.

    Parameters
    ----------
    thickness_mm
        (...) thickness of the body towards the light, mm.
    n_dot_l
        (...) N·L of the blurred normal.
    radius_mm
        Radius of the falloff, mm.
    strength
        Factor on the light.
    """
    falloff = classic_transmittance(thickness_mm, radius_mm)
    result: FloatArray = strength * falloff * np.maximum(CLASSIC_WRAP - n_dot_l, 0.0)
    return result


def _mix(a: FloatArray, b: FloatArray, t: FloatArray) -> FloatArray:
    return a + (b - a) * t
