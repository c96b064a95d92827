"""The whole pixel: every term, in the order in which a shader calls them.

`lambert` is the same surface without any scattering, `classic` the system of 2014, `transfer` ours.
Each gives the same named terms, which add up to the picture.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Literal

import numpy as np

from .._core.arrays import FloatArray, dot
from ..profile.energy import energy_gain
from . import ambient, classic, deep_scatter, direct, normals, shadow, specular
from .pixel import Ambient, Incident, Surface
from .skin import Skin

__all__ = ["TERMS", "ShadingMode", "Tier", "shade"]

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
    return normals.blend_normals(surface.fetched, skin.blend(surface.fetched.shape[1]))


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
    if surface.unexplained is None:
        relief = direct.unexplained_length(skin.transfer, seen, surface.diffused_normals, total)
    else:
        relief = np.sqrt(dot(seen, seen)) * surface.unexplained
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
    # Light leaves within ρ of where it entered: what counts is curvature averaged as far, per channel.
    curvature = surface.diffused_curvature_per_mm
    if curvature is None:
        curvature = surface.curvature_per_mm[:, None]
    return energy_gain(skin.profile.albedo, skin.profile.rms_radius_mm, curvature)


def _specular(surface: Surface, light: Incident, lit: FloatArray) -> FloatArray:
    highlight = specular.specular(
        surface.sharp, surface.view, light.to_light, surface.gloss, surface.reflectance
    )
    return np.repeat((highlight * lit)[:, None], 3, axis=1)


def _tint(skin: Skin, surface: Surface) -> FloatArray:
    return surface.tint * np.asarray(skin.params.deep_scatter_tint)
