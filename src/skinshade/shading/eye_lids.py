"""Light that the lids let through, and the tears on their margins (docs/eyes.md §5).

A lid is a part of a ball around the centre of the eye, beyond a plane. Arguments ``upper``, ``lower`` and
``lid`` (..., 4) hold the plane: its unit normal n and its distance D, mm. The lid covers points P of the eye
with n·P > D.
"""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, dot, unit_vectors
from .eye import eye_height, smoothstep

__all__ = ["lid_iris_openness", "lid_openness", "lid_visibility", "tear_normal"]

LID_ENTRY_SHARE, LID_ENTRY_RISE = 0.83, 0.41
"""Distance from the axis at which an even sky's light enters, over that of the point of the iris that it
reaches: in the middle, and its increase with the fourth power of the distance over that of the limbus. These
numbers and the three below are fitted to paths through the cornea, between lids that are wide open to half
closed."""
LID_CLEARANCE_MM = 0.58
"""Distance of the point of half the light in front of the plane of a lid, mm."""
LID_DISTANCE_MM = 2.59
"""Width of the shadow of a lid on the iris, mm."""
LID_NARROWING = 1.12
"""Decrease of both lengths with the same fourth power: light of the rim enters near the rim."""
LEAST_NARROWED = 0.05
"""Least remainder of both lengths."""
LEAST_MARGIN = 1e-4
"""Least width of a ramp: a step."""


def lid_visibility(
    position_mm: FloatArray,
    direction: FloatArray,
    spread: FloatArray,
    margin_mm: FloatArray,
    upper: FloatArray,
    lower: FloatArray,
    radius_mm: FloatArray,
) -> FloatArray:
    """Return the share (...) of a round lamp, or of a reflection, that the lids do not hide, 0..1.

    Parameters
    ----------
    position_mm
        (..., 3) points of the eye.
    direction
        (..., 3) unit vectors out of the eye: to the lamp, or along a reflection.
    spread
        (...) half angle of the lamp or of the reflection's lobe, radians.
    margin_mm
        (...) half width of the ramp between points that a lid covers and points that it does not; 0 for a
        step.
    upper, lower
        (..., 4) planes of the lids.
    radius_mm
        (...) radius of the lids' ball.
    """
    along = dot(position_mm, direction)
    inside = radius_mm * radius_mm - dot(position_mm, position_mm)
    distance = np.sqrt(np.maximum(along * along + inside, 0.0)) - along
    exit_mm = position_mm + distance[..., None] * direction
    penumbra = np.maximum(2.0 * distance * spread, LEAST_MARGIN)
    ramp = np.maximum(2.0 * margin_mm, LEAST_MARGIN)
    share = np.ones_like(along)
    for lid in (upper, lower):
        free = lid[..., 3] - dot(lid[..., :3], exit_mm)
        bare = lid[..., 3] - dot(lid[..., :3], position_mm)
        share = share * smoothstep(free / penumbra + 0.5) * np.clip(bare / ramp + 0.5, 0.0, 1.0)
    return share


def lid_openness(
    position_mm: FloatArray,
    normal: FloatArray,
    upper: FloatArray,
    lower: FloatArray,
    radius_mm: FloatArray,
) -> FloatArray:
    """Return the share (...) of an even sky's irradiance that the lids do not hide from points of the eye.

    Parameters
    ----------
    position_mm, normal
        (..., 3) points of the eye and their unit normals.
    upper, lower
        (..., 4) planes of the lids.
    radius_mm
        (...) radius of the lids' ball.
    """
    share = 1.0 - _hidden(position_mm, normal, upper, radius_mm)
    share = share - _hidden(position_mm, normal, lower, radius_mm)
    result: FloatArray = np.clip(share, 0.0, 1.0)
    return result


def lid_iris_openness(
    hit_mm: FloatArray,
    cornea: FloatArray,
    limbus: FloatArray,
    upper: FloatArray,
    lower: FloatArray,
) -> FloatArray:
    """Return the share (...) of an even sky's light on the iris that the lids do not hide.

    Parameters
    ----------
    hit_mm
        (..., 3) points of the iris.
    cornea, limbus
        (..., 4) parameters of `skinshade.shading.eye`.
    upper, lower
        (..., 4) planes of the lids.
    """
    squared = dot(hit_mm[..., :2], hit_mm[..., :2]) / limbus[..., 0] ** 2
    rim = squared * squared
    entry = (LID_ENTRY_SHARE + LID_ENTRY_RISE * rim)[..., None] * hit_mm[..., :2]
    narrowed = np.maximum(1.0 - LID_NARROWING * rim, LEAST_NARROWED)
    width = LID_DISTANCE_MM * narrowed
    r = np.sqrt(dot(entry, entry))
    height = eye_height(r, cornea, limbus)
    position = np.concatenate([entry, height[..., None]], axis=-1)
    share = np.ones_like(r)
    for lid in (upper, lower):
        a = lid[..., 3] - dot(lid[..., :3], position) - LID_CLEARANCE_MM * narrowed
        share = share - 0.5 * (1.0 - a / np.sqrt(a * a + width * width))
    result: FloatArray = np.clip(share, 0.0, 1.0)
    return result


def tear_normal(
    position_mm: FloatArray, normal: FloatArray, lid: FloatArray, height_mm: FloatArray
) -> FloatArray:
    """Return unit normals (..., 3) of the eye with the tears on the margin of a lid, a concave fillet.

    Parameters
    ----------
    position_mm, normal
        (..., 3) points of the eye and their unit normals.
    lid
        (..., 4) plane of the lid.
    height_mm
        (...) height of the tears on the eye; 0 for none.
    """
    n = lid[..., :3]
    bare = lid[..., 3] - dot(n, position_mm)
    sine = np.clip(1.0 - bare / np.maximum(height_mm, LEAST_MARGIN), 0.0, 1.0)
    cosine = np.sqrt(np.maximum(1.0 - sine * sine, 0.0))
    across = unit_vectors(n - dot(n, normal)[..., None] * normal)
    return unit_vectors(cosine[..., None] * normal - sine[..., None] * across)


def _hidden(
    position_mm: FloatArray, normal: FloatArray, lid: FloatArray, radius_mm: FloatArray
) -> FloatArray:
    """Return the share (...) of an even sky's irradiance that one lid hides.

    The margin is the point where plane and ball meet above the position, in the plane of both normals. If
    they do not meet, the lid hides nothing.
    """
    n = lid[..., :3]
    toward = dot(n, normal)
    tangent = np.sqrt(np.maximum(1.0 - toward * toward, LEAST_MARGIN))
    across = (n - toward[..., None] * normal) / tangent[..., None]
    rise = tangent[..., None] * normal - toward[..., None] * across
    bare = lid[..., 3] - dot(n, position_mm)
    foot = position_mm + bare[..., None] * n
    along = dot(foot, rise)
    outside = dot(foot, foot) - radius_mm * radius_mm
    radicand = along * along - outside
    length = np.sqrt(np.maximum(radicand, 0.0)) - along
    above, beside = bare * toward + length * tangent, bare * tangent - length * toward
    cosine = beside / np.maximum(np.sqrt(above * above + beside * beside), LEAST_MARGIN)
    result: FloatArray = np.where((above > 0.0) & (radicand > 0.0), 0.5 * (1.0 - cosine), 0.0)
    return result
