"""Direct diffuse light under diffusion, in three tiers of geometry (MODEL §2, §4) [Penner2010]."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.special import ndtr

from .._core.arrays import FloatArray, dot
from ..lut import Lut

__all__ = [
    "direct_diffused_normals",
    "direct_scalar",
    "direct_tensor",
    "directional_curvature",
    "relief_bump",
    "unexplained_length",
]

Transfer = Callable[[FloatArray], FloatArray]
"""k (...) in rad/mm to T (..., 3), as `skinshade.Profile.transfer`."""

SMOOTH_SHORTFALL = 0.025
"""Of |N_c| below T_c(|S|) on a body whose curvature varies: .002 on a torus of 12 and 4 mm, .023 at worst
on an ellipsoid of 15, 10 and 5 mm (benchmarks/three_tiers.py)."""


def direct_scalar(
    lut: Lut,
    normals: FloatArray,
    light: FloatArray,
    curvature_per_mm: FloatArray,
    gain: FloatArray,
) -> FloatArray:
    """Tier of one curvature number: the sphere's table at |H|.

    Parameters
    ----------
    lut
        Curvature table, kernel ``sphere``, without energy gain.
    normals
        (..., 3 channels, 3) unnormalised, of `skinshade.shading.normals.blend_normals`.
    light
        (..., 3) unit, towards the light.
    curvature_per_mm
        (...) mean curvature, 1/mm; its magnitude counts.
    gain
        (..., 3) of `skinshade.profile.energy.energy_gain`, or 1.

    Returns
    -------
    (..., 3)
        Irradiance over that of a surface facing the light.
    """
    length, cos_theta = _polar(normals, light)
    diffused = _table(lut, cos_theta, np.abs(curvature_per_mm))
    return gain * (length * diffused + _lost_relief(length, cos_theta))


def direct_tensor(
    lut: Lut,
    transfer: Transfer,
    normals: FloatArray,
    light: FloatArray,
    directional_per_mm: FloatArray,
    total_per_mm: FloatArray,
    gain: FloatArray,
) -> FloatArray:
    """Tier of the curvature tensor: the ring across which the light changes, times the rest's decay.

    Parameters
    ----------
    lut
        Curvature table, kernel ``ring``, without energy gain.
    transfer
        The profile's.
    directional_per_mm, total_per_mm
        (...) of `directional_curvature`, 1/mm.
    normals, light, gain
        As in `direct_scalar`.
    """
    length, cos_theta = _polar(normals, light)
    rest = np.sqrt(np.maximum(np.square(total_per_mm) - np.square(directional_per_mm), 0.0))
    diffused = _table(lut, cos_theta, directional_per_mm) * transfer(rest)
    return gain * (length * diffused + _lost_relief(length, cos_theta))


def direct_diffused_normals(
    lut: Lut,
    transfer: Transfer,
    normals: FloatArray,
    relief_length: FloatArray,
    light: FloatArray,
    directional_per_mm: FloatArray,
    gain: FloatArray,
) -> FloatArray:
    """Tier of normals diffused over the surface: curvature may vary within the mean free path.

    Parameters
    ----------
    lut, transfer, light, directional_per_mm, gain
        As in `direct_tensor`.
    normals
        (..., 3 channels, 3) of `skinshade.shading.normals.add_mesh_diffusion`.
    relief_length
        (..., 3) of `unexplained_length`: relief that neither table nor tensor knows of.
    """
    length, cos_theta = _polar(normals, light)
    # On any smooth body |N_c| ≤ T_c(κ_d); more is a tensor that the mesh does not resolve.
    share = np.minimum(length / np.maximum(transfer(directional_per_mm), 1e-6), 1.0)
    diffused = _table(lut, cos_theta, directional_per_mm) * share
    return gain * (diffused + _lost_relief(relief_length, cos_theta))


def unexplained_length(
    transfer: Transfer,
    from_texture: FloatArray,
    from_mesh: FloatArray,
    total_per_mm: FloatArray,
) -> FloatArray:
    """Return the length (..., 3) that the normals lost to relief, in the texture and in the mesh.

    A body whose curvature is constant within the mean free path has |N_c| = T_c(|S|): sphere and
    cylinder exactly, and where curvature varies as on an ellipsoid to `SMOOTH_SHORTFALL`. What a fold
    loses beyond that is relief too, whatever carries it.

    Parameters
    ----------
    transfer
        The profile's.
    from_texture, from_mesh
        (..., 3 channels, 3) unnormalised normals of the map, and of the mesh diffused.
    total_per_mm
        (...) |S| of `directional_curvature`, 1/mm.
    """
    texture = np.sqrt(dot(from_texture, from_texture))
    mesh = np.sqrt(dot(from_mesh, from_mesh))
    smooth = (1.0 - SMOOTH_SHORTFALL) * transfer(total_per_mm)
    return texture * np.minimum(mesh / np.maximum(smooth, 1e-6), 1.0)


def directional_curvature(
    tensor_world: FloatArray, normal: FloatArray, light: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return κ_d = |S·L_t|/|L_t| and √(k₁² + k₂²) = |S|, 1/mm.

    Parameters
    ----------
    tensor_world
        (..., 6) shape operator, xx xy xz yy yz zz, 1/mm.
    normal, light
        (..., 3) unit.
    """
    tangential = light - normal * dot(normal, light)[..., None]
    xx, xy, xz, yy, yz, zz = np.moveaxis(tensor_world, -1, 0)
    x, y, z = np.moveaxis(tangential, -1, 0)
    turn2 = (
        np.square(xx * x + xy * y + xz * z)
        + np.square(xy * x + yy * y + yz * z)
        + np.square(xz * x + yz * y + zz * z)
    )
    total = np.sqrt(xx**2 + yy**2 + zz**2 + 2.0 * (xy**2 + xz**2 + yz**2))
    # Straight below the light every direction is as good; the floor only keeps 0/0 out.
    directional = np.sqrt(turn2 / np.maximum(dot(tangential, tangential), 1e-12))
    return np.minimum(directional, total), total


def relief_bump(m: FloatArray, s: FloatArray) -> FloatArray:
    """Return mΦ(m/s) + sφ(m/s) − max(0, m): what relief of slope s adds at the terminator."""
    width = np.maximum(s, 1e-9)
    z = np.minimum(np.abs(m) / width, 30.0)
    density = np.exp(-0.5 * z * z) / np.sqrt(2.0 * np.pi)
    result: FloatArray = width * (density - z * ndtr(-z))
    return result


def _polar(normals: FloatArray, light: FloatArray) -> tuple[FloatArray, FloatArray]:
    length = np.sqrt(dot(normals, normals))
    along = dot(normals, light[..., None, :])
    return length, np.clip(along / np.maximum(length, 1e-9), -1.0, 1.0)


def _table(lut: Lut, cos_theta: FloatArray, curvature_per_mm: FloatArray) -> FloatArray:
    u = lut.columns.coordinate(cos_theta)
    v = lut.rows.coordinate(curvature_per_mm)
    return lut.sample_channels(u, v)


def _lost_relief(length: FloatArray, cos_theta: FloatArray) -> FloatArray:
    slope = np.sqrt(np.maximum(-np.log(np.clip(length, 1e-3, 1.0)), 0.0))
    sine = np.sqrt(np.maximum(1.0 - np.square(cos_theta), 0.0))
    return relief_bump(length * cos_theta, slope * sine)
