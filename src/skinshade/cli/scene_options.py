"""Options of a scene: model, material, light and camera. Their help needs no package for numbers."""

from __future__ import annotations

from dataclasses import dataclass, fields
from pathlib import Path
from typing import Annotated

import typer

from .._core.errors import ArgumentError
from ..mesh.up_axis import UpAxis
from ..params import SkinParams
from ..params.choices import SpecularModel, ToneCurve
from ..params.fields import meaning

__all__ = ["LightOptions", "MaterialOptions", "ModelOptions"]


def _help_of(name: str) -> str:
    """Return the help of an option that sets a field of `SkinParams`."""
    field = next(parameter for parameter in fields(SkinParams) if parameter.name == name)
    if "choice" in field.metadata:
        about: str = field.metadata["choice"].about
        return about
    entry = meaning(field)
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
    specular: Annotated[SpecularModel | None, typer.Option(help=_help_of("specular"))] = None
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
