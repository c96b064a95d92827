"""Normal maps: reading and scaling."""

from __future__ import annotations

import os

import numpy as np

from .._core.arrays import ImageArray
from .._core.errors import ImageFileError
from .images import read_image

__all__ = ["read_normal_map", "scale_slopes"]

FACING_SHARE = 0.5
"""Least share of texels that face outwards in a tangent-space normal map."""


def read_normal_map(path: str | os.PathLike[str]) -> ImageArray:
    """Return tangent-space normals (H, W, 3) in −1..1, +y up, unit length, from an 8 or 16-bit map.

    Raises
    ------
    ImageFileError
        If the file cannot be read, or most of its normals do not face outwards, as in a two-channel or
        object-space map. A blur needs the third channel: it carries the relief that the blur removes.
    """
    normals = read_image(path) * 2.0 - 1.0
    if (normals[..., 2] > 0.0).mean() < FACING_SHARE:
        raise ImageFileError(
            f"{path}: not a tangent-space normal map with three channels: most texels have blue below"
            " one half"
        )
    length = np.sqrt(np.einsum("...i,...i->...", normals, normals))[..., None]
    result: ImageArray = (normals / np.maximum(length, 1e-6)).astype(np.float32)
    return result


def scale_slopes(normals: ImageArray, strength: float) -> ImageArray:
    """Return a normal map (H, W, 3) with its slopes multiplied by a strength ≥ 0."""
    if strength == 1.0:
        return normals
    scaled = normals * np.array([strength, strength, 1.0], dtype=np.float32)
    result: ImageArray = scaled / np.linalg.norm(scaled, axis=2, keepdims=True)
    return result
