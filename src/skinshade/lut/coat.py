"""Tables of the coat: what a GGX lobe reflects from one direction (MODEL §9)."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from .._core.arrays import FloatArray, as_floats
from .._core.version import __version__
from ..params.gloss import alpha_from_gloss
from .table import Axis, Lut, checked_size

__all__ = ["build_coat_lut", "coat_fresnel"]

RADII, ANGLES = 16, 10
"""Nodes of the quadrature over visible normals: E is within 3e-4 of 33,000 nodes."""
COSINES = (1e-4, 0.998)
"""N·V of the first and the last column. At 0 nothing is visible, and at 1 the pull is 0/0; E changes by less
than 2e-4 from here to there."""
GREATEST_REFLECTANCE = 0.9
"""Reflectance above which the index of refraction no longer grows; at 1 it would be infinite."""


def coat_fresnel(cosine: FloatArray, reflectance: FloatArray) -> FloatArray:
    """Return the reflectance (...) of a smooth dielectric for unpolarised light (Fresnel's equations).

    Parameters
    ----------
    cosine
        (...) cosine between the light and the normal, 0..1.
    reflectance
        (...) reflectance F₀ at normal incidence, which gives the index of refraction
        (1 + √F₀)/(1 − √F₀); values above .9 have that of .9.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.lut.coat import coat_fresnel
    >>> coat_fresnel(np.array([0.0, 0.5, 1.0]), np.array(0.028)).round(3)
    array([1.   , 0.072, 0.028])
    """
    root = np.sqrt(np.clip(reflectance, 0.0, GREATEST_REFLECTANCE))
    # With g² = η² − 1 + c², g − c is (η² − 1)/(g + c), without cancellation.
    excess = 4.0 * root / np.square(1.0 - root)
    total = np.maximum(np.sqrt(excess + np.square(cosine)) + cosine, 1e-9)
    across = excess / np.square(total)
    along = (cosine * total - 1.0) / (cosine * excess / total + 1.0)
    result: FloatArray = 0.5 * np.square(across) * (1.0 + np.square(along))
    return result


def build_coat_lut(*, reflectance: float = 0.028, size: tuple[int, int] = (64, 32)) -> Lut:
    """Tabulate the reflection of a GGX lobe over the square root of N·V (columns) and gloss (rows).

    Parameters
    ----------
    reflectance
        Reflectance at normal incidence, 0..1.
    size
        (width, height) in texels, 2..16384.

    Returns
    -------
    Lut
        Three numbers of one lobe: the directional albedo E, the share of the light from one direction that
        the lobe reflects; the pull ω of its mean direction, which is that of (1−ω)R + ωN with the mirror
        direction R; and E of the same lobe with Fresnel 1. Bilinear lookups of E are within 1e-3 of the
        integral in the default size.

    Raises
    ------
    ArgumentError
        If a size or the reflectance is out of range.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.lut import build_coat_lut
    >>> gloss = 0.427  # a roughness of .45
    >>> build_coat_lut().sample(np.sqrt([0.1, 0.4, 1.0]), gloss)[:, 0].round(3)
    array([0.185, 0.079, 0.027])
    """
    width, height = checked_size(size)
    return _built(
        float(as_floats("reflectance", reflectance, (), low=0.0, high=1.0)), width, height
    )


@lru_cache(maxsize=16)
def _built(reflectance: float, width: int, height: int) -> Lut:
    """Return the table; it is kept, because most materials of a scene have one reflectance."""
    columns, rows = _axis("root_n_dot_v", width), _axis("gloss", height)
    cosine = np.clip(np.square(np.linspace(0.0, 1.0, width)), *COSINES)
    alpha = alpha_from_gloss(np.linspace(0.0, 1.0, height))
    values = np.stack([_reflection(cosine, one, reflectance) for one in alpha])
    provenance = {"reflectance": reflectance, "version": __version__}
    return Lut(values.astype(np.float32), "coat", columns, rows, provenance)


def _axis(name: str, count: int) -> Axis:
    """Return an axis whose first texel centre is 0 and whose last is 1: the limits are exact."""
    half = 0.5 / (count - 1)
    return Axis(name, "1", -half, 1.0 + half)


def _reflection(cosine: FloatArray, alpha: float, reflectance: float) -> FloatArray:
    """Return E, ω and E of Fresnel 1 (n, 3) for N·V (n,), by quadrature over visible normals."""
    c, squared = cosine[:, None], alpha * alpha
    s = np.sqrt(1.0 - c * c)
    hx, hz, weights = _visible_normals(c, s, alpha)
    v_dot_h = np.clip(s * hx + c * hz, 0.0, 1.0)
    across, up = 2.0 * v_dot_h * hx - s, 2.0 * v_dot_h * hz - c
    # Height-correlated shadowing and masking over masking alone, which the visible normals contain.
    from_eye, from_light = _lambda(c, squared), _lambda(np.maximum(up, 1e-9), squared)
    share = np.where(up > 0.0, (1.0 + from_eye) / (1.0 + from_eye + from_light), 0.0) * weights
    reflected = share * coat_fresnel(v_dot_h, np.asarray(reflectance))
    mean_away, mean_up = -(reflected * across).sum(axis=1), (reflected * up).sum(axis=1)
    turned = s[:, 0] * mean_up - cosine * mean_away
    pull = turned / np.where(reflectance > 0.0, turned + mean_away, 1.0)
    return np.stack([reflected.sum(axis=1), pull, share.sum(axis=1)], axis=1)


def _visible_normals(
    c: FloatArray, s: FloatArray, alpha: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the components x and z (n, m) of microfacet normals, and their weights (m,) [Heitz2018].

    The eye is at (s, 0, c). The nodes fill half of the disk, because the other half is its mirror image. They
    are denser towards the rim, where the long tail of GGX lies.
    """
    nodes, weights = np.polynomial.legendre.leggauss(RADII)
    inner = 0.5 - 0.5 * nodes
    angle = np.pi * ((np.arange(ANGLES) + 0.5) / ANGLES - 0.5)
    radius = np.sqrt(1.0 - inner * inner)
    first = (radius[:, None] * np.cos(angle)).ravel()
    second = (radius[:, None] * np.sin(angle)).ravel()
    weight = np.repeat(weights * inner / ANGLES, ANGLES)
    length = np.sqrt(np.square(alpha * s) + c * c)
    eye_x, eye_z = alpha * s / length, c / length
    half = 0.5 * (1.0 + eye_z)
    second = (1.0 - half) * np.sqrt(np.maximum(1.0 - first * first, 0.0)) + half * second
    third = np.sqrt(np.maximum(1.0 - first * first - second * second, 0.0))
    x, y = alpha * (eye_x * third - eye_z * second), alpha * first
    z = np.maximum(eye_x * second + eye_z * third, 1e-12)
    norm = np.sqrt(x * x + y * y + z * z)
    return x / norm, z / norm, weight


def _lambda(cosine: FloatArray, alpha_squared: float) -> FloatArray:
    """Return Smith's Λ (...) of GGX at a cosine (...) above 0 [Heitz2014]."""
    tangent = 1.0 / np.square(cosine) - 1.0
    result: FloatArray = 0.5 * (np.sqrt(1.0 + alpha_squared * tangent) - 1.0)
    return result
