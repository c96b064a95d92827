"""What a pixel is given: the surface it sees, each light, and light from all around."""

from __future__ import annotations

from dataclasses import dataclass

from .._core.arrays import FloatArray, unit_vectors

__all__ = ["Ambient", "Incident", "Surface"]


@dataclass(frozen=True)
class Surface:
    """What a pixel sees, (N, ...) each.

    Attributes
    ----------
    view
        (N, 3) unit, towards the eye.
    mesh_normal
        (N, 3) unit, interpolated.
    fetched
        (N, 2 or 3, 3) normal map at each blur of ``Skin.blend``, sharp first, in world axes.
    curvature_per_mm
        (N,) mean curvature.
    albedo
        (N, 3).
    gloss, reflectance
        (N,).
    tint
        (N, 3) of light that comes through.
    tensor_world
        (N, 6) shape operator, 1/mm, or None.
    diffused_normals
        (N, 3, 3) mesh normals diffused by the profile, or None.
    diffused_curvature_per_mm
        (N, 3) mean curvature diffused by the profile, or None; the energy gain takes it.
    unexplained
        (N, 3) of `skinshade.shading.direct.unexplained_length` where the map is flat, which varies no
        faster than vertices stand and can be found for them; None, and it is found for each pixel.
    """

    view: FloatArray
    mesh_normal: FloatArray
    fetched: FloatArray
    curvature_per_mm: FloatArray
    albedo: FloatArray
    gloss: FloatArray
    reflectance: FloatArray
    tint: FloatArray
    tensor_world: FloatArray | None = None
    diffused_normals: FloatArray | None = None
    diffused_curvature_per_mm: FloatArray | None = None
    unexplained: FloatArray | None = None

    @property
    def sharp(self) -> FloatArray:
        """(N, 3) unit normal of the map without blur."""
        return unit_vectors(self.fetched[:, 0])

    @property
    def blurred(self) -> FloatArray:
        """(N, 3) unit normal of the widest blur."""
        return unit_vectors(self.fetched[:, -1])


@dataclass(frozen=True)
class Incident:
    """One light at each pixel.

    Attributes
    ----------
    to_light
        (N, 3) unit.
    radiance
        (N, 3) irradiance over π on a surface that faces it.
    shadow_filter
        (N,) of the wide filter, 0..1.
    thickness_mm
        (N,) towards the light, or None for no deep scatter.
    """

    to_light: FloatArray
    radiance: FloatArray
    shadow_filter: FloatArray
    thickness_mm: FloatArray | None = None


@dataclass(frozen=True)
class Ambient:
    """Light from all around at each pixel.

    Attributes
    ----------
    radiance_sh
        (9, 3).
    visibility
        (N, 3) share that arrives.
    bounced
        (N, 3) irradiance over π from the body's own lit parts where they hide the surroundings.
    through
        (N, 3) irradiance over π that arrives through the body, or None.
    reflected
        (N, 3) preconvolved radiance in the mirror direction, both lobes.
    """

    radiance_sh: FloatArray
    visibility: FloatArray
    bounced: FloatArray
    reflected: FloatArray
    through: FloatArray | None = None
