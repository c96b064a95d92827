"""Debug views of the surface."""

from __future__ import annotations

import numpy as np

from ..._core.arrays import FloatArray
from ...params.choices import View
from ...shading.pixel import Incident, Surface
from ...shading.tonemap import linear_from_srgb
from ..prepare.colours import curvature_colour, grey
from ..settings import THICKNESS_RANGE_MM

__all__ = ["surface_view"]


def surface_view(view: View, surface: Surface, lights: list[Incident]) -> FloatArray | None:
    """Return a view (N, 3) of the surface, or None where the view shows light."""
    if view == View.NORMAL:
        return linear_from_srgb(0.5 + 0.5 * surface.sharp)
    if view == View.BLURRED_NORMAL:
        return linear_from_srgb(0.5 + 0.5 * surface.blurred)
    if view == View.CURVATURE:
        return curvature_colour(surface.curvature_per_mm)
    if view == View.THICKNESS:
        thicknesses = [light.thickness_mm for light in lights if light.thickness_mm is not None]
        thickness = np.min(thicknesses, axis=0) if thicknesses else np.zeros(surface.gloss.size)
        return grey(np.clip(thickness / THICKNESS_RANGE_MM, 0.0, 1.0))
    if view == View.SHADOW:
        filters = [light.shadow_filter for light in lights]
        return grey(np.max(filters, axis=0) if filters else np.ones(surface.gloss.size))
    if view == View.ALBEDO:
        return surface.albedo
    return None
