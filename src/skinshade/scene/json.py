"""Scenes from JSON files."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .._core.arrays import ImageArray
from .._core.errors import ArgumentError, SceneFileError
from .._core.files import existing_file
from .._core.json import parse_json
from .._core.limits import check_limit
from ..mesh import Mesh, load_mesh
from ..params import SkinParams
from ..params.choices import SpecularModel, ToneCurve
from ..profile import Profile
from .asset_parts import asset_parts
from .camera import Camera
from .environment import Environment
from .images import read_image, read_linear
from .lights import DirectionalLight, Light, SpotLight
from .maps import read_normal_map
from .material import Material
from .part import Part
from .scene import Scene

if TYPE_CHECKING:
    from pydantic import ValidationError

    from .schema import MapFile, SceneFile, SpotFile, SunFile

__all__ = ["load_scene"]


def load_scene(path: str | os.PathLike[str], *, lights: Sequence[str] | None = None) -> Scene:
    """Read a scene description.

    Parameters
    ----------
    path
        JSON file in the schema of ``docs/scene.schema.json``. Paths in it are relative to its folder.
    lights
        Names of the lights to turn on, or one name; the lights that the file enables if None.

    Raises
    ------
    SceneFileError
        Naming the file and the field that is missing, unknown or wrong.
    FileError, MeshError, UnitError
        If a file that the description names cannot be used.

    Examples
    --------
    >>> import json
    >>> from importlib.resources import files
    >>> from pathlib import Path
    >>> import skinshade as sk
    >>> description = {
    ...     "skinshade": 1,
    ...     "mesh": {"path": str(files("skinshade") / "heads/assets/head.glb")},
    ...     "camera": {"position": [0, 0, 0.9], "target": [0, 0, 0]},
    ...     "lights": [{"kind": "sun", "name": "key", "to_light": [0, 1, 1], "irradiance": [3, 3, 3]}],
    ... }
    >>> _ = Path("scene.json").write_text(json.dumps(description))
    >>> [light.irradiance.tolist() for light in sk.load_scene("scene.json").lights]
    [[3.0, 3.0, 3.0]]
    """
    file = existing_file(path, SceneFileError)
    check_limit("json_bytes", file.stat().st_size, str(file), SceneFileError)
    try:
        description = _parse(file.read_text(encoding="utf-8"))
        return _scene(description, file.parent, lights)
    except UnicodeDecodeError as error:
        raise SceneFileError(f"{file}: not UTF-8 ({error.reason})") from None
    except ArgumentError as error:
        raise SceneFileError(f"{file}: {error}") from None


def _parse(text: str) -> SceneFile:
    """Return the validated description, or raise an ArgumentError that names the field."""
    parse_json(text)  # refuses duplicate keys, which the validator would accept
    from pydantic import ValidationError

    from .schema import SceneFile

    try:
        return SceneFile.model_validate_json(text)
    except ValidationError as error:
        raise ArgumentError(_message(error)) from None


def _message(error: ValidationError) -> str:
    """Return the first fault of a validation, with the path of its field."""
    fault = error.errors()[0]
    # The path also contains the members of unions, which are no fields.
    members = ("sun", "spot", "preset", "burley", "gaussians", "dipole", "number", "list", "object")
    *parents, last = fault["loc"] or ("",)
    parts = [part for part in parents if part not in members and "[" not in str(part)]
    if fault["type"] == "extra_forbidden" or (last not in members and "[" not in str(last)):
        parts.append(last)
    field = "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in parts)
    field = "".join(c if c.isprintable() else repr(c)[1:-1] for c in field)
    reasons = {"extra_forbidden": "unknown key", "missing": "missing"}
    reason = reasons.get(fault["type"], fault["msg"].removeprefix("Input "))
    value = fault["input"]
    given = "" if isinstance(value, (dict, list)) else f" (it is {str(value)[:60]!r})"
    return f"{field.lstrip('.') or 'the file'}: {reason}{given}"


def _scene(description: SceneFile, folder: Path, names: Sequence[str] | None) -> Scene:
    entry = description.mesh
    mesh = load_mesh(folder / entry.path, unit_mm=description.unit_mm, up=entry.up)
    mesh, parts = _with_parts(description, folder, mesh)
    v_up = _maps_run_up(description)
    if v_up and mesh.uvs is not None:
        mesh = mesh.with_uvs_flipped()
        parts = [part.with_maps_flipped() for part in parts]
    unit, camera = mesh.unit_mm, description.camera
    material = _material(description.material, folder, mesh, v_up)
    return Scene(
        mesh,
        Camera(
            np.array(camera.position) * unit,
            np.array(camera.target) * unit,
            camera.vertical_fov_deg,
            np.array(camera.up),
        ),
        material,
        tuple(_light(light, unit) for light in _enabled(description, names)),
        _environment(description, folder),
        np.array(description.background),
        description.tone.exposure,
        ToneCurve(description.tone.curve),
        tuple(_with_skin_of(part, material) for part in parts),
    )


def _with_parts(description: SceneFile, folder: Path, mesh: Mesh) -> tuple[Mesh, list[Part]]:
    """Return the mesh, and its parts if it has several materials; the first skin has the scene's material."""
    names = description.mesh.skin_materials
    if mesh.materials is None or len(np.unique(mesh.materials)) == 1:
        if names:
            raise ArgumentError("mesh.skin_materials: the model does not have several materials")
        return mesh, []
    mesh, _, parts = asset_parts(folder / description.mesh.path, mesh, names)
    return mesh, parts


def _with_skin_of(part: Part, material: Material) -> Part:
    """Return a part; skin has the profile and the parameters of the scene's material."""
    if not part.is_skin:
        return part
    own = replace(part.material, profile=material.profile, params=material.params)
    return replace(part, material=own)


def _maps_run_up(description: SceneFile) -> bool:
    """Return whether any map counts v from below; then the mesh is flipped, else it is not."""
    material: Any = description.material
    maps = (material.albedo, material.normal, material.deep_scatter)
    return any(getattr(entry, "v", "down") == "up" for entry in maps)


def _material(material: Any, folder: Path, mesh: Mesh, v_up: bool) -> Material:
    result = Material()
    if material.albedo is not None:
        result = replace(result, albedo=_colours(material.albedo, folder, v_up))
    if material.deep_scatter is not None:
        result = replace(result, deep_scatter=_colours(material.deep_scatter, folder, v_up))
    if material.normal is not None:
        normal = read_normal_map(folder / material.normal.path)
        if v_up != (material.normal.v == "up"):
            normal = normal[::-1] * np.array([1.0, -1.0, 1.0], dtype=np.float32)
        result = replace(result, normal=normal)
    return replace(result, profile=_profile(material.profile, result), params=_params(material))


def _colours(entry: MapFile | float | Sequence[float], folder: Path, v_up: bool) -> ImageArray:
    """Return linear colours (H, W, 3) of a map or a constant."""
    if isinstance(entry, (int, float)):
        return np.full((1, 1, 3), entry, dtype=np.float32)
    if isinstance(entry, Sequence):
        return np.array(entry, dtype=np.float32).reshape(1, 1, 3)
    read = read_image if entry.color_space == "linear" else read_linear
    image = read(folder / entry.path)
    return image if v_up == (entry.v == "up") else np.ascontiguousarray(image[::-1])


def _profile(profile: Any, material: Material) -> Profile:
    if profile is None:
        return material.profile
    if profile.kind == "preset":
        return Profile.preset(profile.name)
    fields = profile.model_dump(exclude={"kind"})
    if profile.kind == "gaussians":
        check_limit("gaussians", len(profile.variances_mm2), "material.profile")
        return Profile.gaussians(**fields)
    if profile.kind == "dipole":
        return Profile.dipole(**fields)
    albedo = fields["albedo"]
    if albedo == "mean-of-map":
        albedo = material.albedo.reshape(-1, 3).mean(axis=0, dtype=np.float64)
    return Profile.burley(length_mm=profile.length_mm, kind=profile.length_kind, albedo=albedo)


def _params(material: Any) -> SkinParams:
    given = {
        name: getattr(material, name)
        for name in SkinParams.__dataclass_fields__
        if getattr(material, name, None) is not None
    }
    if material.normal is not None:
        if "normal_strength" in given:
            raise ArgumentError("material.normal_strength: give it as material.normal.strength")
        given["normal_strength"] = material.normal.strength
    if "gloss" in given and "specular" not in given:
        # Assets with a gloss were made for Blinn-Phong lobes, and keep their look.
        given["specular"] = SpecularModel.BLINN_PHONG
    if material.roughness is not None and "gloss" in given:
        raise ArgumentError("material: give roughness or gloss, not both")
    if material.ior is not None:
        if "reflectance" in given:
            raise ArgumentError("material: give ior or reflectance, not both")
        given["reflectance"] = ((material.ior - 1.0) / (material.ior + 1.0)) ** 2
    return SkinParams(**given)


def _enabled(description: SceneFile, names: Sequence[str] | None) -> list[SunFile | SpotFile]:
    if names is None:
        return [light for light in description.lights if light.enabled]
    chosen = [names] if isinstance(names, str) else list(names)
    known = [light.name for light in description.lights]
    for name in chosen:
        if name not in known:
            raise ArgumentError(
                f"there is no light {name!r}; there are {', '.join(known) or 'no lights'}"
            )
    return [light for light in description.lights if light.name in chosen]


def _light(light: SunFile | SpotFile, unit_mm: float) -> Light:
    irradiance = np.array(light.irradiance)
    try:
        if light.kind == "sun":
            return DirectionalLight(np.array(light.to_light), irradiance)
        position, target = np.array(light.position), np.array(light.target)
        return SpotLight(position * unit_mm, target * unit_mm, irradiance, light.cone_deg)
    except ArgumentError as error:
        raise ArgumentError(f"light {light.name!r}: {error}") from None


def _environment(description: SceneFile, folder: Path) -> Environment | None:
    entry = description.environment
    if entry is None:
        return None
    return Environment.load(
        folder / entry.path,
        scale=entry.scale,
        visible=entry.visible,
        extract_sun=entry.extract_sun,
    )
