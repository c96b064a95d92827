"""Specular lobes of a material at N pixels, by specular model."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, dot
from ..params.choices import Shading, SpecularModel
from . import coat, specular
from .image_light import PreconvolvedRadiance, coat_radiance, reflected_radiance
from .pixel import Surface
from .skin import Skin
from .specular import SHARP_LOBE_SHARE

__all__ = ["highlight", "reflected_sky", "sky_share"]


def highlight(skin: Skin, surface: Surface, to_light: FloatArray, shading: Shading) -> FloatArray:
    """Return the reflected radiance (N,) per unit of light from directions (N, 3), without shadow."""
    arguments = surface.sharp, surface.view, to_light
    model = skin.specular_model(shading)
    if model == SpecularModel.BLINN_PHONG:
        return specular.specular(*arguments, surface.gloss, surface.reflectance)
    total = np.zeros_like(surface.gloss)
    for weight, gloss in _lobes(model, surface.gloss):
        total += weight * coat.coat_highlight(*arguments, gloss, surface.reflectance)
    return total


def sky_share(skin: Skin, surface: Surface, shading: Shading) -> FloatArray:
    """Return the share (N,) of an even sky that the coat reflects to the eye, before occlusion.

    For GGX lobes it is their directional albedo, and the diffuse light is multiplied by the rest.
    """
    n_dot_v, model = dot(surface.sharp, surface.view), skin.specular_model(shading)
    if model == SpecularModel.BLINN_PHONG:
        return specular.ambient_specular_fresnel(n_dot_v, surface.gloss, surface.reflectance)
    total = np.zeros_like(surface.gloss)
    for weight, gloss in _lobes(model, surface.gloss):
        total += weight * _coat(skin, surface, n_dot_v, gloss)[0]
    return total


def reflected_sky(
    skin: Skin, surface: Surface, preconvolved: PreconvolvedRadiance, shading: Shading
) -> FloatArray:
    """Return the mean radiance (N, 3) of the environment over the lobes; `sky_share` is not included."""
    model = skin.specular_model(shading)
    if model == SpecularModel.BLINN_PHONG:
        direction = specular.reflected(surface.sharp, surface.view)
        return reflected_radiance(preconvolved, direction, surface.gloss)
    n_dot_v = dot(surface.sharp, surface.view)
    radiance, shares = np.zeros_like(surface.view), np.zeros_like(surface.gloss)
    for weight, gloss in _lobes(model, surface.gloss):
        albedo, pull = _coat(skin, surface, n_dot_v, gloss)
        direction = coat.coat_direction(surface.sharp, surface.view, pull)
        share = weight * albedo
        radiance += share[:, None] * coat_radiance(preconvolved, direction, n_dot_v, gloss)
        shares += share
    return radiance / np.maximum(shares, 1e-9)[:, None]


def _lobes(model: SpecularModel, gloss: FloatArray) -> list[tuple[float, FloatArray]]:
    """Return weight and gloss (N,) of the GGX lobes of a model."""
    if model == SpecularModel.GGX:
        return [(1.0, gloss)]
    return [(1.0 - SHARP_LOBE_SHARE, gloss), (SHARP_LOBE_SHARE, coat.second_gloss(gloss))]


def _coat(
    skin: Skin, surface: Surface, n_dot_v: FloatArray, gloss: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return the directional albedo and the pull (N,) of a lobe."""
    return coat.coat(skin.lut("coat"), n_dot_v, gloss, surface.reflectance, skin.coat_reflectance)
