"""Materials: diffusion profile, parameters and texture maps."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from .._core.arrays import ImageArray, as_floats
from .._core.errors import ArgumentError
from ..params import SkinParams
from ..profile import Profile

__all__ = ["Material"]

MAP_RANGES = {
    "albedo": ((-1e3, 1e3),) * 3,
    "normal": ((-1.001, 1.001),) * 3,
    "specular": ((0.0, 10.0), (0.0, 1.0)),
    "deep_scatter": ((-1e3, 1e3),) * 3,
}
"""Least and greatest value of every channel of the maps. Half floats hold them, and light stays finite. Image
files have colours somewhat below 0 and above 1, and rounded normals."""
ALBEDO_RANGE = (1e-4, 0.9999)
"""Least and greatest albedo of the profile: light through the body is divided by it."""
RADIUS_RANGE_MM = (1e-5, 1e4)
"""Least and greatest root mean square radius of the scaled profile, mm."""


@dataclass(frozen=True, repr=False)
class Material:
    """Skin or another translucent material.

    Attributes
    ----------
    profile
        Diffusion profile, with an albedo of 1e-4..0.9999, and a root mean square radius of 1e-5..1e4 mm
        after it is scaled.
    params
        Parameters that all pixels share.
    albedo
        (H, W, 3) linear, or (1, 1, 3) for one colour; physical values are 0..1, and ±1000 is accepted.
    normal
        (H, W, 3) tangent-space normals in −1..1, +y up in the picture; None for the mesh's normals.
    specular
        (H, W, 2) factor on the reflectance 0..10, and gloss 0..1; None for the values of `params`.
    name
        Name of the material in its file; may be empty.
    deep_scatter
        (H, W, 3) linear tint of light that comes through the body, 0..1, within ±1000; None for white.

    Examples
    --------
    >>> import skinshade as sk
    >>> sk.Material(params=sk.SkinParams(roughness=0.4))
    Material('skin-deon2007', albedo 1×1)
    """

    profile: Profile = field(default_factory=lambda: Profile.preset("skin-deon2007"))
    params: SkinParams = field(default_factory=SkinParams)
    albedo: ImageArray = field(
        default_factory=lambda: np.array([[[0.48, 0.29, 0.21]]], dtype=np.float32)
    )
    normal: ImageArray | None = None
    specular: ImageArray | None = None
    deep_scatter: ImageArray | None = None
    name: str = ""

    def __post_init__(self) -> None:
        for name, image in self._maps().items():
            ranges = MAP_RANGES[name]
            if image.ndim != 3 or image.shape[2] != len(ranges) or 0 in image.shape:
                raise ArgumentError(
                    f"material {name}: shape is {image.shape}; it must be (H, W, {len(ranges)})"
                )
            # Whole rows are compared first: a loop over the channels of every texel takes 10 times as long.
            rows = image.reshape(len(image), -1)
            least_row, greatest_row = (
                ends.reshape(image.shape[1:]) for ends in (rows.min(axis=0), rows.max(axis=0))
            )
            ends = zip(least_row.min(axis=0), greatest_row.max(axis=0), ranges, strict=True)
            for channel, (smallest, greatest, (low, high)) in enumerate(ends):
                if not (smallest >= low and greatest <= high):  # false for NaN
                    raise ArgumentError(
                        f"material {name}: all values must be finite, and lie in [{low:g}, {high:g}] in"
                        f" channel {channel}, which reaches from {smallest:g} to {greatest:g}"
                    )
        radius_mm = self.profile.rms_radius_mm * self.params.scatter_scale
        for name, values, (least, most) in (
            ("albedo", self.profile.albedo, ALBEDO_RANGE),
            ("scaled rms_radius_mm", radius_mm, RADIUS_RANGE_MM),
        ):
            as_floats(f"material profile: {name}", values, low=least, high=most)

    @property
    def has_maps(self) -> bool:
        """Whether a map has more than one texel, so that the mesh needs UVs."""
        return any(image.shape[:2] != (1, 1) for image in self._maps().values())

    def with_maps_flipped(self) -> Material:
        """Return the material with maps for a mesh whose v is reversed."""
        maps: dict[str, Any] = {
            name: np.ascontiguousarray(image[::-1]) for name, image in self._maps().items()
        }
        if self.normal is not None:
            maps["normal"] = maps["normal"] * np.array([1.0, -1.0, 1.0], dtype=np.float32)
        return replace(self, **maps)

    def _maps(self) -> dict[str, ImageArray]:
        maps = {name: getattr(self, name) for name in MAP_RANGES}
        return {name: image for name, image in maps.items() if image is not None}

    def __repr__(self) -> str:
        maps = (f"{name} {image.shape[1]}×{image.shape[0]}" for name, image in self._maps().items())
        return f"Material({self.profile.name!r}, {', '.join(maps)})"
