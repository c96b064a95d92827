"""Ambient light under diffusion (MODEL §5): spherical harmonics, or three lookups for other light."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, dot, unit_vectors
from .._core.harmonics import harmonics

__all__ = [
    "ambient_irradiance",
    "ambient_normals",
    "ambient_of_three",
    "bounced_visibility",
    "occluded_reflection",
    "reflected_visibility",
    "sh_basis",
    "specular_visibility",
    "transferred_irradiance",
]

COSINE_BANDS = np.array([1.0, 2.0 / 3.0, 1.0 / 4.0])
"""Factors of the clamped cosine for bands 0, 1 and 2, divided by π [Ramamoorthi2001]."""
BAND_SLICES = (slice(0, 1), slice(1, 4), slice(4, 9))
"""Indices of the harmonics of bands 0, 1 and 2."""
LEAST_HIDDEN = 0.02
"""Least hidden share by which bounced light is divided, about that of the noise of rays."""


def sh_basis(directions: FloatArray) -> FloatArray:
    """Return the nine real spherical harmonics of bands 0..2 (..., 9) at unit directions (..., 3)."""
    return harmonics(directions, 2)


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
    basis = sh_basis(normals / np.maximum(length, 1e-9)[..., None])
    total = np.zeros_like(length)
    for band, own in enumerate(BAND_SLICES):
        light = np.einsum("...cl,lc->...c", basis[..., own], radiance_sh[own])
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


def transferred_irradiance(ambient_transfer: FloatArray, radiance_sh: FloatArray) -> FloatArray:
    """Return the irradiance over π (..., 3), ≥ 0, of a sky through a baked ambient transfer.

    It includes occlusion, light that other parts of the body reflect, and diffusion.

    Parameters
    ----------
    ambient_transfer
        (..., 3 channels, 9) ``total`` of `skinshade.AmbientTransfer`.
    radiance_sh
        (9, 3) harmonic coefficients of the sky's radiance.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.ambient import sh_basis, transferred_irradiance
    >>> half_hidden = np.zeros((3, 9))
    >>> half_hidden[:, 0] = 0.5 * sh_basis(np.array([0.0, 0.0, 1.0]))[0]
    >>> sky = np.zeros((9, 3))
    >>> sky[0] = np.sqrt(4.0 * np.pi)  # radiance 1 in every direction
    >>> transferred_irradiance(half_hidden, sky)
    array([0.5, 0.5, 0.5])
    """
    result: FloatArray = np.maximum(np.einsum("...cl,lc->...c", ambient_transfer, radiance_sh), 0.0)
    return result


def reflected_visibility(
    sky_harmonics: FloatArray, normal: FloatArray, direction: FloatArray
) -> FloatArray:
    """Return the share (...) of the light around a mirror direction that the body does not hide, 0..1.

    Parameters
    ----------
    sky_harmonics
        (..., 9) cosine-weighted mean of the harmonics over the visible directions of a point, from
        `skinshade.mesh_ambient_transfer`.
    normal
        (..., 3) unit normals of the mesh.
    direction
        (..., 3) unit mirror directions, from `skinshade.shading.specular.reflected`.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.ambient import COSINE_BANDS, reflected_visibility, sh_basis
    >>> up = np.array([0.0, 0.0, 1.0])
    >>> free = np.repeat(COSINE_BANDS, [1, 3, 5]) * sh_basis(up)  # nothing is hidden
    >>> float(reflected_visibility(0.5 * free, up, up).round(6))
    0.5
    """
    visible = dot(sky_harmonics, sh_basis(direction))
    # Along the horizon and below, the clamped cosine of nine harmonics is near 0.
    x = np.maximum(dot(normal, direction), 0.0)
    free = (0.375 + x * (2.0 + 1.875 * x)) / (4.0 * np.pi)
    result: FloatArray = np.clip(visible / free, 0.0, 1.0)
    return result


def occluded_reflection(
    sky: FloatArray,
    bounced: FloatArray,
    sky_harmonics: FloatArray,
    normal: FloatArray,
    direction: FloatArray,
) -> FloatArray:
    """Return reflected light (..., 3): that of the sky where it is visible, else that of the body itself.

    Parameters
    ----------
    sky
        (..., 3) radiance of the sky around the mirror direction.
    bounced
        (..., 3) irradiance over π from other parts of the body.
    sky_harmonics, normal, direction
        As for `reflected_visibility`. The first harmonic tells which share of all directions is hidden.
    """
    visibility = reflected_visibility(sky_harmonics, normal, direction)[..., None]
    hidden = 1.0 - sky_harmonics[..., :1] / 0.28209479177387814
    body = bounced / np.maximum(hidden, LEAST_HIDDEN)
    return sky * visibility + body * (1.0 - visibility)


def specular_visibility(
    n_dot_v: FloatArray, visibility: FloatArray, roughness: FloatArray
) -> FloatArray:
    """Return the share (...) of reflected ambient light that is not occluded, 0..1 [Lagarde2014]."""
    exponent = np.exp2(-16.0 * roughness - 1.0)
    base = np.maximum(n_dot_v + visibility, 0.0)
    result: FloatArray = np.clip(base**exponent - 1.0 + visibility, 0.0, 1.0)
    return result
