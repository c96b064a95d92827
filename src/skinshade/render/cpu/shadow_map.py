"""Depth seen from a light: the wide shadow filter and the thickness of what is lit from behind."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from scipy.ndimage import gaussian_filter1d, map_coordinates, maximum_filter, minimum_filter

from ..._core.arrays import FloatArray, dot, unit_vectors
from ...mesh import Mesh
from ...scene import Light
from ...shading.deep_scatter import inward_offset, poisson_disk, thickness_from_depths
from ...shading.shadow import variance_shadow
from ..light_view import MAP_SIZE, LightView
from .raster import depth_maps

__all__ = ["FILTER_TAPS", "ShadowFilter", "ShadowMap", "hemisphere_disk", "render_shadow_map"]

ShadowFilter = Literal["percentage-closer", "variance"]

FILTER_TAPS = 48
BLUR_REACH = 3.0
"""Standard deviations that the variance filter's Gaussian holds."""
NOWHERE_MM = 1e30
"""Depth of nothing for the GPU: infinity cannot be filtered, nor compared on every driver."""
STEEPEST_SLOPE = 8.0
HOLLOW_PER_MM = 0.04
"""Receivers are planes no steeper than `STEEPEST_SLOPE` against the light; in a hollow of this curvature
no steeper than 1, because the plane would pass for the wall that shadows it."""
BIAS_MM = 0.4
TERMINATOR_REACH_MM = 8.0
"""How far along the surface light is taken to have come from where it is lit."""
ATTACHED_MM = 4.0
"""A hollow of a face rises this much above the plane of a receiver within the filter; what is nearer
to the light by more, or has a far side before the receiver, is another part that casts a shadow."""


@dataclass(frozen=True)
class ShadowMap:
    """Depths along a light's axis, mm.

    Attributes
    ----------
    seen
        How the light sees the body.
    first
        (S, S) the nearest surface; infinite where there is none.
    occluders
        (S, S) what shadows: the nearest surface that faces away, or `first` and `ATTACHED_MM` more.
    """

    seen: LightView
    first: FloatArray
    occluders: FloatArray
    cache: dict[int, tuple[FloatArray, FloatArray]] = field(default_factory=dict)
    blurred: dict[float, tuple[FloatArray, FloatArray]] = field(default_factory=dict)

    def shadow_filter(
        self,
        position_mm: FloatArray,
        normal: FloatArray,
        to_light: FloatArray,
        curvature_per_mm: FloatArray,
        width_mm: float,
        kind: ShadowFilter = "percentage-closer",
    ) -> FloatArray:
        """Return the share (N,) of a disk across the light that is lit.

        Past the terminator a body hides itself from the light, which is not a shadow but what the
        curvature table describes: there the question is asked where the light that diffuses comes from,
        at the terminator itself.

        Percentage-closer: the disk's weight is a hemisphere, √(1−r²), whose transfer across a straight
        edge is exactly the smoothstep that the shadow table inverts; receivers are planes, so that a
        slope does not shadow itself. Variance: a Gaussian as wide of the nearest surface, and what its
        moments tell; a slope's own variance keeps it lit.
        """
        cosine = dot(normal, to_light)
        past = np.maximum(-cosine, 0.0)
        tangential = unit_vectors(to_light - normal * cosine[:, None])
        reach = np.minimum(past / np.maximum(curvature_per_mm, 1e-3), TERMINATOR_REACH_MM)
        at_terminator = position_mm + tangential * reach[:, None]
        if kind == "variance":
            return self._from_moments(at_terminator, width_mm)
        upright = unit_vectors(normal + to_light * past[:, None])
        hollow = np.clip(1.0 + curvature_per_mm / HOLLOW_PER_MM, 0.0, 1.0)
        slope = self._slopes(upright, 1.0 + (STEEPEST_SLOPE - 1.0) * hollow)
        return self._filtered(at_terminator, slope, width_mm)

    def _from_moments(self, position_mm: FloatArray, width_mm: float) -> FloatArray:
        x, y, depth, _ = self.seen.place(position_mm)
        # Its last row and column go on for ever, as the Gaussian's do.
        mean, mean_square = (
            map_coordinates(each, (y - 0.5, x - 0.5), order=1, mode="nearest")
            for each in self.moments(width_mm)
        )
        return variance_shadow(mean, mean_square, depth - BIAS_MM - self.seen.middle_depth_mm)

    def moments(self, width_mm: float) -> tuple[FloatArray, FloatArray]:
        """Return blurred depth and its square (S, S) from the body's middle; nothing is its far end."""
        if width_mm not in self.blurred:
            depth = np.minimum(self.first - self.seen.middle_depth_mm, self.seen.reach_mm)
            sigma = self.seen.blur_texels(width_mm)
            both = []
            for each in (depth, depth * depth):
                for axis in (1, 0):
                    each = gaussian_filter1d(
                        each, sigma, axis=axis, mode="nearest", truncate=BLUR_REACH
                    )
                both.append(each)
            self.blurred[width_mm] = both[0], both[1]
        return self.blurred[width_mm]

    def _filtered(
        self, position_mm: FloatArray, slope: tuple[FloatArray, FloatArray], width_mm: float
    ) -> FloatArray:
        if not position_mm.size:
            return np.zeros(0)
        x, y, depth, texel_mm = self.seen.place(position_mm)
        depth = depth - BIAS_MM
        # Beside a lamp a texel is as small as nothing; no filter need be wider than the map.
        radius = np.minimum(0.5 * width_mm / texel_mm, MAP_SIZE)
        margin = np.hypot(*slope) * 0.5 * width_mm
        nearest, farthest = self._extremes(int(np.ceil(radius.max())) + 1)
        at = (
            np.clip(y, 0, MAP_SIZE - 1).astype(np.int64),
            np.clip(x, 0, MAP_SIZE - 1).astype(np.int64),
        )
        lit = np.ones(depth.size)
        lit[farthest[at] < depth - margin] = 0.0
        edge = np.flatnonzero((nearest[at] < depth + margin) & (farthest[at] >= depth - margin))
        x, y, depth, radius = x[edge], y[edge], depth[edge], radius[edge]
        rise_x, rise_y = slope[0][edge] * texel_mm[edge], slope[1][edge] * texel_mm[edge]
        total = np.zeros(edge.size)
        for dx, dy in hemisphere_disk(FILTER_TAPS):
            across, down = dx * radius, dy * radius
            total += _compared(
                self.occluders, x + across, y + down, depth + rise_x * across + rise_y * down
            )
        lit[edge] = total / FILTER_TAPS
        return lit

    def _extremes(self, reach: int) -> tuple[FloatArray, FloatArray]:
        """The least and greatest depth within a reach of every texel: most pixels need no taps.

        A lamp's texels differ from pixel to pixel, and so does the reach: in powers of two few
        filters serve them all.
        """
        reach = min(1 << (reach - 1).bit_length(), MAP_SIZE)
        if reach not in self.cache:
            size = 2 * reach + 1
            self.cache[reach] = (
                minimum_filter(self.occluders, size=size, mode="nearest"),
                maximum_filter(self.occluders, size=size, mode="nearest"),
            )
        return self.cache[reach]

    def thickness(
        self,
        position_mm: FloatArray,
        normal: FloatArray,
        offset_mm: float,
        radius_mm: float,
        taps: int,
    ) -> FloatArray:
        """Return the mean depth (N,) of the body between the light and each point, mm."""
        x, y, depth, texel_mm = self.seen.place(inward_offset(position_mm, normal, offset_mm))
        occluders = np.empty((depth.size, taps))
        for tap, (dx, dy) in enumerate(poisson_disk(taps)):
            scale = radius_mm / texel_mm
            found = _texel(self.first, np.floor(x + dx * scale), np.floor(y + dy * scale))
            # A tap that misses the body sees no wall there: as thick as nothing.
            occluders[:, tap] = np.where(np.isfinite(found), found, depth)
        return thickness_from_depths(depth, occluders)

    def _slopes(self, normal: FloatArray, steepest: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Change of depth per mm along the map's x and y (down)."""
        n = normal @ self.seen.view[:3, :3].T
        facing = np.maximum(n[:, 2], 1e-3)
        slope_x, slope_y = n[:, 0] / facing, -n[:, 1] / facing
        excess = np.maximum(np.hypot(slope_x, slope_y) / steepest, 1.0)
        return slope_x / excess, slope_y / excess


def _compared(depths: FloatArray, x: FloatArray, y: FloatArray, depth: FloatArray) -> FloatArray:
    """Percentage-closer: compare four texels, then interpolate."""
    x0, y0 = np.floor(x - 0.5), np.floor(y - 0.5)
    fx, fy = x - 0.5 - x0, y - 0.5 - y0
    at = [_texel(depths, x0 + i, y0 + j) >= depth for j in (0.0, 1.0) for i in (0.0, 1.0)]
    top = at[0] * (1.0 - fx) + at[1] * fx
    bottom = at[2] * (1.0 - fx) + at[3] * fx
    result: FloatArray = top * (1.0 - fy) + bottom * fy
    return result


def _texel(depths: FloatArray, x: FloatArray, y: FloatArray) -> FloatArray:
    """Outside a map goes on what its rim sees: nothing, or a body that reaches past a lamp's cone."""
    last = MAP_SIZE - 1
    at = np.clip(y, 0, last).astype(np.int64) * MAP_SIZE + np.clip(x, 0, last).astype(np.int64)
    return depths.ravel()[at]


def render_shadow_map(light: Light, mesh: Mesh) -> ShadowMap:
    """Rasterise a mesh as a light sees it."""
    view = LightView.of(light, mesh)
    seen = mesh.positions_mm @ view.view[:3, :3].T + view.view[:3, 3]
    clip = seen @ view.projection[:, :3].T + view.projection[:, 3]
    first, away = depth_maps(clip, -seen[:, 2], mesh.faces, (MAP_SIZE, MAP_SIZE))
    return ShadowMap(view, first, np.minimum(away, first + ATTACHED_MM))


def hemisphere_disk(taps: int) -> FloatArray:
    """Return points (taps, 2) of the unit disk with density √(1−r²), on a sunflower spiral [Vogel1979]."""
    share = (np.arange(taps) + 0.5) / taps
    radius = np.sqrt(1.0 - (1.0 - share) ** (2.0 / 3.0))
    angle = np.arange(taps) * np.pi * (3.0 - np.sqrt(5.0))
    return radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
