"""Ambient light under diffusion (MODEL §5): spherical harmonics, or three lookups for other light."""

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
"""Factors of the clamped cosine for bands 0, 1 and 2, divided by π [Ramamoorthi2001]."""


def sh_basis(directions: FloatArray) -> FloatArray:
    """Return the nine real spherical harmonics of bands 0..2 (..., 9) at unit directions (..., 3)."""
    return np.stack([harmonic for band in _bands(directions) for harmonic in band], axis=-1)


def _bands(directions: FloatArray) -> list[list[FloatArray]]:
    """Return the harmonics (...) of bands 0, 1 and 2 at unit directions (..., 3)."""
    x, y, z = directions[..., 0], directions[..., 1], directions[..., 2]
    return [
        [np.full_like(x, 0.28209479177387814)],  # √(1/4π)
        [
            0.4886025119029199 * y,  # √(3/4π)
            0.4886025119029199 * z,
            0.4886025119029199 * x,
        ],
        [
            1.0925484305920792 * x * y,  # √(15/4π)
            1.0925484305920792 * y * z,
            0.31539156525252005 * (3.0 * z * z - 1.0),  # √(5/16π)
            1.0925484305920792 * x * z,
            0.5462742152960396 * (x * x - y * y),  # √(15/16π)
        ],
    ]


def ambient_irradiance(
    radiance_sh: FloatArray, normals: FloatArray, band_transfer: FloatArray | None = None
) -> FloatArray:
    """Return the irradiance over π of each channel at its own normal, (..., 3), ≥ 0.

    Parameters
    ----------
    radiance_sh
        (9, 3) harmonic coefficients of the environment's radiance.
    normals
        (..., 3 channels, 3) blended normals, not normalised: band l is multiplied by their length to the
        power l(l+1)/2.
    band_transfer
        (..., 3 bands, 3 channels) factors of diffusion over a curved body, T_c(√(l(l+1))κ)·g_c; 1 if None.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.ambient import ambient_irradiance
    >>> radiance_sh = np.zeros((9, 3))
    >>> radiance_sh[0] = np.sqrt(4.0 * np.pi)  # radiance 1 in every direction
    >>> up = np.array([0.0, 1.0, 0.0])
    >>> ambient_irradiance(radiance_sh, np.stack([up, up, up]))
    array([1., 1., 1.])
    """
    length = np.sqrt(dot(normals, normals))
    # Blurring relief damps band l by |N|^(l(l+1)/2): the powers 0, 1 and 3.
    damping = [np.ones_like(length), length, length * length * length]
    total, coefficients = np.zeros_like(length), iter(radiance_sh)
    for band, harmonics in enumerate(_bands(normals / np.maximum(length, 1e-9)[..., None])):
        light = sum(harmonic * next(coefficients) for harmonic in harmonics)
        factor = COSINE_BANDS[band] * damping[band]
        total += light * (factor if band_transfer is None else factor * band_transfer[..., band, :])
    result: FloatArray = np.maximum(total, 0.0)
    return result


def ambient_normals(normals: FloatArray) -> FloatArray:
    """Return the unit normals (..., 3 channels, 3) for ambient light without harmonics, e.g. cube maps."""
    return unit_vectors(normals)


def ambient_of_three(red: FloatArray, green: FloatArray, blue: FloatArray) -> FloatArray:
    """Return ambient light (..., 3) from three lookups, one for each normal of `ambient_normals`.

    Parameters
    ----------
    red, green, blue
        (..., 3) colours at the red, green and blue normal. The result has the red of the first colour,
        the green of the second and the blue of the third.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.ambient import ambient_of_three
    >>> ambient_of_three(np.array([1, 0, 0]), np.array([0, 2, 0]), np.array([0, 0, 3]))
    array([1, 2, 3])
    """
    return np.stack([red[..., 0], green[..., 1], blue[..., 2]], axis=-1)


def bounced_visibility(visibility: FloatArray, albedo: FloatArray) -> FloatArray:
    """Return visibility (..., 3) that includes the light reflected by neighbouring surfaces [Jimenez2016].

    The cubic is a fit to path-traced occlusion: in bright skin, neighbouring surfaces reflect red light
    into the creases.
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
    """Return the share (...) of reflected ambient light that is not occluded, 0..1 [Lagarde2014]."""
    exponent = np.exp2(-16.0 * roughness - 1.0)
    base = np.maximum(n_dot_v + visibility, 0.0)
    result: FloatArray = np.clip(base**exponent - 1.0 + visibility, 0.0, 1.0)
    return result
