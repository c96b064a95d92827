"""Normal maps under diffusion: a blurred normal for each channel, not normalised (MODEL §4)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import FloatArray, dot
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
"""Shortest and longest period of the relief for which the weights are fitted: a pore and a wrinkle."""
SAMPLES = 64
"""Number of spatial frequencies in the fit."""


@dataclass(frozen=True)
class NormalBlend:
    """Weights of the fetches of a normal map, per channel.

    Attributes
    ----------
    sigmas_mm
        (n,) standard deviations of the blurred fetches, mm; n is 1 or 2.
    weights
        (3 channels, n + 1) weights of the sharp fetch and of the blurred ones; they are not negative, and
        each row sums to 1.
    """

    sigmas_mm: FloatArray
    weights: FloatArray


@cache
def _frequencies() -> FloatArray:
    """Return the spatial frequencies (SAMPLES,) of the fit, rad/mm."""
    short, long = BUMP_PERIODS_MM
    return np.geomspace(2.0 * np.pi / long, 2.0 * np.pi / short, SAMPLES)


def normal_blend(profile: Profile, *, fetches: int = 3) -> NormalBlend:
    """Return the weights of sharp and blurred normals that fit a profile's transfer function best.

    Parameters
    ----------
    profile
        Diffusion profile.
    fetches
        Number of fetches: 3 (sharp and two blurs) or 2 (sharp and one blur).

    Returns
    -------
    NormalBlend
        Least-squares fit over log k between the periods `BUMP_PERIODS_MM`; the blurs are the best of a
        search.

    Examples
    --------
    >>> import skinshade as sk
    >>> from skinshade.shading.normals import normal_blend
    >>> blend = normal_blend(sk.Profile.preset("skin-deon2007"))
    >>> blend.sigmas_mm.round(2)
    array([0.18, 1.14])
    >>> blend.weights.round(2)
    array([[0.11, 0.29, 0.6 ],
           [0.2 , 0.7 , 0.1 ],
           [0.35, 0.65, 0.  ]])
    """
    k = _frequencies()
    target = profile.transfer(k)
    scale = float(np.sqrt(np.prod(profile.rms_radius_mm) ** (2.0 / 3.0)))
    candidates = np.geomspace(0.15, 4.0, 40) * scale
    if fetches == 2:
        fits = [_fit_two_fetches(k, target, np.array([sigma])) for sigma in candidates]
    else:
        fits = [
            _fit_three_fetches(k, target, np.array([narrow, wide]))
            for i, narrow in enumerate(candidates)
            for wide in candidates[i + 4 :: 2]
        ]
    return min(fits, key=lambda fit: fit[0])[1]


def map_level(map_extent: ArrayLike, uv_along_x: FloatArray, uv_along_y: FloatArray) -> FloatArray:
    """Return the mip level (...) for the footprint of a pixel in a map, ≥ 0.

    The level depends on the shorter axis of the footprint, or on an eighth of the longer axis if that is
    greater, as in 8-fold anisotropic filtering. Supersampling averages along the longer axis.

    Parameters
    ----------
    map_extent
        (..., 2) width and height of the map, texels.
    uv_along_x, uv_along_y
        (..., 2) changes of UV to the next pixel in x and in y.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.normals import map_level
    >>> float(map_level((1024, 1024), np.array([4.0 / 1024.0, 0.0]), np.array([0.0, 8.0 / 1024.0])))
    2.0
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
    """Return the mip level (...) that blurs a map by σ on the surface, at least `hardware_level`.

    Parameters
    ----------
    sigma_mm
        Standard deviation of the blur, mm.
    uv_scale_mm
        Length of the unit of UV on the surface, mm.
    map_size
        Longer side of the map, texels.
    hardware_level
        (...) mip level for the footprint of the pixel, from `map_level` or from the hardware.
    """
    level = np.log2(np.maximum(2.0 * np.asarray(sigma_mm) * map_size / uv_scale_mm, 1.0))
    result: FloatArray = np.maximum(hardware_level, level)
    return result


def blend_normals(fetched: FloatArray, blend: NormalBlend) -> FloatArray:
    """Return the normal of each channel, (..., 3 channels, 3), not normalised.

    Parameters
    ----------
    fetched
        (..., n + 1, 3) sharp normal, then the normal of each blur, not renormalised.
    blend
        Weights of the fetches.
    """
    result: FloatArray = blend.weights[..., 0, None] * fetched[..., None, 0, :]
    for index in range(1, fetched.shape[-2]):
        result = result + blend.weights[..., index, None] * fetched[..., None, index, :]
    return result


def add_mesh_diffusion(
    from_texture: FloatArray, from_mesh: FloatArray, mesh_normal: FloatArray
) -> FloatArray:
    """Return normals (..., 3 channels, 3) after diffusion of both the normal map and the mesh.

    Parameters
    ----------
    from_texture, from_mesh
        (..., 3 channels, 3) normals from `blend_normals` and from `skinshade.mesh_diffused_normals`.
    mesh_normal
        (..., 3) unit normals of the mesh.
    """
    length = np.sqrt(dot(from_texture, from_texture))[..., None]
    result: FloatArray = from_texture + length * (from_mesh - mesh_normal[..., None, :])
    return result


def _fit_three_fetches(
    k: FloatArray, target: FloatArray, sigmas: FloatArray
) -> tuple[float, NormalBlend]:
    """Return the squared error and the weights of the best fit with two blurs."""
    # Because Σb = 1, the sharp weight drops out: T − 1 = Σ b_j (G_j − 1), b_j ≥ 0, over the blurs. If
    # their sum exceeds 1, it is scaled to 1, and the sharp weight is 0.
    basis = np.exp(-0.5 * np.square(k[:, None] * sigmas)) - 1.0
    b = _nonnegative_pair(basis, target - 1.0)
    b /= np.maximum(1.0, b.sum(axis=0))
    error = float(np.square(basis @ b - target + 1.0).sum())
    return error, NormalBlend(sigmas, np.concatenate([1.0 - b.sum(axis=0, keepdims=True), b]).T)


def _nonnegative_pair(basis: FloatArray, target: FloatArray) -> FloatArray:
    """Return the factors b (2, n) ≥ 0 of two columns (k, 2) with the least squared error to (k, n).

    Where the solution without the bounds is negative, one factor is 0. SciPy's ``nnls`` gives the same,
    but its import takes .4 s.
    """
    squares = np.maximum(np.square(basis).sum(axis=0), 1e-300)[:, None]
    projected = basis.T @ target
    alone = np.maximum(projected / squares, 0.0)
    first_is_better = alone[0] * projected[0] >= alone[1] * projected[1]
    single = alone * np.stack([first_is_better, ~first_is_better])
    # The normal equations would lose half of the digits where the columns are nearly parallel.
    both = np.linalg.lstsq(basis, target, rcond=None)[0]
    result: FloatArray = np.where((both >= 0.0).all(axis=0), both, single)
    return result


def _fit_two_fetches(
    k: FloatArray, target: FloatArray, sigma: FloatArray
) -> tuple[float, NormalBlend]:
    """Return the squared error and the weights of the best fit with one blur."""
    damping = 1.0 - np.exp(-0.5 * np.square(k * sigma[0]))
    b = np.clip((1.0 - target).T @ damping / (damping @ damping), 0.0, 1.0)
    error = float(np.square((1.0 - target).T - b[:, None] * damping).sum())
    return error, NormalBlend(sigma, np.stack([1.0 - b, b], axis=1))
