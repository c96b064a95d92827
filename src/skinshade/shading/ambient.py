"""Ambient light under diffusion (MODEL §5): spherical harmonics, or three normals for anything else."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, dot, unit_vectors

__all__ = [
    "ambient_irradiance",
    "ambient_normals",
    "ambient_of_three",
    "bounced_visibility",
    "sh_basis",
    "specular_visibility",
]

COSINE_BANDS = np.array([1.0, 2.0 / 3.0, 1.0 / 4.0])
"""Transfer of the clamped cosine per band, over π [Ramamoorthi2001]."""
BAND_OF = np.array([0, 1, 1, 1, 2, 2, 2, 2, 2])


def sh_basis(directions: FloatArray) -> FloatArray:
    """Return the nine real spherical harmonics of bands 0..2 (..., 9) at unit directions (..., 3)."""
    x, y, z = directions[..., 0], directions[..., 1], directions[..., 2]
    return np.stack(
        [
            np.full_like(x, 0.28209479177387814),  # √(1/4π)
            0.4886025119029199 * y,  # √(3/4π)
            0.4886025119029199 * z,
            0.4886025119029199 * x,
            1.0925484305920792 * x * y,  # √(15/4π)
            1.0925484305920792 * y * z,
            0.31539156525252005 * (3.0 * z * z - 1.0),  # √(5/16π)
            1.0925484305920792 * x * z,
            0.5462742152960396 * (x * x - y * y),  # √(15/16π)
        ],
        axis=-1,
    )


def ambient_irradiance(
    radiance_sh: FloatArray, normals: FloatArray, band_transfer: FloatArray | None = None
) -> FloatArray:
    """Return irradiance over π for the normal that each channel sees, (..., 3), ≥ 0.

    Parameters
    ----------
    radiance_sh
        (9, 3) coefficients of the environment's radiance.
    normals
        (..., 3 channels, 3) unnormalised: band l takes their length to the power l.
    band_transfer
        (..., 3 bands, 3 channels) of diffusion over a curved body, T_c(√(l(l+1))κ)·g_c; 1 if None.
    """
    length = np.sqrt(dot(normals, normals))
    basis = sh_basis(normals / np.maximum(length, 1e-9)[..., None])
    # |N|⁰, |N|¹, |N|³: a relief's blur damps band 2 three times as fast as band 1, l(l+1)/2.
    bands = np.stack([np.ones_like(length), length, length**3], axis=-2)
    if band_transfer is not None:
        bands = bands * band_transfer
    bands = bands * COSINE_BANDS[:, None]
    total = np.zeros_like(length)
    for term in range(9):
        total += basis[..., term] * bands[..., BAND_OF[term], :] * radiance_sh[term]
    result: FloatArray = np.maximum(total, 0.0)
    return result


def ambient_normals(normals: FloatArray) -> FloatArray:
    """Return the unit normals (..., 3 channels, 3) to evaluate any other ambient light with."""
    return unit_vectors(normals)


def ambient_of_three(red: FloatArray, green: FloatArray, blue: FloatArray) -> FloatArray:
    """Return R of the first, G of the second, B of the third of three ambient values (..., 3)."""
    return np.stack([red[..., 0], green[..., 1], blue[..., 2]], axis=-1)


def bounced_visibility(visibility: FloatArray, albedo: FloatArray) -> FloatArray:
    """Return visibility (..., 3) with the light that neighbouring surfaces return [Jimenez2016].

    A fit to path-traced occlusion: bright skin fills its own creases with red light.
    """
    a = 2.0404 * albedo - 0.3324
    b = -4.7951 * albedo + 0.6417
    c = 2.7552 * albedo + 0.6903
    result: FloatArray = np.maximum(
        visibility, ((visibility * a + b) * visibility + c) * visibility
    )
    return result


def specular_visibility(
    n_dot_v: FloatArray, visibility: FloatArray, roughness: FloatArray
) -> FloatArray:
    """Return the share of reflected ambient light that is not occluded, 0..1 [Lagarde2014]."""
    exponent = np.exp2(-16.0 * roughness - 1.0)
    base = np.maximum(n_dot_v + visibility, 0.0)
    result: FloatArray = np.clip(base**exponent - 1.0 + visibility, 0.0, 1.0)
    return result
