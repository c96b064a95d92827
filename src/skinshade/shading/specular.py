"""Specular light of two lobes: Blinn-Phong, Schlick-Smith visibility, Schlick Fresnel (MODEL §9)."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, dot, unit_vectors
from ..params.gloss import POWER_OCTAVES, gloss_from_roughness

__all__ = [
    "ambient_specular_fresnel",
    "diffuse_share",
    "gloss_from_roughness",
    "gloss_of_relief",
    "reflected",
    "specular",
    "specular_power",
]

SHARP_LOBE_SHARE = 0.05
"""Weight of the second lobe, whose power is the square of the first lobe's power [Jimenez2013]."""
SHARPEST_POWER = 2.0**POWER_OCTAVES
"""Greatest power of the second lobe."""


def specular_power(gloss: FloatArray) -> FloatArray:
    """Return the Blinn-Phong power 2^(13·gloss) (...) of gloss (...), 0..1.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.specular import specular_power
    >>> specular_power(np.array([0.0, 1.0]))
    array([1.000e+00, 8.192e+03])
    """
    result: FloatArray = np.exp2(POWER_OCTAVES * gloss)
    return result


def gloss_of_relief(gloss: FloatArray, normal_length: FloatArray) -> FloatArray:
    """Return the gloss (...), reduced by the relief that a mip level has averaged away [Toksvig2005].

    Parameters
    ----------
    gloss
        (...) gloss of the first lobe, 0..1.
    normal_length
        (...) length of the averaged normal, 0..1. It is shorter, the more the averaged normals differ.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.specular import gloss_of_relief
    >>> gloss_of_relief(np.array([0.5, 0.5]), np.array([1.0, 0.9])).round(3)
    array([0.5  , 0.233])
    """
    length = np.clip(normal_length, 1e-3, 1.0)
    power = specular_power(gloss)
    widened = length * power / (length + power * (1.0 - length))
    result: FloatArray = np.log2(np.maximum(widened, 1.0)) / POWER_OCTAVES
    return result


def specular(
    normal: FloatArray,
    view: FloatArray,
    light: FloatArray,
    gloss: FloatArray,
    reflectance: FloatArray,
) -> FloatArray:
    """Return π·BRDF·(N·L), the reflected radiance per unit of light (...).

    Parameters
    ----------
    normal
        (..., 3) sharp normals, unit vectors.
    view, light
        (..., 3) unit vectors towards the eye and towards the light.
    gloss
        (...) gloss of the first lobe, 0..1.
    reflectance
        (...) reflectance F₀ at normal incidence; .028 for skin.
    """
    half = unit_vectors(view + light)
    n_dot_l = np.clip(dot(normal, light), 0.0, 1.0)
    n_dot_v = np.clip(dot(normal, view), 1e-4, 1.0)
    n_dot_h = np.clip(dot(normal, half), 0.0, 1.0)
    v_dot_h = np.clip(dot(view, half), 0.0, 1.0)
    wide = specular_power(gloss)
    sharp = np.minimum(np.square(wide), SHARPEST_POWER)
    lobes = (1.0 - SHARP_LOBE_SHARE) * _lobe(n_dot_h, n_dot_l, n_dot_v, wide)
    lobes += SHARP_LOBE_SHARE * _lobe(n_dot_h, n_dot_l, n_dot_v, sharp)
    fresnel = reflectance + (1.0 - reflectance) * (1.0 - v_dot_h) ** 5
    result: FloatArray = np.pi * lobes * fresnel * n_dot_l
    return result


def reflected(normal: FloatArray, view: FloatArray) -> FloatArray:
    """Return the mirror direction (..., 3): the direction to the eye, reflected at the normal."""
    return 2.0 * dot(normal, view)[..., None] * normal - view


def ambient_specular_fresnel(
    n_dot_v: FloatArray, gloss: FloatArray, reflectance: FloatArray
) -> FloatArray:
    """Return the Fresnel factor of preconvolved light, F₀ + (1−F₀)(1−N·V)⁵/(4−3G) (...) [Lagarde2011].

    G is the gloss.
    """
    grazing = (1.0 - np.clip(n_dot_v, 0.0, 1.0)) ** 5
    result: FloatArray = reflectance + (1.0 - reflectance) * grazing / (4.0 - 3.0 * gloss)
    return result


def diffuse_share(n_dot_v: FloatArray, gloss: FloatArray, reflectance: FloatArray) -> FloatArray:
    """Return the share (...) of light that passes the specular coat and is diffused."""
    return 1.0 - ambient_specular_fresnel(n_dot_v, gloss, reflectance)


def _lobe(
    n_dot_h: FloatArray, n_dot_l: FloatArray, n_dot_v: FloatArray, power: FloatArray
) -> FloatArray:
    """Return the distribution times the visibility (...) of a lobe."""
    distribution = (power + 2.0) / (2.0 * np.pi) * n_dot_h**power
    k = 1.0 / np.sqrt(np.pi * power / 4.0 + np.pi / 2.0)
    visibility = 0.25 / ((k + (1.0 - k) * n_dot_l) * (k + (1.0 - k) * n_dot_v))
    result: FloatArray = distribution * visibility
    return result
