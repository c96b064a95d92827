"""Inputs of shading at N pixels: the surface, each light, and the ambient light."""

from __future__ import annotations

from dataclasses import dataclass

from .._core.arrays import FloatArray, unit_vectors

__all__ = ["Ambient", "Incident", "Surface"]


@dataclass(frozen=True)
class Surface:
    """Surface at N pixels.

    Attributes
    ----------
    view
        (N, 3) unit vectors towards the eye.
    mesh_normal
        (N, 3) unit normals of the mesh, interpolated.
    fetched
        (N, 2 or 3, 3) normals of the map in world axes: sharp, then at each blur of ``Skin.blend``.
    curvature_per_mm
        (N,) mean curvature, 1/mm.
    albedo
        (N, 3) linear albedo of the texture, 0..1.
    gloss
        (N,) gloss of the first specular lobe, 0..1.
    reflectance
        (N,) specular reflectance at normal incidence.
    tint
        (N, 3) colour of light that passes through the body, 0..1.
    tensor_world
        (N, 6) shape operator in world axes, xx xy xz yy yz zz, 1/mm, or None.
    diffused_normals
        (N, 3 channels, 3) mesh normals diffused by the profile, or None.
    diffused_curvature_per_mm
        (N, 3) mean curvature diffused by the profile, 1/mm, or None. The energy gain depends on it.
    mesh_relief
        (N, 3) `skinshade.shading.direct.relief_length` of the mesh alone, computed at the vertices. If it
        is None, the length is computed at every pixel.
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
    mesh_relief: FloatArray | None = None

    @property
    def sharp(self) -> FloatArray:
        """Unit normals (N, 3) of the map without blur."""
        return unit_vectors(self.fetched[:, 0])

    @property
    def blurred(self) -> FloatArray:
        """Unit normals (N, 3) of the map at the widest blur."""
        return unit_vectors(self.fetched[:, -1])


@dataclass(frozen=True)
class Incident:
    """One light at N pixels.

    Attributes
    ----------
    to_light
        (N, 3) unit vectors towards the light.
    radiance
        (N, 3) irradiance over π on a surface that faces the light.
    shadow_filter
        (N,) value of the wide shadow filter, 0..1.
    thickness_mm
        (N,) thickness of the body towards the light, mm, or None for no deep scatter.
    contact
        (N,) share of `skinshade.shading.contact.contact_filter`, or None for no contact shadow.
    """

    to_light: FloatArray
    radiance: FloatArray
    shadow_filter: FloatArray
    thickness_mm: FloatArray | None = None
    contact: FloatArray | None = None


@dataclass(frozen=True)
class Ambient:
    """Ambient light at N pixels.

    Attributes
    ----------
    radiance_sh
        (9, 3) harmonic coefficients of the environment's radiance.
    visibility
        (N, 3) irradiance that arrives from the environment, over that of its harmonics at the mesh normal.
    bounced
        (N, 3) irradiance over π from lit parts of the body that occlude the environment.
    reflected
        (N, 3) mean radiance over the specular lobes, from `skinshade.shading.lobes.reflected_sky`.
    through
        (N, 3) irradiance over π that arrives through the body, or None.
    sky_harmonics
        (N, 9) harmonics of the visible part of the sky, weighted by the cosine with the mesh normal; None
        if nothing is hidden.
    """

    radiance_sh: FloatArray
    visibility: FloatArray
    bounced: FloatArray
    reflected: FloatArray
    through: FloatArray | None = None
    sky_harmonics: FloatArray | None = None
