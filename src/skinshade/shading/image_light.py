"""Reflections of the surroundings, preconvolved for every gloss (MODEL §9)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._core.arrays import FloatArray, ImageArray, IntArray
from .specular import SHARP_LOBE_SHARE, specular_power

__all__ = [
    "LOBE_POWERS",
    "PreconvolvedRadiance",
    "bilinear",
    "equirectangular_uv",
    "reflected_radiance",
    "reflection_level",
]

LOBE_POWERS = (1.0, 4.0, 16.0, 64.0, 256.0)
"""Phong powers of the preconvolved levels; a Blinn-Phong power n reflects like n/4 [Walter2007]."""
LEVEL_SIZE = (128, 64)
"""Columns and rows of each level."""


@dataclass(frozen=True)
class PreconvolvedRadiance:
    """Radiance averaged over Phong lobes around every direction, a level for each of `LOBE_POWERS`.

    Attributes
    ----------
    levels
        (n, H, W, 3).
    """

    levels: ImageArray

    @property
    def atlas(self) -> ImageArray:
        """(n·H, W, 3) the levels one below the other, as shaders sample them."""
        return self.levels.reshape(-1, *self.levels.shape[2:])

    def sample(self, directions: FloatArray, power: FloatArray) -> FloatArray:
        """Return (..., 3) radiance around unit directions (..., 3) for Phong powers (...)."""
        level = reflection_level(power)
        low = np.minimum(level.astype(np.int64), self.levels.shape[0] - 2)
        share = (level - low)[..., None]
        u, v = equirectangular_uv(directions)
        sharp = bilinear(self.levels, low + 1, u, v)
        return bilinear(self.levels, low, u, v) * (1.0 - share) + sharp * share


def equirectangular_uv(direction: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return u, v (...) in 0..1 of unit directions (..., 3)."""
    u = 0.5 + np.arctan2(direction[..., 2], direction[..., 0]) / (2.0 * np.pi)
    v = np.arccos(np.clip(direction[..., 1], -1.0, 1.0)) / np.pi
    return u, v


def reflection_level(power: FloatArray) -> FloatArray:
    """Return the level (...) of `LOBE_POWERS`, between two of them too, for Phong powers (...)."""
    level = np.log(np.maximum(power, LOBE_POWERS[0])) / np.log(LOBE_POWERS[1])
    result: FloatArray = np.clip(level, 0.0, len(LOBE_POWERS) - 1.0)
    return result


def reflected_radiance(
    preconvolved: PreconvolvedRadiance, direction: FloatArray, gloss: FloatArray
) -> FloatArray:
    """Return (..., 3) radiance that both specular lobes see around a mirror direction.

    Parameters
    ----------
    preconvolved
        Of the surroundings.
    direction
        (..., 3) unit, of `skinshade.shading.specular.reflected`.
    gloss
        (...) of the first lobe, 0..1.
    """
    power = specular_power(gloss)
    # Around the mirror direction a lobe about the half vector is twice as wide: a quarter of the power.
    wide = preconvolved.sample(direction, power / 4.0)
    sharp = preconvolved.sample(direction, np.square(power) / 4.0)
    return (1.0 - SHARP_LOBE_SHARE) * wide + SHARP_LOBE_SHARE * sharp


def bilinear(levels: ImageArray, level: IntArray, u: FloatArray, v: FloatArray) -> FloatArray:
    """Return (..., C) of equirectangular pictures (n, H, W, C) at a level of each and u, v (...)."""
    _, height, width, _ = levels.shape
    x, y = u * width - 0.5, np.clip(v * height - 0.5, 0.0, height - 1.0)
    x0, y0 = np.floor(x).astype(np.int64), np.minimum(y.astype(np.int64), height - 2)
    fx, fy = (x - x0)[..., None], (y - y0)[..., None]
    left, right = x0 % width, (x0 + 1) % width
    top = levels[level, y0, left] * (1.0 - fx) + levels[level, y0, right] * fx
    bottom = levels[level, y0 + 1, left] * (1.0 - fx) + levels[level, y0 + 1, right] * fx
    result: FloatArray = top * (1.0 - fy) + bottom * fy
    return result
