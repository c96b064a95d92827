"""Periodic noise volumes for the maps of the built-in head.

Noise is sampled at positions in space, so that patterns cross the seams of a texture. The volumes are
small and repeat; slices through them along a curved surface look aperiodic.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..._core import native

Float32 = NDArray[np.float32]


def smooth_volume(rng: np.random.Generator, cells: int = 48) -> Float32:
    """Return periodic band-limited Gaussian noise (c, c, c), mean 0, standard deviation 1.

    A feature is about four samples across.
    """
    from scipy.ndimage import gaussian_filter  # costs .2 s

    field = gaussian_filter(
        rng.standard_normal((cells, cells, cells), dtype=np.float32), 1.1, mode="wrap"
    )
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
    from scipy.spatial import cKDTree

    lattice = np.stack(np.meshgrid(*[np.arange(across)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    seeds = (lattice + rng.uniform(0.08, 0.92, lattice.shape)) % across
    tree = cKDTree(seeds, boxsize=np.full(3, float(across)))
    axis = (np.arange(samples) + 0.5) * (across / samples)
    grid = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1).reshape(-1, 3)
    near = np.asarray(tree.query(grid, k=2)[0])
    return near[:, 0].astype(np.float32), (near[:, 1] - near[:, 0]).astype(np.float32)


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
