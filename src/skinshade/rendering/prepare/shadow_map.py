"""Shadow maps: depths from a light, blurred moments of the depths, and thickness of the body."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..._core.arrays import FloatArray, dot
from ...mesh import Mesh
from ...shading.contact import contact_slope, faded_contact, unhidden_share
from ...shading.deep_scatter import inward_offset, mean_thickness, poisson_disk
from ...shading.shadow import SHADOW_TAPS, shadow_disk, shadow_occluder_depth
from . import compiled_fetches as compiled
from .light_view import MAP_SIZE, LightView
from .rasterizer import depth_maps

__all__ = [
    "FILTER_TAPS",
    "ShadowMap",
    "blurred_moments",
    "contact",
    "rasterize_shadow_map",
    "tap_disks",
    "thickness",
]

FILTER_TAPS = SHADOW_TAPS[-1]
"""Number of taps of the wide filter in both backends."""
BLUR_REACH = 3.0
"""Standard deviations at which the Gaussian of the variance filter is cut off."""
FAR_MM = 1e30
"""Depth of empty texels on the GPU, where infinity cannot be filtered, nor compared on some drivers."""


@dataclass(frozen=True)
class ShadowMap:
    """Depths along a light's axis, mm; infinite where there is no surface.

    Attributes
    ----------
    view
        Camera of the light.
    nearest_mm
        (S, S) depth of the nearest surface.
    occluder_mm
        (S, S) depth of the nearest occluder, by `skinshade.shading.shadow.shadow_occluder_depth`.
    """

    view: LightView
    nearest_mm: FloatArray
    occluder_mm: FloatArray


def rasterize_shadow_map(view: LightView, mesh: Mesh) -> ShadowMap:
    """Return the shadow map of a mesh."""
    in_view = mesh.positions_mm @ view.view[:3, :3].T + view.view[:3, 3]
    clip = in_view @ view.projection[:, :3].T + view.projection[:, 3]
    nearest, facing_away = depth_maps(clip, -in_view[:, 2], mesh.faces, (MAP_SIZE, MAP_SIZE))
    facing = np.ones(())
    occluder = np.minimum(facing_away, shadow_occluder_depth(nearest, facing))
    return ShadowMap(view, nearest, occluder)


def blurred_moments(shadow_map: ShadowMap, width_mm: float) -> tuple[FloatArray, FloatArray]:
    """Return the mean depth and mean square depth (S, S) under the variance filter.

    Depths start at the body's middle, mm and mm². Empty texels have the depth of the body's far end.

    Parameters
    ----------
    shadow_map
        Map of the light.
    width_mm
        Width of the wide filter, mm.
    """
    from scipy.ndimage import gaussian_filter1d  # costs .4 s, and only the variance filter needs it

    view = shadow_map.view
    depth = np.minimum(shadow_map.nearest_mm - view.middle_depth_mm, view.radius_mm)
    sigma = view.blur_texels(width_mm)

    def blurred(values: FloatArray) -> FloatArray:
        for axis in (1, 0):
            values = gaussian_filter1d(
                values, sigma, axis=axis, mode="nearest", truncate=BLUR_REACH
            )
        return values

    return blurred(depth), blurred(depth * depth)


def contact(
    shadow_map: ShadowMap, position_mm: FloatArray, face_normal: FloatArray, to_light: FloatArray
) -> FloatArray:
    """Return the share (N,) of the disk around points that nothing hides from a light within .6 mm.

    Parameters
    ----------
    shadow_map
        Map of the light.
    position_mm, face_normal, to_light
        (N, 3) points in mm, unit normals of their faces, and unit vectors towards the light.
    """
    view = shadow_map.view
    coordinates = view.coordinates(position_mm)
    uv_per_mm = 1.0 / (view.texel_mm(coordinates[:, 3]) * MAP_SIZE)
    share = unhidden_share(
        shadow_map.nearest_mm,
        coordinates[:, :2],
        coordinates[:, 2],
        np.repeat(uv_per_mm[:, None], 2, axis=1),
        contact_slope(face_normal, to_light, view.view[0, :3], view.view[1, :3]),
    )
    return faded_contact(share, dot(face_normal, to_light))


def tap_disks(thickness_taps: int) -> FloatArray:
    """Return the disk of the wide filter, followed by the disk of the thickness: (taps, 2)."""
    return np.concatenate([shadow_disk(FILTER_TAPS), poisson_disk(max(thickness_taps, 1))])


def thickness(
    shadow_map: ShadowMap,
    position_mm: FloatArray,
    normal: FloatArray,
    offset_mm: float,
    radius_mm: float,
    taps: int,
) -> FloatArray:
    """Return the mean thickness (N,) of the body between a light and points, mm.

    Parameters
    ----------
    shadow_map
        Map of the light.
    position_mm, normal
        (N, 3) points on the surface, mm, and unit normals.
    offset_mm
        Distance by which the points are moved inwards, mm.
    radius_mm
        Radius of the disk of taps, mm.
    taps
        8 or 32.
    """
    view = shadow_map.view
    coordinates = view.coordinates(inward_offset(position_mm, normal, offset_mm))
    radius_uv = radius_mm / (view.texel_mm(coordinates[:, 3]) * MAP_SIZE)
    depths_mm, radii_uv = shadow_map.nearest_mm, np.repeat(radius_uv[:, None], 2, axis=1)
    points = (coordinates[:, :2], coordinates[:, 2], radii_uv)
    if compiled.serves(texels=depths_mm.size):
        return compiled.mean_thickness(depths_mm, *points, poisson_disk(taps))
    return mean_thickness(depths_mm, *points, taps)
