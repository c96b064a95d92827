"""Light on the iris from tables, and reflection by the tears (docs/eyes.md §3, §5)."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, dot
from ..lut import Lut
from .eye import smoothstep

__all__ = [
    "dielectric_fresnel",
    "eye_ambient",
    "eye_inside",
    "eye_light",
    "lamp_highlight",
    "pupil_radius",
]

EYE_SLICES, EYE_COLUMNS, EYE_ROWS = 16.0, 32.0, 16.0
"""Angles of the light, and columns and rows of each of them, in the table of a lamp."""
EYE_LEAST_COSINE = -0.3420201433256687
"""Cosine of 110°, the greatest angle between light and gaze at which light reaches the iris."""
EYE_WARP = 0.7
"""Power of the cosine that spaces the angles, so that those near 90° are close to each other."""
EYE_LAST_SINE = 0.5055021429481007
"""Sine of the angle of the slice next to straight light. The entry moves with the sine of a small angle, and
with the warped cosine it would move with its square."""
LEAST_LUMINANCE, GREATEST_LUMINANCE = 1e-6, 1e8
"""Luminance at which the pupil has long been widest and narrowest, cd/m²."""


def eye_light(lut: Lut, hit_mm: FloatArray, light: FloatArray) -> FloatArray:
    """Return light on the iris (..., 3): irradiance over that facing the light, and entry x, y, mm.

    Parameters
    ----------
    lut
        Table ``lamp`` of `skinshade.build_eye_lut`.
    hit_mm
        (..., 3) points of the iris, mm.
    light
        (..., 3) unit vectors from the eye to the light, in the frame of the eye.

    Notes
    -----
    Light that reaches the point has entered the cornea at x, y: from there the shadows of the lids and the
    direction of the light inside follow.
    """
    across = np.sqrt(light[..., 0] ** 2 + light[..., 1] ** 2)
    turned = across > 1e-6
    safe = np.maximum(across, 1e-6)
    cosine = np.where(turned, light[..., 0] / safe, 1.0)
    sine = np.where(turned, light[..., 1] / safe, 0.0)
    x = hit_mm[..., 0] * cosine + hit_mm[..., 1] * sine
    y = hit_mm[..., 1] * cosine - hit_mm[..., 0] * sine
    index = eye_slice(light[..., 2])
    low = np.minimum(np.floor(index), EYE_SLICES - 2.0)
    iris_radius = -lut.columns.low * (EYE_COLUMNS - 1.0) / EYE_COLUMNS
    row = 0.5 + (EYE_ROWS - 1.0) * np.minimum(np.abs(y) / iris_radius, 1.0) + EYE_ROWS * low
    u = lut.columns.coordinate(x)
    first = lut.sample_at(u, lut.rows.coordinate(row))
    second = lut.sample_at(u, lut.rows.coordinate(row + EYE_ROWS))
    weight = index - low
    straight = 1.0 - np.minimum(across / EYE_LAST_SINE, 1.0)
    moved = np.where(low > EYE_SLICES - 2.5, straight, weight)
    value = first + (second - first) * np.stack([weight, moved, moved], axis=-1)
    entry_x, entry_y = value[..., 1], np.where(y < 0.0, -value[..., 2], value[..., 2])
    return np.stack(
        [
            value[..., 0],
            entry_x * cosine - entry_y * sine,
            entry_x * sine + entry_y * cosine,
        ],
        axis=-1,
    )


def eye_slice(cosine: FloatArray) -> FloatArray:
    """Return the fractional slice (...) of the lamp's table for cosines (...) between light and gaze."""
    clamped = np.clip(cosine, EYE_LEAST_COSINE, 1.0)
    warped = np.sign(clamped) * np.abs(clamped) ** EYE_WARP
    least = -((-EYE_LEAST_COSINE) ** EYE_WARP)
    result: FloatArray = (EYE_SLICES - 1.0) * (warped - least) / (1.0 - least)
    return result


def eye_ambient(lut: Lut, r_mm: FloatArray) -> FloatArray:
    """Return factors (..., 4) of surroundings' light on the iris: of bands 0, 1 and 2, and a tilt, radians.

    The light is that of `skinshade.shading.ambient.ambient_irradiance` with the three factors, at the
    normal cos(tilt) z + sin(tilt) r, where r is the unit vector away from the axis.

    Parameters
    ----------
    lut
        Table ``surroundings`` of `skinshade.build_eye_lut`.
    r_mm
        (...) distance of the point of the iris from the axis, mm.
    """
    u = lut.columns.coordinate(r_mm)
    bands = lut.sample_at(u, np.full_like(u, 0.25))
    tilt = lut.sample_at(u, np.full_like(u, 0.75))
    return np.concatenate([bands, tilt[..., :1]], axis=-1)


def eye_inside(n_dot_v: FloatArray, index: FloatArray) -> FloatArray:
    """Return the radiance outside over that inside (...), (1 − F)/index², at cosines (...) outside.

    The radiance of an iris of albedo A that receives the irradiance E is A·E/π times this.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.eye_light import eye_inside
    >>> eye_inside(np.array([1.0, 0.5]), np.array(1.336)).round(3)
    array([0.549, 0.526])
    """
    result: FloatArray = (1.0 - dielectric_fresnel(n_dot_v, index)) / (index * index)
    return result


def dielectric_fresnel(cosine: FloatArray, index: FloatArray) -> FloatArray:
    """Return the exact reflectance (...) of unpolarised light at cosines (...) in air, for an index above 1.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.eye_light import dielectric_fresnel
    >>> dielectric_fresnel(np.array([1.0, 0.5, 0.0]), np.array(1.337)).round(4)
    array([0.0208, 0.0604, 1.    ])
    """
    c = np.clip(cosine, 0.0, 1.0)
    inside = np.sqrt(np.maximum(index * index - 1.0 + c * c, 0.0))
    s = (c - inside) / np.maximum(c + inside, 1e-6)
    p = (index * index * c - inside) / np.maximum(index * index * c + inside, 1e-6)
    result: FloatArray = 0.5 * (s * s + p * p)
    return result


def lamp_highlight(
    reflected: FloatArray, light: FloatArray, lamp: FloatArray, roughness: FloatArray
) -> FloatArray:
    """Return the reflection (...) of a round lamp before Fresnel's factor, over its irradiance divided by π.

    Parameters
    ----------
    reflected
        (..., 3) unit mirror directions of the view.
    light
        (..., 3) unit vectors to the middle of the lamp.
    lamp
        (...) half angle of the lamp, radians, up to about .5.
    roughness
        (...) angle by which the surface widens a reflection, radians.

    Notes
    -----
    The integral over all directions is π. The angle between the directions is a series of its chord, within
    .001 up to 60°.
    """
    apart = reflected - light
    chord2 = dot(apart, apart)
    angle = np.sqrt(chord2) * (1.0 + chord2 * (1.0 / 24.0 + chord2 * (3.0 / 640.0)))
    wide = np.sqrt(lamp * lamp + roughness * roughness)
    soft = np.maximum(roughness, 1e-4)
    disk = smoothstep((wide + soft - angle) / (2.0 * soft))
    result: FloatArray = disk / (np.sin(wide) ** 2 + soft * soft / 5.0)
    return result


def pupil_radius(luminance: FloatArray) -> FloatArray:
    """Return the radius (...) of the pupil, mm, at a luminance (...), cd/m² [MoonSpencer1944].

    The luminance is in the form of [Watson2012].

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.eye_light import pupil_radius
    >>> pupil_radius(np.array([0.01, 1.0, 100.0])).round(2)
    array([3.45, 2.45, 1.45])
    """
    bounded = np.clip(luminance, LEAST_LUMINANCE, GREATEST_LUMINANCE)
    result: FloatArray = 2.45 - 1.5 * np.tanh(0.4 * np.log10(bounded))
    return result
