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
STORED_RANGE = (-1.0, 2.0)
"""Least and greatest stored value; a filter that sharpens a float map can go somewhat beyond 0..1."""
LEAST_LENGTH = np.float32(1e-6)
"""Length below which a vector counts as zero: far below a step of 16 bits."""


def read_normal_map(path: str | os.PathLike[str]) -> ImageArray:
    """Return tangent-space normals (H, W, 3) in −1..1, +y up, unit length, from a map that stores 0..1.

    Raises
    ------
    ImageFileError
        If the file cannot be read, has values far beyond 0..1, or most of its normals do not face outwards,
        as in a two-channel or object-space map. A blur needs the third channel: it carries the relief that
        the blur removes.
    """
    normals = read_image(path)
    smallest, greatest = float(normals.min()), float(normals.max())
    if smallest < STORED_RANGE[0] or greatest > STORED_RANGE[1]:
        raise ImageFileError(
            f"{path}: not a normal map: its values reach from {smallest:g} to {greatest:g}, not 0 to 1"
        )
    normals *= 2.0
    normals -= 1.0
    if np.count_nonzero(normals[..., 2] > 0.0) < FACING_SHARE * normals[..., 2].size:
        raise ImageFileError(
            f"{path}: not a tangent-space normal map with three channels: most texels have blue below"
            " one half"
        )
    for row in normals:  # row by row, which needs no memory for another image
        length = np.sqrt(np.einsum("...i,...i->...", row, row))[..., None]
        row /= np.maximum(length, LEAST_LENGTH)
    return normals


def scale_slopes(normals: ImageArray, strength: float) -> ImageArray:
    """Return a normal map (H, W, 3) with slopes multiplied by a strength ≥ 0; zero vectors stay zero."""
    if strength == 1.0:
        return normals
    scaled = normals * np.array([strength, strength, 1.0], dtype=np.float32)
    length = np.linalg.norm(scaled, axis=2, keepdims=True)
    result: ImageArray = scaled / np.maximum(length, LEAST_LENGTH)
    return result
