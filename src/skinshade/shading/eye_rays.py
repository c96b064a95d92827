"""Rays of light through both surfaces of a cornea, for the tables of an eye (docs/eyes.md §3)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import FloatArray, dot
from ..params import EyeParams
from .eye import eye_height, eye_limbal_opacity, eye_normal
from .eye_light import dielectric_fresnel

__all__ = ["PARTS", "quasirandom_parts", "through_cornea"]

CORNEA_INDEX = 1.376
"""Index between the two surfaces of the cornea [LiouBrennan1997]."""
BACK_RADIUS_RATIO, BACK_ASPHERICITY, THICKNESS_MM = 6.4 / 7.8, -0.60, 0.50
"""Back surface of the cornea [LiouBrennan1997]: its radius over that of the front, asphericity, and
distance from the front."""
PARTS = 16
"""Parts in which rays are traced, so that each fits the processor's cache."""


def quasirandom_parts(count: int, dimensions: int) -> Iterator[FloatArray]:
    """Yield parts (1 + dimensions, n) of a quasirandom sequence of the unit cube [Roberts2018].

    The first coordinate rises evenly from 0 to 1, from part to part.
    """
    root = 2.0
    for _ in range(64):
        root = (1.0 + root) ** (1.0 / (dimensions + 1.0))
    steps = root ** -np.arange(1.0, dimensions + 1.0)
    for part in range(PARTS):
        index = np.arange(part * count, (part + 1) * count) + 0.5
        yield np.stack([index / (PARTS * count), *((0.5 + steps[:, None] * index) % 1.0)])


def _refracted(
    direction: FloatArray, normal: FloatArray, ratio: float
) -> tuple[FloatArray, NDArray[np.bool_]]:
    """Return the directions (n, 3) of refracted rays, and whether there are any (n,)."""
    c = -dot(direction, normal)
    radicand = 1.0 - ratio * ratio * (1.0 - c * c)
    bend = ratio * c - np.sqrt(np.maximum(radicand, 0.0))
    return ratio * direction + bend[:, None] * normal, radicand > 0.0


def through_cornea(
    params: EyeParams, x: FloatArray, y: FloatArray, light: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return where light that enters at x, y (n,) meets the cone of the iris, x, y (n,), and its flux (n,).

    The flux is that per unit of area of the plane of x and y, and of the beam.
    """
    r = np.hypot(x, y)
    entry = np.stack([x, y, eye_height(r, params.cornea, params.limbus)], axis=-1)
    normal = eye_normal(entry, params.cornea, params.limbus)
    facing = dot(normal, light)
    tears = np.array(params.tear_index)
    flux = facing / normal[:, 2] * (1.0 - dielectric_fresnel(facing, tears))
    flux *= 1.0 - eye_limbal_opacity(r, params.limbus)
    # The sclera hides light from behind.
    behind = dot(entry, light)
    reach2 = dot(entry, entry) - behind * behind
    lit = (facing > 0.0) & ~((behind < 0.0) & (reach2 < params.sclera_radius_mm**2))
    ray, passes = _refracted(-light, normal, 1.0 / CORNEA_INDEX)
    lit &= passes
    back, back_normal = _back_surface(params, entry, ray)
    before = np.clip(-dot(ray, back_normal), 0.0, 1.0)
    ray, passes = _refracted(ray, back_normal, CORNEA_INDEX / params.aqueous_index)
    lit &= passes
    # The reflection at the back is reversible: that of the cosine behind, from the thinner side.
    after = np.clip(-dot(ray, back_normal), 0.0, 1.0)
    flux *= 1.0 - _interface(before, after, CORNEA_INDEX / params.aqueous_index)
    hit = _cone(params, back, ray)
    return hit[:, 0], hit[:, 1], np.where(lit, flux, 0.0)


def _interface(before: FloatArray, after: FloatArray, ratio: float) -> FloatArray:
    """Return the reflectance of unpolarised light from the cosines (n,) on both sides of a surface."""
    s = (ratio * before - after) / np.maximum(ratio * before + after, 1e-9)
    p = (before - ratio * after) / np.maximum(before + ratio * after, 1e-9)
    result: FloatArray = 0.5 * (s * s + p * p)
    return result


def _back_surface(
    params: EyeParams, entry: FloatArray, ray: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return points and unit normals (n, 3) of the cornea's back surface on rays."""
    radius, q = params.cornea_radius_mm * BACK_RADIUS_RATIO, 1.0 + BACK_ASPHERICITY
    s = params.apex_mm - THICKNESS_MM - entry[:, 2]
    dz = ray[:, 2]
    a = 1.0 - (1.0 - q) * dz * dz
    b = dot(entry[:, :2], ray[:, :2]) + dz * (radius - q * s)
    c = dot(entry[:, :2], entry[:, :2]) - 2.0 * radius * s + q * s * s
    root = np.sqrt(np.maximum(b * b - a * c, 0.0))
    point = entry + (c / np.maximum(root - b, 1e-9))[:, None] * ray
    depth = params.apex_mm - THICKNESS_MM - point[:, 2]
    normal = np.stack([point[:, 0], point[:, 1], radius - q * depth], axis=-1)
    return point, normal / np.sqrt(dot(normal, normal))[:, None]


def _cone(params: EyeParams, point: FloatArray, ray: FloatArray) -> FloatArray:
    """Return the points (n, 3) of the cone of the iris on rays, far outside where there are none."""
    tip, slope = params.iris[0], params.iris[1]
    h, m2 = tip - point[:, 2], slope * slope
    a = ray[:, 2] ** 2 - m2 * dot(ray[:, :2], ray[:, :2])
    b = h * ray[:, 2] + m2 * dot(point[:, :2], ray[:, :2])
    e = h * h - m2 * dot(point[:, :2], point[:, :2])
    root = np.sqrt(np.maximum(b * b - a * e, 0.0))
    distance = e / np.maximum(b + root, 1e-9) if slope < 0.0 else (b + root) / np.maximum(a, 1e-4)
    return point + distance[:, None] * ray
