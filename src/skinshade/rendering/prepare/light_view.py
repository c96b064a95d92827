"""Camera of a light's shadow map, and the size of its texels in mm."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..._core.arrays import FloatArray, bounding_sphere
from ...mesh import Mesh
from ...scene import Light
from ...shading.shadow import light_coordinates

__all__ = ["MAP_SIZE", "LightView"]

MAP_SIZE = 1024
"""Texels along a side of a shadow map."""
BLUR_PER_WIDTH = 0.236
"""Ratio of standard deviation to filter width at which the integral of a Gaussian is closest to the
smoothstep: the greatest difference is .021."""
WIDEST_BLUR = 100.0
"""Greatest standard deviation of the variance filter, texels."""


@dataclass(frozen=True)
class LightView:
    """Camera of a light, whose view contains the whole body.

    Attributes
    ----------
    view, projection
        (4, 4) matrices for column vectors, from positions in mm.
    middle_mm
        (3,) middle of the body.
    radius_mm
        Radius of the body about its middle, mm.
    """

    view: FloatArray
    projection: FloatArray
    middle_mm: FloatArray
    radius_mm: float

    @classmethod
    def of(cls, light: Light, mesh: Mesh) -> LightView:
        """Return a view that contains the whole mesh, or the whole cone of a spot light."""
        middle, radius = bounding_sphere(mesh.positions_mm)
        return cls(*light.view_and_projection(middle, radius), middle, radius)

    @property
    def middle_depth_mm(self) -> float:
        """Depth of the body's middle along the light's axis, mm."""
        return float(self.coordinates(self.middle_mm[None])[0, 2])

    @property
    def least_texel_mm(self) -> float:
        """Width of a texel at the near plane of the projection, mm; no texel on the body is narrower."""
        a, b = self.projection[2, 2:]
        near = abs(b / a) if self.projection[3, 2] else 1.0
        return float(self.texel_mm(np.array(near)))

    def coordinates(self, position_mm: FloatArray) -> FloatArray:
        """Return u, v (down), depth in mm and clip coordinate w, (N, 4), of points (N, 3) in mm."""
        return light_coordinates(position_mm, self.view, self.projection)

    def texel_mm(self, w: FloatArray) -> FloatArray:
        """Return the width (N,) of a texel at points of clip coordinate w (N,), mm."""
        result: FloatArray = np.abs(w) * 2.0 / (self.projection[0, 0] * MAP_SIZE)
        return result

    def blur_texels(self, width_mm: float) -> float:
        """Return the standard deviation of the variance filter, texels, for a filter width in mm.

        The size of a spot light's texels is taken at the body's middle. Close to the light, where texels
        are very small, the result is limited to `WIDEST_BLUR`.
        """
        w = self.coordinates(self.middle_mm[None])[0, 3]
        texel_mm = max(float(self.texel_mm(w)), 1e-9)
        return min(BLUR_PER_WIDTH * width_mm / texel_mm, WIDEST_BLUR)
