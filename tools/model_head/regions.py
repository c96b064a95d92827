"""Weights of lips, brows, thin cartilage and redness on the head."""

from __future__ import annotations

import numpy as np

from .ear import ear
from .face import lip_curves_mm
from .fields import Array, along, ramp, spline
from .head import head, unevenness
from .mesh import evaluate

_BROW = [
    (13.0, 18.0, 95, 3.7),
    (20, 20.4, 92, 4.4),
    (30, 23.2, 89, 4.0),
    (39, 24.6, 84, 3.1),
    (47, 22.4, 77, 2.1),
    (53.5, 18.4, 68, 0.9),
]


def thickness_mm(p: Array, normals: Array, limit_mm: float = 12.0) -> Array:
    """Return the thickness ``(N,)`` of the head along the inward normals, at most ``limit_mm``."""
    depth = np.full(len(p), limit_mm)
    for step in np.arange(0.6, limit_mm, 0.4)[::-1]:
        outside = evaluate(head, p - normals * step) > 0.0
        depth = np.where(outside, step, depth)
    return depth


def regions(p: Array, normals: Array) -> Array:
    """Return weights ``(N, 4)``, 0..1, of lips, brows, thin cartilage and redness."""
    q = p - unevenness(p)
    x, y, z = np.abs(q[:, 0]), q[:, 1], q[:, 2]
    upper, _, lower = lip_curves_mm(x)
    lips = ramp(upper - y, -0.9, 0.7) * ramp(y - lower, -0.9, 0.7) * ramp(x, 26.5, 23.0)
    lips = lips * ramp(z, 70.0, 76.0)
    curve = spline(_BROW, 32)
    mirrored = np.stack([x, y, z], axis=1)
    gap, parameter = along(mirrored, curve[:, :3])
    half = np.interp(parameter, np.linspace(0, 1, len(curve)), curve[:, 3])
    brow = ramp(gap / np.maximum(half, 0.5), 1.25, 0.6) * ramp(z, 50.0, 60.0)
    thin = ramp(thickness_mm(p, normals), 9.0, 4.0)

    def spot(centre: tuple[float, float, float], size: tuple[float, float, float]) -> Array:
        return np.asarray(np.exp(-0.5 * np.sum(((mirrored - centre) / size) ** 2, axis=1)))

    shell = ramp(ear(q), 5.0, 0.8)
    red = 0.55 * spot((44, -27, 68), (17, 15, 24)) + 0.5 * spot((0, -38, 108), (15, 9, 14))
    red = red + 0.5 * spot((18, -42, 94), (5, 7, 8)) + 0.7 * shell
    red = red + 0.3 * spot((0, -100, 92), (16, 9, 12))
    red = red + 0.35 * spot((32, 4, 76), (15, 8, 10))
    return np.clip(np.stack([lips, brow, thin, red], axis=1), 0.0, 1.0)
