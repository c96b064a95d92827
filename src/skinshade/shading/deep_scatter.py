"""Light through thin parts: thickness from a depth map, and what gets through it (MODEL §6) [Green2007]."""

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
    "poisson_disk",
    "thickness",
    "thickness_from_depths",
    "transmittance",
]

CLASSIC_WRAP = 0.3
"""N·L above zero at which the deep scatter of 2014 ended."""
SIGMA_TIMES_RMS = 1.2
"""σ·ρ that meets Monte Carlo slabs of skin best; used where a profile is all that is known."""


def linear_depth(depth: FloatArray, projection: FloatArray) -> FloatArray:
    """Return the distance (...) along the light's axis, in the projection's unit, from stored depths.

    Parameters
    ----------
    depth
        (...) as stored, in whichever range the projection gives.
    projection
        (4, 4) for column vectors. Parallel or perspective, left- or right-handed, 0..1, −1..1 or
        reversed are all one formula: depth = (az + b)/(cz + d) solved for |z|.
    """
    a, b = projection[2, 2], projection[2, 3]
    c, d = projection[3, 2], projection[3, 3]
    result: FloatArray = np.abs((depth * d - b) / (a - depth * c))
    return result


def inward_offset(position_mm: FloatArray, normal: FloatArray, offset_mm: float) -> FloatArray:
    """Return positions (..., 3) moved into the body, so that silhouettes find their own depth."""
    return position_mm - normal * offset_mm


@cache
def poisson_disk(taps: int) -> FloatArray:
    """Return points (taps, 2) on the unit disk, evenly spread without a pattern; read-only.

    Each is the best of many candidates: the farthest from those before it and from the rim.

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
        # The rim repels half as far as a neighbour, as if the next disk began a little way off.
        room = 2.0 * (1.0 - radius) + 0.8 / np.sqrt(taps)
        if points.size:
            apart = np.linalg.norm(candidates[:, None] - points, axis=2).min(axis=1)
            room = np.minimum(room, apart)
        points = np.concatenate([points, candidates[[np.argmax(room)]]])
    points -= points.mean(axis=0)
    points /= max(1.0, float(np.linalg.norm(points, axis=1).max()))
    points.setflags(write=False)
    return points


def thickness_from_depths(receiver_mm: FloatArray, occluder_mm: FloatArray) -> FloatArray:
    """Return the mean over taps (last axis) of max(0, receiver − occluder), mm."""
    result: FloatArray = np.maximum(receiver_mm[..., None] - occluder_mm, 0.0).mean(axis=-1)
    return result


def thickness(
    depth_map: FloatArray,
    projection: FloatArray,
    uv: FloatArray,
    receiver_mm: FloatArray,
    radius_uv: FloatArray,
    taps: int,
) -> FloatArray:
    """Return the mean thickness (...) in front of receivers, mm, from a light's depth map.

    Parameters
    ----------
    depth_map
        (H, W) as the projection stores it; the nearest texel is taken, the edge's beyond the edge.
    projection
        (4, 4) of the light, as in `linear_depth`, in mm.
    uv
        (..., 2) of the receivers in the map, v down.
    receiver_mm
        (...) distance of the receivers, moved by `inward_offset`, along the light's axis.
    radius_uv
        (..., 2) of the disk.
    taps
        8 or 32.
    """
    height, width = depth_map.shape
    at = (uv[..., None, :] + poisson_disk(taps) * radius_uv[..., None, :]) * (width, height)
    texel = np.clip(np.floor(at), 0, (width - 1, height - 1)).astype(np.int64)
    depths = depth_map[texel[..., 1], texel[..., 0]]
    return thickness_from_depths(receiver_mm, linear_depth(depths, projection))


def default_sigma_per_mm(rms_radius_mm: FloatArray) -> FloatArray:
    """Return σ (3,) of `transmittance` from a profile's rms radius, 1/mm."""
    return SIGMA_TIMES_RMS / rms_radius_mm


def transmittance(
    thickness_mm: FloatArray, albedo: FloatArray, sigma_per_mm: FloatArray
) -> FloatArray:
    """Return the share of diffuse light that a slab lets through (..., 3) [KubelkaMunk1931].

    Parameters
    ----------
    thickness_mm
        (...) mm.
    albedo
        (..., 3) diffuse albedo of a slab without end, in (0, 1).
    sigma_per_mm
        (..., 3) decay in the tail, 1/mm.

    Returns
    -------
    (..., 3)
        Absolute; divide by the albedo where that is multiplied later.
    """
    # b/(a sinh x + b cosh x) with a, b = (1 ± A²)/2A, multiplied by e^{−x}: thick slabs do not overflow.
    a2, decay = np.square(albedo), np.exp(-sigma_per_mm * thickness_mm[..., None])
    result: FloatArray = (1.0 - a2) * decay / (1.0 - a2 * decay * decay)
    return result


def classic_transmittance(thickness_mm: FloatArray, radius_mm: float) -> FloatArray:
    """Return exp(−t²/2R²) (...), the falloff of 2014; R about 5 mm for an ear."""
    result: FloatArray = np.exp(-0.5 * np.square(thickness_mm / radius_mm))
    return result


def direct_deep_scatter(
    transmitted: FloatArray, n_dot_l: FloatArray, strength: float
) -> FloatArray:
    """Return the light through the body (..., 3) over that on a surface facing the light.

    Parameters
    ----------
    transmitted
        (..., 3) of `transmittance`.
    n_dot_l
        (...) of the blurred normal; light enters on the far side where it is negative.
    strength
        1 is physical.
    """
    return strength * transmitted * np.maximum(-n_dot_l, 0.0)[..., None]


def ambient_deep_scatter(
    transmitted: FloatArray, irradiance_behind: FloatArray, strength: float
) -> FloatArray:
    """Return T(t̄)·E(−N) (..., 3): ambient light from behind through a mean thickness."""
    return strength * transmitted * irradiance_behind
