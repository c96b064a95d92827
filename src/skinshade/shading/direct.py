"""Direct diffuse light under diffusion, in three tiers of geometry (MODEL §2, §4) [Penner2010]."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .._core.arrays import FloatArray, dot
from .._core.normal_cdf import normal_cdf
from ..lut import Lut

__all__ = [
    "direct_diffused_normals",
    "direct_scalar",
    "direct_tensor",
    "directional_curvature",
    "relief_bump",
    "relief_length",
]

Transfer = Callable[[FloatArray], FloatArray]
"""Function from k (...) in rad/mm to T (..., 3), such as `skinshade.Profile.transfer`."""

SMOOTH_SHORTFALL = 0.025
"""Bound on the share by which |N_c| falls below T_c(|S|) on a smooth body whose curvature varies. The share
is .002 on a torus of 12 and 4 mm, and at most .023 on an ellipsoid of 15, 10 and 5 mm
(benchmarks/three_tiers.py)."""


def direct_scalar(
    lut: Lut,
    normals: FloatArray,
    light: FloatArray,
    curvature_per_mm: FloatArray,
    gain: FloatArray,
) -> FloatArray:
    """Return direct diffuse light in the scalar tier: the sphere's table at |H|.

    Parameters
    ----------
    lut
        Curvature table with the kernel ``sphere``, without energy gain.
    normals
        (..., 3 channels, 3) normals from `skinshade.shading.normals.blend_normals`, not normalised.
    light
        (..., 3) unit vectors towards the light.
    curvature_per_mm
        (...) mean curvature H, 1/mm; its sign has no effect.
    gain
        (..., 3) gain from `skinshade.shading.energy.energy_gain`, or 1.

    Returns
    -------
    (..., 3)
        Irradiance divided by the irradiance of a surface that faces the light.

    Examples
    --------
    >>> import numpy as np
    >>> import skinshade as sk
    >>> from skinshade.shading.direct import direct_scalar
    >>> lut = sk.build_curvature_lut(sk.Profile.preset("skin-deon2007"), energy_gain=False)
    >>> normals = np.tile([0.0, 0.0, 1.0], (3, 1))
    >>> edge_on, curvature_per_mm = np.array([1.0, 0.0, 0.0]), np.array(0.05)
    >>> direct_scalar(lut, normals, edge_on, curvature_per_mm, np.ones(3)).round(3)
    array([0.018, 0.004, 0.003])
    """
    length, cos_theta = _lengths_and_cosines(normals, light)
    diffused = _lookup(lut, cos_theta, np.abs(curvature_per_mm))
    return gain * (length * diffused + _relief_light(length, cos_theta))


def direct_tensor(
    lut: Lut,
    transfer: Transfer,
    normals: FloatArray,
    light: FloatArray,
    directional_per_mm: FloatArray,
    total_per_mm: FloatArray,
    gain: FloatArray,
) -> FloatArray:
    """Return direct diffuse light (..., 3) in the tensor tier.

    The light changes along S·L_t, where the curvature is κ_d, so the ring's table is evaluated at κ_d. Its
    value is multiplied by T(√(|S|² − κ_d²)), the decay by the remaining curvature.

    Parameters
    ----------
    lut
        Curvature table with the kernel ``ring``, without energy gain.
    transfer
        Transfer function of the profile.
    directional_per_mm, total_per_mm
        (...) curvatures κ_d and |S| from `directional_curvature`, 1/mm.
    normals, light, gain
        As in `direct_scalar`.
    """
    length, cos_theta = _lengths_and_cosines(normals, light)
    remaining = np.sqrt(np.maximum(np.square(total_per_mm) - np.square(directional_per_mm), 0.0))
    diffused = _lookup(lut, cos_theta, directional_per_mm) * transfer(remaining)
    return gain * (length * diffused + _relief_light(length, cos_theta))


def direct_diffused_normals(
    lut: Lut,
    transfer: Transfer,
    normals: FloatArray,
    relief_length: FloatArray,
    light: FloatArray,
    directional_per_mm: FloatArray,
    gain: FloatArray,
) -> FloatArray:
    """Return direct diffuse light (..., 3) in the tier of diffused normals.

    The normals are diffused over the surface, so the curvature may vary within the mean free path.

    Parameters
    ----------
    lut, transfer, light, directional_per_mm, gain
        As in `direct_tensor`.
    normals
        (..., 3 channels, 3) normals from `skinshade.shading.normals.add_mesh_diffusion`.
    relief_length
        (..., 3) length from the function `relief_length`, for relief that neither the table nor the
        tensor describes.
    """
    length, cos_theta = _lengths_and_cosines(normals, light)
    # On a smooth body |N_c| ≤ T_c(κ_d). The bound of 1 applies to meshes too coarse for their tensor.
    share = np.minimum(length / np.maximum(transfer(directional_per_mm), 1e-6), 1.0)
    diffused = _lookup(lut, cos_theta, directional_per_mm) * share
    return gain * (diffused + _relief_light(relief_length, cos_theta))


def relief_length(
    transfer: Transfer,
    from_texture: FloatArray,
    from_mesh: FloatArray,
    total_per_mm: FloatArray,
) -> FloatArray:
    """Return the length (..., 3) that normals keep when relief in the texture and in the mesh is averaged.

    A body whose curvature is constant within the mean free path has |N_c| = T_c(|S|). This is exact on a
    sphere and a cylinder, and holds to `SMOOTH_SHORTFALL` where the curvature varies, as on an ellipsoid.
    Any further loss of length, for example in a fold of the mesh, counts as relief too.

    Parameters
    ----------
    transfer
        Transfer function of the profile.
    from_texture, from_mesh
        (..., 3 channels, 3) normals of the map, and diffused normals of the mesh, not normalised.
    total_per_mm
        (...) curvature |S| from `directional_curvature`, 1/mm.
    """
    texture_length = np.sqrt(dot(from_texture, from_texture))
    mesh_length = np.sqrt(dot(from_mesh, from_mesh))
    smooth_length = (1.0 - SMOOTH_SHORTFALL) * transfer(total_per_mm)
    return texture_length * np.minimum(mesh_length / np.maximum(smooth_length, 1e-6), 1.0)


def directional_curvature(
    tensor_world: FloatArray, normal: FloatArray, light: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return κ_d = |S·L_t|/|L_t| and |S| = √(k₁² + k₂²), both (...), 1/mm; L_t is the tangential part of L.

    Parameters
    ----------
    tensor_world
        (..., 6) shape operator S in world axes, xx xy xz yy yz zz, 1/mm.
    normal, light
        (..., 3) unit vectors.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.direct import directional_curvature
    >>> cylinder = np.array([0.1, 0.0, 0.0, 0.0, 0.0, 0.0])  # radius 10 mm, curved along x
    >>> across, along = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])
    >>> kappa, total = directional_curvature(cylinder, np.array([0.0, 0.0, 1.0]), np.stack([across, along]))
    >>> kappa
    array([0.1, 0. ])
    """
    tangential = light - normal * dot(normal, light)[..., None]
    xx, xy, xz, yy, yz, zz = np.moveaxis(tensor_world, -1, 0)
    x, y, z = np.moveaxis(tangential, -1, 0)
    squared_change = (
        np.square(xx * x + xy * y + xz * z)
        + np.square(xy * x + yy * y + yz * z)
        + np.square(xz * x + yz * y + zz * z)
    )
    total = np.sqrt(xx**2 + yy**2 + zz**2 + 2.0 * (xy**2 + xz**2 + yz**2))
    # Where N = L, L_t is 0 and all directions are equivalent. The floor avoids 0/0.
    directional = np.sqrt(squared_change / np.maximum(dot(tangential, tangential), 1e-12))
    return np.minimum(directional, total), total


def relief_bump(m: FloatArray, s: FloatArray) -> FloatArray:
    """Return mΦ(m/s) + sφ(m/s) − max(0, m): the light that relief of slope s adds at the terminator.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.direct import relief_bump
    >>> relief_bump(np.array([-0.5, 0.0, 0.5]), np.array(0.25)).round(4)
    array([0.0021, 0.0997, 0.0021])
    """
    width = np.maximum(s, 1e-9)
    z = np.minimum(np.abs(m) / width, 30.0)
    density = np.exp(-0.5 * z * z) / np.sqrt(2.0 * np.pi)
    result: FloatArray = width * (density - z * normal_cdf(-z))
    return result


def _lengths_and_cosines(normals: FloatArray, light: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the length of each channel's normal and the cosine of its angle to the light, (..., 3)."""
    length = np.sqrt(dot(normals, normals))
    n_dot_l = dot(normals, light[..., None, :])
    return length, np.clip(n_dot_l / np.maximum(length, 1e-9), -1.0, 1.0)


def _lookup(lut: Lut, cos_theta: FloatArray, curvature_per_mm: FloatArray) -> FloatArray:
    """Return values (..., 3) of a curvature table; each channel has its own column."""
    u = lut.columns.coordinate(cos_theta)
    v = lut.rows.coordinate(curvature_per_mm)
    return lut.sample_channels(u, v)


def _relief_light(length: FloatArray, cos_theta: FloatArray) -> FloatArray:
    """Return the light (..., 3) that relief adds at the terminator, given the length that normals keep."""
    slope = np.sqrt(np.maximum(-np.log(np.clip(length, 1e-3, 1.0)), 0.0))
    sine = np.sqrt(np.maximum(1.0 - np.square(cos_theta), 0.0))
    return relief_bump(length * cos_theta, slope * sine)
