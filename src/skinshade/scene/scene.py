"""Scenes: a body with its materials, lights, environment and camera."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from .._core.arrays import LARGEST_LIGHT, FloatVector, as_floats, as_positions, as_rgb
from .._core.errors import ArgumentError
from .._core.limits import check_limit
from .._core.notebook import table_html
from ..mesh import Mesh
from ..params.choices import ToneCurve
from ..profile import Profile
from .camera import Camera
from .environment import Environment
from .lights import Light
from .material import Material
from .part import Part

__all__ = ["Scene"]

LARGEST_UV = 1e9
"""Greatest texture coordinate; float32 has no digits left for texels far below it."""
LARGEST_CURVATURE_PER_MM = 1e12
"""Greatest curvature and entry of a shape operator among the attributes of a mesh, 1/mm; products of greater
values overflow float32."""


@dataclass(frozen=True, repr=False)
class Scene:
    """A body, its lights and a camera. Lengths are in mm; y points up, and heads face +z.

    Attributes
    ----------
    mesh
        Geometry: positions within ±1e15 mm, UVs within ±1e9, and curvatures in its attributes within
        ±1e12/mm.
    camera
        Point of view.
    material
        Skin of the body.
    lights
        Lights that cast shadows; the limit ``lights`` of `skinshade.Limits` applies.
    environment
        Light from the surroundings, or None.
    background
        (3,) linear radiance behind the body, unless the environment is visible, 0..1e6.
    exposure
        Factor on light before the tone curve, 0..1e6.
    tone
        Tone curve, ``filmic`` or ``srgb``.
    parts
        Parts of the body with materials of their own; `material` applies to the other faces.

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
    parts: tuple[Part, ...] = ()

    def __post_init__(self) -> None:
        background = as_rgb("background", self.background, low=0.0, high=LARGEST_LIGHT)
        object.__setattr__(self, "background", background)
        as_floats("exposure", self.exposure, (), low=0.0, high=LARGEST_LIGHT)
        check_limit("lights", len(self.lights), "scene")
        object.__setattr__(self, "tone", ToneCurve.of(self.tone, "tone"))
        materials = [self.material, *(part.material for part in self.parts)]
        if self.mesh.uvs is None and any(material.has_maps for material in materials):
            raise ArgumentError("the mesh has no UVs, which the maps of the material need")
        _check_mesh(self.mesh)
        self._check_parts()

    def _check_parts(self) -> None:
        numbers = [part.number for part in self.parts]
        if len(set(numbers)) < len(numbers):
            raise ArgumentError(f"parts have the numbers {numbers}; every number occurs once")
        if self.parts and self.mesh.materials is None:
            raise ArgumentError("the mesh has no material numbers, which parts need")
        for part in self.parts:
            if part.is_skin and not part.material.profile.equals(self.material.profile):
                raise ArgumentError(
                    f"part {part.name!r}: all skin of a scene has one profile; see with_profile"
                )

    def with_params(self, **changes: Any) -> Scene:
        """Return the scene with `changes` to the `SkinParams` of its skin."""
        return self._with_skin(
            lambda material: replace(material, params=replace(material.params, **changes))
        )

    def with_profile(self, profile: Profile) -> Scene:
        """Return the scene with another `profile` for its skin."""
        return self._with_skin(lambda material: replace(material, profile=profile))

    def _with_skin(self, change: Callable[[Material], Material]) -> Scene:
        parts = tuple(
            replace(part, material=change(part.material)) if part.is_skin else part
            for part in self.parts
        )
        return replace(self, material=change(self.material), parts=parts)

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


def _check_mesh(mesh: Mesh) -> None:
    """Raise if values at the vertices of a mesh are beyond what both backends can compute with."""
    count = len(mesh.positions)
    as_positions("mesh: positions_mm", mesh.positions_mm)
    if mesh.uvs is not None:
        as_floats("mesh: uvs", mesh.uvs, (count, 2), low=-LARGEST_UV, high=LARGEST_UV)
    shapes: dict[str, tuple[int, ...]] = {"curvature": (count,), "tensor": (count, 6)}
    most = LARGEST_CURVATURE_PER_MM
    for name, shape in shapes.items():
        if name in mesh.attributes:
            as_floats(f"mesh: {name}", mesh.attributes[name], shape, low=-most, high=most)
