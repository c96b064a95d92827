"""Materials: diffusion profile, parameters and texture maps."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from .._core.arrays import ImageArray
from .._core.errors import ArgumentError
from ..params import SkinParams
from ..profile import Profile

__all__ = ["Material"]


@dataclass(frozen=True, repr=False)
class Material:
    """Skin or another translucent material.

    Attributes
    ----------
    profile
        Diffusion profile.
    params
        Parameters that all pixels share.
    albedo
        (H, W, 3) linear, or (1, 1, 3) for one colour.
    normal
        (H, W, 3) tangent-space normals in −1..1, +y up in the picture; None for the mesh's normals.
    specular
        (H, W, 2) factor on the reflectance, and gloss 0..1; None for the values of `params`.
    name
        Name of the material in its file; may be empty.
    deep_scatter
        (H, W, 3) linear tint of light that comes through the body, 0..1; None for white.

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
        for name, channels in (("albedo", 3), ("normal", 3), ("specular", 2), ("deep_scatter", 3)):
            image = getattr(self, name)
            if image is None:
                continue
            if image.ndim != 3 or image.shape[2] != channels or 0 in image.shape:
                raise ArgumentError(
                    f"material {name}: shape is {image.shape}; it must be (H, W, {channels})"
                )
            if not np.isfinite(image).all():
                raise ArgumentError(f"material {name}: all values must be finite")

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
        names = ("albedo", "normal", "specular", "deep_scatter")
        maps = {name: getattr(self, name) for name in names}
        return {name: image for name, image in maps.items() if image is not None}

    def __repr__(self) -> str:
        maps = (f"{name} {image.shape[1]}×{image.shape[0]}" for name, image in self._maps().items())
        return f"Material({self.profile.name!r}, {', '.join(maps)})"
