"""Texels of a texture on a mesh: their points on the surface, and their size there."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

Float32 = NDArray[np.float32]
Int32 = NDArray[np.int32]


@dataclass(frozen=True)
class Texels:
    """Texels that the charts of a mesh cover.

    Attributes
    ----------
    size
        Texels along a side of the square texture.
    index
        (N,) flat indices of covered texels, row by row, top row first.
    face, weight
        (N,) triangle at each texel, and (N, 3) its barycentric weights.
    """

    size: int
    index: Int32
    face: Int32
    weight: Float32

    def interpolate(self, values: Float32, faces: Int32) -> Float32:
        """Return vertex values (V, C) of triangles (F, 3) at the texels, (N, C)."""
        out = values[faces[:, 0]].take(self.face, axis=0)
        out *= self.weight[:, :1]
        for k in (1, 2):
            corner = values[faces[:, k]].take(self.face, axis=0)
            corner *= self.weight[:, k : k + 1]
            out += corner
        return np.asarray(out, dtype=np.float32)


def rasterise(uvs: Float32, faces: Int32, size: int) -> Texels:
    """Return the texels whose centres the triangles (F, 3) cover, by UVs (V, 2) with v down."""
    corner = uvs.astype(np.float64)[faces] * size - 0.5
    low = np.ceil(corner.min(axis=1) - 1e-6).astype(np.int64)
    span = np.floor(corner.max(axis=1) + 1e-6).astype(np.int64) - low + 1
    low = np.maximum(low, 0)
    owner = np.full(size * size, -1, dtype=np.int32)
    weights = np.empty((size * size, 3), dtype=np.float32)
    a = corner[:, 0]
    e1, e2 = corner[:, 1] - a, corner[:, 2] - a
    area = e1[:, 0] * e2[:, 1] - e1[:, 1] * e2[:, 0]
    divisor = np.where(np.abs(area) > 1e-12, area, 1.0)
    # Weights of the second and third corner are affine in column and row, from the corner of the box.
    step = np.stack([e2[:, 1], -e2[:, 0], -e1[:, 1], e1[:, 0]], axis=1) / divisor[:, None]
    first = low - a
    base = np.stack(
        [
            step[:, 0] * first[:, 0] + step[:, 1] * first[:, 1],
            step[:, 2] * first[:, 0] + step[:, 3] * first[:, 1],
        ],
        axis=1,
    )
    affine = np.concatenate([step, base], axis=1).astype(np.float32)
    corner_index = low[:, 1] * size + low[:, 0]
    usable = (np.min(span, axis=1) > 0) & (np.abs(area) > 1e-12)
    usable &= np.all(low + span <= size, axis=1)
    shape = span[:, 0] * 4096 + span[:, 1]
    order = np.argsort(shape, kind="stable")
    order = order[usable[order]]
    groups = np.flatnonzero(np.diff(shape[order], prepend=-1, append=-1))
    for start, stop in pairwise(groups):
        # Triangles whose boxes have the same width and height are rasterised as one block.
        batch = order[start:stop]
        columns, rows = (int(n) for n in span[batch[0]])
        r, c = np.divmod(np.arange(columns * rows), columns)
        k = affine[batch][:, :, None]
        column, line = c.astype(np.float32), r.astype(np.float32)
        w1 = k[:, 0] * column + k[:, 1] * line + k[:, 4]
        w2 = k[:, 2] * column + k[:, 3] * line + k[:, 5]
        w0 = 1.0 - w1 - w2
        inside = np.minimum(np.minimum(w0, w1), w2) >= -1e-5
        flat = (corner_index[batch][:, None] + (r * size + c))[inside]
        owner[flat] = np.broadcast_to(batch[:, None], inside.shape)[inside]
        weights[flat] = np.stack([w0[inside], w1[inside], w2[inside]], axis=1)
    index = np.flatnonzero(owner >= 0).astype(np.int32)
    return Texels(size, index, owner[index], weights[index])


def spread(covered: NDArray[np.bool_], rings: int) -> tuple[Int32, Int32]:
    """Return the empty texels within `rings` of a chart, and the covered texel nearest to each of them.

    `covered` is (H, W); both results are flat indices (M,).
    """
    height, width = covered.shape
    taken = np.zeros((height + 2, width + 2), dtype=bool)
    taken[1:-1, 1:-1] = covered
    outside = np.ones_like(taken)
    outside[1:-1, 1:-1] = False
    stride = width + 2
    edge = np.zeros_like(taken)
    edge[1:-1, 1:-1] = ~(taken[:-2, 1:-1] & taken[2:, 1:-1] & taken[1:-1, :-2] & taken[1:-1, 2:])
    frontier = np.flatnonzero(edge & taken)
    origin = frontier.copy()
    taken_flat, outside_flat = taken.ravel(), outside.ravel()
    target, source = [], []
    for ring in range(rings):
        moves = [1, -1, stride, -stride]
        if ring % 2:
            moves += [stride + 1, stride - 1, 1 - stride, -1 - stride]
        new = np.concatenate([frontier + m for m in moves])
        nearest = np.tile(origin, len(moves))
        free = ~taken_flat[new] & ~outside_flat[new]
        new, first = np.unique(new[free], return_index=True)
        nearest = nearest[free][first]
        taken_flat[new] = True
        target.append(new)
        source.append(nearest)
        frontier, origin = new, nearest
    empty_index, nearest_index = (
        (padded // stride - 1) * width + padded % stride - 1
        for padded in (np.concatenate(target), np.concatenate(source))
    )
    return empty_index.astype(np.int32), nearest_index.astype(np.int32)


@dataclass(frozen=True)
class TexelFrame:
    """Shape of texels on the skin; one value for each triangle.

    T is the unit tangent along +u, B = N × T the unit bitangent (up in the image).

    Attributes
    ----------
    right_mm
        (F,) step of one texel along +u: ``right_mm`` T.
    shear_mm, up_mm
        (F,) step of one texel up: ``shear_mm`` T + ``up_mm`` B.
    steps_mm
        (F, 2, 3) both steps as vectors in space, mm.
    to_texels
        (F, 2, 3) matrix from a displacement on the skin, mm, to the displacement (right, up) in texels.
    """

    right_mm: Float32
    shear_mm: Float32
    up_mm: Float32
    steps_mm: Float32
    to_texels: Float32


def texel_frame(positions_mm: Float32, uvs: Float32, faces: Int32, size: int) -> TexelFrame:
    """Return the shapes of texels, given positions (V, 3), UVs (V, 2) and triangles (F, 3)."""
    p, q = positions_mm.astype(np.float64)[faces], uvs.astype(np.float64)[faces] * size
    d1, d2 = q[:, 1] - q[:, 0], q[:, 2] - q[:, 0]
    det = d1[:, 0] * d2[:, 1] - d1[:, 1] * d2[:, 0]
    det = np.where(np.abs(det) < 1e-9, 1e-9, det)[:, None]
    e1, e2 = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
    right = (e1 * d2[:, 1:] - e2 * d1[:, 1:]) / det
    up = -(e2 * d1[:, :1] - e1 * d2[:, :1]) / det
    length = np.maximum(np.linalg.norm(right, axis=1), 1e-9)
    tangent = right / length[:, None]
    shear = np.sum(up * tangent, axis=1)
    rest = up - shear[:, None] * tangent
    height = np.maximum(np.linalg.norm(rest, axis=1), 1e-9)
    bitangent = rest / height[:, None]
    row_up = bitangent / height[:, None]
    row_right = (tangent - shear[:, None] * row_up) / length[:, None]
    inverse = np.stack([row_right, row_up], axis=1)
    return TexelFrame(
        length.astype(np.float32),
        shear.astype(np.float32),
        height.astype(np.float32),
        np.stack([right, up], axis=1).astype(np.float32),
        inverse.astype(np.float32),
    )


def fill(values: Float32, texels: Texels) -> Float32:
    """Return an image (H, W, C) with values (N, C) at the texels; a mean value fills the rest."""
    flat = np.empty((texels.size**2, values.shape[1]), dtype=np.float32)
    flat[:] = values[::16].mean(axis=0)
    flat[texels.index] = values
    return flat.reshape(texels.size, texels.size, -1)


def double(image: Float32) -> Float32:
    """Return an image at twice the size by linear interpolation; texel ``i`` moves to ``2 i``."""
    h, w, c = image.shape
    wide = np.empty((h, 2 * w, c), dtype=np.float32)
    wide[:, ::2] = image
    wide[:, 1:-1:2] = 0.5 * (image[:, :-1] + image[:, 1:])
    wide[:, -1] = image[:, -1]
    out = np.empty((2 * h, 2 * w, c), dtype=np.float32)
    out[::2] = wide
    np.add(wide[:-1], wide[1:], out=out[1:-1:2])
    out[1:-1:2] *= 0.5
    out[-1] = wide[-1]
    return out


def map_bands(image: Float32, work: Callable[[slice, Float32], None], rows: int = 32) -> None:
    """Double an image and call `work` with the rows and the values of each of its bands, on all cores.

    Bands have no row in common, so that the result does not depend on their order.
    """
    height = image.shape[0]

    def process(top: int) -> None:
        stop = min(top + rows, height)
        band = double(image[top : stop + 1])
        work(slice(2 * top, 2 * stop), band[: 2 * (stop - top)])

    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        for _ in pool.map(process, range(0, height, rows)):
            pass
