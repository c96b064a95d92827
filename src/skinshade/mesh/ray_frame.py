"""Coordinates of a body in -1..1, in which rays are cast, and the hits of rays."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import FloatArray, FloatRows, FloatVector, IntArray

__all__ = ["RayFrame", "RayHits", "morton_codes"]


@dataclass(frozen=True)
class RayFrame:
    """Coordinates in which the corners of all faces lie in -1..1.

    Attributes
    ----------
    middle
        (3,) middle of the box of the faces.
    scale
        Factor of lengths, a power of two: products with it are exact.
    """

    middle: FloatVector
    scale: float

    @classmethod
    def of(cls, positions: FloatArray, faces: IntArray) -> RayFrame:
        """Return the frame of a mesh; positions that no face uses do not count."""
        if not len(faces):
            return cls(np.zeros(3), 1.0)
        used = np.zeros(len(positions), dtype=np.bool_)
        used[np.asarray(faces).ravel()] = True
        corners = positions if used.all() else positions[used]
        low, high = corners.min(axis=0), corners.max(axis=0)
        middle = 0.5 * low + 0.5 * high
        half = float(np.maximum(high - middle, middle - low).max())
        # Half of the least normal number: the inverse of the scale is finite.
        exponent = int(np.clip(np.frexp(half)[1], -1020, 1020))
        return cls(middle, float(np.ldexp(1.0, -exponent)))

    def points(self, positions: FloatArray) -> FloatRows:
        """Return positions (N, 3) in this frame."""
        moved = np.subtract(positions, self.middle, dtype=np.float64)
        moved *= self.scale
        return moved


@dataclass(frozen=True)
class RayHits:
    """Nearest faces on rays.

    Attributes
    ----------
    distances
        (N,) distances, infinite without a hit.
    faces
        (N,) indices of faces, -1 without a hit. Of faces at equal distances, the one with the least index.
    weights
        (N, 3) barycentric weights of the corners of the face, 0 without a hit.
    """

    distances: FloatVector
    faces: NDArray[np.int64]
    weights: FloatRows


def morton_codes(points: FloatArray) -> IntArray:
    """Return the positions (N,) of points along the Morton curve, with ten bits per axis."""
    low, extent = points.min(axis=0), np.maximum(np.ptp(points, axis=0), 1e-300)
    cell = np.minimum((points - low) / extent * 1024.0, 1023.0).astype(np.int64)
    codes = np.zeros(len(points), dtype=np.int64)
    for bit in range(10):
        for axis in range(3):
            codes |= ((cell[:, axis] >> bit) & 1) << (3 * bit + axis)
    return codes
