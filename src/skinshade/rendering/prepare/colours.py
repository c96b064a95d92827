"""Colours of surface properties in debug views and thumbnails."""

from __future__ import annotations

import numpy as np

from ..._core.arrays import FloatArray
from ...shading.tonemap import linear_from_srgb
from ..settings import CURVATURE_RANGE_PER_MM

__all__ = ["curvature_colour", "grey"]


def curvature_colour(curvature_per_mm: FloatArray) -> FloatArray:
    """Return linear colours (N, 3): red where convex, blue where concave, grey where flat."""
    share = np.clip(curvature_per_mm / CURVATURE_RANGE_PER_MM, -1.0, 1.0)[:, None]
    convex, concave = np.array([0.85, 0.20, 0.10]), np.array([0.10, 0.30, 0.85])
    ends = np.where(share > 0.0, convex, concave)
    return linear_from_srgb(0.92 + (ends - 0.92) * np.sqrt(np.abs(share)))


def grey(share: FloatArray) -> FloatArray:
    """Return linear greys (N, 3) whose display value is `share` (N,), 0..1."""
    return np.repeat(linear_from_srgb(share)[:, None], 3, axis=1)
