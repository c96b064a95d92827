"""What a surface is made of: a diffusion profile, maps, and the numbers of `SkinParams`."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from .._core.arrays import ImageArray
from .._core.errors import ArgumentError
from ..params import SkinParams
from ..profile import Profile

__all__ = ["Material"]


@dataclass(frozen=True)
class Material:
    """Skin, or any other translucent matter.

    Attributes
    ----------
    profile
        How light diffuses.
    params
        Numbers; see `skinshade.SkinParams`.
    albedo
        (H, W, 3) linear, or (1, 1, 3) for one colour.
    normal
        (H, W, 3) tangent-space normals in −1..1, +y up in the picture; None for none.
    specular
        (H, W, 2): factor on the reflectance, and gloss 0..1; None for `params` alone.
    deep_scatter
        (H, W, 3) linear tint of light that comes through, 0..1: veins, bones; None for white.
    """

    profile: Profile = field(default_factory=lambda: Profile.preset("skin-deon2007"))
    params: SkinParams = field(default_factory=SkinParams)
    albedo: ImageArray = field(
        default_factory=lambda: np.array([[[0.48, 0.29, 0.21]]], dtype=np.float32)
    )
    normal: ImageArray | None = None
    specular: ImageArray | None = None
    deep_scatter: ImageArray | None = None

    def __post_init__(self) -> None:
        for name, channels in (("albedo", 3), ("normal", 3), ("specular", 2), ("deep_scatter", 3)):
            picture = getattr(self, name)
            if picture is None:
                continue
            if picture.ndim != 3 or picture.shape[2] != channels or 0 in picture.shape:
                raise ArgumentError(
                    f"material {name}: shape is {picture.shape}; it must be (H, W, {channels})"
                )
            if not np.isfinite(picture).all():
                raise ArgumentError(f"material {name}: must be finite")

    @property
    def has_maps(self) -> bool:
        """Whether anything differs from texel to texel, so that the mesh must have UVs."""
        maps = (self.albedo, self.normal, self.specular, self.deep_scatter)
        return any(picture is not None and picture.shape[:2] != (1, 1) for picture in maps)
