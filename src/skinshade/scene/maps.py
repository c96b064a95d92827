"""Texture maps of a material, from files."""

from __future__ import annotations

import os

import numpy as np

from .._core.arrays import ImageArray
from .._core.errors import ImageFileError
from .images import read_image

__all__ = ["read_normal_map", "steepened"]

FACING_SHARE = 0.5
"""Less than this share of texels facing outwards, and a picture is no tangent-space normal map."""


def read_normal_map(path: str | os.PathLike[str]) -> ImageArray:
    """Return tangent-space normals (H, W, 3) in −1..1, +y up, unit length, from an 8 or 16-bit map.

    Raises
    ------
    ImageFileError
        If the file cannot be read, or most of it does not face outwards, as in a two-channel or an
        object-space map: the third channel is what carries the relief that a blur removes.
    """
    normals = read_image(path) * 2.0 - 1.0
    if (normals[..., 2] > 0.0).mean() < FACING_SHARE:
        raise ImageFileError(
            f"{path}: not a tangent-space normal map with three channels (blue is mostly below ½)"
        )
    length = np.sqrt(np.einsum("...i,...i->...", normals, normals))[..., None]
    result: ImageArray = (normals / np.maximum(length, 1e-6)).astype(np.float32)
    return result


def steepened(normals: ImageArray, strength: float) -> ImageArray:
    """Return a normal map (H, W, 3) with its slopes multiplied by a strength ≥ 0."""
    if strength == 1.0:
        return normals
    steep = normals * np.array([strength, strength, 1.0], dtype=np.float32)
    result: ImageArray = steep / np.linalg.norm(steep, axis=2, keepdims=True)
    return result
