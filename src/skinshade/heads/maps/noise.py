"""Periodic noise volumes for the maps of the built-in head.

Noise is sampled at positions in space, so that patterns cross the seams of a texture. The volumes are
small and repeat; slices through them along a curved surface look aperiodic.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..._core import native
from .blur import gaussian_blur

Float32 = NDArray[np.float32]

MARGIN = 0.08
"""Least distance of a point from the faces of its cell, in cells; closer pairs of points look like one."""
CELLS_AWAY = 2
"""Cells within which the nearest two points lie: the point of the neighbour beyond the nearest face is at
most 1.93 cells away, and points three cells away at least 2.08."""
GROUP = 4
"""Points after which the search compares their distance."""


def smooth_volume(rng: np.random.Generator, cells: int = 48) -> Float32:
    """Return periodic band-limited Gaussian noise (c, c, c), mean 0, standard deviation 1.

    A feature is about four samples across.
    """
    field = rng.standard_normal((cells, cells, cells), dtype=np.float32)
    for axis in range(3):
        field = gaussian_blur(field, 1.1, axis, "wrap").astype(np.float32)
    field -= field.mean()
    return np.asarray(field / field.std(), dtype=np.float32)


def sample_smooth(volume: Float32, points_mm: Float32, feature_mm: float) -> Float32:
    """Return values (N,) of a smooth volume at points (N, 3), mm, with features of `feature_mm`."""
    scale = np.float32(4.0 / feature_mm)
    if native.available() and points_mm.dtype == np.float32:
        values = np.empty(len(points_mm), dtype=np.float32)
        points, ranges = np.ascontiguousarray(points_mm), native.blocks(len(points_mm))
        arguments = np.ascontiguousarray(volume), len(volume), points, float(scale), values
        native.run("sample_volume", ranges, *arguments)
        return values
    from scipy.ndimage import map_coordinates

    coordinates = (points_mm * scale).T
    return np.asarray(
        map_coordinates(volume, coordinates, output=np.float32, order=1, mode="grid-wrap"),
        dtype=np.float32,
    )


def cellular_volume(rng: np.random.Generator, samples: int, across: int) -> tuple[Float32, Float32]:
    """Return two periodic volumes: distance to the nearest of scattered points, and gap to the second.

    The gap is the difference of both distances. Both volumes are flat arrays of ``samples**3`` values,
    in units of the mean spacing of the points. Each of the ``across**3`` cells of a jittered lattice
    holds one point.
    """
    lattice = np.stack(np.meshgrid(*[np.arange(across)] * 3, indexing="ij"), axis=-1)
    points = lattice + rng.uniform(MARGIN, 1.0 - MARGIN, (across**3, 3)).reshape(lattice.shape)
    beyond = np.arange(-CELLS_AWAY, across + CELLS_AWAY)
    x, y, z = (beyond % across)[:, None, None], (beyond % across)[:, None], beyond % across
    turns = np.stack(np.meshgrid(*[beyond // across] * 3, indexing="ij"), axis=-1)
    repeated = points[x, y, z] + across * turns
    axis = (np.arange(samples) + 0.5) * (across / samples)
    starts = np.searchsorted(axis, np.arange(across + 1))
    nearest = np.empty((2, samples, samples, samples))
    for cell in np.ndindex(across, across, across):
        around = tuple(slice(c, c + 2 * CELLS_AWAY + 1) for c in cell)
        block = tuple(slice(starts[c], starts[c + 1]) for c in cell)
        coordinates = [axis[part] for part in block]
        nearest[(slice(None), *block)] = _nearest_two(
            repeated[around].reshape(-1, 3), np.array(cell), coordinates
        )
    near, second = np.sqrt(nearest.reshape(2, -1))
    return near.astype(np.float32), (second - near).astype(np.float32)


def _nearest_two(
    points: NDArray[np.float64], cell: NDArray[np.int64], axes: list[NDArray[np.floating]]
) -> NDArray[np.float64]:
    """Return the squared distances (2, a, b, c) of samples in a cell to the nearest two points (N, 3).

    `axes` are the coordinates x (a,), y (b,) and z (c,) of the samples.
    """
    gaps = np.maximum(np.maximum(cell - points, points - cell - 1.0), 0.0)
    least = np.sum(gaps * gaps, axis=1)  # to the box of the cell
    order = np.argsort(least, kind="stable")
    x, y, z = ((axis - points[order, d, None]) ** 2 for d, axis in enumerate(axes))
    nearest = np.full((2, *(axis.size for axis in axes)), np.inf)
    first, second = nearest
    for count, i in enumerate(order):
        # Points are taken in groups, because the comparison takes as long as one point.
        if count % GROUP == 0 and least[i] > second.max(initial=0.0):
            break
        square = x[count, :, None, None] + y[count, :, None] + z[count]
        np.minimum(second, np.maximum(first, square), out=second)
        np.minimum(first, square, out=first)
    return nearest


def sample_cells(
    points_mm: Float32, spacing_mm: float, samples: int, across: int
) -> NDArray[np.int32]:
    """Return flat indices (N,) into a cellular volume scaled to a point spacing of `spacing_mm`.

    `samples` is a power of two.
    """
    step = np.float32(samples / across / spacing_mm)
    # An irrational rotation, so that the lattice is not parallel to the axes of the head.
    rotation = np.array(
        [[0.684, -0.518, 0.514], [0.730, 0.484, -0.483], [0.002, 0.705, 0.709]], dtype=np.float32
    )
    rotation *= step
    out = np.zeros(len(points_mm), dtype=np.int32)
    for k in range(3):
        coordinate = points_mm @ rotation[:, k]
        out *= samples
        out += np.floor(coordinate, out=coordinate).astype(np.int32) & (samples - 1)
    return out
