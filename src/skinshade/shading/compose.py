"""Shading of a whole pixel: all terms, in the order in which a shader evaluates them.

The three lighting models (`skinshade.params.choices.Shading`) return terms of the same names. The sum of
the terms is the image.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from .._core.arrays import FloatArray, dot
from ..params.choices import Boundary, Shading, SpecularModel, Tier
from . import ambient, classic, contact, deep_scatter, direct, lobes, normals, shadow
from .energy import energy_gain
from .pixel import Ambient, Incident, Surface
from .skin import Skin
from .specular import diffuse_share
from .specular import reflected as reflected_direction
from .view_factor import closure_view_factor, view_factor

__all__ = ["TERMS", "shade"]

TERMS = (
    "direct",
    "deep_scatter",
    "specular",
    "ambient",
    "ambient_deep_scatter",
    "ambient_specular",
)
"""Names of the terms that `shade` returns. All terms are radiance; the diffuse ones include the albedo."""

_LightTerms = Callable[[Skin, Surface, FloatArray, Incident], dict[str, FloatArray]]
"""Function that returns the terms of one light, given the normal of each channel."""


def shade(
    skin: Skin,
    surface: Surface,
    lights: list[Incident],
    surroundings: Ambient | None,
    shading: Shading = Shading.TRANSFER,
    tier: Tier = Tier.DIFFUSED_NORMALS,
) -> dict[str, FloatArray]:
    """Return every term of `TERMS` as radiance (N, 3).

    Parameters
    ----------
    skin
        Material with the tables that the lighting model uses.
    surface
        Surface at N pixels.
    lights
        Lights at these pixels.
    surroundings
        Ambient light at these pixels; None for no ambient light.
    shading
        Lighting model.
    tier
        Geometry that `Shading.TRANSFER` uses.

    Examples
    --------
    >>> import numpy as np
    >>> import skinshade as sk
    >>> from skinshade.params.choices import Tier
    >>> from skinshade.shading.compose import shade
    >>> from skinshade.shading.pixel import Incident, Surface
    >>> profile = sk.Profile.preset("skin-deon2007")
    >>> skin = sk.Skin.of(profile, sk.SkinParams(), luts=("sphere", "shadow", "coat"), fetches=(2,))
    >>> up = np.array([[0.0, 0.0, 1.0]])
    >>> surface = Surface(
    ...     view=up,
    ...     mesh_normal=up,
    ...     fetched=np.stack([up, up], axis=1),
    ...     curvature_per_mm=np.array([0.0]),
    ...     albedo=np.array([[0.5, 0.4, 0.3]]),
    ...     gloss=np.array([0.35]),
    ...     reflectance=np.array([0.028]),
    ...     tint=np.ones((1, 3)),
    ... )
    >>> light = Incident(to_light=up, radiance=np.ones((1, 3)), shadow_filter=np.ones(1))
    >>> shade(skin, surface, [light], None, tier=Tier.SCALAR)["direct"].round(1)
    array([[0.5, 0.4, 0.3]])
    """
    zero = np.zeros_like(surface.albedo)
    terms = dict.fromkeys(TERMS, zero)
    gain = _gain(skin, surface) if shading == Shading.TRANSFER else np.ones_like(zero)
    methods: dict[Shading, _LightTerms] = {
        Shading.LAMBERT: _lambert,
        Shading.CLASSIC: _classic,
        Shading.TRANSFER: partial(_transfer, tier=tier, gain=gain),
    }
    light_terms = methods[shading]
    channel_normals = _channel_normals(skin, surface, shading)
    for light in lights:
        for name, value in light_terms(skin, surface, channel_normals, light).items():
            terms[name] = terms[name] + value * light.radiance
    sky_share = lobes.sky_share(skin, surface, shading)
    if surroundings is not None:
        terms |= _ambient(skin, surface, channel_normals, surroundings, shading, gain, sky_share)
    albedo = surface.albedo
    if shading == Shading.TRANSFER:
        albedo = albedo * _view_factor(skin, surface)
    if shading != Shading.CLASSIC:
        albedo = albedo * _diffuse_share(skin, surface, shading, sky_share)[:, None]
    for name in ("direct", "deep_scatter", "ambient", "ambient_deep_scatter"):
        terms[name] = terms[name] * albedo
    return terms


def _channel_normals(skin: Skin, surface: Surface, shading: Shading) -> FloatArray:
    """Return the normal of each channel, (N, 3 channels, 3)."""
    if shading == Shading.LAMBERT:
        return np.repeat(surface.sharp[:, None], 3, axis=1)
    if shading == Shading.CLASSIC:
        return classic.ambient_normals(surface.sharp, surface.blurred)
    return normals.blend_normals(surface.fetched, skin.blend(surface.fetched.shape[1]))


def _lambert(
    skin: Skin, surface: Surface, channel_normals: FloatArray, light: Incident
) -> dict[str, FloatArray]:
    """Return the terms of one light without scattering."""
    sharpened = _sharpened(skin, light)
    cosine = np.maximum(dot(surface.sharp, light.to_light), 0.0)
    return {
        "direct": np.repeat((cosine * sharpened)[:, None], 3, axis=1),
        "specular": _specular(skin, surface, light, Shading.LAMBERT, sharpened),
    }


def _classic(
    skin: Skin, surface: Surface, channel_normals: FloatArray, light: Incident
) -> dict[str, FloatArray]:
    """Return the terms of one light by the formulas of 2014."""
    params = skin.params
    n_dot_l = dot(surface.mesh_normal, light.to_light)
    diffuse = classic.direct(
        skin.lut("classic"),
        surface.sharp,
        surface.blurred,
        light.to_light,
        surface.curvature_per_mm,
    )
    diffused_shadow = shadow.diffused_shadow(
        skin.lut("classic_shadow"), light.shadow_filter, n_dot_l, params.shadow_filter_width_mm
    )
    sharpened = classic.sharpened_shadow(light.shadow_filter, params.shadow_sharpening)
    terms = {
        "direct": diffuse * diffused_shadow,
        "specular": _specular(skin, surface, light, Shading.CLASSIC, sharpened),
    }
    if light.thickness_mm is not None:
        scattered = classic.deep_scatter(
            light.thickness_mm,
            dot(surface.blurred, light.to_light),
            params.classic_deep_scatter_radius_mm,
            params.deep_scatter_strength,
        )
        terms["deep_scatter"] = scattered[:, None] * _tint(skin, surface)
    return terms


def _transfer(
    skin: Skin,
    surface: Surface,
    channel_normals: FloatArray,
    light: Incident,
    *,
    tier: Tier,
    gain: FloatArray,
) -> dict[str, FloatArray]:
    """Return the terms of one light by the transfer model."""
    params = skin.params
    n_dot_l = dot(surface.mesh_normal, light.to_light)
    diffused_shadow = shadow.diffused_shadow(
        skin.lut("shadow"), light.shadow_filter, n_dot_l, params.shadow_filter_width_mm
    )
    if light.contact is not None:
        diffused_shadow = contact.contact_shadow(
            skin.lut("shadow"), diffused_shadow, light.contact, params.shadow_filter_width_mm
        )
    sharpened = _sharpened(skin, light)
    terms = {
        "direct": _diffuse(skin, surface, channel_normals, light, tier, gain) * diffused_shadow,
        "specular": _specular(skin, surface, light, Shading.TRANSFER, sharpened),
    }
    if light.thickness_mm is not None:
        # The transmittance is absolute. It is divided by the profile's albedo here, because `shade`
        # multiplies by the albedo of the texture.
        transmitted = deep_scatter.transmittance(
            light.thickness_mm, skin.profile.albedo, skin.sigma_per_mm
        )
        scattered = deep_scatter.direct_deep_scatter(
            transmitted / skin.profile.albedo,
            dot(surface.blurred, light.to_light),
            params.deep_scatter_strength,
        )
        beyond = deep_scatter.through_beyond(scattered, terms["direct"])
        terms["deep_scatter"] = beyond * _tint(skin, surface)
    return terms


def _sharpened(skin: Skin, light: Incident) -> FloatArray:
    """Return the lesser (N,) of the sharpened shadow and the contact shadow, into which no light bleeds."""
    sharpened = shadow.sharpened_shadow(light.shadow_filter, skin.params.shadow_sharpening)
    return sharpened if light.contact is None else np.minimum(sharpened, light.contact)


def _diffuse(
    skin: Skin,
    surface: Surface,
    channel_normals: FloatArray,
    light: Incident,
    tier: Tier,
    gain: FloatArray,
) -> FloatArray:
    """Return direct diffuse light (N, 3) in a tier, or in a simpler tier if the surface lacks its data."""
    if tier == Tier.SCALAR or surface.tensor_world is None:
        return direct.direct_scalar(
            skin.lut("sphere"), channel_normals, light.to_light, surface.curvature_per_mm, gain
        )
    directional, total = direct.directional_curvature(
        surface.tensor_world, surface.mesh_normal, light.to_light
    )
    if tier == Tier.TENSOR or surface.diffused_normals is None:
        return direct.direct_tensor(
            skin.lut("ring"),
            skin.transfer,
            channel_normals,
            light.to_light,
            directional,
            total,
            gain,
        )
    diffused = normals.add_mesh_diffusion(
        channel_normals, surface.diffused_normals, surface.mesh_normal
    )
    if surface.mesh_relief is None:
        relief = direct.relief_length(
            skin.transfer, channel_normals, surface.diffused_normals, total
        )
    else:
        relief = np.sqrt(dot(channel_normals, channel_normals)) * surface.mesh_relief
    return direct.direct_diffused_normals(
        skin.lut("ring"), skin.transfer, diffused, relief, light.to_light, directional, gain
    )


def _ambient(
    skin: Skin,
    surface: Surface,
    channel_normals: FloatArray,
    surroundings: Ambient,
    shading: Shading,
    gain: FloatArray,
    sky_share: FloatArray,
) -> dict[str, FloatArray]:
    """Return the terms of ambient light, given the share (N,) of an even sky that the coat reflects."""
    irradiance = ambient.ambient_irradiance(surroundings.radiance_sh, channel_normals)
    # Visibility and bounced light are diffused at the vertices.
    irradiance = irradiance * surroundings.visibility + surroundings.bounced
    reflected = surroundings.reflected
    if surroundings.sky_harmonics is not None:
        reflected = ambient.occluded_reflection(
            reflected,
            surroundings.bounced,
            surroundings.sky_harmonics,
            surface.mesh_normal,
            reflected_direction(surface.sharp, surface.view),
        )
    terms = {
        "ambient": irradiance * gain,
        "ambient_specular": reflected * sky_share[:, None],
    }
    if shading == Shading.TRANSFER and surroundings.through is not None:
        terms["ambient_deep_scatter"] = (
            skin.params.deep_scatter_strength
            * surroundings.through
            / skin.profile.albedo
            * _tint(skin, surface)
        )
    return terms


def _gain(skin: Skin, surface: Surface) -> FloatArray:
    """Return the energy gain (N, 3), from the diffused curvature if the surface has it."""
    # Light leaves within ρ of its entry, so the gain depends on the curvature averaged over that distance.
    curvature = surface.diffused_curvature_per_mm
    if curvature is None:
        curvature = surface.curvature_per_mm[:, None]
    return energy_gain(skin.profile.albedo, skin.profile.rms_radius_mm, curvature)


def _view_factor(skin: Skin, surface: Surface) -> FloatArray:
    """Return the factor (N, 3) on diffuse light that leaves towards the eye."""
    n_dot_v = dot(surface.sharp, surface.view)
    if skin.boundary == Boundary.BLENDER_SKIN:
        return closure_view_factor(surface.albedo, n_dot_v)
    # Maps of the reflectance darken cavities and brighten moisture; they are not of the boundary below.
    return view_factor(surface.albedo, n_dot_v, np.asarray(skin.params.reflectance))


def _diffuse_share(
    skin: Skin, surface: Surface, shading: Shading, sky_share: FloatArray
) -> FloatArray:
    """Return the share (N,) of light that passes the coat and is diffused."""
    if skin.specular_model(shading) == SpecularModel.BLINN_PHONG:
        n_dot_v = dot(surface.mesh_normal, surface.view)
        return diffuse_share(n_dot_v, surface.gloss, surface.reflectance)
    return 1.0 - sky_share


def _specular(
    skin: Skin, surface: Surface, light: Incident, shading: Shading, sharpened: FloatArray
) -> FloatArray:
    """Return the highlight (N, 3) of one light, multiplied by its sharpened shadow (N,)."""
    highlight = lobes.highlight(skin, surface, light.to_light, shading)
    return np.broadcast_to((highlight * sharpened)[:, None], (sharpened.size, 3))


def _tint(skin: Skin, surface: Surface) -> FloatArray:
    """Return the colour (N, 3) of light that passes through the body."""
    return surface.tint * np.asarray(skin.params.deep_scatter_tint)
