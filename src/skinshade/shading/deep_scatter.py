"""Light through thin parts: thickness from a depth map, and transmittance (MODEL §6) [Green2007]."""

from __future__ import annotations

from functools import cache

import numpy as np

from .._core.arrays import FloatArray
from .._core.errors import ArgumentError

__all__ = [
    "ambient_deep_scatter",
    "classic_transmittance",
    "default_sigma_per_mm",
    "direct_deep_scatter",
    "inward_offset",
    "linear_depth",
    "mean_thickness",
    "poisson_disk",
    "thickness",
    "through_beyond",
    "transmittance",
]

CLASSIC_WRAP = 0.3
"""N·L from which the deep scatter of 2014 is 0."""
THICKNESS_TAPS = (8, 32)
"""Tap counts of the thickness disk."""
SIGMA_TIMES_RMS = 1.2
"""Product σ·ρ that fits Monte Carlo slabs of skin best; used if only the profile is given."""


def linear_depth(depth: FloatArray, projection: FloatArray) -> FloatArray:
    """Return the distance (...) along the light's axis, in the projection's unit, from stored depths.

    Parameters
    ----------
    depth
        (...) depths as stored, in the range that the projection gives.
    projection
        (4, 4) matrix for column vectors. One formula, depth = (az + b)/(cz + d) solved for |z|, holds for
        parallel and perspective, left- and right-handed projections, and for the ranges 0..1, −1..1 and
        reversed.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.deep_scatter import linear_depth
    >>> parallel = np.diag([0.01, 0.01, 0.001, 1.0])  # depths 0..1 for 0..1000 mm
    >>> linear_depth(np.array([0.0, 0.4]), parallel)
    array([  0., 400.])
    """
    a, b = projection[2, 2], projection[2, 3]
    c, d = projection[3, 2], projection[3, 3]
    result: FloatArray = np.abs((depth * d - b) / (a - depth * c))
    return result


def inward_offset(position_mm: FloatArray, normal: FloatArray, offset_mm: float) -> FloatArray:
    """Return positions (..., 3), mm, moved into the body against their normals (..., 3).

    The offset moves a receiver at a silhouette onto texels that hold the depth of its own surface.
    """
    return position_mm - normal * offset_mm


@cache
def poisson_disk(taps: int) -> FloatArray:
    """Return points (taps, 2) in the unit disk, evenly spread without a pattern; read-only.

    Each point is one of many random candidates: the farthest from all previous points and from the edge
    of the disk.

    Raises
    ------
    ArgumentError
        If `taps` is not 1..256.
    """
    if not 1 <= taps <= 256:
        raise ArgumentError(f"taps is {taps}; it must be 1..256")
    rng = np.random.default_rng(taps)
    points = np.zeros((0, 2))
    for _ in range(taps):
        radius, angle = np.sqrt(rng.random(2048)), 2.0 * np.pi * rng.random(2048)
        candidates = radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
        # The distance to the edge counts twice, plus a margin, as if another disk began beyond the margin.
        clearance = 2.0 * (1.0 - radius) + 0.8 / np.sqrt(taps)
        if points.size:
            distance = np.linalg.norm(candidates[:, None] - points, axis=2).min(axis=1)
            clearance = np.minimum(clearance, distance)
        points = np.concatenate([points, candidates[[np.argmax(clearance)]]])
    points -= points.mean(axis=0)
    points /= max(1.0, float(np.linalg.norm(points, axis=1).max()))
    points.setflags(write=False)
    return points


def mean_thickness(
    depths_mm: FloatArray,
    uv: FloatArray,
    receiver_mm: FloatArray,
    radius_uv: FloatArray,
    taps: int,
) -> FloatArray:
    """Return the mean thickness (...), mm: max(0, receiver − depth), averaged over a disk of taps.

    Parameters
    ----------
    depths_mm
        (H, W) depths along the light's axis, mm; infinite where there is no surface.
    uv
        (..., 2) coordinates of the receivers in the map, v down. Lookups take the nearest texel and clamp
        to the edge of the map.
    receiver_mm
        (...) depths of the receivers, mm.
    radius_uv
        (..., 2) radii of the disk in the map.
    taps
        Number of taps.
    """
    height, width = depths_mm.shape
    position = (uv[..., None, :] + poisson_disk(taps) * radius_uv[..., None, :]) * (width, height)
    texel = np.clip(np.floor(position), 0, (width - 1, height - 1)).astype(np.int64)
    depths = depths_mm[texel[..., 1], texel[..., 0]]
    result: FloatArray = np.maximum(receiver_mm[..., None] - depths, 0.0).mean(axis=-1)
    return result


def thickness(
    depth_map: FloatArray,
    projection: FloatArray,
    uv: FloatArray,
    receiver_mm: FloatArray,
    radius_uv: FloatArray,
    taps: int,
) -> FloatArray:
    """Return the mean thickness (...) between a light and receivers, mm, from the light's depth map.

    Parameters
    ----------
    depth_map
        (H, W) depths as the projection stores them. Lookups take the nearest texel and clamp to the edge
        of the map.
    projection
        (4, 4) matrix of the light, as in `linear_depth`, in mm.
    uv
        (..., 2) coordinates of the receivers in the map, v down.
    receiver_mm
        (...) distances of the receivers along the light's axis, mm; `inward_offset` moves the receivers
        beforehand.
    radius_uv
        (..., 2) radii of the disk in the map.
    taps
        Number of taps, 8 or 32.
    """
    return mean_thickness(linear_depth(depth_map, projection), uv, receiver_mm, radius_uv, taps)


def default_sigma_per_mm(rms_radius_mm: FloatArray) -> FloatArray:
    """Return σ (3,) of `transmittance`, 1/mm, from a profile's rms radius (3,), mm."""
    return SIGMA_TIMES_RMS / rms_radius_mm


def transmittance(
    thickness_mm: FloatArray, albedo: FloatArray, sigma_per_mm: FloatArray
) -> FloatArray:
    """Return the share of diffuse light that passes through a slab (..., 3) [KubelkaMunk1931].

    Parameters
    ----------
    thickness_mm
        (...) thickness of the slab, mm.
    albedo
        (..., 3) diffuse albedo of an infinitely thick slab, in (0, 1).
    sigma_per_mm
        (..., 3) exponential decay in thick slabs, 1/mm.

    Returns
    -------
    (..., 3)
        Absolute share. Divide it by the albedo if a later step multiplies by the albedo.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.deep_scatter import transmittance
    >>> albedo, sigma_per_mm = np.array([0.44, 0.23, 0.13]), np.array([0.7, 3.3, 5.4])
    >>> transmittance(np.array([0.0, 2.0]), albedo, sigma_per_mm).round(3)
    array([[1.   , 1.   , 1.   ],
           [0.201, 0.001, 0.   ]])
    """
    # The formula is b/(a sinh x + b cosh x) with a, b = (1 ± A²)/2A. Numerator and denominator are
    # multiplied by e^{−x}, so that thick slabs do not overflow.
    a2, decay = np.square(albedo), np.exp(-sigma_per_mm * thickness_mm[..., None])
    result: FloatArray = (1.0 - a2) * decay / (1.0 - a2 * decay * decay)
    return result


def classic_transmittance(thickness_mm: FloatArray, radius_mm: float) -> FloatArray:
    """Return exp(−t²/2R²) (...), the falloff of 2014; R is about 5 mm for an ear."""
    result: FloatArray = np.exp(-0.5 * np.square(thickness_mm / radius_mm))
    return result


def direct_deep_scatter(
    transmitted: FloatArray, n_dot_l: FloatArray, strength: float
) -> FloatArray:
    """Return the light through the body (..., 3), divided by the light on a surface that faces the light.

    Parameters
    ----------
    transmitted
        (..., 3) share from `transmittance`.
    n_dot_l
        (...) N·L of the blurred normal. Where N·L is negative, light enters the body on the far side.
    strength
        Factor on the light; 1 is physical.
    """
    return strength * transmitted * np.maximum(-n_dot_l, 0.0)[..., None]


def through_beyond(through: FloatArray, diffused: FloatArray) -> FloatArray:
    """Return the light through the body (..., 3) that the light diffused over its surface lacks.

    Past the terminator of a thin part, diffusion over the surface and transport through the body describe the
    same light: the greater of both is near a random walk, and their sum is up to twice as bright.

    Parameters
    ----------
    through
        (..., 3) light through the body, from `direct_deep_scatter`.
    diffused
        (..., 3) direct diffuse light at the same point, after its shadow.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.deep_scatter import through_beyond
    >>> through_beyond(np.array([0.3, 0.1, 0.0]), np.array([0.1, 0.2, 0.0])).round(3)
    array([0.2, 0. , 0. ])
    """
    return np.maximum(through - diffused, 0.0)


def ambient_deep_scatter(
    transmitted: FloatArray, irradiance_behind: FloatArray, strength: float
) -> FloatArray:
    """Return strength · T(t̄)·E(−N) (..., 3): ambient light from behind, through a mean thickness t̄."""
    return strength * transmitted * irradiance_behind
