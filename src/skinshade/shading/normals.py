"""Normal maps under diffusion: blurred normals per channel, unnormalised (MODEL §4)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import nnls

from .._core.arrays import FloatArray
from ..profile import Profile

__all__ = [
    "NormalBlend",
    "add_mesh_diffusion",
    "blend_normals",
    "blur_level",
    "map_level",
    "normal_blend",
]

BUMP_PERIODS_MM = (0.4, 5.0)
"""From a pore to a wrinkle: the periods of relief over which the weights are fitted."""
SAMPLES = 64


@dataclass(frozen=True)
class NormalBlend:
    """How to mix fetches of a normal map, per channel.

    Attributes
    ----------
    sigmas_mm
        (n,) blur of the fetches after the sharp one, mm; n is 1 or 2.
    weights
        (3 channels, n + 1) non-negative, each row sums to 1.
    """

    sigmas_mm: FloatArray
    weights: FloatArray


@cache
def _frequencies() -> FloatArray:
    short, long = BUMP_PERIODS_MM
    return np.geomspace(2.0 * np.pi / long, 2.0 * np.pi / short, SAMPLES)


def normal_blend(profile: Profile, *, fetches: int = 3) -> NormalBlend:
    """Fit the weights of sharp and blurred normals to a profile's transfer function.

    Parameters
    ----------
    profile
        Any profile.
    fetches
        3 (sharp and two blurs) or 2 (sharp and one).

    Returns
    -------
    NormalBlend
        Least squares over log k between the periods `BUMP_PERIODS_MM`, blurs by search.
    """
    k = _frequencies()
    target = profile.transfer(k)
    scale = float(np.sqrt(np.prod(profile.rms_radius_mm) ** (2.0 / 3.0)))
    candidates = np.geomspace(0.15, 4.0, 40) * scale
    if fetches == 2:
        fits = [(_two_fetch(k, target, np.array([sigma]))) for sigma in candidates]
    else:
        fits = [
            _three_fetch(k, target, np.array([narrow, wide]))
            for i, narrow in enumerate(candidates)
            for wide in candidates[i + 4 :: 2]
        ]
    return min(fits, key=lambda fit: fit[0])[1]


def map_level(map_extent: ArrayLike, uv_along_x: FloatArray, uv_along_y: FloatArray) -> FloatArray:
    """Return the mip level that the footprint of a pixel asks for, ≥ 0.

    The shorter axis of the footprint, but an eighth of the longer one at least: what 8-fold anisotropic
    filtering takes. Supersampling averages along the longer axis.

    Parameters
    ----------
    map_extent
        (..., 2) width and height of the map, texels.
    uv_along_x, uv_along_y
        (..., 2) changes of UV to the next pixel.
    """
    x = np.square(uv_along_x * np.asarray(map_extent, dtype=np.float64)).sum(axis=-1)
    y = np.square(uv_along_y * np.asarray(map_extent, dtype=np.float64)).sum(axis=-1)
    longer, shorter = np.maximum(x, y), np.minimum(x, y)
    level = 0.5 * np.log2(np.maximum(np.maximum(shorter, longer / 64.0), 1e-30))
    result: FloatArray = np.maximum(level, 0.0)
    return result


def blur_level(
    sigma_mm: FloatArray | float, uv_scale_mm: float, map_size: int, hardware_level: FloatArray
) -> FloatArray:
    """Return the mip level that blurs a map by σ on the surface, at least the hardware's own.

    Parameters
    ----------
    sigma_mm
        Standard deviation of the blur, mm.
    uv_scale_mm
        Length of the unit of UV on the surface, mm.
    map_size
        Side of the map, texels.
    hardware_level
        (...) level that the footprint of the pixel asks for.
    """
    level = np.log2(np.maximum(2.0 * np.asarray(sigma_mm) * map_size / uv_scale_mm, 1.0))
    result: FloatArray = np.maximum(hardware_level, level)
    return result


def blend_normals(fetched: FloatArray, blend: NormalBlend) -> FloatArray:
    """Return the normal that each channel sees, (..., 3 channels, 3), unnormalised.

    Parameters
    ----------
    fetched
        (..., n + 1, 3) sharp normal first, then each blur, none of them renormalised.
    """
    result: FloatArray = np.matmul(blend.weights, fetched)
    return result


def add_mesh_diffusion(
    from_texture: FloatArray, from_mesh: FloatArray, mesh_normal: FloatArray
) -> FloatArray:
    """Add the diffusion of the mesh's own normals to that of its relief.

    Parameters
    ----------
    from_texture, from_mesh
        (..., 3 channels, 3) of `blend_normals` and of `skinshade.mesh_diffused_normals`.
    mesh_normal
        (..., 3) unit.
    """
    length = np.sqrt(np.einsum("...i,...i->...", from_texture, from_texture))[..., None]
    result: FloatArray = from_texture + length * (from_mesh - mesh_normal[..., None, :])
    return result


def _three_fetch(
    k: FloatArray, target: FloatArray, sigmas: FloatArray
) -> tuple[float, NormalBlend]:
    # Σb = 1 takes one column out: T − 1 = Σ b_j (G_j − 1), b_j ≥ 0; a sum above 1 costs the sharp fetch.
    basis = np.exp(-0.5 * np.square(k[:, None] * sigmas)) - 1.0
    weights, error = np.zeros((3, sigmas.size + 1)), 0.0
    for channel in range(3):
        b, _ = nnls(basis, target[:, channel] - 1.0)
        b /= max(1.0, b.sum())
        weights[channel] = (1.0 - b.sum(), *b)
        error += float(np.square(basis @ b - target[:, channel] + 1.0).sum())
    return error, NormalBlend(sigmas, weights)


def _two_fetch(k: FloatArray, target: FloatArray, sigma: FloatArray) -> tuple[float, NormalBlend]:
    lost = 1.0 - np.exp(-0.5 * np.square(k * sigma[0]))
    b = np.clip((1.0 - target).T @ lost / (lost @ lost), 0.0, 1.0)
    error = float(np.square((1.0 - target).T - b[:, None] * lost).sum())
    return error, NormalBlend(sigma, np.stack([1.0 - b, b], axis=1))
