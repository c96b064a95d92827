"""A scene, and its description in a JSON file."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, get_args

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import FloatArray, as_floats, as_rgb
from .._core.errors import ArgumentError, SceneFileError
from .._core.files import existing_file
from ..mesh import Mesh, load_mesh
from ..params import SkinParams
from ..profile import Profile
from ..shading.specular import gloss_from_roughness
from ..shading.tonemap import ToneMap
from .camera import Camera
from .environment import Environment
from .images import read_linear
from .lights import DirectionalLight, Light, SpotLight
from .maps import read_normal_map
from .material import Material

__all__ = ["Scene", "load_scene"]


@dataclass(frozen=True)
class Scene:
    """A head and how it is lit and seen; lengths in mm, y up, a face looks towards +z.

    Attributes
    ----------
    mesh, material, camera
        What is drawn and from where.
    lights
        Each casts shadows.
    environment
        Light from all around, or None.
    background
        (3,) linear radiance behind everything, unless the environment is visible.
    exposure
        Multiplies light before tone mapping.
    tone
        ``filmic`` or ``srgb``.
    """

    mesh: Mesh
    camera: Camera
    material: Material
    lights: tuple[Light, ...] = ()
    environment: Environment | None = None
    background: FloatArray = (0.05, 0.05, 0.05)  # type: ignore[assignment]  # made an array below
    exposure: float = 1.0
    tone: ToneMap = "filmic"

    def __post_init__(self) -> None:
        object.__setattr__(self, "background", as_rgb("background", self.background, low=0.0))
        as_floats("exposure", self.exposure, (), low=0.0)
        if self.tone not in get_args(ToneMap):
            raise ArgumentError(f"tone is {self.tone!r}; it must be one of srgb, filmic")
        if self.mesh.uvs is None and self.material.has_maps:
            raise ArgumentError("the mesh has no UVs, so no map can be placed on it")

    def with_params(self, **changes: Any) -> Scene:
        """Return the scene with some of its material's `SkinParams` changed."""
        params = replace(self.material.params, **changes)
        return replace(self, material=replace(self.material, params=params))


def load_scene(path: str | os.PathLike[str], *, light: str = "front") -> Scene:
    """Read a scene description.

    Parameters
    ----------
    path
        JSON: ``unit_mm``, ``mesh`` (path), ``textures`` (color, normal), ``camera`` (position, target,
        up, vfov_deg), ``sun`` (irradiance_perpendicular, to_light by name), ``lights``, ``environment``
        (path, scale, visible_to_camera) and ``materials``; lengths in ``unit_mm``. Of ``lights`` each has
        an irradiance, and to_light or, if it stands near, position, target and cone_deg (half the
        cone's angle, 30). A path may be relative to the file itself, or to a ``data`` folder beside it; a
        note may follow a texture's, after a space.
    light
        Which of the named sun directions.

    Raises
    ------
    SceneFileError
        Naming the field that is missing or wrong.
    """
    file = existing_file(path, SceneFileError)
    try:
        record = json.loads(file.read_text(encoding="utf-8"))
    except (ValueError, UnicodeDecodeError) as error:
        raise SceneFileError(f"{file}: not JSON ({error})") from None
    if not isinstance(record, dict):
        raise SceneFileError(f"{file}: must hold a JSON object")
    try:
        return _scene(_Record("", record), file, light)
    except ArgumentError as error:
        raise SceneFileError(f"{file}: {error}") from None


@dataclass(frozen=True)
class _Record:
    """An object of the file, and what it is called there."""

    name: str
    fields: Mapping[str, Any]

    def _called(self, field: str) -> str:
        return f"{self.name}.{field}" if self.name else field

    def _value(self, field: str, default: Any = None) -> Any:
        value = self.fields.get(field, default)
        if value is None:
            raise ArgumentError(f"{self.name} lacks the field {field!r}".strip())
        return value

    def record(self, field: str, default: Any = None) -> _Record:
        """Return the object in a field."""
        value = self._value(field, default)
        if not isinstance(value, dict):
            raise ArgumentError(f"{self._called(field)} is {value!r}; it must be an object")
        return _Record(self._called(field), value)

    def records(self, field: str) -> list[_Record]:
        """Return the objects in a field's list; none without it."""
        values = self.fields.get(field, [])
        if not isinstance(values, list):
            raise ArgumentError(f"{self._called(field)} is {values!r}; it must be a list")
        named = {f"{field}[{index}]": value for index, value in enumerate(values)}
        return [_Record(self.name, named).record(name) for name in named]

    def text(self, field: str, default: str | None = None) -> str:
        """Return the text in a field."""
        value = self._value(field, default)
        if not isinstance(value, str):
            raise ArgumentError(f"{self._called(field)} is {value!r}; it must be text")
        return value

    def number(
        self, field: str, default: float | None = None, low: float = -np.inf, high: float = np.inf
    ) -> float:
        """Return the finite number in a field, within a closed range."""
        value = self._value(field, default)
        return float(as_floats(self._called(field), value, (), low=low, high=high))

    def vector(self, field: str, default: ArrayLike | None = None) -> FloatArray:
        """Return the three finite numbers (3,) in a field."""
        return as_floats(self._called(field), self._value(field, default), (3,))


def _scene(record: _Record, file: Path, light: str) -> Scene:
    unit = record.number("unit_mm")
    model = record.record("mesh")
    mesh = load_mesh(_resolved(file, model.text("path")), unit_mm=unit)
    textures = record.record("textures", {})
    if "V runs UP" in model.text("uv_note", "") or model.fields.get("flip_v", False):
        mesh = mesh.with_uvs_flipped()
    material = Material()
    if "color" in textures.fields:
        picture = read_linear(_picture(file, textures.text("color")))
        material = replace(material, albedo=picture)
    material = _with_skin(material, record.record("materials", {}))
    if "normal" in textures.fields:
        normal = read_normal_map(_picture(file, textures.text("normal")))
        material = replace(material, normal=normal)
    camera = record.record("camera")
    return Scene(
        mesh,
        Camera(
            camera.vector("position") * unit,
            camera.vector("target") * unit,
            camera.number("vfov_deg", low=1.0, high=150.0),
            camera.vector("up", (0.0, 1.0, 0.0)),
        ),
        material,
        (*_sun(record, light), *(_light(each, unit) for each in record.records("lights"))),
        _environment(record, file),
        tone="filmic" if record.text("tonemap", "none").startswith("filmic") else "srgb",
    )


def _light(record: _Record, unit: float) -> Light:
    irradiance = record.vector("irradiance")
    near = "position" in record.fields
    for other in ("to_light",) if near else ("target", "cone_deg"):
        if other in record.fields:
            which = "a position" if near else "no position"
            raise ArgumentError(f"{record.name} has {which} and {other!r}; a light is near or far")
    places = [record.vector(each) for each in (("position", "target") if near else ("to_light",))]
    cone_deg = record.number("cone_deg", SpotLight.cone_deg)
    try:
        if near:
            return SpotLight(places[0] * unit, places[1] * unit, irradiance, cone_deg)
        return DirectionalLight(places[0], irradiance)
    except ArgumentError as error:
        raise ArgumentError(f"{record.name}: {error}") from None


def _sun(record: _Record, light: str) -> tuple[Light, ...]:
    if "sun" not in record.fields:
        return ()
    sun = record.record("sun")
    directions = sun.record("to_light")
    if light not in directions.fields:
        names = ", ".join(directions.fields)
        raise ArgumentError(f"has no light {light!r}; there are {names}")
    return (DirectionalLight(directions.vector(light), sun.vector("irradiance_perpendicular")),)


def _environment(record: _Record, file: Path) -> Environment | None:
    if "environment" not in record.fields:
        return None
    surroundings = record.record("environment")
    return Environment.load(
        _resolved(file, surroundings.text("path")),
        scale=surroundings.number("scale", 1.0, low=0.0),
        visible=bool(surroundings.fields.get("visible_to_camera", False)),
    )


def _with_skin(material: Material, materials: _Record) -> Material:
    """Take profile and gloss from the first material that has a radius.

    ``radius_mm`` is a diffuse mean free path, as path tracers with a skin closure take it: its walk has
    the mean free path at which diffusion theory gives that length.
    """
    for name in materials.fields:
        record = materials.record(name)
        if "radius_mm" not in record.fields:
            continue
        ior = record.number("ior", 1.4, low=1.0)
        roughness = record.number("roughness", 0.5, low=0.0, high=1.0)
        params = SkinParams(
            gloss=float(gloss_from_roughness(roughness)),
            reflectance=((ior - 1.0) / (ior + 1.0)) ** 2,
        )
        albedo = material.albedo.reshape(-1, 3).mean(axis=0, dtype=np.float64)
        profile = Profile.burley(
            length_mm=record.fields["radius_mm"], kind="diffuse-mean-free-path", albedo=albedo
        )
        return replace(material, profile=profile, params=params)
    return material


def _resolved(file: Path, name: str) -> Path:
    beside = file.parent / name
    return beside if beside.exists() else file.parent / "data" / name


def _picture(file: Path, text: str) -> Path:
    """A name may hold spaces, and a note may follow it after one: what there is decides."""
    try:
        whole = _resolved(file, text)
        if whole.is_file():
            return whole
    except OSError:  # with its note it is too long for a name
        pass
    return _resolved(file, text.split(" ")[0])
