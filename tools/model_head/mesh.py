"""From the field to triangles: narrow-band marching cubes, adaptive remeshing, projection."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from skimage.measure import marching_cubes

from .fields import Array, Field

LOW_MM = np.array([-132.0, -224.0, -128.0])
HIGH_MM = np.array([132.0, 128.0, 132.0])
_CHUNK = 16384
Faces = NDArray[np.int64]


def evaluate(field: Field, points_mm: Array) -> Array:
    """The field at many points, in pieces that stay in cache."""
    parts = [field(points_mm[i : i + _CHUNK]) for i in range(0, len(points_mm), _CHUNK)]
    return np.concatenate(parts)


def polygonise(field: Field, step_mm: float, *, block: int = 8) -> tuple[Array, Faces]:
    """Marching cubes of the zero set, evaluating only blocks that can meet it.

    Returns vertices ``(V, 3)`` in millimetres and faces ``(F, 3)``, outward counter-clockwise.
    """
    coarse_mm = step_mm * block
    counts = np.ceil((HIGH_MM - LOW_MM) / coarse_mm).astype(int)
    centres = np.stack(
        np.meshgrid(*[np.arange(n) + 0.5 for n in counts], indexing="ij"), axis=-1
    ).reshape(-1, 3) * coarse_mm + LOW_MM
    far = evaluate(field, centres)
    keep = np.abs(far) < coarse_mm * 0.9 * 1.6 + 3.0
    volume = np.repeat(np.repeat(np.repeat(
        np.clip(far, -1e3, 1e3).reshape(counts).astype(np.float32), block, 0), block, 1), block, 2)
    inner = np.stack(
        np.meshgrid(*[np.arange(block)] * 3, indexing="ij"), axis=-1
    ).reshape(-1, 3)
    corners = (np.stack(np.unravel_index(np.flatnonzero(keep), counts), axis=1) * block)
    for i in range(0, len(corners), 64):
        at = (corners[i : i + 64, None, :] + inner[None]).reshape(-1, 3)
        volume[at[:, 0], at[:, 1], at[:, 2]] = evaluate(field, at * step_mm + LOW_MM)
    vertices, faces, _, _ = marching_cubes(volume, 0.0, gradient_direction="ascent")
    return vertices.astype(np.float64) * step_mm + LOW_MM, faces.astype(np.int64)
