"""Two-lobe specular: Blinn-Phong distribution, Schlick-Smith visibility, Schlick Fresnel (MODEL §9)."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, dot, unit_vectors

__all__ = [
    "ambient_specular_fresnel",
    "diffuse_share",
    "gloss_from_roughness",
    "gloss_of_relief",
    "reflected",
    "specular",
    "specular_power",
]

POWER_OCTAVES = 13.0
"""Gloss 1 is a power of 2¹³, about the sharpest highlight that 8-bit gloss maps can place [Lagarde2011]."""
SHARP_LOBE_SHARE = 0.05
"""Weight of the second lobe, whose power is the first one's square [Jimenez2013]."""
SHARPEST_POWER = 2.0**POWER_OCTAVES


def specular_power(gloss: FloatArray) -> FloatArray:
    """Return the Blinn-Phong power 2^(13·gloss) of gloss 0..1."""
    result: FloatArray = np.exp2(POWER_OCTAVES * gloss)
    return result


def gloss_of_relief(gloss: FloatArray, normal_length: FloatArray) -> FloatArray:
    """Return the gloss (...) widened by relief that a mip level has averaged away [Toksvig2005].

    Parameters
    ----------
    gloss
        (...) 0..1.
    normal_length
        (...) of the averaged normal, 0..1: the shorter, the more the normals within it spread.
    """
    length = np.clip(normal_length, 1e-3, 1.0)
    power = specular_power(gloss)
    widened = length * power / (length + power * (1.0 - length))
    result: FloatArray = np.log2(np.maximum(widened, 1.0)) / POWER_OCTAVES
    return result


def gloss_from_roughness(roughness: FloatArray | float) -> FloatArray:
    """Return the gloss whose lobe is as wide as GGX of a roughness r: power 2/r⁴ − 2 [Walter2007]."""
    power = 2.0 / np.maximum(np.asarray(roughness, dtype=np.float64), 1e-3) ** 4 - 2.0
    result: FloatArray = np.clip(np.log2(np.maximum(power, 1.0)) / POWER_OCTAVES, 0.0, 1.0)
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
    normal, view, light
        (..., 3) unit; the sharp normal, towards the eye, towards the light.
    gloss
        (...) 0..1.
    reflectance
        (...) F₀ at normal incidence; .028 for skin.
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
    """Return the mirror direction (..., 3) of the eye about the normal."""
    return 2.0 * dot(normal, view)[..., None] * normal - view


def ambient_specular_fresnel(
    n_dot_v: FloatArray, gloss: FloatArray, reflectance: FloatArray
) -> FloatArray:
    """Return F₀ + (1−F₀)(1−N·V)⁵/(4−3·gloss) (...), for preconvolved ambient light [Lagarde2011]."""
    grazing = (1.0 - np.clip(n_dot_v, 0.0, 1.0)) ** 5
    result: FloatArray = reflectance + (1.0 - reflectance) * grazing / (4.0 - 3.0 * gloss)
    return result


def diffuse_share(n_dot_v: FloatArray, gloss: FloatArray, reflectance: FloatArray) -> FloatArray:
    """Return the share (...) of light that the specular coat lets through to be diffused."""
    return 1.0 - ambient_specular_fresnel(n_dot_v, gloss, reflectance)


def _lobe(
    n_dot_h: FloatArray, n_dot_l: FloatArray, n_dot_v: FloatArray, power: FloatArray
) -> FloatArray:
    distribution = (power + 2.0) / (2.0 * np.pi) * n_dot_h**power
    k = 1.0 / np.sqrt(np.pi * power / 4.0 + np.pi / 2.0)
    visibility = 0.25 / ((k + (1.0 - k) * n_dot_l) * (k + (1.0 - k) * n_dot_v))
    result: FloatArray = distribution * visibility
    return result
