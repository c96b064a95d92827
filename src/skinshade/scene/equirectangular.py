"""Texels of equirectangular images: their directions, their solid angles, and averages over them."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, ImageArray

__all__ = ["averaged", "grid_directions", "row_solid_angle"]

ROWS = 64
"""Rows of an image that are averaged at once."""


def grid_directions(height: int, width: int) -> FloatArray:
    """Return the directions (H, W, 3) of the centres of texels."""
    theta = (np.arange(height) + 0.5) / height * np.pi
    phi = ((np.arange(width) + 0.5) / width - 0.5) * 2.0 * np.pi
    sine = np.sin(theta)[:, None]
    flat = np.broadcast_to(np.cos(theta)[:, None], (height, width))
    return np.stack([sine * np.cos(phi), flat, sine * np.sin(phi)], axis=-1)


def row_solid_angle(height: int) -> FloatArray:
    """Return the solid angle (H,) of each row of texels, sr."""
    edges = np.cos(np.arange(height + 1) / height * np.pi)
    return 2.0 * np.pi * (edges[:-1] - edges[1:])


def averaged(image: ImageArray, size: tuple[int, int]) -> FloatArray:
    """Return an image (H, W, 3) averaged by area to a size (width, height); the total light is kept."""
    height, width = image.shape[:2]
    edges, wanted = np.linspace(0.0, 1.0, width + 1), np.linspace(0.0, 1.0, size[0] + 1)
    narrow = np.empty((height, size[0], 3))
    for start in range(0, height, ROWS):  # float64 of the whole image would take twice its memory
        rows = image[start : start + ROWS].astype(np.float64)
        narrow[start : start + ROWS] = _mean_between(rows.swapaxes(0, 1), edges, wanted).swapaxes(
            0, 1
        )
    return _mean_between(narrow, _row_edges(height), _row_edges(size[1]))


def _row_edges(height: int) -> FloatArray:
    """Return −cos θ at the edges of rows: equal steps span equal solid angles."""
    return -np.cos(np.arange(height + 1) / height * np.pi)


def _mean_between(values: FloatArray, edges: FloatArray, wanted: FloatArray) -> FloatArray:
    """Return the means between wanted edges of values (n, ...) that are constant between other edges."""
    step = np.diff(edges)
    sums = np.concatenate([np.zeros_like(values[:1]), np.cumsum(values * step[:, None, None], 0)])
    at = np.clip(np.searchsorted(edges, wanted, side="right") - 1, 0, step.size - 1)
    share = ((wanted - edges[at]) / step[at])[:, None, None]
    read = sums[at] + share * (sums[at + 1] - sums[at])
    return np.diff(read, axis=0) / np.diff(wanted)[:, None, None]
