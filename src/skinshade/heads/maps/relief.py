"""Relief of the built-in head: pores, furrows, folds, and the normals of a height field."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .noise import cellular_volume, sample_cells, sample_smooth
from .regions import SkinTexels, ramp, spot
from .texels import Float32

__all__ = ["height_normals", "relief_mm", "relief_strengths", "skin_cells"]

CELL_SAMPLES = 64
CELLS_ACROSS = 6
"""Samples and cells along an edge of the cellular volumes."""


def relief_strengths(s: SkinTexels, noise: Float32) -> tuple[Float32, Float32]:
    """Return the depths of pores and furrows (N, 2) and the broad relief (N,), mm."""
    p = s.p
    coarse = sample_smooth(noise, p + 7.0, 14.0)
    lump = sample_smooth(noise, p - 23.0, 4.5)
    skin = 1.0 - ramp(s.lips, 0.2, 0.7)
    nose = spot(p, (0, -36, 104), (18, 14, 16))
    cheek = spot(p, (30, -28, 76), (17, 20, 20))
    lids = spot(p, (31, 1, 77), (13, 9, 9))
    ears = ramp(np.abs(p[:, 0]), 66.0, 76.0) * ramp(p[:, 1], -60.0, -40.0)
    pores = 0.022 + 0.036 * nose + 0.030 * cheek + 0.012 * spot(p, (0, 45, 92), (32, 22, 20))
    pores = pores * (1.0 + 0.22 * coarse) * skin * (1.0 - 0.8 * lids) * (1.0 - 0.6 * ears)
    pores *= 0.35 + 0.65 * s.front
    furrows = (0.017 + 0.006 * lids) * (1.0 - 0.5 * nose) * skin * (1.0 - 0.5 * ears)
    broad = 0.030 * lump * (0.5 + 0.5 * s.front) * (1.0 - 0.5 * lids)
    # Lines of the forehead: three shallow grooves of varying depth.
    y = p[:, 1] + 1.7 * coarse + 0.0035 * p[:, 0] ** 2
    strength = ramp(p[:, 2], 60.0, 84.0) * ramp(coarse + lump * 0.3, -1.2, 0.8)
    for height, depth in ((42.0, 0.085), (52.5, 0.10), (63.0, 0.06)):
        broad -= depth * strength * np.exp(-0.5 * ((y - height) / 0.75) ** 2)
    # Folds of the lower lids and beside the eyes.
    under = p[:, 1] + 0.5 * coarse + 12.0 - 0.012 * (np.abs(p[:, 0]) - 28.0) ** 2
    folds = 0.05 * spot(p, (30, -10, 75), (10, 5, 9))
    for height in (0.0, 2.6):
        broad -= folds * np.exp(-0.5 * ((under - height) / 0.5) ** 2)
    return np.stack([pores, furrows], axis=1).astype(np.float32), broad.astype(np.float32)


def skin_cells(rng: np.random.Generator) -> tuple[Float32, Float32]:
    """Return relative depths 0..1 of pores and of furrows between cells, as flat periodic volumes."""
    first, gap = cellular_volume(rng, CELL_SAMPLES, CELLS_ACROSS)
    pit = np.clip(1.0 - first * np.float32(1.0 / 0.52), 0.0, None)
    pit = pit * pit * (4.5 - 3.0 * pit)
    furrow = np.exp(-((gap * np.float32(1.0 / 0.13)) ** 2))
    return pit.astype(np.float32), furrow.astype(np.float32)


def relief_mm(ground: Float32, cells: tuple[Float32, Float32], noise: Float32) -> Float32:
    """Return the height of the skin (N,), mm: broad relief, pores, furrows and creases of the lips.

    Columns of `ground` (N, 7): position in mm (3); depths of pores and furrows, and broad relief, all of
    `relief_strengths`; weight of the lips.
    """
    p = ground[:, :3]
    height = ground[:, 5].copy()
    small = sample_cells(p, 0.82, CELL_SAMPLES, CELLS_ACROSS)
    height -= ground[:, 3] * cells[0].take(small)
    net = sample_cells(p[:, [2, 0, 1]], 1.05, CELL_SAMPLES, CELLS_ACROSS)
    height -= ground[:, 4] * cells[1].take(net)
    lip_texels = np.flatnonzero(ground[:, 6] > 0.25)
    strength = ramp(ground[lip_texels, 6], 0.2, 0.7)
    stretched = p[lip_texels] * np.array([1.0, 0.16, 0.10], dtype=np.float32)
    crease = sample_smooth(noise, stretched, 1.25)
    crease += 0.6 * sample_smooth(noise, stretched + 9.0, 0.75)
    height[lip_texels] -= (
        np.float32(0.055) * strength * np.maximum(np.abs(crease) * -0.9 + 0.8, 0.0)
    )
    return height


def height_normals(height_mm: Float32, index: NDArray[np.int64], shape: Float32) -> Float32:
    """Return tangent-space unit normals (N, 3) at the texels `index` of a height field (H, W).

    Columns of `shape` (N, 3): ``right_mm``, ``shear_mm`` and ``up_mm`` of the texels, see `TexelFrame`.
    """
    size = height_mm.shape[0]
    flat = height_mm.ravel()
    last = flat.size - 1
    right = flat.take(np.minimum(index + 1, last)) - flat.take(np.maximum(index - 1, 0))
    up = flat.take(np.maximum(index - size, 0)) - flat.take(np.minimum(index + size, last))
    along = 0.5 * right / shape[:, 0]
    across = (0.5 * up - shape[:, 1] * along) / shape[:, 2]
    scale = 1.0 / np.sqrt(1.0 + along * along + across * across)
    return np.stack([-along * scale, -across * scale, scale], axis=1).astype(np.float32)
