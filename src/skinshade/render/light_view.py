"""How a light sees the body: the square of a shadow map, in texels and mm."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._core.arrays import FloatArray, bounding_sphere
from ..mesh import Mesh
from ..scene import Light

__all__ = ["MAP_SIZE", "LightView"]

MAP_SIZE = 1024
"""Texels along a side."""
BLUR_PER_WIDTH = 0.236
"""A Gaussian's integral is then within .020 of the smoothstep everywhere, its best."""
WIDEST_BLUR = 100.0
"""Texels."""


@dataclass(frozen=True)
class LightView:
    """A light's camera.

    Attributes
    ----------
    view, projection
        (4, 4) matrices from mm.
    middle_mm
        (3,) of the body.
    reach_mm
        Radius of the body about its middle.
    """

    view: FloatArray
    projection: FloatArray
    middle_mm: FloatArray
    reach_mm: float

    @classmethod
    def of(cls, light: Light, mesh: Mesh) -> LightView:
        """Return a view that holds the whole mesh, or the whole of a lamp's cone."""
        middle, reach = bounding_sphere(mesh.positions_mm)
        return cls(*light.view_and_projection(middle, reach), middle, reach)

    @property
    def middle_depth_mm(self) -> float:
        """Depth of the body's middle."""
        return float(self.place(self.middle_mm[None])[2][0])

    def blur_texels(self, width_mm: float) -> float:
        """Return the standard deviation of the variance filter that passes for a smoothstep of a width.

        A lamp's texels are taken as wide as they are in the body's middle; beside it, where they are as
        small as nothing, the filter ends at `WIDEST_BLUR`.
        """
        texel_mm = float(self.place(self.middle_mm[None])[3][0])
        return min(BLUR_PER_WIDTH * width_mm / max(texel_mm, 1e-9), WIDEST_BLUR)

    def place(
        self, position_mm: FloatArray
    ) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
        """Return x and y in texels, depth and the size of a texel there, mm, of points (N, 3)."""
        seen = position_mm @ self.view[:3, :3].T + self.view[:3, 3]
        clip = seen @ self.projection[:, :3].T + self.projection[:, 3]
        w = np.where(np.abs(clip[:, 3]) < 1e-9, 1e-9, clip[:, 3])
        x = (0.5 * clip[:, 0] / w + 0.5) * MAP_SIZE
        y = (0.5 - 0.5 * clip[:, 1] / w) * MAP_SIZE
        return x, y, -seen[:, 2], np.abs(w) * 2.0 / (self.projection[0, 0] * MAP_SIZE)
