"""Compiled fetches from depth maps and textures: the twins of functions with the same names."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..._core import native
from ..._core.arrays import FloatArray, ImageArray, IntArray

__all__ = ["halve_image", "interpolated", "lit_share", "mean_thickness", "sample_texture", "serves"]

DepthMap = NDArray[np.float32]
MOST_TEXELS = 1 << 31
"""Limit of texels of a depth map: taps.c has indices of 32 bits."""
MOST_CHANNELS = 4
"""Limit of channels of a texture, as in fetch.c."""


def serves(channels: int = 1, texels: int = 0) -> bool:
    """Return whether the compiled functions are in use for textures or depth maps of a size."""
    return native.available() and channels <= MOST_CHANNELS and texels < MOST_TEXELS


def lit_share(
    depths_mm: DepthMap,
    uv: FloatArray,
    receiver_mm: FloatArray,
    radius_uv: FloatArray,
    rise_mm: FloatArray,
    disk: FloatArray,
) -> FloatArray:
    """Return the share (N,) of a disk of taps that no occluder hides, as `lit_share` of `shading.shadow`.

    Depths are float32 (H, W), which rounds those of a head to 3e-5 mm.
    """
    lit = np.empty(receiver_mm.size)
    height, width = depths_mm.shape
    points = (uv, receiver_mm, radius_uv, rise_mm, disk)
    rows = [np.ascontiguousarray(array, dtype=np.float64) for array in points]
    ranges = native.blocks(lit.size)
    native.run("lit_share", ranges, depths_mm, width, height, *rows, len(disk), lit)
    return lit


def mean_thickness(
    depths_mm: FloatArray,
    uv: FloatArray,
    receiver_mm: FloatArray,
    radius_uv: FloatArray,
    disk: FloatArray,
) -> FloatArray:
    """Return the mean thickness (N,) over a disk, as `mean_thickness` of `shading.deep_scatter`."""
    result = np.empty(receiver_mm.size)
    height, width = depths_mm.shape
    points = (uv, receiver_mm, radius_uv, disk)
    rows = [np.ascontiguousarray(array, dtype=np.float64) for array in points]
    ranges = native.blocks(result.size)
    native.run("mean_thickness", ranges, depths_mm, width, height, *rows, len(disk), result)
    return result


def sample_texture(
    texels: ImageArray, sizes: IntArray, uv: FloatArray, level: FloatArray
) -> FloatArray:
    """Return trilinear values (N, C), as `mips.Texture.sample`; every channel is contiguous.

    Parameters
    ----------
    texels
        (T, C) texels of all levels, float32.
    sizes
        (L, 3) first texel, width and height of each level.
    uv, level
        (N, 2) texture coordinates, and (N,) levels.
    """
    channels, count = texels.shape[1], len(uv)
    values = np.empty((channels, count))
    points = [np.ascontiguousarray(array, dtype=np.float64) for array in (*uv.T, level)]
    ranges, images = native.blocks(count), (texels, channels, sizes, len(sizes))
    native.run("fetch_texture", ranges, *images, *points, count, values)
    return values.T


def halve_image(image: ImageArray, result: ImageArray) -> None:
    """Write averages of 2×2 texels of an image (H, W, C) into an image of half its size."""
    height, width, channels = image.shape
    rows = native.blocks(len(result), max(native.GRAIN // result[0].size, 1))
    native.run("halve_image", rows, image, width, height, channels, result)


def interpolated(
    values: FloatArray, faces: IntArray, face: IntArray, weights: FloatArray
) -> FloatArray:
    """Return rows (N, K) of a table (V, K) at points of faces (N,), mixed with weights (N, 3) of the corners.

    Every column of the result is contiguous.
    """
    count, columns = len(face), values.shape[1]
    results = np.empty((columns, count))
    native.run(
        "interpolate",
        native.blocks(count),
        np.ascontiguousarray(values),
        columns,
        np.ascontiguousarray(faces, dtype=np.int64),
        np.ascontiguousarray(face, dtype=np.int64),
        np.ascontiguousarray(weights),
        count,
        results,
    )
    return results.T
