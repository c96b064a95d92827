"""Heads: a mesh with its material."""

from __future__ import annotations

from dataclasses import dataclass

from ..mesh import Mesh
from ..scene import Material, Part

__all__ = ["Head"]


@dataclass(frozen=True)
class Head:
    """A head to draw.

    Attributes
    ----------
    mesh
        Geometry.
    material
        Profile, parameters and maps of its skin.
    parts
        Parts with materials of their own, such as hair and eyes.

    Examples
    --------
    >>> import skinshade as sk
    >>> sk.builtin_head().mesh
    Mesh(20560 vertices, 40034 faces, 174.2 × 322 × 213.1 mm, UVs, attributes: _REGION)
    """

    mesh: Mesh
    material: Material
    parts: tuple[Part, ...] = ()
