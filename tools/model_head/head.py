"""Signed distance field of the whole head."""

from __future__ import annotations

import numpy as np

from .ear import add_ears
from .face import add_eyes, add_lips, add_nose, relief_mm
from .fields import Array, smooth_intersection
from .skull import bust_cut, jaw_fillet_mm, mask, neck


def unevenness(p: Array) -> Array:
    """Return the shift ``(N, 3)`` of 1-2 mm that makes the halves of the face differ, as in a real one."""
    x, y, z = p[:, 0], p[:, 1], p[:, 2]
    face = np.exp(-0.5 * ((z - 85.0) / 45.0) ** 2)
    dx = face * (
        1.1 * np.exp(-0.5 * ((y + 38.0) / 20.0) ** 2)
        - 0.9 * np.exp(-0.5 * ((y + 100.0) / 22.0) ** 2)
    )
    dy = face * 0.7 * np.tanh(x / 25.0) * (
        np.exp(-0.5 * ((y + 69.0) / 12.0) ** 2) - 1.1 * np.exp(-0.5 * ((y - 12.0) / 16.0) ** 2)
    ) + 1.6 * np.tanh(x / 60.0) * np.exp(-0.5 * ((z + 15.0) / 30.0) ** 2)
    dz = 0.9 * np.tanh(x / 40.0) * np.exp(-0.5 * ((y + 20.0) / 50.0) ** 2)
    return np.stack([dx, dy, dz], axis=1)


def _without_ears(p: Array) -> Array:
    f = mask(p) - relief_mm(p)
    f = add_nose(f, p)
    f = add_eyes(f, p)
    f = add_lips(f, p)
    width = jaw_fillet_mm(p)
    body = neck(p)
    h = np.maximum(width - np.abs(f - body), 0.0)
    return np.asarray(np.minimum(f, body) - h * h * (0.25 / width))


def rest_of_head(points_mm: Array) -> Array:
    """Return the distance to the head without the ears and without the cut at the shoulders."""
    return _without_ears(points_mm - unevenness(points_mm))


def head(points_mm: Array) -> Array:
    """Return the signed distance ``(N,)`` to the bust, mm, negative inside, of points ``(N, 3)``."""
    p = points_mm - unevenness(points_mm)
    f = add_ears(_without_ears(p), p)
    return smooth_intersection(f, bust_cut(p), 9.0)


def gradient(points_mm: Array, step_mm: float = 0.02) -> Array:
    """Return the gradient ``(N, 3)`` of `head` by central differences."""
    offsets = np.array([[1, -1, -1], [-1, -1, 1], [-1, 1, -1], [1, 1, 1]], dtype=np.float64)
    total = np.zeros_like(points_mm)
    for o in offsets:
        total += o * head(points_mm + step_mm * o)[:, None]
    return np.asarray(total / (4.0 * step_mm))
