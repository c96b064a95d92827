"""Options of a scene: model, material, light and camera."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

from .._core.errors import ArgumentError
from .._core.units import parse_unit_mm
from ..heads import builtin_head, head_scene, load_head
from ..heads.portrait import DEFAULT_LIGHT, portrait_camera
from ..mesh.axes import UpAxis
from ..params import SkinParams
from ..params.choices import ToneCurve
from ..params.fields import meaning
from ..profile import Profile
from ..scene import DirectionalLight, Environment, Scene, load_scene
from .values import parse_numbers, parse_pair

__all__ = ["LightOptions", "MaterialOptions", "ModelOptions", "build_scene"]

DEFAULT_VIEW = (28.0, 4.0)
"""Yaw and pitch of the camera around a head, degrees."""


def _help_of(name: str) -> str:
    """Return the help of an option that sets a field of `SkinParams`."""
    entry = next(meaning(parameter) for parameter in fields(SkinParams) if parameter.name == name)
    unit = "" if entry.unit == "1" else f" {entry.unit}"
    return f"{entry.about} {entry.low:g}..{entry.high:g}{unit}."


@dataclass(frozen=True)
class ModelOptions:
    """Model."""

    model: Annotated[
        Path | None,
        typer.Argument(
            help="GLB, glTF, OBJ, PLY, STL, or a scene in JSON; by default the built-in head."
        ),
    ] = None
    unit_mm: Annotated[
        str | None,
        typer.Option(help="Unit of the model: a length in mm, or mm, cm, m, in or ft."),
    ] = None
    up: Annotated[UpAxis, typer.Option(help="Up axis of an OBJ, PLY or STL model.")] = UpAxis.Y
    albedo: Annotated[Path | None, typer.Option(help="Colour map.")] = None
    normal_map: Annotated[Path | None, typer.Option(help="Tangent-space normal map, +y up.")] = None
    flip_v: Annotated[bool, typer.Option("--flip-v", help="The model's v increases upwards.")] = (
        False
    )
    skin_material: Annotated[
        list[str] | None,
        typer.Option(
            help="Name of a material of the model that is skin, with * for any text; repeat it for"
            " several. By default, hair, eyes and the like are told by their names."
        ),
    ] = None

    @property
    def is_scene_file(self) -> bool:
        """Whether the model is a scene in JSON."""
        return self.model is not None and self.model.suffix.lower() == ".json"

    def check(self) -> None:
        """Raise if an option has no effect on the built-in head or a scene file.

        Raises
        ------
        ArgumentError
            If there is such an option; the message names it.
        """
        if self.model is not None and not self.is_scene_file:
            return
        options = {
            "--unit-mm": self.unit_mm is not None,
            "--up": self.up != UpAxis.Y,
            "--albedo": self.albedo is not None,
            "--normal-map": self.normal_map is not None,
            "--flip-v": self.flip_v,
            "--skin-material": bool(self.skin_material),
        }
        for option, is_given in options.items():
            if is_given:
                source = "a scene in JSON" if self.is_scene_file else "the built-in head"
                raise ArgumentError(f"{option} needs a model; it has no effect on {source}")


@dataclass(frozen=True)
class MaterialOptions:
    """Material."""

    profile: Annotated[
        str | None, typer.Option(help="Diffusion profile; see skinshade profile.")
    ] = None
    scatter_scale: Annotated[float | None, typer.Option(help=_help_of("scatter_scale"))] = None
    gloss: Annotated[float | None, typer.Option(help=_help_of("gloss"))] = None
    roughness: Annotated[
        float | None, typer.Option(help="GGX roughness, instead of --gloss. 0..1.")
    ] = None
    normal_strength: Annotated[float | None, typer.Option(help=_help_of("normal_strength"))] = None
    deep_scatter_strength: Annotated[
        float | None, typer.Option(help=_help_of("deep_scatter_strength"))
    ] = None


@dataclass(frozen=True)
class LightOptions:
    """Camera and light."""

    view: Annotated[
        str | None,
        typer.Option(help="Camera: yaw,pitch in degrees around the head; 0,0 is in front."),
    ] = None
    light: Annotated[
        list[str] | None,
        typer.Option(
            help="yaw,pitch,intensity of a directional light, or the name of a light of a scene in"
            " JSON; repeat it for several lights."
        ),
    ] = None
    light_from_camera: Annotated[
        bool,
        typer.Option(
            "--light-from-camera",
            help="The angles of --light start at the camera, not at the head.",
        ),
    ] = False
    env: Annotated[
        Path | None, typer.Option(help="Equirectangular image that lights the head.")
    ] = None
    env_scale: Annotated[float, typer.Option(help="Factor of the environment.")] = 1.0
    show_env: Annotated[
        bool, typer.Option("--show-env", help="Show the environment behind the head.")
    ] = False
    no_extract_sun: Annotated[
        bool,
        typer.Option(
            "--no-extract-sun",
            help="The sun of the environment stays in its image, without a shadow of its own.",
        ),
    ] = False
    background: Annotated[str | None, typer.Option(help="Linear colour r,g,b behind the head.")] = (
        None
    )
    exposure: Annotated[
        float | None, typer.Option(help="Factor of the light before the tone curve.")
    ] = None
    tone: Annotated[ToneCurve | None, typer.Option(help="Tone curve.")] = None


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
