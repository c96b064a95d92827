"""Contact shadow: what hides a light within .6 mm, such as lids, nostril rims and lips (MODEL §3).

The wide filter ignores surfaces that rise less than `skinshade.shading.shadow.ATTACHED_MM`. A second, narrow
filter compares the depths of the nearest surface with the plane of the mesh's face.
"""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, dot
from ..lut import Lut
from .deep_scatter import linear_depth
from .shadow import diffused_shadow, light_coordinates, plane_slope, shadow_disk, smoothstep

__all__ = ["contact_filter", "contact_shadow", "contact_slope", "faded_contact", "unhidden_share"]

CONTACT_TAPS = 12
"""Taps of the contact filter. Its disk covers about four texels of a head's map."""
CONTACT_RADIUS_MM = 0.6
"""Radius of the contact filter: about one texel of a head's map. Radii of .4 to .8 mm differ little on
grooves, steps and ledges of 1 mm."""
CONTACT_BIAS_MM = 0.8
"""Depth by which the plane of a face moves towards the light. In a hollow, neighbouring faces rise above this
plane; with .4 mm, twice as many pixels of a scan are too dark where nothing is near."""
CONTACT_BIAS_PER_SLOPE_MM = 0.3
"""Depth that a slope of 1 adds to the bias: half a texel of a head's map. Without it, shallow creases between
faces become dark lines where the light is oblique."""
CONTACT_FADE_FROM = 0.05
"""Cosine of face and light below which there is no contact shadow, because a face's slope is 20 there."""
CONTACT_FADE_TO = 0.15
"""Cosine of face and light from which the contact shadow is complete."""


def contact_slope(
    face_normal: FloatArray, to_light: FloatArray, light_right: FloatArray, light_up: FloatArray
) -> FloatArray:
    """Return the slope (..., 2) of a face: change of depth per mm to the right and down in a light's map.

    Parameters
    ----------
    face_normal, to_light
        (..., 3) unit normals of the faces, and unit vectors towards the light.
    light_right, light_up
        (3,) unit axes of the light's view.
    """
    return plane_slope(face_normal, to_light, light_right, light_up, CONTACT_FADE_FROM)


def contact_filter(
    depth_map: FloatArray,
    map_extent: FloatArray,
    view: FloatArray,
    projection: FloatArray,
    position_mm: FloatArray,
    face_normal: FloatArray,
    to_light: FloatArray,
) -> FloatArray:
    """Return the share (...) of a disk of `CONTACT_RADIUS_MM` around points that nothing hides from a light.

    Parameters
    ----------
    depth_map
        (H, W) depths of the nearest surface as the projection stores them; lookups outside the map clamp
        to its edge.
    map_extent
        (..., 2) width and height of the map, texels. Only the twin for shaders needs them.
    view, projection
        (4, 4) matrices of the light, as in `skinshade.shading.shadow.light_coordinates`.
    position_mm
        (..., 3) positions of the points, mm.
    face_normal, to_light
        (..., 3) unit normals of the faces of the mesh, not interpolated, and unit vectors towards the light.
    """
    coordinates = light_coordinates(position_mm, view, projection)
    uv_per_mm = np.abs(projection[[0, 1], [0, 1]]) * 0.5 / np.abs(coordinates[..., 3:])
    share = unhidden_share(
        linear_depth(depth_map, projection),
        coordinates[..., :2],
        coordinates[..., 2],
        uv_per_mm,
        contact_slope(face_normal, to_light, view[0, :3], view[1, :3]),
    )
    return faded_contact(share, dot(face_normal, to_light))


def unhidden_share(
    depths_mm: FloatArray,
    uv: FloatArray,
    receiver_mm: FloatArray,
    uv_per_mm: FloatArray,
    slope: FloatArray,
) -> FloatArray:
    """Return the share (...) of the contact filter's disk that nothing hides.

    Each texel is compared with the depth of the face's plane in the middle of this texel, so that a flat face
    and a convex body never hide themselves, however oblique the light.

    Parameters
    ----------
    depths_mm
        (H, W) depths of the nearest surface along the light's axis, mm.
    uv, receiver_mm
        (..., 2) coordinates of the receivers in the map, v down, and (...) their depths, mm.
    uv_per_mm
        (..., 2) lengths in the map of 1 mm across the light.
    slope
        (..., 2) slope from `contact_slope`.
    """
    height, width = depths_mm.shape
    flat = depths_mm.ravel()
    x, y = uv[..., 0] * width - 0.5, uv[..., 1] * height - 0.5
    texels_x, texels_y = uv_per_mm[..., 0] * width, uv_per_mm[..., 1] * height
    rise_x, rise_y = slope[..., 0] / texels_x, slope[..., 1] / texels_y
    steepness = np.sqrt(dot(slope, slope))
    biased = receiver_mm - CONTACT_BIAS_MM - CONTACT_BIAS_PER_SLOPE_MM * steepness
    total = np.zeros(receiver_mm.shape)
    for right, down in CONTACT_RADIUS_MM * shadow_disk(CONTACT_TAPS):
        tap_x, tap_y = x + right * texels_x, y + down * texels_y
        left, top = np.floor(tap_x), np.floor(tap_y)
        for row, share_y in ((top, 1.0 - (tap_y - top)), (top + 1.0, tap_y - top)):
            first = np.clip(row, 0, height - 1).astype(np.int64) * width
            beside = biased + (row - y) * rise_y
            for column, share_x in ((left, 1.0 - (tap_x - left)), (left + 1.0, tap_x - left)):
                depth = flat[first + np.clip(column, 0, width - 1).astype(np.int64)]
                total += (depth >= beside + (column - x) * rise_x) * (share_x * share_y)
    result: FloatArray = total / CONTACT_TAPS
    return result


def faded_contact(share: FloatArray, cosine: FloatArray) -> FloatArray:
    """Return the unhidden share (...), which fades to 1 where the cosine of face and light is small."""
    fade = (cosine - CONTACT_FADE_FROM) / (CONTACT_FADE_TO - CONTACT_FADE_FROM)
    result: FloatArray = 1.0 - np.clip(fade, 0.0, 1.0) * (1.0 - share)
    return result


def contact_shadow(
    lut: Lut, shadow: FloatArray, contact: FloatArray, filter_width_mm: float
) -> FloatArray:
    """Return the lesser (..., 3) of a diffused shadow and the contact shadow, 0..1.

    Light bleeds into a contact shadow as it does at `CONTACT_RADIUS_MM` within the shadow of a straight edge.

    Parameters
    ----------
    lut
        Shadow table.
    shadow
        (..., 3) result of `skinshade.shading.shadow.diffused_shadow`.
    contact
        (...) result of `contact_filter`.
    filter_width_mm
        Width of the wide filter across the light, mm; the table is for this width.

    Examples
    --------
    >>> import numpy as np
    >>> import skinshade as sk
    >>> from skinshade.shading.contact import contact_shadow
    >>> lut = sk.build_shadow_lut(sk.Profile.preset("skin-deon2007"), sharpening=8.0)
    >>> contact_shadow(lut, np.ones((3, 3)), np.array([0.0, 0.5, 1.0]), 8.0).round(2)
    array([[0.19, 0.03, 0.01],
           [0.59, 0.52, 0.51],
           [1.  , 1.  , 1.  ]])
    """
    inside = smoothstep(np.array(0.5 - CONTACT_RADIUS_MM / filter_width_mm))
    bleed = diffused_shadow(lut, inside, np.array(1.0), filter_width_mm)
    return np.minimum(shadow, contact[..., None] + (1.0 - contact[..., None]) * bleed)
