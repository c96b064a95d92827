"""Settings of a bake."""

from __future__ import annotations

from dataclasses import dataclass

from .._core.choice import Choice
from .._core.errors import ArgumentError
from .._core.units import checked_unit_mm
from ..mesh.axes import UpAxis
from ..mesh.rays import RayTracing
from ..profile import Profile

__all__ = ["BakeSettings", "MapFormat", "OutputFormat"]


class MapFormat(Choice):
    """File format of texture maps; ``png`` has 16 bits."""

    EXR = "exr"
    PNG = "png"


class OutputFormat(Choice):
    """File format of baked assets; USD needs the extra ``usd``."""

    GLB = "glb"
    PLY = "ply"
    USDA = "usda"
    USDC = "usdc"


@dataclass(frozen=True)
class BakeSettings:
    """Settings of a bake. Fields of an enumeration also accept the text of a member.

    Attributes
    ----------
    unit_mm
        Length of one unit of the files, mm. None means metres for glTF, and what a comment of an OBJ or
        PLY file states; other files need a unit.
    up
        Up axis of OBJ, PLY and STL files: ``y``, or ``z``, which is turned to y in the output.
    tensor, thickness
        Also bake the shape operator and the thickness; the mean curvature is always baked.
    ambient_transfer
        Also bake the ambient transfer of order 2, diffused by the profile; light that bounces has the
        profile's albedo.
    profile
        Name of the preset that is written to the file; curvature does not depend on it.
    smoothing
        Smoothing passes over the curvature, 0..100.
    rays
        Rays at each vertex for the thickness, 1..4096.
    tracing
        Ray caster: ``embree``; ``builtin``; or ``auto`` for the compiled one, else Embree where it is
        installed, else NumPy's.
    map_size
        Texels along a side of the texture maps that are written beside the asset, 4..16384; 0 for no maps.
    map_format
        Format of the maps: ``exr``, or ``png`` with 16 bits.
    """

    unit_mm: float | None = None
    up: UpAxis = UpAxis.Y
    tensor: bool = False
    thickness: bool = False
    ambient_transfer: bool = False
    profile: str = "skin-deon2007"
    smoothing: int = 2
    rays: int = 64
    tracing: RayTracing = RayTracing.AUTO
    map_size: int = 0
    map_format: MapFormat = MapFormat.EXR

    def __post_init__(self) -> None:
        if self.unit_mm is not None:
            checked_unit_mm(self.unit_mm, "unit_mm")
        if not 0 <= self.smoothing <= 100:
            raise ArgumentError(f"smoothing is {self.smoothing}; it must be 0..100 passes")
        if not 1 <= self.rays <= 4096:
            raise ArgumentError(f"rays is {self.rays}; it must be 1..4096")
        if self.map_size and not 4 <= self.map_size <= 16384:
            raise ArgumentError(f"map_size is {self.map_size}; it must be 0 or 4..16384 texels")
        object.__setattr__(self, "up", UpAxis.of(self.up, "up"))
        object.__setattr__(self, "map_format", MapFormat.of(self.map_format, "map_format"))
        object.__setattr__(self, "tracing", RayTracing.of(self.tracing, "tracing"))
        Profile.preset(self.profile)
