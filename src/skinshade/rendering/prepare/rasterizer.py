"""Rasteriser: the visible face at each sample, by homogeneous edge functions [Olano1997].

The inverse of the matrix of a face's corners (x·w, y·w, w) gives three functions that are linear over the
screen: the barycentric coordinates divided by w. The functions are also valid for corners behind the eye,
so that faces need no clipping, and they give perspective-correct derivatives.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..._core.arrays import FloatArray, IntArray, dot
from . import compiled_rasterizer as compiled
from .fragments import Fragments, Hidden, keep_nearest, screen_positions

__all__ = ["Fragments", "depth_maps", "rasterize"]

CANDIDATES_PER_BATCH = 1 << 20
"""Pairs of face and pixel tested at once. They limit the memory to about 100 MiB for any mesh."""

EDGE_SLACK = 1e-14
"""Widening of faces, so that rounding leaves no gap at a shared edge; relative to the largest term of an
edge function."""
BOX_SLACK = 1e-6
"""Widening of bounding boxes in pixels, because x·w/w differs from x by rounding."""


def rasterize(
    clip: FloatArray,
    faces: IntArray,
    size: tuple[int, int],
    offset: tuple[float, float] = (0.5, 0.5),
    hidden: Hidden | None = None,
    opaque: int = 0,
) -> Fragments:
    """Return the nearest face at one sample of every pixel.

    Parameters
    ----------
    clip
        (V, 4) clip coordinates; y points up, and w is the distance in front of the eye.
    faces
        (F, 3) vertex indices; both sides of a face are visible.
    size
        (width, height) in pixels.
    offset
        Position of the sample within the pixel, 0..1 each, from the top left.
    hidden
        Function that returns which points show nothing, such as those between the hairs of a card.
    opaque
        Number of faces at the beginning of which no point is hidden.
    """
    if compiled.serves():
        return compiled.rasterize(clip, faces, size, offset, hidden, opaque)
    width, height = size
    functions, _ = _edge_functions(clip, faces, size)
    planes = _depth_planes(functions, clip[:, 3][faces])
    nearest = np.full(width * height, np.inf)
    winner = np.full(width * height, -1, dtype=np.int64)
    for face, pixel, depth in _covered(clip, faces, size, offset, functions, planes):
        if hidden is not None:
            x, y = pixel % width + offset[0], pixel // width + offset[1]
            absent = hidden(face, _barycentric(functions[face], x[:, None], y[:, None])[0])
            if absent is not None:
                face, pixel, depth = face[~absent], pixel[~absent], depth[~absent]
        keep_nearest(nearest, winner, face, pixel, depth)
    pixel = np.flatnonzero(winner >= 0)
    face = winner[pixel]
    rows = functions[face]
    x = (pixel % width + offset[0])[:, None]
    y = (pixel // width + offset[1])[:, None]
    barycentric, total = _barycentric(rows, x, y)
    along_x, along_y = (
        (rows[..., axis] - barycentric * rows[..., axis].sum(axis=1, keepdims=True)) / total
        for axis in (0, 1)
    )
    return Fragments(pixel, face, barycentric, along_x, along_y)


def _barycentric(
    functions: FloatArray, x: NDArray[np.floating[Any]], y: NDArray[np.floating[Any]]
) -> tuple[FloatArray, FloatArray]:
    """Return barycentric coordinates (N, 3) at points (N, 1) of faces (N, 3, 3), and 1/w (N, 1)."""
    edge = functions[..., 0] * x + functions[..., 1] * y + functions[..., 2]
    total = edge.sum(axis=1, keepdims=True)
    return edge / total, total


def depth_maps(
    clip: FloatArray, depth_mm: FloatArray, faces: IntArray, size: tuple[int, int]
) -> tuple[FloatArray, FloatArray]:
    """Return the depth of the nearest surface, and of the nearest surface that faces away.

    Parameters
    ----------
    clip
        (V, 4) clip coordinates of the light's view.
    depth_mm
        (V,) distance along the light's axis, mm.
    faces
        (F, 3) vertex indices, counter-clockwise seen from outside.
    size
        (width, height) in pixels.

    Returns
    -------
    nearest, facing_away
        (height, width) mm, infinite where there is no surface. In the second map the lit side of a body
        does not shadow itself, so that it needs no bias.
    """
    if compiled.serves():
        return compiled.depth_maps(clip, depth_mm, faces, size)
    width, height = size
    functions, determinant = _edge_functions(clip, faces, size)
    planes = _depth_planes(functions, depth_mm[faces])
    # Screen y runs down, which reverses the winding.
    faces_away = determinant > 0.0
    nearest = np.full(width * height, np.inf)
    facing_away = np.full(width * height, np.inf)
    for face, pixel, depth in _covered(clip, faces, size, (0.5, 0.5), functions, planes):
        np.minimum.at(nearest, pixel, depth)
        back = np.flatnonzero(faces_away[face])
        np.minimum.at(facing_away, pixel[back], depth[back])
    return nearest.reshape(height, width), facing_away.reshape(height, width)


def _edge_functions(
    clip: FloatArray, faces: IntArray, size: tuple[int, int]
) -> tuple[FloatArray, FloatArray]:
    """Return the edge functions (F, 3 corners, 3) and the signed areas (F,) of faces.

    A function has the coefficients of x, y and 1, which are zero for a face that is seen edge-on.
    """
    a, b, c = np.moveaxis(screen_positions(clip, size)[faces], 1, 0)
    rows = np.stack([_cross(b, c), _cross(c, a), _cross(a, b)], axis=1)
    determinant = dot(a, rows[:, 0])
    x, y, w = np.abs(a).T
    greatest = np.maximum(np.maximum(x, y), w)
    usable = np.abs(determinant) > 1e-12 * np.maximum(np.square(greatest), 1e-300)
    scale = np.where(usable, 1.0 / np.where(usable, determinant, 1.0), 0.0)
    return rows * scale[:, None, None], determinant


def _depth_planes(functions: FloatArray, corner_depths: FloatArray) -> FloatArray:
    """Return the coefficients (F, 6) of depth/w and of 1/w, which are linear over the screen."""
    over_w = np.einsum("fi,fik->fk", corner_depths, functions)
    inverse_w = functions[:, 0] + functions[:, 1] + functions[:, 2]
    return np.concatenate([over_w, inverse_w], axis=1)


def _covered(
    clip: FloatArray,
    faces: IntArray,
    size: tuple[int, int],
    offset: tuple[float, float],
    functions: FloatArray,
    planes: FloatArray,
) -> Iterator[tuple[IntArray, IntArray, FloatArray]]:
    """Yield batches (face, pixel, depth) of all samples that lie within a face."""
    # Components are computed one by one, because NumPy is slow at sums over an axis of three.
    reach = np.abs(functions) @ np.array([size[0], size[1], 1.0])
    widened = functions.copy()
    widened[:, :, 2] += EDGE_SLACK * reach
    table = np.ascontiguousarray(widened.reshape(-1, 9).T)
    depth_table = np.ascontiguousarray(planes.T)
    for face, column, row in _candidates(clip, faces, size, offset):
        x, y = column + offset[0], row + offset[1]
        inside = np.ones(face.size, dtype=bool)
        for corner in (0, 3, 6):
            edge = table[corner][face] * x
            edge += table[corner + 1][face] * y
            edge += table[corner + 2][face]
            inside &= edge >= 0.0
        kept = np.flatnonzero(inside)
        face, x, y = face[kept], x[kept], y[kept]
        pixel = row[kept] * size[0] + column[kept]
        a, b, c, d, e, f = (coefficients[face] for coefficients in depth_table)
        inverse_w = d * x + e * y + f
        in_front = inverse_w > 0.0
        depth = (a * x + b * y + c) / np.where(in_front, inverse_w, 1.0)
        if not in_front.all():
            face, pixel, depth = face[in_front], pixel[in_front], depth[in_front]
        yield face, pixel, depth


def _cross(a: FloatArray, b: FloatArray) -> FloatArray:
    x = a[:, 1] * b[:, 2] - a[:, 2] * b[:, 1]
    y = a[:, 2] * b[:, 0] - a[:, 0] * b[:, 2]
    z = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return np.stack([x, y, z], axis=1)


def _candidates(
    clip: FloatArray, faces: IntArray, size: tuple[int, int], offset: tuple[float, float]
) -> Iterator[tuple[IntArray, IntArray, IntArray]]:
    """Yield batches (face, x, y) of all pixels in the bounding boxes of faces."""
    width, height = size
    screen = screen_positions(clip, size)
    behind: NDArray[np.bool_] = np.asarray(screen[:, 2] <= 1e-9)
    xy = screen[:, :2] / np.where(behind, 1.0, screen[:, 2])[:, None]
    a, b, c = (xy[corner] for corner in faces.T)
    corner_behind = [behind[corner] for corner in faces.T]
    any_behind = corner_behind[0] | corner_behind[1] | corner_behind[2]
    all_behind = corner_behind[0] & corner_behind[1] & corner_behind[2]
    least, greatest = np.minimum(np.minimum(a, b), c), np.maximum(np.maximum(a, b), c)
    limit = np.array([width, height], dtype=np.float64)
    low = np.where(any_behind[:, None], 0.0, np.ceil(least - offset - BOX_SLACK))
    high = np.where(any_behind[:, None], limit - 1.0, np.floor(greatest - offset + BOX_SLACK))
    low = np.clip(low, 0.0, limit).astype(np.int64)
    high = np.clip(high, -1.0, limit - 1.0).astype(np.int64)
    extent = np.maximum(high - low + 1, 0)
    extent[all_behind] = 0
    count = extent[:, 0] * extent[:, 1]
    nonempty = np.flatnonzero(count)
    ends = np.cumsum(count[nonempty])
    start = 0
    while start < nonempty.size:
        before = ends[start - 1] if start else 0
        stop = int(np.searchsorted(ends, before + CANDIDATES_PER_BATCH, side="right"))
        stop = max(stop, start + 1)
        batch = nonempty[start:stop]
        face = np.repeat(batch, count[batch])
        within = np.arange(face.size) - np.repeat(
            ends[start:stop] - count[batch] - before, count[batch]
        )
        y, x = np.divmod(within, extent[face, 0])
        yield face, x + low[face, 0], y + low[face, 1]
        start = stop
