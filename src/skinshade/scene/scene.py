"""A scene, and its description in a JSON file."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from .._core.arrays import FloatArray, as_rgb
from .._core.errors import ArgumentError, SceneFileError, SkinshadeError
from .._core.files import existing_file
from ..mesh import Mesh, load_mesh
from ..params import SkinParams
from ..profile import Profile
from ..shading.specular import gloss_from_roughness
from ..shading.tonemap import ToneMap
from .camera import Camera
from .environment import Environment
from .images import read_linear
from .lights import DirectionalLight, Light
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
        up, vfov_deg), ``sun`` (irradiance_perpendicular, to_light by name), ``environment`` (path,
        scale, visible_to_camera) and ``materials``; lengths in ``unit_mm``. A path may be relative to
        the file itself, or to a ``data`` folder beside it.
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
        return _scene(record, file, light)
    except ArgumentError as error:
        raise SceneFileError(f"{file}: {error}") from None
    except SkinshadeError:
        raise
    except KeyError as error:
        raise SceneFileError(f"{file}: lacks the field {error}") from None
    except (TypeError, ValueError, AttributeError, IndexError) as error:
        raise SceneFileError(f"{file}: a field has a wrong type or value ({error})") from None


def _scene(record: Mapping[str, Any], file: Path, light: str) -> Scene:
    unit = float(record["unit_mm"])
    mesh = load_mesh(_resolved(file, record["mesh"]["path"]), unit_mm=unit)
    textures = record.get("textures", {})
    if "V runs UP" in str(record["mesh"].get("uv_note", "")) or record["mesh"].get("flip_v", False):
        mesh = mesh.with_uvs_flipped()
    material = Material()
    if "color" in textures:
        picture = read_linear(_resolved(file, _first_word(textures["color"])))
        material = replace(material, albedo=picture)
    material = _with_skin(material, record.get("materials", {}))
    if "normal" in textures:
        normal = read_normal_map(_resolved(file, _first_word(textures["normal"])))
        material = replace(material, normal=normal)
    camera = record["camera"]
    return Scene(
        mesh,
        Camera(
            np.asarray(camera["position"], dtype=np.float64) * unit,
            np.asarray(camera["target"], dtype=np.float64) * unit,
            float(camera["vfov_deg"]),
            np.asarray(camera.get("up", (0.0, 1.0, 0.0)), dtype=np.float64),
        ),
        material,
        _lights(record, file, light),
        _environment(record, file),
        tone="filmic" if str(record.get("tonemap", "none")).startswith("filmic") else "srgb",
    )


def _lights(record: Mapping[str, Any], file: Path, light: str) -> tuple[Light, ...]:
    if "sun" not in record:
        return ()
    sun = record["sun"]
    names = sun["to_light"]
    if light not in names:
        raise SceneFileError(f"{file}: has no light {light!r}; there are {', '.join(names)}")
    return (DirectionalLight(names[light], sun["irradiance_perpendicular"]),)


def _environment(record: Mapping[str, Any], file: Path) -> Environment | None:
    if "environment" not in record:
        return None
    surroundings = record["environment"]
    return Environment.load(
        _resolved(file, surroundings["path"]),
        scale=float(surroundings.get("scale", 1.0)),
        visible=bool(surroundings.get("visible_to_camera", False)),
    )


def _with_skin(material: Material, materials: Mapping[str, Any]) -> Material:
    """Take profile and gloss from the first material that has a radius.

    ``radius_mm`` is a diffuse mean free path, as path tracers with a skin closure take it: its walk has
    the mean free path at which diffusion theory gives that length.
    """
    for record in materials.values():
        if "radius_mm" not in record:
            continue
        ior = float(record.get("ior", 1.4))
        params = SkinParams(
            gloss=float(gloss_from_roughness(float(record.get("roughness", 0.5)))),
            reflectance=((ior - 1.0) / (ior + 1.0)) ** 2,
        )
        albedo = material.albedo.reshape(-1, 3).mean(axis=0, dtype=np.float64)
        profile = Profile.burley(
            length_mm=record["radius_mm"], kind="diffuse-mean-free-path", albedo=albedo
        )
        return replace(material, profile=profile, params=params)
    return material


def _resolved(file: Path, name: str) -> Path:
    beside = file.parent / name
    return beside if beside.exists() else file.parent / "data" / name


def _first_word(text: str) -> str:
    return text.split(" ")[0]
