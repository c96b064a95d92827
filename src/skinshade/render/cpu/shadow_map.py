"""Depth seen from a light: the wide shadow filter and the thickness of what is lit from behind."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from scipy.ndimage import maximum_filter, minimum_filter

from ..._core.arrays import FloatArray, dot
from ...mesh import Mesh
from ...scene import Light
from ...shading.deep_scatter import inward_offset, poisson_disk, thickness_from_depths
from .raster import depth_maps

__all__ = ["ShadowMap", "render_shadow_map"]

MAP_SIZE = 1024
FILTER_TAPS = 48
STEEPEST_SLOPE = 8.0
"""Receivers are treated as planes no steeper than this against the light."""
BIAS_MM = 0.4
SAGITTA_FACTOR = 4.0
"""A convex surface that faces away bends towards the light within the filter's radius r, by ½κr² and
more where it is steep; that many times as much is not taken for another part's shadow."""
ATTACHED_MM = 4.0
"""A hollow of a face rises this much above the plane of a receiver within the filter; what is nearer
to the light by more, or has a far side before the receiver, is another part that casts a shadow."""
TERMINATOR = 0.15
"""N·L below which the map of what faces away takes over from the map of what is nearest."""


@dataclass(frozen=True)
class ShadowMap:
    """Depths along a light's axis, mm.

    Attributes
    ----------
    view, projection
        (4, 4) matrices of the light.
    first
        (S, S) the nearest surface; infinite where there is none.
    away
        (S, S) the nearest surface that faces away from the light.
    occluders
        (S, S) what shadows a surface that faces the light: `away`, or `first` and `ATTACHED_MM`.
    """

    view: FloatArray
    projection: FloatArray
    first: FloatArray
    away: FloatArray
    occluders: FloatArray
    cache: dict[tuple[bool, int], tuple[FloatArray, FloatArray]] = field(default_factory=dict)

    def shadow_filter(
        self,
        position_mm: FloatArray,
        normal: FloatArray,
        curvature_per_mm: FloatArray,
        width_mm: float,
    ) -> FloatArray:
        """Return the share (N,) of a disk across the light that is lit.

        The disk's weight is a hemisphere, √(1−r²), whose transfer across a straight edge is exactly
        the smoothstep that the shadow table inverts. Receivers are planes, so that a slope does not
        shadow itself. Past the terminator a body hides itself from the light, which is not a shadow
        but what the curvature table describes: there only surfaces that face away count.
        """
        slopes = self._slopes(normal)
        facing = slopes[2]
        lit = np.zeros(facing.size)
        towards = np.flatnonzero(facing > 0.0)
        lit[towards] = self._filtered(
            self.occluders,
            position_mm[towards],
            (slopes[0][towards], slopes[1][towards]),
            np.full(towards.size, BIAS_MM),
            width_mm,
        )
        away = np.flatnonzero(facing < TERMINATOR)
        sagitta = 0.5 * np.maximum(curvature_per_mm[away], 0.0) * (0.5 * width_mm) ** 2
        around = self._filtered(
            self.away,
            position_mm[away],
            (slopes[0][away] * (facing[away] < 0.0), slopes[1][away] * (facing[away] < 0.0)),
            BIAS_MM + np.minimum(SAGITTA_FACTOR * sagitta, 0.5 * width_mm),
            width_mm,
        )
        share = np.clip(facing[away] / TERMINATOR, 0.0, 1.0)
        lit[away] = share * lit[away] + (1.0 - share) * around
        return lit

    def _filtered(
        self,
        depths: FloatArray,
        position_mm: FloatArray,
        slope: tuple[FloatArray, FloatArray],
        bias_mm: FloatArray,
        width_mm: float,
    ) -> FloatArray:
        if not position_mm.size:
            return np.zeros(0)
        x, y, depth, texel_mm = self._locate(position_mm)
        depth = depth - bias_mm
        radius = 0.5 * width_mm / texel_mm
        margin = np.hypot(*slope) * 0.5 * width_mm
        nearest, farthest = self._extremes(depths, int(np.ceil(radius.max())) + 1)
        at = (np.clip(y, 0, MAP_SIZE - 1).astype(np.int64), np.clip(x, 0, MAP_SIZE - 1).astype(np.int64))
        lit = np.ones(depth.size)
        lit[farthest[at] < depth - margin] = 0.0
        edge = np.flatnonzero((nearest[at] < depth + margin) & (farthest[at] >= depth - margin))
        x, y, depth, radius = x[edge], y[edge], depth[edge], radius[edge]
        rise_x, rise_y = slope[0][edge] * texel_mm[edge], slope[1][edge] * texel_mm[edge]
        total = np.zeros(edge.size)
        for dx, dy in _hemisphere_disk(FILTER_TAPS):
            across, down = dx * radius, dy * radius
            total += _compared(depths, x + across, y + down, depth + rise_x * across + rise_y * down)
        lit[edge] = total / FILTER_TAPS
        return lit

    def _extremes(self, depths: FloatArray, reach: int) -> tuple[FloatArray, FloatArray]:
        """The least and greatest depth within a reach of every texel: most pixels need no taps."""
        key = (depths is self.away, reach)
        if key not in self.cache:
            size = 2 * reach + 1
            self.cache[key] = (
                minimum_filter(depths, size=size, mode="constant", cval=np.inf),
                maximum_filter(depths, size=size, mode="constant", cval=np.inf),
            )
        return self.cache[key]

    def thickness(
        self, position_mm: FloatArray, normal: FloatArray, offset_mm: float, radius_mm: float, taps: int
    ) -> FloatArray:
        """Return the mean depth (N,) of the body between the light and each point, mm."""
        x, y, depth, texel_mm = self._locate(inward_offset(position_mm, normal, offset_mm))
        occluders = np.empty((depth.size, taps))
        for tap, (dx, dy) in enumerate(poisson_disk(taps)):
            scale = radius_mm / texel_mm
            found = _texel(self.first, np.floor(x + dx * scale), np.floor(y + dy * scale))
            # A tap that misses the body sees no wall there: as thick as nothing.
            occluders[:, tap] = np.where(np.isfinite(found), found, depth)
        return thickness_from_depths(depth, occluders)

    def _locate(self, position_mm: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
        """Texel coordinates, depth and the size of a texel there, mm."""
        seen = position_mm @ self.view[:3, :3].T + self.view[:3, 3]
        clip = seen @ self.projection[:, :3].T + self.projection[:, 3]
        w = np.where(np.abs(clip[:, 3]) < 1e-9, 1e-9, clip[:, 3])
        x = (0.5 * clip[:, 0] / w + 0.5) * MAP_SIZE
        y = (0.5 - 0.5 * clip[:, 1] / w) * MAP_SIZE
        return x, y, -seen[:, 2], np.abs(w) * 2.0 / (self.projection[0, 0] * MAP_SIZE)

    def _slopes(self, normal: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Change of depth per mm along the map's x and y (down), and the cosine to its axis."""
        n = normal @ self.view[:3, :3].T
        facing = n[:, 2]
        steep = np.where(np.abs(facing) < 1e-6, 1e-6, facing)
        slope_x, slope_y = n[:, 0] / steep, -n[:, 1] / steep
        excess = np.maximum(np.hypot(slope_x, slope_y) / STEEPEST_SLOPE, 1.0)
        return slope_x / excess, slope_y / excess, facing

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
    """Nothing lies outside a map: it holds the whole body."""
    last = MAP_SIZE - 1
    inside = (x >= 0) & (x <= last) & (y >= 0) & (y <= last)
    at = np.clip(y, 0, last).astype(np.int64) * MAP_SIZE + np.clip(x, 0, last).astype(np.int64)
    return np.where(inside, depths.ravel()[at], np.inf)


def render_shadow_map(light: Light, mesh: Mesh) -> ShadowMap:
    """Rasterise a mesh as a light sees it."""
    points = mesh.positions_mm
    centre = 0.5 * (points.min(axis=0) + points.max(axis=0))
    radius = float(np.sqrt(dot(points - centre, points - centre).max()))
    view, projection = light.view_and_projection(centre, radius)
    seen = points @ view[:3, :3].T + view[:3, 3]
    clip = seen @ projection[:, :3].T + projection[:, 3]
    first, away = depth_maps(clip, -seen[:, 2], mesh.faces, (MAP_SIZE, MAP_SIZE))
    return ShadowMap(view, projection, first, away, np.minimum(away, first + ATTACHED_MM))


def _hemisphere_disk(taps: int) -> FloatArray:
    """Points (taps, 2) of the unit disk with density √(1−r²), on a sunflower spiral [Vogel1979]."""
    share = (np.arange(taps) + 0.5) / taps
    radius = np.sqrt(1.0 - (1.0 - share) ** (2.0 / 3.0))
    angle = np.arange(taps) * np.pi * (3.0 - np.sqrt(5.0))
    return radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
