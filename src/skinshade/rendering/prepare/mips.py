"""Mip-mapped textures. Levels are plain averages, so that blurred normals keep their reduced length."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..._core.arrays import FloatArray, ImageArray, IndexRows
from ...shading.normals import map_level
from . import compiled_fetches as compiled

__all__ = ["Texture", "build_texture"]


@dataclass(frozen=True)
class Texture:
    """Mip levels of a repeating texture, each half as wide as the previous one, in one table of texels.

    Attributes
    ----------
    texels
        (T, C) texels of all levels, float32.
    starts
        (L,) index of the first texel of each level.
    widths, heights
        (L,) sizes of the levels, texels.
    """

    texels: ImageArray
    starts: np.ndarray[tuple[int], np.dtype[np.int64]]
    widths: np.ndarray[tuple[int], np.dtype[np.int64]]
    heights: np.ndarray[tuple[int], np.dtype[np.int64]]

    @property
    def sizes(self) -> IndexRows:
        """First texel, width and height (L, 3) of each level."""
        return np.stack([self.starts, self.widths, self.heights], axis=1)

    @property
    def size(self) -> int:
        """Longer side of the first level, texels."""
        return int(max(self.widths[0], self.heights[0]))

    def images(self) -> list[ImageArray]:
        """Return the levels as images (h, w, C)."""
        return [
            self.texels[start : start + h * w].reshape(h, w, self.texels.shape[1])
            for start, h, w in zip(self.starts, self.heights, self.widths, strict=True)
        ]

    def level(self, along_x: FloatArray, along_y: FloatArray) -> FloatArray:
        """Return the mip level (N,), ≥ 0, for changes of UV (N, 2) from one pixel to the next."""
        return map_level((self.widths[0], self.heights[0]), along_x, along_y)

    def sample(self, uv: FloatArray, level: FloatArray) -> FloatArray:
        """Return trilinear values (N, C) at texture coordinates (N, 2) and levels (N,)."""
        if compiled.serves(self.texels.shape[1]):
            return compiled.sample_texture(self.texels, self.sizes, uv, level)
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


def build_texture(image: ImageArray) -> Texture:
    """Build the levels of an image (H, W, C) by averaging blocks of 2×2, down to one texel."""
    height, width, channels = image.shape
    sizes = [(height, width)]
    while max(sizes[-1]) > 1:
        sizes.append((max(sizes[-1][0] // 2, 1), max(sizes[-1][1] // 2, 1)))
    heights, widths = np.array(sizes).T
    starts = np.concatenate([[0], np.cumsum(heights * widths)])
    texels = np.empty((starts[-1], channels), dtype=np.float32)
    texture = Texture(texels, starts[:-1], widths, heights)
    levels = texture.images()
    levels[0][...] = image
    for level, smaller in pairwise(levels):
        if compiled.serves():
            compiled.halve_image(level, smaller)
        else:
            smaller[...] = _halved(_halved(level, 0), 1)
    return texture


def _halved(image: ImageArray, axis: int) -> ImageArray:
    """Return averages of pairs along an axis; an odd last row or column is dropped."""
    count = image.shape[axis] // 2 * 2
    if count == 0:
        return image
    even = (slice(None),) * axis
    # Slices are summed because NumPy's mean over a short axis takes five times as long.
    result = image[(*even, slice(0, count, 2))] + image[(*even, slice(1, count, 2))]
    result *= np.float32(0.5)
    return result
