"""Schema of scene descriptions in JSON, version 1.

The models validate files, and ``docs/scene.schema.json`` is generated from them.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Discriminator, Field, Tag, create_model

from .._core.arrays import LARGEST_LIGHT, LARGEST_POSITION
from ..params import SkinParams
from ..params.fields import choice_fields, meaning, number_fields

__all__ = ["SceneFile", "json_schema"]


def _whole(value: Any) -> Any:
    """Return a value that is a whole number; true and 1.0 are none."""
    if type(value) is not int:
        raise ValueError("should be a whole number")
    return value


class _Model(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)


Number = Annotated[float, Field(ge=-LARGEST_POSITION, le=LARGEST_POSITION)]
Factor = Annotated[float, Field(ge=0.0, le=LARGEST_LIGHT)]
Share = Annotated[float, Field(ge=0.0, le=1.0)]
Vector = tuple[Number, Number, Number]
Light3 = tuple[Factor, Factor, Factor]
Share3 = tuple[Share, Share, Share]
Path = Annotated[str, Field(min_length=1, description="Relative to the folder of this file.")]


def _form(value: Any) -> str:
    """Return the form of a value that may be a number, a list or an object."""
    if isinstance(value, (dict, BaseModel)):
        return "object"
    return "list" if isinstance(value, (list, tuple)) else "number"


class MapFile(_Model):
    """Texture map from an image file."""

    path: Path
    color_space: Literal["srgb", "linear"] | None = Field(
        None, description="Colour space of the stored values; by the file's format if missing."
    )
    v: Literal["up", "down"] = Field(
        "down",
        description="Direction in which v increases in the image; glTF counts it down from the top.",
    )


class NormalMapFile(MapFile):
    """Tangent-space normal map from an image file, +y up in the image."""

    color_space: Literal["linear"] | None = Field(None, description="Normal maps are linear.")
    strength: Annotated[float, Field(ge=0.0, le=2.0)] = 1.0


class MeshFile(_Model):
    """Model to draw."""

    path: Path
    up: Literal["y", "z"] = Field(
        "y",
        description="Axis of an OBJ, PLY or STL file that points up; camera and lights have y up.",
    )
    credit: str = Field("", description="Credit to show with every picture.")
    skin_materials: list[str] = Field(
        [],
        description="Names of the materials of a glTF model that are skin, with * for any text."
        " By default, hair, eyes and the like are recognised by their names.",
    )


class PresetProfile(_Model):
    """Profile that skinshade contains."""

    kind: Literal["preset"]
    name: str


class BurleyProfile(_Model):
    """Burley's normalised diffusion."""

    kind: Literal["burley"]
    length_mm: Light3
    length_kind: Literal[
        "shape",
        "mean-free-path-searchlight",
        "mean-free-path-diffuse",
        "diffuse-mean-free-path",
        "blender-skin-radius",
    ]
    albedo: Share3 | Literal["mean-of-map"]


class GaussiansProfile(_Model):
    """Mixture of Gaussians."""

    kind: Literal["gaussians"]
    variances_mm2: list[Factor]
    weights: list[Light3]
    albedo: Share3


class DipoleProfile(_Model):
    """Dipole of diffusion theory."""

    kind: Literal["dipole"]
    sigma_s_prime_per_mm: Light3
    sigma_a_per_mm: Light3
    ior: Annotated[float, Field(ge=1.0, le=3.0)] = 1.3


ProfileFile = Annotated[
    PresetProfile | BurleyProfile | GaussiansProfile | DipoleProfile, Field(discriminator="kind")
]
ColourMap = Annotated[
    Annotated[Share, Tag("number")]
    | Annotated[Share3, Tag("list")]
    | Annotated[MapFile, Tag("object")],
    Discriminator(_form),
]


class _MaterialMaps(_Model):
    """Material: maps, profile, and parameters of `skinshade.SkinParams`."""

    albedo: ColourMap | None = None
    normal: NormalMapFile | None = None
    deep_scatter: ColourMap | None = None
    profile: ProfileFile | None = None
    roughness: Share | None = Field(None, description="GGX roughness, instead of gloss.")
    ior: Annotated[float, Field(ge=1.0, le=2.6)] | None = Field(
        None, description="Index of refraction, instead of reflectance."
    )


def _parameter_fields() -> dict[str, Any]:
    """Return a field for each parameter of `SkinParams`, with its range and meaning."""
    result: dict[str, Any] = {}
    for parameter in choice_fields(SkinParams):
        entry = parameter.metadata["choice"]
        names = Literal[tuple(member.value for member in entry.kind)]  # type: ignore[valid-type]
        result[parameter.name] = (names | None, Field(None, description=entry.about))
    for parameter in number_fields(SkinParams):
        m = meaning(parameter)
        number = Annotated[float, Field(ge=m.low, le=m.high)]
        kind: Any = number
        if isinstance(parameter.default, tuple):
            kind = tuple[number, number, number]
        about = m.about if m.unit == "1" else f"{m.about} Unit: {m.unit}."
        result[parameter.name] = (kind | None, Field(None, description=about))
    return result


MaterialFile = create_model(
    "MaterialFile", __base__=_MaterialMaps, __doc__=_MaterialMaps.__doc__, **_parameter_fields()
)


class CameraFile(_Model):
    """Perspective camera; positions in units of the file."""

    position: Vector
    target: Vector
    up: Vector = (0.0, 1.0, 0.0)
    vertical_fov_deg: Annotated[float, Field(ge=1.0, le=150.0)] = 20.0


class _LightFile(_Model):
    name: str = ""
    irradiance: Light3 = Field(description="On a surface that faces the light; π for radiance 1.")
    enabled: bool = True


class SunFile(_LightFile):
    """Light from an infinite distance."""

    kind: Literal["sun"]
    to_light: Vector = Field(description="Direction towards the light.")
    angular_diameter_deg: Annotated[float, Field(ge=0.0, le=180.0)] = Field(
        0.5, description="For path tracers; shadows of skinshade have the width of its filter."
    )


class SpotFile(_LightFile):
    """Light from a point within a cone; irradiance is that at the target."""

    kind: Literal["spot"]
    position: Vector
    target: Vector
    cone_deg: Annotated[float, Field(ge=1.0, le=80.0)] = Field(
        30.0, description="Half angle at which the light ends."
    )


class EnvironmentFile(_Model):
    """Equirectangular image that lights the scene."""

    path: Path
    scale: Factor = 1.0
    visible: bool = Field(False, description="Show it behind the body.")
    extract_sun: bool = Field(
        True, description="Draw the sun of the image as a light with a shadow."
    )


class ToneFile(_Model):
    """Tone curve from linear light to display values."""

    curve: Literal["srgb", "filmic"] = "filmic"
    exposure: Factor = 1.0


class SceneFile(_Model):
    """A scene; unknown keys are errors."""

    version: Annotated[Literal[1], BeforeValidator(_whole)] = Field(
        alias="skinshade", description="Version of this schema."
    )
    unit_mm: Annotated[float, Field(ge=1e-6, le=1e9)] | None = Field(
        None, description="Length of the model's unit, mm; the model's own if missing."
    )
    mesh: MeshFile
    material: MaterialFile = Field(default_factory=MaterialFile)  # type: ignore[valid-type]
    camera: CameraFile
    lights: list[Annotated[SunFile | SpotFile, Field(discriminator="kind")]] = []
    environment: EnvironmentFile | None = None
    background: Light3 = (0.05, 0.05, 0.05)
    tone: ToneFile = ToneFile()


def json_schema() -> dict[str, Any]:
    """Return the JSON Schema of scene descriptions."""
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        **SceneFile.model_json_schema(by_alias=True),
        "title": "skinshade scene, version 1",
    }
