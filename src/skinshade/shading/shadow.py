"""Shadows under diffusion: the wide filter, and the light of each channel across its edge (MODEL §3).

The filter has one width in mm everywhere, so a table can sharpen its edge and let light bleed across the
edge. The filter compares depths along the light's axis. Three rules keep a body from shadowing itself: the
receiver is a plane, lookups past the terminator move back to the terminator, and a surface that faces the
light is `ATTACHED_MM` deeper in the shadow map.
"""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, dot, unit_vectors
from .._core.errors import ArgumentError
from ..lut import Lut
from ..lut.shadow import inverse_smoothstep
from .deep_scatter import linear_depth

__all__ = [
    "diffused_shadow",
    "light_coordinates",
    "lit_share",
    "plane_slope",
    "shadow_disk",
    "shadow_filter",
    "shadow_occluder_depth",
    "shadow_receiver",
    "shadow_slope",
    "sharpened_shadow",
    "smoothstep",
    "variance_shadow",
]

LEAST_COSINE = 0.05
"""Least N·L in the shadow table; below it, the filter is wider on the surface than the table's range."""
LEAST_VARIANCE_MM2 = 0.01
"""Least variance of depths: greater than the rounding error of a flat wall."""
SHADOW_TAPS = (16, 48)
"""Tap counts of the wide filter; the renderers use the greater one."""
SHADOW_BIAS_MM = 0.4
"""Depth by which a receiver moves towards the light: about two texels of a head's shadow map."""
ATTACHED_MM = 4.0
"""Depth that the shadow map adds to a surface that faces the light. Within the filter, the walls of a hollow
in a face rise less than this above the receiver's plane. A surface that rises more is another part of the
body and casts a shadow."""
STEEPEST_SLOPE = 8.0
"""Slope of the steepest receiver plane: depth over distance across the light."""
HOLLOW_PER_MM = 0.04
"""Concave curvature from which the steepest slope is 1. In a hollow, a steeper plane would cut through the
wall that casts the shadow."""
TERMINATOR_REACH_MM = 8.0
"""Greatest distance along the surface by which a lookup moves back to the terminator."""
DARK_BEYOND = -0.6
"""N·L below which every curvature table is dark, so that the filter need not be evaluated."""


def smoothstep(p: FloatArray) -> FloatArray:
    """Return 3p² − 2p³ (...), with p clamped to 0..1."""
    q = np.clip(p, 0.0, 1.0)
    result: FloatArray = q * q * (3.0 - 2.0 * q)
    return result


def shadow_disk(taps: int) -> FloatArray:
    """Return points (taps, 2) of the unit disk with the density √(1−r²), on a spiral [Vogel1979].

    With this density, the filter of a straight edge is exactly a smoothstep of the filter's width.

    Raises
    ------
    ArgumentError
        If `taps` is not 1..256.
    """
    if not 1 <= taps <= 256:
        raise ArgumentError(f"taps is {taps}; it must be 1..256")
    share = (np.arange(taps) + 0.5) / taps
    radius = np.sqrt(1.0 - (1.0 - share) ** (2.0 / 3.0))
    angle = np.arange(taps) * np.pi * (3.0 - np.sqrt(5.0))
    return radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)


def light_coordinates(
    position_mm: FloatArray, view: FloatArray, projection: FloatArray
) -> FloatArray:
    """Return u, v (down), depth in mm and clip w (..., 4) of points in a light's depth map.

    Parameters
    ----------
    position_mm
        (..., 3) positions, mm.
    view, projection
        (4, 4) matrices of the light, for column vectors. The view looks along its z axis and may be
        left- or right-handed.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.shadow import light_coordinates
    >>> parallel = np.diag([0.01, 0.01, 0.001, 1.0])  # a map 200 mm wide
    >>> u, v, depth_mm, w = light_coordinates(np.array([50.0, 0.0, 400.0]), np.eye(4), parallel)
    >>> float(u), float(v), float(depth_mm)
    (0.75, 0.5, 400.0)
    """
    in_view = position_mm @ view[:3, :3].T + view[:3, 3]
    clip = in_view @ projection[:, :3].T + projection[:, 3]
    w = np.where(np.abs(clip[..., 3]) < 1e-9, 1e-9, clip[..., 3])
    u, v = 0.5 + 0.5 * clip[..., 0] / w, 0.5 - 0.5 * clip[..., 1] / w
    return np.stack([u, v, np.abs(in_view[..., 2]), w], axis=-1)


def shadow_receiver(
    position_mm: FloatArray,
    normal: FloatArray,
    to_light: FloatArray,
    curvature_per_mm: FloatArray,
) -> FloatArray:
    """Return the positions (..., 3) at which the wide filter is evaluated, mm, for points of a surface.

    Past the terminator, a body hides itself from the light. The curvature table already describes this
    darkening. The lookup therefore moves along the surface to the terminator, from which light diffuses.

    Parameters
    ----------
    position_mm
        (..., 3) positions of the points, mm.
    normal, to_light
        (..., 3) unit normals of the mesh, and unit vectors towards the light.
    curvature_per_mm
        (...) mean curvature, 1/mm.
    """
    cosine = dot(normal, to_light)
    tangential = unit_vectors(to_light - normal * cosine[..., None])
    sine_past = np.maximum(-cosine, 0.0)
    distance_mm = np.minimum(sine_past / np.maximum(curvature_per_mm, 1e-3), TERMINATOR_REACH_MM)
    result: FloatArray = position_mm + tangential * distance_mm[..., None]
    return result


def shadow_slope(
    normal: FloatArray,
    to_light: FloatArray,
    curvature_per_mm: FloatArray,
    light_right: FloatArray,
    light_up: FloatArray,
) -> FloatArray:
    """Return the slope (..., 2) of the receiver plane: change of depth per mm to the right and downwards.

    Parameters
    ----------
    normal, to_light
        (..., 3) unit normals of the mesh, and unit vectors towards the light.
    curvature_per_mm
        (...) mean curvature, 1/mm.
    light_right, light_up
        (3,) unit axes of the light's view.
    """
    sine_past = np.maximum(-dot(normal, to_light), 0.0)
    plane_normal = unit_vectors(normal + to_light * sine_past[..., None])
    slope = plane_slope(plane_normal, to_light, light_right, light_up, 1e-3)
    flatness = np.clip(1.0 + curvature_per_mm / HOLLOW_PER_MM, 0.0, 1.0)
    steepest = 1.0 + (STEEPEST_SLOPE - 1.0) * flatness
    length = np.sqrt(dot(slope, slope))
    result: FloatArray = slope / np.maximum(length / steepest, 1.0)[..., None]
    return result


def plane_slope(
    normal: FloatArray,
    to_light: FloatArray,
    light_right: FloatArray,
    light_up: FloatArray,
    least_cosine: float,
) -> FloatArray:
    """Return the slope (..., 2) of planes: change of depth per mm to the right and down in a light's map.

    Parameters
    ----------
    normal, to_light
        (..., 3) unit normals of the planes, and unit vectors towards the light.
    light_right, light_up
        (3,) unit axes of the light's view.
    least_cosine
        Least cosine of normal and light, which bounds the slope.
    """
    axis = np.cross(light_right, light_up)
    # In left-handed axes the cross product points away from the light.
    handedness = np.where(to_light @ axis < 0.0, -1.0, 1.0)
    cosine = np.maximum(handedness * (normal @ axis), least_cosine)
    across = np.stack([normal @ light_right, -(normal @ light_up)], axis=-1)
    result: FloatArray = across / cosine[..., None]
    return result


def shadow_occluder_depth(depth_mm: FloatArray, faces_light: FloatArray) -> FloatArray:
    """Return the depth (...) that a shadow map stores for a fragment, mm.

    The map adds `ATTACHED_MM` to the depth of a triangle that faces the light. A triangle that faces away
    keeps its own depth.

    Parameters
    ----------
    depth_mm
        (...) depth of the fragment along the light's axis, mm.
    faces_light
        (...) 1 for a triangle that faces the light, 0 for a triangle that faces away.
    """
    return depth_mm + ATTACHED_MM * faces_light


def shadow_filter(
    depth_map: FloatArray,
    map_extent: FloatArray,
    view: FloatArray,
    projection: FloatArray,
    position_mm: FloatArray,
    normal: FloatArray,
    to_light: FloatArray,
    curvature_per_mm: FloatArray,
    filter_width_mm: float,
    bias_mm: float,
    taps: int,
) -> FloatArray:
    """Return the value (...) of the wide filter from a light's depth map, 0 in shadow, 1 in light.

    Parameters
    ----------
    depth_map
        (H, W) depths as the projection stores them; lookups outside the map clamp to its edge.
    map_extent
        (..., 2) width and height of the map, texels. Only the twin for shaders needs them, because
        shaders cannot query the size of every texture.
    view, projection
        (4, 4) matrices of the light, as in `light_coordinates`.
    position_mm, normal, to_light, curvature_per_mm
        As in `shadow_receiver`.
    filter_width_mm
        Width of the filter across the light, mm.
    bias_mm
        `SHADOW_BIAS_MM` for a map with depths from `shadow_occluder_depth`, or of triangles that
        face away from the light; `SHADOW_BIAS_MM` + `ATTACHED_MM` for a map of the nearest surface.
    taps
        Number of taps, 16 or 48.
    """
    receiver = shadow_receiver(position_mm, normal, to_light, curvature_per_mm)
    coordinates = light_coordinates(receiver, view, projection)
    slope = shadow_slope(normal, to_light, curvature_per_mm, view[0, :3], view[1, :3])
    radius_mm = 0.5 * filter_width_mm
    extent = np.abs(projection[[0, 1], [0, 1]]) * 0.5 / np.abs(coordinates[..., 3:])
    return lit_share(
        linear_depth(depth_map, projection),
        coordinates[..., :2],
        coordinates[..., 2] - bias_mm,
        radius_mm * extent,
        radius_mm * slope,
        taps,
    )


def lit_share(
    depths_mm: FloatArray,
    uv: FloatArray,
    receiver_mm: FloatArray,
    radius_uv: FloatArray,
    rise_mm: FloatArray,
    taps: int,
) -> FloatArray:
    """Return the share (...) of the wide filter's disk that no occluder hides, by a loop over the taps.

    Parameters
    ----------
    depths_mm
        (H, W) depths of occluders along the light's axis, mm.
    uv
        (..., 2) coordinates of the receivers in the map, v down.
    receiver_mm
        (...) depths of the receivers, after subtraction of the bias, mm.
    radius_uv
        (..., 2) radii of the disk in the map.
    rise_mm
        (..., 2) rise of the receiver plane from the middle of the disk to its right and lower edge, mm.
    taps
        Number of taps.
    """
    total = np.zeros(receiver_mm.shape)
    for right, down in shadow_disk(taps):
        depth = receiver_mm + right * rise_mm[..., 0] + down * rise_mm[..., 1]
        u, v = uv[..., 0] + right * radius_uv[..., 0], uv[..., 1] + down * radius_uv[..., 1]
        total += _compare_depths(depths_mm, u, v, depth)
    result: FloatArray = total / taps
    return result


def diffused_shadow(
    lut: Lut, shadow_filter: FloatArray, n_dot_l: FloatArray, filter_width_mm: float
) -> FloatArray:
    """Return the share of the light in each channel, (..., 3), 0..1; light bleeds across the shadow's edge.

    Parameters
    ----------
    lut
        Shadow table.
    shadow_filter
        (...) value of the wide filter, 0 in shadow, 1 in light.
    n_dot_l
        (...) N·L of the mesh's normal. On the surface, the filter is width/(N·L) wide.
    filter_width_mm
        Width of the filter across the light, mm.
    """
    per_mm = np.maximum(n_dot_l, LEAST_COSINE) / filter_width_mm
    return lut.sample_at(lut.columns.coordinate(shadow_filter), lut.rows.coordinate(per_mm))


def sharpened_shadow(shadow_filter: FloatArray, sharpening: float) -> FloatArray:
    """Return the value (...) of the wide filter with an edge that is narrower by the factor `sharpening`.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.shadow import sharpened_shadow
    >>> sharpened_shadow(np.array([0.4, 0.5, 0.55]), 4.0).round(3)
    array([0.136, 0.5  , 0.696])
    """
    return smoothstep((inverse_smoothstep(shadow_filter) - 0.5) * sharpening + 0.5)


def variance_shadow(
    mean_depth_mm: FloatArray, mean_square_depth_mm2: FloatArray, depth_mm: FloatArray
) -> FloatArray:
    """Return the greatest share (...) of the blurred depths that can lie behind a receiver [Donnelly2006].

    The result is Chebyshev's bound. The bound is exact if the filter covers two walls and the receiver
    lies on the far wall.

    Parameters
    ----------
    mean_depth_mm, mean_square_depth_mm2
        (...) blurred depths, mm, and blurred squares of depths, mm².
    depth_mm
        (...) depth of the receiver from the same origin, mm.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.shadow import variance_shadow
    >>> depths_mm = np.array([10.0, 10.0, 10.0, 30.0])  # a quarter of the depths is not an occluder
    >>> float(variance_shadow(depths_mm.mean(), np.square(depths_mm).mean(), np.array(30.0)))
    0.25
    """
    variance = mean_square_depth_mm2 - mean_depth_mm * mean_depth_mm
    variance = np.maximum(variance, LEAST_VARIANCE_MM2)
    distance_mm = np.maximum(depth_mm - mean_depth_mm, 0.0)
    result: FloatArray = variance / (variance + distance_mm * distance_mm)
    return result


def _compare_depths(
    depths_mm: FloatArray, u: FloatArray, v: FloatArray, receiver_mm: FloatArray
) -> FloatArray:
    """Return the lit share (...) of four texels, compared one by one and interpolated (percentage-closer)."""
    height, width = depths_mm.shape
    x, y = u * width - 0.5, v * height - 0.5
    left, top = np.floor(x), np.floor(y)
    fx, fy = x - left, y - top
    columns = [np.clip(left + i, 0, width - 1).astype(np.int64) for i in (0.0, 1.0)]
    rows = [np.clip(top + j, 0, height - 1).astype(np.int64) * width for j in (0.0, 1.0)]
    flat = depths_mm.ravel()
    upper, lower = (
        (flat[row + columns[0]] >= receiver_mm) * (1.0 - fx)
        + (flat[row + columns[1]] >= receiver_mm) * fx
        for row in rows
    )
    result: FloatArray = upper * (1.0 - fy) + lower * fy
    return result
