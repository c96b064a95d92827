"""Reflections of the surroundings, preconvolved for every gloss (MODEL §9)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._core.arrays import FloatArray, ImageArray, ImageStack, IntArray
from . import compiled_fetch as compiled
from .specular import SHARP_LOBE_SHARE, specular_power

__all__ = [
    "LOBE_POWERS",
    "PreconvolvedRadiance",
    "bilinear",
    "coat_radiance",
    "equirectangular_uv",
    "reflected_radiance",
    "reflection_level",
]

LOBE_POWERS = (1.0, 4.0, 16.0, 64.0, 256.0)
"""Phong powers of the preconvolved levels."""
LEVEL_SIZE = (128, 64)
"""Columns and rows of each level."""
REFLECTION_LEVELS = float(len(LOBE_POWERS))
"""Number of levels, for shaders."""
REFLECTION_ROWS = float(LEVEL_SIZE[1])
"""Number of rows of each level in the atlas that shaders sample."""
LEAST_VIEW_COSINE = 0.01
"""Least N·V in the power of a lobe; below it, lobes of any gloss are narrower than the sharpest level."""


@dataclass(frozen=True)
class PreconvolvedRadiance:
    """Radiance of an environment, averaged over Phong lobes around every direction.

    Attributes
    ----------
    levels
        (n, H, W, 3) equirectangular images, one for each power in `LOBE_POWERS`.
    """

    levels: ImageStack

    @property
    def atlas(self) -> ImageArray:
        """Image (n·H, W, 3) of all levels, one below the other, for shaders."""
        count, height, width, channels = self.levels.shape
        return self.levels.reshape(count * height, width, channels)

    def sample(self, directions: FloatArray, power: FloatArray) -> FloatArray:
        """Return the radiance (..., 3) around unit directions (..., 3), for lobes of Phong powers (...)."""
        level = reflection_level(power)
        wide_level = np.minimum(level.astype(np.int64), self.levels.shape[0] - 2)
        weight = (level - wide_level)[..., None]
        u, v = equirectangular_uv(directions)
        sharp = bilinear(self.levels, wide_level + 1, u, v)
        return bilinear(self.levels, wide_level, u, v) * (1.0 - weight) + sharp * weight


def equirectangular_uv(direction: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the coordinates u, v (...) of unit directions (..., 3), 0..1; v is 0 at +y.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.image_light import equirectangular_uv
    >>> u, v = equirectangular_uv(np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]))
    >>> u, v
    (array([0.5 , 0.75]), array([0.5, 0.5]))
    """
    u = 0.5 + np.arctan2(direction[..., 2], direction[..., 0]) / (2.0 * np.pi)
    v = np.arccos(np.clip(direction[..., 1], -1.0, 1.0)) / np.pi
    return u, v


def reflection_level(power: FloatArray) -> FloatArray:
    """Return the fractional index (...) of Phong powers (...) in `LOBE_POWERS`.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.shading.image_light import reflection_level
    >>> reflection_level(np.array([1.0, 8.0, 1000.0]))
    array([0. , 1.5, 4. ])
    """
    level = np.log(np.maximum(power, LOBE_POWERS[0])) / np.log(LOBE_POWERS[1])
    result: FloatArray = np.clip(level, 0.0, len(LOBE_POWERS) - 1.0)
    return result


def reflected_radiance(
    preconvolved: PreconvolvedRadiance, direction: FloatArray, gloss: FloatArray
) -> FloatArray:
    """Return the radiance (..., 3) that both specular lobes reflect from the environment.

    Parameters
    ----------
    preconvolved
        Radiance of the environment.
    direction
        (..., 3) unit mirror directions, from `skinshade.shading.specular.reflected`.
    gloss
        (...) gloss of the first lobe, 0..1.
    """
    power = specular_power(gloss)
    # A lobe is twice as wide around the mirror direction as around the half vector: a quarter of the power.
    wide = preconvolved.sample(direction, power / 4.0)
    sharp = preconvolved.sample(direction, np.square(power) / 4.0)
    return (1.0 - SHARP_LOBE_SHARE) * wide + SHARP_LOBE_SHARE * sharp


def coat_radiance(
    preconvolved: PreconvolvedRadiance,
    direction: FloatArray,
    n_dot_v: FloatArray,
    gloss: FloatArray,
) -> FloatArray:
    """Return the radiance (..., 3) that a GGX lobe reflects from the environment.

    The Phong power 1/(4α²·N·V) = (p + 2)/(8·N·V) fits the first twenty harmonics of the lobe around its mean
    direction, for α of .03 to .6 and N·V of .2 to 1: the long tails of GGX make a lobe wider than that of
    the Blinn-Phong power p, and towards grazing directions it gets narrower.

    Parameters
    ----------
    preconvolved
        Radiance of the environment.
    direction
        (..., 3) mean directions, from `skinshade.shading.coat.coat_direction`; unit vectors.
    n_dot_v
        (...) cosine between the sharp normal and the direction towards the eye.
    gloss
        (...) gloss of the lobe, 0..1.
    """
    cosine = np.maximum(n_dot_v, LEAST_VIEW_COSINE)
    return preconvolved.sample(direction, (specular_power(gloss) + 2.0) / (8.0 * cosine))


def bilinear(levels: ImageStack, level: IntArray, u: FloatArray, v: FloatArray) -> FloatArray:
    """Return bilinear lookups (..., C) in images `levels` (n, H, W, C) at `level` (...) and u, v (...).

    The coordinate u repeats, and v clamps to the edge.
    """
    if compiled.serves(levels):
        return compiled.bilinear(levels, level, u, v)
    _, height, width, _ = levels.shape
    x, y = u * width - 0.5, np.clip(v * height - 0.5, 0.0, height - 1.0)
    x0, y0 = np.floor(x).astype(np.int64), np.minimum(y.astype(np.int64), height - 2)
    fx, fy = (x - x0)[..., None], (y - y0)[..., None]
    left, right = x0 % width, (x0 + 1) % width
    top = levels[level, y0, left] * (1.0 - fx) + levels[level, y0, right] * fx
    bottom = levels[level, y0 + 1, left] * (1.0 - fx) + levels[level, y0 + 1, right] * fx
    result: FloatArray = top * (1.0 - fy) + bottom * fy
    return result
