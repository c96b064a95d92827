"""Scenes: a body with its material, lights, environment and camera."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from .._core.arrays import FloatVector, as_floats, as_rgb
from .._core.errors import ArgumentError
from .._core.notebook import table_html
from ..mesh import Mesh
from ..params.choices import ToneCurve
from .camera import Camera
from .environment import Environment
from .lights import Light
from .material import Material

__all__ = ["Scene"]


@dataclass(frozen=True, repr=False)
class Scene:
    """A body, its lights and a camera. Lengths are in mm; y points up, and heads face +z.

    Attributes
    ----------
    mesh
        Geometry.
    camera
        Point of view.
    material
        Skin of the body.
    lights
        Lights that cast shadows.
    environment
        Light from the surroundings, or None.
    background
        (3,) linear radiance behind the body, unless the environment is visible.
    exposure
        Factor on light before the tone curve, ≥ 0.
    tone
        Tone curve, ``filmic`` or ``srgb``.

    Examples
    --------
    >>> import skinshade as sk
    >>> scene = sk.head_scene(sk.builtin_head()).with_params(roughness=0.4)
    >>> round(scene.material.params.gloss, 3)
    0.481
    """

    mesh: Mesh
    camera: Camera
    material: Material
    lights: tuple[Light, ...] = ()
    environment: Environment | None = None
    background: FloatVector = (0.05, 0.05, 0.05)  # type: ignore[assignment]  # converted in __post_init__
    exposure: float = 1.0
    tone: ToneCurve = ToneCurve.FILMIC

    def __post_init__(self) -> None:
        object.__setattr__(self, "background", as_rgb("background", self.background, low=0.0))
        as_floats("exposure", self.exposure, (), low=0.0)
        object.__setattr__(self, "tone", ToneCurve.of(self.tone, "tone"))
        if self.mesh.uvs is None and self.material.has_maps:
            raise ArgumentError("the mesh has no UVs, which the maps of the material need")

    def with_params(self, **changes: Any) -> Scene:
        """Return the scene with `changes` to the `SkinParams` of its material."""
        params = replace(self.material.params, **changes)
        return replace(self, material=replace(self.material, params=params))

    def __repr__(self) -> str:
        lights = ", ".join(type(light).__name__ for light in self.lights) or "no lights"
        return f"Scene({self.mesh!r}, {self.material!r}, {lights}, {self.environment!r})"

    def _repr_html_(self) -> str:
        lights = (
            f"{type(light).__name__}, irradiance {light.irradiance.round(3)}"
            for light in self.lights
        )
        rows = {
            "mesh": self.mesh,
            "material": self.material,
            "camera": self.camera,
            "lights": "; ".join(lights) or "none",
            "environment": self.environment,
            "tone curve": f"{self.tone.value}, exposure {self.exposure:g}",
        }
        return table_html("Scene", rows)
