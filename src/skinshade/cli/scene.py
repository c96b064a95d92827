"""Scene that the options of a command describe."""

from __future__ import annotations

from dataclasses import fields, replace
from typing import Any

import numpy as np

from .._core.errors import ArgumentError
from .._core.units import parse_unit_mm
from ..heads import builtin_head, head_scene, load_head
from ..heads.portrait import DEFAULT_LIGHT, portrait_camera
from ..profile import Profile
from ..scene import DirectionalLight, Environment, Scene, load_scene
from .scene_options import LightOptions, MaterialOptions, ModelOptions
from .values import parse_numbers, parse_pair

__all__ = ["LightOptions", "MaterialOptions", "ModelOptions", "build_scene"]

DEFAULT_VIEW = (28.0, 4.0)
"""Yaw and pitch of the camera around a head, degrees."""


def build_scene(model: ModelOptions, material: MaterialOptions, light: LightOptions) -> Scene:
    """Return the scene that the options describe.

    Raises
    ------
    InputError
        If a file or a value cannot be used.
    """
    model.check()
    scene = _scene_from_file(model, light) if model.is_scene_file else _portrait(model, light)
    scene = _with_material(scene, material)
    scene = _with_environment(scene, light)
    changes: dict[str, Any] = {"exposure": light.exposure, "tone": light.tone}
    if light.background is not None:
        changes["background"] = np.array(parse_numbers(light.background, 3, "--background"))
    return replace(scene, **_without_none(changes))


def _scene_from_file(model: ModelOptions, light: LightOptions) -> Scene:
    assert model.model is not None
    if light.light_from_camera:
        raise ArgumentError("--light-from-camera has no effect on a scene in JSON")
    scene = load_scene(model.model, lights=light.light)
    if light.view is None:
        return scene
    return replace(scene, camera=portrait_camera(scene.mesh, *parse_pair(light.view, "--view")))


def _portrait(model: ModelOptions, light: LightOptions) -> Scene:
    yaw, pitch = DEFAULT_VIEW if light.view is None else parse_pair(light.view, "--view")
    lights = [
        DirectionalLight.from_angles(*parse_numbers(text, 3, "--light"))
        for text in light.light or ()
    ] or [DEFAULT_LIGHT]
    if light.light_from_camera:
        lights = [entry.turned(yaw, pitch) for entry in lights]
    if model.model is None:
        head = builtin_head()
    else:
        head = load_head(
            model.model,
            unit_mm=None if model.unit_mm is None else parse_unit_mm(model.unit_mm),
            up=model.up,
            albedo=model.albedo,
            normal_map=model.normal_map,
            flip_v=model.flip_v,
            skin_material=model.skin_material or (),
        )
    return head_scene(head, yaw_deg=yaw, pitch_deg=pitch, lights=lights)


def _with_material(scene: Scene, material: MaterialOptions) -> Scene:
    if material.gloss is not None and material.roughness is not None:
        raise ArgumentError("--gloss and --roughness: give one of them")
    changes = _without_none(
        {entry.name: getattr(material, entry.name) for entry in fields(material)}
    )
    profile = changes.pop("profile", None)
    scene = scene.with_params(**changes)
    return scene if profile is None else scene.with_profile(Profile.preset(profile))


def _with_environment(scene: Scene, light: LightOptions) -> Scene:
    if light.env is not None:
        environment = Environment.load(
            light.env,
            scale=light.env_scale,
            visible=light.show_env,
            extract_sun=not light.no_extract_sun,
        )
        return replace(scene, environment=environment)
    if scene.environment is None:
        return scene
    environment = replace(
        scene.environment,
        scale=scene.environment.scale * light.env_scale,
        visible=scene.environment.visible or light.show_env,
        extract_sun=scene.environment.extract_sun and not light.no_extract_sun,
    )
    return replace(scene, environment=environment)


def _without_none(changes: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in changes.items() if value is not None}
