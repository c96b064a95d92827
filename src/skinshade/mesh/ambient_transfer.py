"""Ambient transfer of a mesh: harmonics of the light that reaches its vertices (MODEL §5)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import FloatArray, IntArray, as_faces, as_floats, as_positions, unit_vectors
from .._core.errors import ArgumentError, MeshError
from .._core.harmonics import MOST_ORDER
from .._core.progress import Progress, silent
from ..profile import Profile
from .ambient_rays import AmbientRays
from .diffusion import diffuse_on_mesh
from .normals import vertex_normals
from .rays import RayTracing

__all__ = ["AmbientTransfer", "diffused_by_channel", "mesh_ambient_transfer", "share_sent_back"]

BOUNCES = 4
"""Bounces of light between parts of a body. A fifth adds less than .1 % in the folds of a head."""
COAT_ALBEDO = 0.049
"""Mean share of diffuse light that the coat of a body reflects, for an index of refraction of 1.4."""
DIFFUSION_TOLERANCE = 1e-4
"""Tolerance of diffusion: a tenth of a step of eight bits in the picture."""


@dataclass(frozen=True)
class AmbientTransfer:
    """Harmonics that turn the radiance of a sky into the light at vertices.

    The irradiance over π of a channel at a vertex is the scalar product of its row and the harmonics of the
    sky's radiance in that channel.

    Attributes
    ----------
    visible
        (V, H) transfer of light that arrives without a bounce, not diffused. Its first three bands also
        tell in which directions the sky is visible.
    total
        (V, 3, H) transfer of a channel with bounces, diffused by the profile if one is given.

    Examples
    --------
    >>> import skinshade as sk
    >>> plane = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    >>> sk.mesh_ambient_transfer(plane, [[0, 1, 2]]).total.shape
    (3, 3, 9)
    """

    visible: FloatArray
    total: FloatArray

    @property
    def order(self) -> int:
        """Greatest band of the harmonics."""
        return int(np.sqrt(self.visible.shape[1])) - 1

    def irradiance(self, radiance_sh: ArrayLike) -> FloatArray:
        """Return the irradiance over π (V, 3), ≥ 0, under a sky.

        Parameters
        ----------
        radiance_sh
            (H, 3) or more harmonics of the sky's radiance.

        Raises
        ------
        ArgumentError
            If there are fewer harmonics.
        """
        sky = as_floats("radiance_sh", radiance_sh)
        count = self.visible.shape[1]
        if sky.ndim != 2 or sky.shape[1] != 3 or len(sky) < count:
            raise ArgumentError(f"radiance_sh: shape is {sky.shape}; it must be ({count}, 3)")
        result: FloatArray = np.maximum(np.einsum("vch,hc->vc", self.total, sky[:count]), 0.0)
        return result


def mesh_ambient_transfer(
    positions_mm: ArrayLike,
    faces: ArrayLike,
    normals: ArrayLike | None = None,
    *,
    albedo: ArrayLike = 0.0,
    profile: Profile | None = None,
    order: int = 2,
    bounces: int = BOUNCES,
    tracing: str = RayTracing.AUTO,
    progress: Progress = silent,
) -> AmbientTransfer:
    """Return the ambient transfer of a mesh: occlusion, bounces and diffusion in one scalar product.

    Parameters
    ----------
    positions_mm, faces
        (V, 3) mm and (F, 3), counter-clockwise seen from outside.
    normals
        (V, 3) outward unit normals; computed if None.
    albedo
        (3,) or (V, 3) diffuse albedo of the vertices, 0..1.
    profile
        Profile that diffuses the light; None for a body without scattering.
    order
        Greatest band of the harmonics, 0..4: 2 for a sky that turns, 4 for greater accuracy.
    bounces
        Bounces of light between parts of the body, 0..64.
    tracing
        Ray caster, as in `skinshade.mesh_thickness`.
    progress
        Called with the name of the work and the fraction that is done.

    Returns
    -------
    AmbientTransfer
        Arrays of the harmonics at the vertices.

    Raises
    ------
    ArgumentError, MeshError
        If an array is malformed, a number is out of range, or there are no vertices or faces.

    Examples
    --------
    >>> import numpy as np
    >>> import skinshade as sk
    >>> mesh = sk.builtin_head().mesh
    >>> transfer = sk.mesh_ambient_transfer(mesh.positions_mm, mesh.faces, mesh.normals, albedo=0.5)
    >>> sky = np.zeros((9, 3))
    >>> sky[0] = np.sqrt(4.0 * np.pi)  # radiance 1 in every direction
    >>> light = transfer.irradiance(sky)
    >>> bool(0.0 <= light.min() < light.max().round(5) <= 1.0)
    True
    """
    p = as_positions("positions_mm", positions_mm)
    f = as_faces("faces", faces, p.shape[0])
    if not p.size or not f.size:
        raise MeshError("positions_mm, faces: there are no vertices or no faces")
    n = (
        vertex_normals(p, f)
        if normals is None
        else unit_vectors(as_floats("normals", normals, p.shape))
    )
    if not 0 <= order <= MOST_ORDER or int(order) != order:
        raise ArgumentError(f"order is {order}; it must be a whole number, 0..{MOST_ORDER}")
    if not 0 <= bounces <= 64 or int(bounces) != bounces:
        raise ArgumentError(f"bounces is {bounces}; it must be a whole number, 0..64")
    colours = as_floats("albedo", albedo, low=0.0, high=1.0)
    try:
        colours = np.broadcast_to(colours, p.shape)
    except ValueError:
        raise ArgumentError(
            f"albedo: shape is {colours.shape}; it must be (3,) or (V, 3)"
        ) from None
    rays = AmbientRays.cast(p, f, n, tracing=tracing, progress=progress)
    visible = rays.visible_harmonics(order)
    reflectance = share_sent_back(colours)
    total = np.stack(
        [visible + rays.bounced(visible, reflectance[:, [c]], f, bounces) for c in range(3)], axis=1
    )
    if profile is not None:
        total = diffused_by_channel(p, f, total, profile)
    return AmbientTransfer(visible, total)


def share_sent_back(albedo: FloatArray) -> FloatArray:
    """Return the share (...) of light that a surface of an albedo (...) sends back, coat included."""
    return (1.0 - COAT_ALBEDO) * albedo + COAT_ALBEDO


def diffused_by_channel(
    positions_mm: FloatArray, faces: IntArray, values: FloatArray, profile: Profile
) -> FloatArray:
    """Return values (V, 3, K) of three channels, each diffused by its own channel of the profile."""
    mixed = diffuse_on_mesh(positions_mm, faces, values, profile, tolerance=DIFFUSION_TOLERANCE)
    return np.stack([mixed[:, c, ..., c] for c in range(3)], axis=1)
