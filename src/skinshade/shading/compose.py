"""The whole pixel: every term, in the order in which a shader calls them.

`lambert` is the same surface without any scattering, `classic` the system of 2014, `transfer` ours.
Each gives the same named terms, which add up to the picture.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Literal

import numpy as np

from .._core.arrays import FloatArray, dot, unit_vectors
from ..lut import Lut, build_curvature_lut, build_shadow_lut
from ..lut.classic import classic_curvature_lut, classic_shadow_lut
from ..lut.spectral import DiffusionGeometry
from ..params import SkinParams
from ..profile import Profile
from ..profile.energy import energy_gain
from . import ambient, classic, deep_scatter, direct, normals, shadow, specular
from .normals import NormalBlend

__all__ = ["TERMS", "Ambient", "Incident", "ShadingMode", "Skin", "Surface", "Tier", "shade"]

ShadingMode = Literal["lambert", "classic", "transfer"]
Tier = Literal["scalar", "tensor", "diffused-normals"]

TERMS = (
    "direct",
    "deep_scatter",
    "specular",
    "ambient",
    "ambient_deep_scatter",
    "ambient_specular",
)
"""What `shade` returns: diffuse terms carry the albedo, all are radiance."""


TABLE_RADIUS_MM = (0.5, 4000.0)
"""Radii of curvature that the tables hold: from a lash line to what is flat for any profile."""
TABLE_SIZE = (512, 128)


@dataclass(frozen=True)
class Skin:
    """What is the same for every pixel of a material: tables and fitted weights, made when asked for.

    Attributes
    ----------
    profile
        Already scaled by ``params.scatter_scale``.
    params
        The numbers of the material.
    """

    profile: Profile
    params: SkinParams

    @classmethod
    def of(cls, profile: Profile, params: SkinParams) -> Skin:
        """Return the skin of a material's profile and parameters."""
        return cls(profile.scaled(params.scatter_scale), params)

    def transfer(self, k_per_mm: FloatArray) -> FloatArray:
        """Return the profile's T(k) (..., 3)."""
        return self.profile.kernel.transfer(k_per_mm)

    @cached_property
    def sphere(self) -> Lut:
        """Curvature table of the sphere, without energy gain."""
        return self._curvature_table("sphere")

    @cached_property
    def ring(self) -> Lut:
        """Curvature table of the ring, without energy gain."""
        return self._curvature_table("ring")

    @cached_property
    def shadow(self) -> Lut:
        """Shadow table for the material's filter, down to grazing light."""
        width = self.params.shadow_filter_width_mm
        return build_shadow_lut(
            self.profile,
            size=(512, 64),
            width_mm=(width, width / shadow.LEAST_COSINE),
            sharpening=self.params.shadow_sharpening,
        )

    @cached_property
    def classic_curvature(self) -> Lut:
        """Curvature table of 2014."""
        return classic_curvature_lut(self.profile, size=(512, 64))

    @cached_property
    def classic_shadow(self) -> Lut:
        """Shadow table of 2014."""
        return classic_shadow_lut(
            self.profile, size=(512, 64), sharpening=self.params.shadow_sharpening
        )

    @cached_property
    def blend(self) -> NormalBlend:
        """Weights of the normal fetches."""
        return normals.normal_blend(self.profile)

    @property
    def sigma_per_mm(self) -> FloatArray:
        """(3,) decay of light that comes through the body."""
        default = deep_scatter.default_sigma_per_mm(self.profile.rms_radius_mm)
        given = np.asarray(self.params.deep_scatter_sigma_per_mm)
        return np.where(given > 0.0, given, default)

    def _curvature_table(self, kernel: DiffusionGeometry) -> Lut:
        return build_curvature_lut(
            self.profile,
            size=TABLE_SIZE,
            radius_mm=TABLE_RADIUS_MM,
            kernel=kernel,
            energy_gain=False,
        )


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
        (N, n+1, 3) normal map at each blur of ``Skin.blend``, sharp first, in world axes.
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


_Direct = Callable[[Skin, Surface, FloatArray, Incident], dict[str, FloatArray]]


def shade(
    skin: Skin,
    surface: Surface,
    lights: list[Incident],
    surroundings: Ambient | None,
    mode: ShadingMode = "transfer",
    tier: Tier = "diffused-normals",
) -> dict[str, FloatArray]:
    """Return every term of `TERMS` as radiance (N, 3)."""
    zero = np.zeros_like(surface.albedo)
    terms = dict.fromkeys(TERMS, zero)
    gain = _gain(skin, surface) if mode == "transfer" else np.ones_like(zero)
    methods: dict[ShadingMode, _Direct] = {
        "lambert": _lambert,
        "classic": _classic,
        "transfer": partial(_transfer, tier=tier, gain=gain),
    }
    direct_of = methods[mode]
    seen = _seen_normals(skin, surface, mode)
    for light in lights:
        for name, value in direct_of(skin, surface, seen, light).items():
            terms[name] = terms[name] + value * light.radiance
    if surroundings is not None:
        terms |= _ambient(skin, surface, seen, surroundings, mode, gain)
    body = surface.albedo
    if mode != "classic":
        n_dot_v = dot(surface.mesh_normal, surface.view)
        share = specular.diffuse_share(n_dot_v, surface.gloss, surface.reflectance)
        body = body * share[:, None]
    for name in ("direct", "deep_scatter", "ambient", "ambient_deep_scatter"):
        terms[name] = terms[name] * body
    return terms


def _seen_normals(skin: Skin, surface: Surface, mode: ShadingMode) -> FloatArray:
    """The normal that each channel sees in its map, (N, 3 channels, 3)."""
    if mode == "lambert":
        return np.repeat(surface.sharp[:, None], 3, axis=1)
    if mode == "classic":
        return classic.ambient_normals(surface.sharp, surface.blurred)
    return normals.blend_normals(surface.fetched, skin.blend)


def _lambert(
    skin: Skin, surface: Surface, seen: FloatArray, light: Incident
) -> dict[str, FloatArray]:
    lit = shadow.sharpened_shadow(light.shadow_filter, skin.params.shadow_sharpening)
    cosine = np.maximum(dot(surface.sharp, light.to_light), 0.0)
    return {
        "direct": np.repeat((cosine * lit)[:, None], 3, axis=1),
        "specular": _specular(surface, light, lit),
    }


def _classic(
    skin: Skin, surface: Surface, seen: FloatArray, light: Incident
) -> dict[str, FloatArray]:
    params = skin.params
    n_dot_l = dot(surface.mesh_normal, light.to_light)
    diffuse = classic.direct(
        skin.classic_curvature,
        surface.sharp,
        surface.blurred,
        light.to_light,
        surface.curvature_per_mm,
    )
    edge = shadow.diffused_shadow(
        skin.classic_shadow, light.shadow_filter, n_dot_l, params.shadow_filter_width_mm
    )
    lit = classic.sharpened_shadow(light.shadow_filter, params.shadow_sharpening)
    terms = {"direct": diffuse * edge, "specular": _specular(surface, light, lit)}
    if light.thickness_mm is not None:
        glow = classic.deep_scatter(
            light.thickness_mm,
            dot(surface.blurred, light.to_light),
            params.classic_deep_scatter_radius_mm,
            params.deep_scatter_strength,
        )
        terms["deep_scatter"] = glow[:, None] * _tint(skin, surface)
    return terms


def _transfer(
    skin: Skin,
    surface: Surface,
    seen: FloatArray,
    light: Incident,
    *,
    tier: Tier,
    gain: FloatArray,
) -> dict[str, FloatArray]:
    params = skin.params
    n_dot_l = dot(surface.mesh_normal, light.to_light)
    edge = shadow.diffused_shadow(
        skin.shadow, light.shadow_filter, n_dot_l, params.shadow_filter_width_mm
    )
    lit = shadow.sharpened_shadow(light.shadow_filter, params.shadow_sharpening)
    result = {
        "direct": _diffused(skin, surface, seen, light, tier, gain) * edge,
        "specular": _specular(surface, light, lit),
    }
    if light.thickness_mm is not None:
        # The profile's albedo is the body's; the texture's stays outside, where it is multiplied.
        passed = deep_scatter.transmittance(
            light.thickness_mm, skin.profile.albedo, skin.sigma_per_mm
        )
        glow = deep_scatter.direct_deep_scatter(
            passed / skin.profile.albedo,
            dot(surface.blurred, light.to_light),
            params.deep_scatter_strength,
        )
        result["deep_scatter"] = glow * _tint(skin, surface)
    return result


def _diffused(
    skin: Skin,
    surface: Surface,
    seen: FloatArray,
    light: Incident,
    tier: Tier,
    gain: FloatArray,
) -> FloatArray:
    if tier == "scalar" or surface.tensor_world is None:
        return direct.direct_scalar(
            skin.sphere, seen, light.to_light, surface.curvature_per_mm, gain
        )
    directional, total = direct.directional_curvature(
        surface.tensor_world, surface.mesh_normal, light.to_light
    )
    if tier == "tensor" or surface.diffused_normals is None:
        return direct.direct_tensor(
            skin.ring, skin.transfer, seen, light.to_light, directional, total, gain
        )
    both = normals.add_mesh_diffusion(seen, surface.diffused_normals, surface.mesh_normal)
    relief = direct.unexplained_length(skin.transfer, seen, surface.diffused_normals, total)
    return direct.direct_diffused_normals(
        skin.ring, skin.transfer, both, relief, light.to_light, directional, gain
    )


def _ambient(
    skin: Skin,
    surface: Surface,
    seen: FloatArray,
    surroundings: Ambient,
    mode: ShadingMode,
    gain: FloatArray,
) -> dict[str, FloatArray]:
    bands = None
    if mode == "transfer":
        k = np.sqrt(np.array([0.0, 2.0, 6.0])) * np.abs(surface.curvature_per_mm)[:, None]
        bands = skin.transfer(k) * gain[:, None, :]
    irradiance = ambient.ambient_irradiance(surroundings.radiance_sh, seen, bands)
    n_dot_v = dot(surface.sharp, surface.view)
    open_to = ambient.specular_visibility(
        n_dot_v, surroundings.visibility.mean(axis=1), 1.0 - surface.gloss
    )
    fresnel = specular.ambient_specular_fresnel(n_dot_v, surface.gloss, surface.reflectance)
    terms = {
        "ambient": irradiance * surroundings.visibility + surroundings.bounced,
        "ambient_specular": surroundings.reflected * (fresnel * open_to)[:, None],
    }
    if mode == "transfer" and surroundings.through is not None:
        terms["ambient_deep_scatter"] = (
            skin.params.deep_scatter_strength
            * surroundings.through
            / skin.profile.albedo
            * _tint(skin, surface)
        )
    return terms


def _gain(skin: Skin, surface: Surface) -> FloatArray:
    rms = skin.profile.rms_radius_mm
    if surface.diffused_curvature_per_mm is None:
        return energy_gain(skin.profile.albedo, rms, surface.curvature_per_mm)
    # Light leaves within ρ of where it entered: what counts is curvature averaged as far, per channel.
    albedo, curvature = skin.profile.albedo, surface.diffused_curvature_per_mm
    one = [slice(channel, channel + 1) for channel in range(3)]
    return np.concatenate(
        [energy_gain(albedo[c], rms[c], curvature[:, c][:, 0]) for c in one], axis=1
    )


def _specular(surface: Surface, light: Incident, lit: FloatArray) -> FloatArray:
    highlight = specular.specular(
        surface.sharp, surface.view, light.to_light, surface.gloss, surface.reflectance
    )
    return np.repeat((highlight * lit)[:, None], 3, axis=1)


def _tint(skin: Skin, surface: Surface) -> FloatArray:
    return surface.tint * np.asarray(skin.params.deep_scatter_tint)
