"""Parts of a body that have a material of their own, such as hair, eyes or clothes."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from .._core.arrays import ImageArray, as_floats
from .._core.errors import ArgumentError
from .material import Material

__all__ = ["Part"]


@dataclass(frozen=True, repr=False)
class Part:
    """Faces of a mesh with a material of their own.

    Attributes
    ----------
    number
        Number of the faces in `skinshade.Mesh.materials`.
    material
        Maps and parameters. Without skin, the profile has no effect.
    is_skin
        Whether light scatters in the part. Other parts have plain diffuse and specular light.
    opacity
        (H, W, 1) opacity 0..1, for maps of the size of the albedo; None for an opaque part.
    opacity_cutoff
        Opacity below which nothing is drawn, 0..1. A part with opacity casts no shadow.

    Examples
    --------
    >>> import skinshade as sk
    >>> sk.Part(1, sk.Material(name="hair"), is_skin=False)
    Part('hair', not skin)
    """

    number: int
    material: Material = field(default_factory=Material)
    is_skin: bool = True
    opacity: ImageArray | None = None
    opacity_cutoff: float = 0.5

    def __post_init__(self) -> None:
        as_floats("part opacity_cutoff", self.opacity_cutoff, (), low=0.0, high=1.0)
        if self.opacity is None:
            return
        if self.is_skin:
            raise ArgumentError(f"part {self.name!r}: skin is opaque; it has an opacity map")
        height, width = self.material.albedo.shape[:2]
        opacity = as_floats("part opacity", self.opacity, (height, width, 1), low=0.0, high=1.0)
        object.__setattr__(self, "opacity", opacity.astype(np.float32))

    def with_maps_flipped(self) -> Part:
        """Return the part with maps for a mesh whose v is reversed."""
        opacity = None if self.opacity is None else self.opacity[::-1]
        return replace(self, material=self.material.with_maps_flipped(), opacity=opacity)

    @property
    def name(self) -> str:
        """Name of the material."""
        return self.material.name

    def __repr__(self) -> str:
        return f"Part({self.name!r}, {'skin' if self.is_skin else 'not skin'})"
