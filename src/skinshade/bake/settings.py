"""What is baked, and for which skin."""

from __future__ import annotations

from dataclasses import dataclass

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
    """

    unit_mm: float | None = None
    tensor: bool = False
    thickness: bool = False
    profile: str = "skin-deon2007"
    smoothing: int = 2
    rays: int = 64
    tracing: RayTracing = "auto"

    def __post_init__(self) -> None:
        if self.unit_mm is not None:
            checked_unit_mm(self.unit_mm, "unit_mm")
        if not 0 <= self.smoothing <= 100:
            raise ArgumentError(f"smoothing is {self.smoothing}; it must be 0..100 passes")
        if not 1 <= self.rays <= 4096:
            raise ArgumentError(f"rays is {self.rays}; it must be 1..4096")
        Profile.preset(self.profile)
