"""Mip-mapped textures; averages are plain, so that blurred normals keep what they lost of length."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..._core.arrays import FloatArray, ImageArray
from ...shading.normals import map_level

__all__ = ["Texture", "build_texture"]


@dataclass(frozen=True)
class Texture:
    """Levels of a repeating texture, each half as wide as the one before, in one flat table.

    Attributes
    ----------
    texels
        (total, C) float32.
    starts
        (levels,) where each begins.
    widths, heights
        (levels,) their sizes.
    """

    texels: ImageArray
    starts: np.ndarray[tuple[int], np.dtype[np.int64]]
    widths: np.ndarray[tuple[int], np.dtype[np.int64]]
    heights: np.ndarray[tuple[int], np.dtype[np.int64]]

    @property
    def size(self) -> int:
        """The longer side of the first level, texels."""
        return int(max(self.widths[0], self.heights[0]))

    def level(self, along_x: FloatArray, along_y: FloatArray) -> FloatArray:
        """Return the mip level (N,) for changes of UV (N, 2) per pixel, ≥ 0."""
        return map_level((self.widths[0], self.heights[0]), along_x, along_y)

    def sample(self, uv: FloatArray, level: FloatArray) -> FloatArray:
        """Return (N, C), trilinear, at texture coordinates (N, 2) and levels (N,)."""
        bounded = np.clip(level, 0.0, self.starts.size - 1.0)
        low = bounded.astype(np.int64)
        share = (bounded - low)[:, None]
        result = self._bilinear(uv, low)
        between = np.flatnonzero(share[:, 0] > 0.0)
        above = self._bilinear(uv[between], low[between] + 1)
        result[between] += share[between] * (above - result[between])
        return result

    def _bilinear(
        self, uv: FloatArray, level: np.ndarray[tuple[int], np.dtype[np.int64]]
    ) -> FloatArray:
        width, height, start = self.widths[level], self.heights[level], self.starts[level]
        x, y = uv[:, 0] * width - 0.5, uv[:, 1] * height - 0.5
        x0, y0 = np.floor(x), np.floor(y)
        fx, fy = (x - x0)[:, None], (y - y0)[:, None]
        left, top = x0.astype(np.int64) % width, y0.astype(np.int64) % height
        right, bottom = (left + 1) % width, (top + 1) % height
        upper, lower = start + top * width, start + bottom * width
        t = self.texels
        first = t[upper + left] * (1.0 - fx) + t[upper + right] * fx
        second = t[lower + left] * (1.0 - fx) + t[lower + right] * fx
        result: FloatArray = first * (1.0 - fy) + second * fy
        return result


def build_texture(picture: ImageArray) -> Texture:
    """Build the levels of a picture (H, W, C) by averaging whole blocks, down to one texel."""
    levels = [np.ascontiguousarray(picture, dtype=np.float32)]
    while max(levels[-1].shape[:2]) > 1:
        levels.append(_halved(_halved(levels[-1], 0), 1))
    counts = np.array([level.shape[0] * level.shape[1] for level in levels])
    return Texture(
        np.concatenate([level.reshape(-1, level.shape[2]) for level in levels]),
        np.concatenate([[0], np.cumsum(counts)[:-1]]),
        np.array([level.shape[1] for level in levels]),
        np.array([level.shape[0] for level in levels]),
    )


def _halved(picture: ImageArray, axis: int) -> ImageArray:
    """Average neighbours along an axis; an odd last row or column is left out."""
    count = picture.shape[axis] // 2 * 2
    if count == 0:
        return picture
    even = (slice(None),) * axis
    # Sums of slices: NumPy's mean over short axes takes five times as long.
    result = picture[(*even, slice(0, count, 2))] + picture[(*even, slice(1, count, 2))]
    result *= np.float32(0.5)
    return result
