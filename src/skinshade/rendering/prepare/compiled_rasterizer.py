"""Compiled rasteriser: the twins of the functions of `rasterizer`, with the same arguments."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..._core import native
from ..._core.arrays import FloatArray, IntArray
from .fragments import Fragments, Hidden, keep_nearest, screen_positions

__all__ = ["depth_maps", "rasterize", "serves"]

BAND_ROWS = 256
"""Least rows of a band. Every band visits all faces; small depth maps are drawn in one."""


def serves() -> bool:
    """Return whether the compiled functions are in use."""
    return native.available()


def rasterize(
    clip: FloatArray,
    faces: IntArray,
    size: tuple[int, int],
    offset: tuple[float, float],
    hidden: Hidden | None,
    opaque: int,
) -> Fragments:
    """Return the nearest face at one sample of every pixel, as `rasterizer.rasterize`."""
    width, height = size
    screen = screen_positions(clip, size)
    w, faces = np.ascontiguousarray(clip[:, 3]), _indices(faces)
    view = np.array([width, height, *offset])
    nearest = np.full(width * height, np.inf)
    winner = np.full(width * height, -1, dtype=np.int64)
    bands = native.blocks(height, BAND_ROWS)
    end = len(faces) if hidden is None else opaque
    native.run("raster_nearest", bands, screen, w, faces, 0, end, view, nearest, winner)
    if hidden is not None and opaque < len(faces):
        face, pixel, depth = _listed(screen, w, faces, opaque, view, nearest, bands)
        ends = np.zeros((0, 3))
        if face.size:
            ends = _resolved(screen, faces, face, pixel, view).barycentric
        absent = hidden(face, ends) if face.size else None
        if absent is not None:
            face, pixel, depth = face[~absent], pixel[~absent], depth[~absent]
        keep_nearest(nearest, winner, face, pixel, depth)
    pixel = np.flatnonzero(winner >= 0)
    return _resolved(screen, faces, winner[pixel], pixel, view)


def depth_maps(
    clip: FloatArray, depth_mm: FloatArray, faces: IntArray, size: tuple[int, int]
) -> tuple[FloatArray, FloatArray]:
    """Return two maps of the nearest depths, as `rasterizer.depth_maps`."""
    width, height = size
    nearest = np.full((height, width), np.inf)
    facing_away = np.full((height, width), np.inf)
    native.run(
        "raster_depths",
        native.blocks(height, BAND_ROWS),
        screen_positions(clip, size),
        np.ascontiguousarray(depth_mm, dtype=np.float64),
        _indices(faces),
        len(faces),
        np.array([width, height, 0.5, 0.5]),
        nearest,
        facing_away,
    )
    return nearest, facing_away


def _indices(faces: IntArray) -> IntArray:
    return np.ascontiguousarray(faces, dtype=np.int64)


def _listed(
    screen: FloatArray,
    w: FloatArray,
    faces: IntArray,
    start: int,
    view: FloatArray,
    nearest: FloatArray,
    bands: list[int],
) -> tuple[IntArray, IntArray, FloatArray]:
    """Return face, pixel and depth of the samples of faces from `start` that no nearer surface hides.

    Samples of one pixel are in the order of their faces.
    """
    arguments = (screen, w, faces, start, len(faces), view, nearest)
    counts = native.run("raster_list", bands, *arguments, None, None, None)
    ends = np.cumsum(counts)
    face, pixel = np.empty(ends[-1], dtype=np.int64), np.empty(ends[-1], dtype=np.int64)
    depth = np.empty(ends[-1])

    def of_bands(values: NDArray[np.generic]) -> list[NDArray[np.generic]]:
        return np.split(values, ends[:-1])

    native.run("raster_list", bands, *arguments, of_bands(face), of_bands(pixel), of_bands(depth))
    return face, pixel, depth


def _resolved(
    screen: FloatArray, faces: IntArray, face: IntArray, pixel: IntArray, view: FloatArray
) -> Fragments:
    """Return the fragments of faces (N,) at pixels (N,)."""
    barycentric, along_x, along_y = (np.empty((pixel.size, 3)) for _ in range(3))
    arrays = (screen, faces, face, pixel, view)
    native.run("raster_resolve", native.blocks(pixel.size), *arrays, barycentric, along_x, along_y)
    return Fragments(pixel, face, barycentric, along_x, along_y)
