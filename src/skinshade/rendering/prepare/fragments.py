"""Visible points of a picture, and what the rasteriser and its compiled twin share."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..._core.arrays import FloatArray, IntArray

__all__ = ["Fragments", "Hidden", "keep_nearest", "screen_positions"]


@dataclass(frozen=True)
class Fragments:
    """Visible surface: one entry for each covered pixel.

    Attributes
    ----------
    pixel
        (N,) index y·width + x, in rising order.
    face
        (N,) index of the visible face.
    barycentric
        (N, 3) perspective-correct barycentric coordinates.
    along_x, along_y
        (N, 3) change of `barycentric` from one pixel to the next.
    """

    pixel: IntArray
    face: IntArray
    barycentric: FloatArray
    along_x: FloatArray
    along_y: FloatArray

    def chosen(self, index: slice | NDArray[np.bool_]) -> Fragments:
        """Return the entries that an `index` chooses."""
        return Fragments(
            self.pixel[index],
            self.face[index],
            self.barycentric[index],
            self.along_x[index],
            self.along_y[index],
        )


Hidden = Callable[[IntArray, FloatArray], NDArray[np.bool_] | None]
"""Function of faces (N,) and barycentric coordinates (N, 3) that returns which points show nothing."""


def screen_positions(clip: FloatArray, size: tuple[int, int]) -> FloatArray:
    """Return homogeneous pixel coordinates (V, 3): x·w, y·w (down), w."""
    w = clip[:, 3]
    x = 0.5 * (clip[:, 0] + w) * size[0]
    y = 0.5 * (w - clip[:, 1]) * size[1]
    return np.stack([x, y, w], axis=1)


def keep_nearest(
    nearest: FloatArray, winner: IntArray, face: IntArray, pixel: IntArray, depth: FloatArray
) -> None:
    """Enter samples into a buffer of depths; the last of equally near samples of a pixel wins.

    Parameters
    ----------
    nearest, winner
        (P,) least depth and its face at every pixel, which are changed.
    face, pixel, depth
        (N,) face, pixel and depth of every sample.
    """
    np.minimum.at(nearest, pixel, depth)
    first = depth == nearest[pixel]
    winner[pixel[first]] = face[first]
