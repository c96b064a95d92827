"""Compiled fetches from equirectangular images: the twin of `image_light.bilinear`."""

from __future__ import annotations

import numpy as np

from .._core import native
from .._core.arrays import FloatArray, ImageStack, IntArray

__all__ = ["bilinear", "serves"]


def serves(levels: ImageStack) -> bool:
    """Return whether the compiled function is in use for images of this type and number of channels."""
    return native.available() and levels.dtype == np.float32 and levels.shape[-1] == 3


def bilinear(levels: ImageStack, level: IntArray, u: FloatArray, v: FloatArray) -> FloatArray:
    """Return bilinear lookups (..., 3), as `image_light.bilinear`; every channel is contiguous."""
    values = np.empty((3, *u.shape))
    arguments = (level.astype(np.int64, copy=False), u, v)
    native.run(
        "fetch_panorama",
        native.blocks(u.size),
        np.ascontiguousarray(levels),
        np.array(levels.shape[:3], dtype=np.int64),
        *(np.ascontiguousarray(np.broadcast_to(array, u.shape)) for array in arguments),
        u.size,
        values,
    )
    return np.moveaxis(values, 0, -1)
