"""Both forms of the wide shadow filter, evaluated at many points. Threads can share a filter."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from ..._core.arrays import FloatArray, dot
from ...params.choices import ShadowFilter
from ...shading.shadow import (
    SHADOW_BIAS_MM,
    lit_share,
    shadow_disk,
    shadow_receiver,
    shadow_slope,
    variance_shadow,
)
from . import compiled_fetches as compiled
from .extremes import extreme_within
from .light_view import MAP_SIZE
from .shadow_map import FILTER_TAPS, ShadowMap, blurred_moments

__all__ = ["PercentageCloserFilter", "VarianceFilter", "WideFilter", "build_filter"]


class WideFilter(Protocol):
    """Wide shadow filter of one light."""

    def lit(
        self,
        position_mm: FloatArray,
        normal: FloatArray,
        to_light: FloatArray,
        curvature_per_mm: FloatArray,
    ) -> FloatArray:
        """Return the filter's value (N,), 0 in shadow, 1 in light.

        Parameters
        ----------
        position_mm, normal, to_light
            (N, 3) points in mm, unit normals of the mesh, and unit vectors towards the light.
        curvature_per_mm
            (N,) mean curvature, 1/mm.
        """


def build_filter(kind: ShadowFilter, shadow_map: ShadowMap, width_mm: float) -> WideFilter:
    """Return the wide filter of a kind and a width in mm for the map of a light."""
    if kind == ShadowFilter.VARIANCE:
        return VarianceFilter.build(shadow_map, width_mm)
    return PercentageCloserFilter.build(shadow_map, width_mm)


@dataclass(frozen=True)
class PercentageCloserFilter(WideFilter):
    """Disk of `FILTER_TAPS` taps, each compared with the receiver plane.

    Attributes
    ----------
    shadow_map
        Map of the light.
    width_mm
        Width of the filter, mm.
    reach
        Distance within which `nearest_mm` and `farthest_mm` are searched, texels.
    occluder_mm
        (S, S) depth of the nearest occluder, float32.
    nearest_mm, farthest_mm
        (S, S) least and greatest depth of occluders within the reach. Points in front of all occluders or
        behind all of them need no taps.
    """

    shadow_map: ShadowMap
    width_mm: float
    reach: int
    occluder_mm: NDArray[np.float32]
    nearest_mm: FloatArray
    farthest_mm: FloatArray

    @classmethod
    def build(cls, shadow_map: ShadowMap, width_mm: float) -> PercentageCloserFilter:
        """Return the filter of a width in mm for the map of a light."""
        radius = 0.5 * width_mm / shadow_map.view.least_texel_mm
        reach = int(min(np.ceil(radius) + 1.0, MAP_SIZE))
        return cls(
            shadow_map,
            width_mm,
            reach,
            shadow_map.occluder_mm.astype(np.float32),
            extreme_within(shadow_map.occluder_mm, reach, np.minimum),
            extreme_within(shadow_map.occluder_mm, reach, np.maximum),
        )

    def lit(
        self,
        position_mm: FloatArray,
        normal: FloatArray,
        to_light: FloatArray,
        curvature_per_mm: FloatArray,
    ) -> FloatArray:
        """Return the filter's value (N,)."""
        if not position_mm.size:
            return np.zeros(0)
        view = self.shadow_map.view
        receiver = shadow_receiver(position_mm, normal, to_light, curvature_per_mm)
        slope = shadow_slope(normal, to_light, curvature_per_mm, view.view[0, :3], view.view[1, :3])
        coordinates = view.coordinates(receiver)
        uv, depth = coordinates[:, :2], coordinates[:, 2] - SHADOW_BIAS_MM
        # Texels close to a lamp can be very small; the radius is limited to the size of the map.
        radius = np.minimum(0.5 * self.width_mm / view.texel_mm(coordinates[:, 3]), MAP_SIZE)
        rise = 0.5 * self.width_mm * slope
        margin = np.sqrt(dot(rise, rise))
        column, row = np.clip(uv * MAP_SIZE, 0, MAP_SIZE - 1).astype(np.int64).T
        nearest, farthest = self.nearest_mm[row, column], self.farthest_mm[row, column]
        within_reach = radius + 1.0 <= self.reach
        dark = within_reach & (farthest < depth - margin)
        bright = within_reach & (nearest >= depth + margin)
        lit = np.where(dark, 0.0, 1.0)
        partial = np.flatnonzero(~dark & ~bright)
        radii_uv = np.repeat(radius[partial, None] / MAP_SIZE, 2, axis=1)
        points = (uv[partial], depth[partial], radii_uv, rise[partial])
        if compiled.serves(texels=self.occluder_mm.size):
            disk = shadow_disk(FILTER_TAPS)
            lit[partial] = compiled.lit_share(self.occluder_mm, *points, disk)
        else:
            lit[partial] = lit_share(self.shadow_map.occluder_mm, *points, FILTER_TAPS)
        return lit


@dataclass(frozen=True)
class VarianceFilter(WideFilter):
    """Gaussian blur of the nearest depths, with Chebyshev's bound on the moments.

    Attributes
    ----------
    shadow_map
        Map of the light.
    mean_mm, mean_square_mm2
        (S, S) blurred depth from the body's middle, and blurred square of this depth.
    """

    shadow_map: ShadowMap
    mean_mm: FloatArray
    mean_square_mm2: FloatArray

    @classmethod
    def build(cls, shadow_map: ShadowMap, width_mm: float) -> VarianceFilter:
        """Return the filter of a width in mm for the map of a light."""
        return cls(shadow_map, *blurred_moments(shadow_map, width_mm))

    def lit(
        self,
        position_mm: FloatArray,
        normal: FloatArray,
        to_light: FloatArray,
        curvature_per_mm: FloatArray,
    ) -> FloatArray:
        """Return the filter's value (N,)."""
        from scipy.ndimage import map_coordinates  # costs .4 s

        view = self.shadow_map.view
        receiver = shadow_receiver(position_mm, normal, to_light, curvature_per_mm)
        coordinates = view.coordinates(receiver)
        x, y = (coordinates[:, :2] * MAP_SIZE - 0.5).T
        mean, mean_square = (
            map_coordinates(moment, (y, x), order=1, mode="nearest")
            for moment in (self.mean_mm, self.mean_square_mm2)
        )
        depth = coordinates[:, 2] - SHADOW_BIAS_MM - view.middle_depth_mm
        return variance_shadow(mean, mean_square, depth)
