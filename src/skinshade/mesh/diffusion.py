"""Diffusion over a surface by a profile's transfer function (MODEL §7).

The square of a frequency of the plane corresponds to an eigenvalue of the Laplacian of the mesh, so that a
profile acts as the matrix function T(√(M⁻¹K)). Chebyshev polynomials of the matrix apply it to all values at
once, without time steps, factorisations or a Gaussian fit.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import FloatArray, as_faces, as_floats, as_positions
from .._core.errors import MeshError
from .._core.progress import Progress, silent
from ..profile import Profile
from .chebyshev import chebyshev_factors, filtered
from .laplacian import Laplacian
from .rational import transferred

__all__ = ["diffuse_on_mesh", "mesh_diffused_normals"]

WORK = "diffusing over the surface"


def diffuse_on_mesh(
    positions_mm: ArrayLike,
    faces: ArrayLike,
    values: ArrayLike,
    profile: Profile,
    *,
    tolerance: float = 1e-8,
    progress: Progress = silent,
) -> FloatArray:
    """Diffuse values at vertices over the surface by the three channels of a profile.

    Parameters
    ----------
    positions_mm, faces
        (V, 3) mm and (F, 3). Vertices at one position are one point of the surface.
    values
        (V, ...) any quantity, such as irradiance or normals. Values at vertices that no face uses do
        not count.
    profile
        Any profile.
    tolerance
        Greatest error of the result, relative to the norm of the input, 1e-12..1e-1. Needle-like faces and
        profiles with a sharp peak need many steps.
    progress
        Called with the name of the work and the fraction that is done.

    Returns
    -------
    (V, ..., 3)
        Diffused values; the last axis is the channel. Constants and the integral over the surface are
        kept within 1e-7. The result is exact up to the resolution of the mesh.

    Raises
    ------
    ArgumentError, MeshError
        If an array is malformed, the faces around a vertex have no area, or the profile is too wide for
        the shortest edges of a mesh of more than 500,000 points.

    Examples
    --------
    >>> import numpy as np
    >>> import skinshade as sk
    >>> mesh = sk.builtin_head().mesh
    >>> light = np.maximum(mesh.normals @ [0.0, 0.0, 1.0], 0.0)
    >>> skin = sk.Profile.preset("skin-deon2007")
    >>> sk.diffuse_on_mesh(mesh.positions_mm, mesh.faces, light, skin, tolerance=1e-4).shape
    (20560, 3)
    """
    p = as_positions("positions_mm", positions_mm)
    if p.shape[0] == 0:
        raise MeshError("positions_mm: there are no vertices")
    f = as_faces("faces", faces, p.shape[0])
    v = as_floats("values", values)
    as_floats("tolerance", tolerance, (), low=1e-12, high=0.1)
    if v.ndim == 0 or v.shape[0] != p.shape[0]:
        raise MeshError(f"values: shape is {v.shape} for {p.shape[0]} vertices")
    laplacian = Laplacian.of(p, f)
    points = laplacian.points_of(v.reshape(len(p), -1), f)
    reaches = profile.rms_radius_mm
    transfer, reach = profile.kernel.transfer, float(reaches.max())

    def report(fraction: float) -> None:
        progress(WORK, fraction)

    report(0.0)
    factors = chebyshev_factors(transfer, laplacian.greatest, reach, tolerance)
    if factors is None:
        shift = 1.0 / (reach * float(reaches.min()))
        result = transferred(laplacian, transfer, points, tolerance, shift, report)
    else:
        result = filtered(laplacian, factors, points, report)
    report(1.0)
    if laplacian.point is not None:
        result = result[laplacian.point]
    return result.reshape(*v.shape, 3)


def mesh_diffused_normals(
    positions_mm: ArrayLike, faces: ArrayLike, normals: ArrayLike, profile: Profile
) -> FloatArray:
    """Return normals, diffused by the channels of a profile and not normalised [Kolchin2007].

    They are shorter than 1 where the surface curves within the reach of the profile: their length is the
    contrast that diffusion leaves.

    Parameters
    ----------
    positions_mm, faces
        (V, 3) mm and (F, 3), as in `diffuse_on_mesh`.
    normals
        (V, 3) unit.
    profile
        Any profile.

    Returns
    -------
    (V, 3, 3)
        Diffused normals; the second axis is the channel.

    Raises
    ------
    ArgumentError, MeshError
        As in `diffuse_on_mesh`.

    Examples
    --------
    >>> import skinshade as sk
    >>> mesh = sk.builtin_head().mesh
    >>> skin = sk.Profile.preset("skin-deon2007")
    >>> sk.mesh_diffused_normals(mesh.positions_mm, mesh.faces, mesh.normals, skin).shape
    (20560, 3, 3)
    """
    return np.swapaxes(diffuse_on_mesh(positions_mm, faces, normals, profile), -1, -2)
