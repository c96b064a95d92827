"""Gloss and reflectance of the built-in head: an oily T-zone, moist lips, dry ears and neck."""

from __future__ import annotations

import numpy as np

from .noise import sample_smooth
from .regions import SkinTexels, ramp, spot
from .texels import Float32

__all__ = ["skin_gloss"]


def skin_gloss(s: SkinTexels, noise: Float32) -> Float32:
    """Return the factor of the reflectance, and the gloss, (N, 2)."""
    p = s.p
    medium = sample_smooth(noise, p + 143.0, 9.0)
    fine = sample_smooth(noise, p - 91.0, 2.0)
    oil = 0.85 * spot(p, (0, -30, 106), (13, 26, 18)) + 0.6 * spot(p, (0, 45, 93), (30, 24, 18))
    oil = oil + 0.35 * spot(p, (0, -101, 93), (14, 9, 12))
    oil = oil + 0.3 * spot(p, (44, -20, 68), (12, 9, 16))
    oil = np.minimum(oil + 0.35 * spot(p, (31, 2, 78), (12, 8, 8)), 1.0)
    dry = np.maximum(ramp(p[:, 1], -104.0, -130.0), 0.8 * ramp(np.abs(p[:, 0]), 68.0, 78.0))
    scale = 1.0 + 0.28 * oil - 0.25 * dry + 0.06 * medium + 0.05 * fine
    gloss = 0.35 + 0.075 * oil - 0.05 * dry + 0.014 * medium + 0.010 * fine
    wet = ramp(s.lips, 0.3, 0.9)
    scale += wet * (1.35 + 0.08 * fine - scale)
    gloss += wet * (0.46 + 0.015 * fine - gloss)
    result = np.stack([np.clip(scale, 0.3, 2.0), np.clip(gloss, 0.05, 0.95)], axis=1)
    return np.asarray(result, dtype=np.float32)
