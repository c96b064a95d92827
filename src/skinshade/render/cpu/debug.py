"""What lies under a picture, as a picture."""

from __future__ import annotations

import numpy as np

from ..._core.arrays import FloatArray
from ...shading.pixel import Incident, Surface
from ...shading.tonemap import linear_from_srgb

__all__ = ["curvature_colour", "debug_image"]

CURVATURE_RANGE_PER_MM = 0.2
THICKNESS_RANGE_MM = 30.0


def debug_image(view: str, surface: Surface, lights: list[Incident]) -> FloatArray | None:
    """Return a debug view (N, 3) of the geometry, or None where the view is a term of the light."""
    if view == "normal":
        return linear_from_srgb(0.5 + 0.5 * surface.sharp)
    if view == "blurred-normal":
        return linear_from_srgb(0.5 + 0.5 * surface.blurred)
    if view == "curvature":
        return curvature_colour(surface.curvature_per_mm)
    if view == "thickness":
        found = [light.thickness_mm for light in lights if light.thickness_mm is not None]
        thickness = np.min(found, axis=0) if found else np.zeros(surface.gloss.size)
        return _grey(np.clip(thickness / THICKNESS_RANGE_MM, 0.0, 1.0))
    if view == "shadow":
        found = [light.shadow_filter for light in lights]
        return _grey(np.max(found, axis=0) if found else np.ones(surface.gloss.size))
    if view == "albedo":
        return surface.albedo
    return None


def curvature_colour(curvature_per_mm: FloatArray) -> FloatArray:
    """Return linear light (N, 3): red where convex, blue where concave, full at the range's ends."""
    share = np.clip(curvature_per_mm / CURVATURE_RANGE_PER_MM, -1.0, 1.0)[:, None]
    convex, concave = np.array([0.85, 0.20, 0.10]), np.array([0.10, 0.30, 0.85])
    ends = np.where(share > 0.0, convex, concave)
    return linear_from_srgb(0.92 + (ends - 0.92) * np.sqrt(np.abs(share)))


def _grey(share: FloatArray) -> FloatArray:
    return np.repeat(linear_from_srgb(share)[:, None], 3, axis=1)
