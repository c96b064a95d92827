"""The coat: one GGX lobe, its share of the light, and its reflection of the sky (MODEL §9)."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, dot, unit_vectors
from ..lut import Lut
from ..lut.coat import coat_fresnel
from ..params.gloss import alpha_from_gloss
from .specular import reflected

__all__ = [
    "alpha_from_gloss",
    "coat",
    "coat_direction",
    "coat_fresnel",
    "coat_highlight",
    "second_gloss",
]


def second_gloss(gloss: FloatArray) -> FloatArray:
    """Return the gloss (...) of the second lobe, whose power is the square of the first lobe's; at most 1."""
    return np.minimum(2.0 * gloss, 1.0)


def coat_highlight(
    normal: FloatArray,
    view: FloatArray,
    light: FloatArray,
    gloss: FloatArray,
    reflectance: FloatArray,
) -> FloatArray:
    """Return π·BRDF·(N·L) of a GGX lobe, the reflected radiance per unit of light (...).

    Parameters
    ----------
    normal
        (..., 3) sharp normals, unit vectors.
    view, light
        (..., 3) unit vectors towards the eye and towards the light.
    gloss
        (...) gloss of the lobe, 0..1.
    reflectance
        (...) reflectance F₀ at normal incidence; .028 for skin.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.coat import coat_highlight
    >>> up = np.array([0.0, 0.0, 1.0])
    >>> coat_highlight(up, up, up, np.array(0.427), np.array(0.028)).round(3)
    np.float64(0.171)
    """
    half = unit_vectors(view + light)
    n_dot_l = np.clip(dot(normal, light), 0.0, 1.0)
    n_dot_v = np.clip(dot(normal, view), 1e-4, 1.0)
    n_dot_h = np.clip(dot(normal, half), 0.0, 1.0)
    v_dot_h = np.clip(dot(view, half), 0.0, 1.0)
    squared = np.square(alpha_from_gloss(gloss))
    # Lagrange's identity: the squared sine, of which 1 − (N·H)² would lose digits in single precision.
    sine2 = np.maximum(dot(normal, normal) * dot(half, half) - np.square(n_dot_h), 0.0)
    sine2 = np.where(n_dot_h > 0.0, sine2, 1.0)  # an eye below the surface can have H below it
    root = squared / (np.square(n_dot_h) * squared + sine2)
    distribution = np.square(root) / (np.pi * squared)
    toward_eye = n_dot_l * np.sqrt(np.square(n_dot_v) * (1.0 - squared) + squared)
    toward_light = n_dot_v * np.sqrt(np.square(n_dot_l) * (1.0 - squared) + squared)
    visibility = 0.5 / (toward_eye + toward_light)
    fresnel = coat_fresnel(v_dot_h, reflectance)
    result: FloatArray = np.pi * distribution * visibility * fresnel * n_dot_l
    return result


def coat(
    lut: Lut,
    n_dot_v: FloatArray,
    gloss: FloatArray,
    reflectance: FloatArray,
    coat_reflectance: float,
) -> tuple[FloatArray, FloatArray]:
    """Return the directional albedo E (...) of a GGX lobe and the pull ω (...) of its mean direction.

    Parameters
    ----------
    lut
        Table of `skinshade.lut.build_coat_lut`.
    n_dot_v
        (...) cosine between the sharp normal and the direction towards the eye.
    gloss
        (...) gloss of the lobe, 0..1.
    reflectance
        (...) reflectance F₀ at normal incidence.
    coat_reflectance
        Reflectance that the table was built for. Another reflectance changes E as a Fresnel term that is
        (1−F₀)/(1−F₀') of the table's and 1 at grazing incidence would: within .015 of the integral for a
        change by a factor of 1.4.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.lut import build_coat_lut
    >>> from skinshade.shading.coat import coat
    >>> albedo, pull = coat(build_coat_lut(), np.array([0.2, 0.8]), np.array(0.427), np.array(0.028), 0.028)
    >>> albedo.round(3), pull.round(2)
    (array([0.14 , 0.031]), array([0.15, 0.01]))
    """
    column = np.sqrt(np.clip(n_dot_v, 0.0, 1.0))
    u, v = lut.columns.coordinate(column), lut.rows.coordinate(gloss)
    albedo, pull, unit_albedo = np.moveaxis(lut.sample_at(*np.broadcast_arrays(u, v)), -1, 0)
    share = (1.0 - reflectance) / (1.0 - coat_reflectance)
    mixed = unit_albedo + share * (albedo - unit_albedo)
    return np.clip(mixed, 0.0, unit_albedo), pull


def coat_direction(normal: FloatArray, view: FloatArray, pull: FloatArray) -> FloatArray:
    """Return the mean direction (..., 3) that a lobe reflects to the eye.

    Parameters
    ----------
    normal, view
        (..., 3) sharp normals, and directions towards the eye; unit vectors.
    pull
        (...) pull of the lobe towards the normal, from `coat`.
    """
    mirrored = reflected(normal, view)
    return unit_vectors(mirrored + pull[..., None] * (normal - mirrored))
