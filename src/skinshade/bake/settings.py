"""What is baked, and for which skin."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from .._core.errors import ArgumentError
from .._core.units import checked_unit_mm
from ..mesh.rays import RayTracing
from ..profile import Profile

__all__ = ["BakeSettings"]


@dataclass(frozen=True)
class BakeSettings:
    """How assets are baked.

    Attributes
    ----------
    unit_mm
        Length of one unit of the files, mm; None takes glTF's metres, and asks for it elsewhere.
    tensor, thickness
        Whether the shape operator and the thickness are baked beside the mean curvature.
    profile
        Name of the preset that is noted in the file; curvature depends on none.
    smoothing
        Passes over the curvature, 0..100.
    rays
        Of thickness at each vertex, 1..4096.
    tracing
        ``auto``, ``embree`` or ``builtin``.
    map_size
        Texels along a side of texture maps beside the asset, 4..16384; 0 for none.
    map_format
        ``exr``, or ``png`` of 16 bits.
    """

    unit_mm: float | None = None
    tensor: bool = False
    thickness: bool = False
    profile: str = "skin-deon2007"
    smoothing: int = 2
    rays: int = 64
    tracing: RayTracing = "auto"
    map_size: int = 0
    map_format: Literal["exr", "png"] = "exr"

    def __post_init__(self) -> None:
        if self.unit_mm is not None:
            checked_unit_mm(self.unit_mm, "unit_mm")
        if not 0 <= self.smoothing <= 100:
            raise ArgumentError(f"smoothing is {self.smoothing}; it must be 0..100 passes")
        if not 1 <= self.rays <= 4096:
            raise ArgumentError(f"rays is {self.rays}; it must be 1..4096")
        if self.map_size and not 4 <= self.map_size <= 16384:
            raise ArgumentError(f"map_size is {self.map_size}; it must be 0 or 4..16384 texels")
        if self.map_format not in ("exr", "png"):
            raise ArgumentError(f"map_format is {self.map_format!r}; it must be exr or png")
        if self.tracing not in get_args(RayTracing):
            raise ArgumentError(f"tracing is {self.tracing!r}; it must be auto, embree or builtin")
        Profile.preset(self.profile)
