"""Which point of a mesh every texel shows, and how large it is there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Float32 = NDArray[np.float32]
Int32 = NDArray[np.int32]


@dataclass(frozen=True)
class Texels:
    """Texels covered by a mesh's charts.

    Attributes
    ----------
    size
        Texels along a side of the square texture.
    index
        Covered texels ``(N,)``, flat and row by row, the top row first.
    face, weight
        Triangle shown, ``(N,)``, and its barycentric weights, ``(N, 3)``.
    """

    size: int
    index: Int32
    face: Int32
    weight: Float32

    def interpolate(self, values: Float32, faces: Int32) -> Float32:
        """Vertex values ``(V, C)`` at the texels, ``(N, C)``."""
        corner = faces[self.face]
        out = values[corner[:, 0]] * self.weight[:, :1]
        out += values[corner[:, 1]] * self.weight[:, 1:2]
        out += values[corner[:, 2]] * self.weight[:, 2:]
        return np.asarray(out, dtype=np.float32)


def rasterise(uvs: Float32, faces: Int32, size: int) -> Texels:
    """Find the texels whose centres the triangles cover; glTF's v runs down."""
    corner = uvs.astype(np.float64)[faces] * size - 0.5
    low = np.ceil(corner.min(axis=1) - 1e-6).astype(np.int64)
    span = np.floor(corner.max(axis=1) + 1e-6).astype(np.int64) - low + 1
    low = np.maximum(low, 0)
    owner = np.full(size * size, -1, dtype=np.int32)
    weights = np.empty((size * size, 3), dtype=np.float32)
    a = corner[:, 0]
    e1, e2 = corner[:, 1] - a, corner[:, 2] - a
    area = e1[:, 0] * e2[:, 1] - e1[:, 1] * e2[:, 0]
    cells = np.maximum(span[:, 0], 1) * np.maximum(span[:, 1], 1)
    order = np.argsort(cells, kind="stable")
    order = order[(np.min(span, axis=1)[order] > 0) & (np.abs(area[order]) > 1e-12)]
    start = 0
    while start < len(order):
        # a batch of triangles with about equal boxes, walked as one block of rows
        reach = int(np.searchsorted(cells[order], cells[order[start]] * 1.4 + 2))
        stop = max(start + 1, min(reach, start + 400_000 // int(cells[order[start]] + 1) + 1))
        batch = order[start:stop]
        start = stop
        count = cells[batch]
        t = np.repeat(batch, count)
        k = np.arange(len(t)) - np.repeat(np.cumsum(count) - count, count)
        width = span[t, 0]
        row = k // width
        column = k - row * width + low[t, 0]
        row += low[t, 1]
        dx, dy = column - a[t, 0], row - a[t, 1]
        inverse = 1.0 / area[t]
        w1 = (dx * e2[t, 1] - dy * e2[t, 0]) * inverse
        w2 = (e1[t, 0] * dy - e1[t, 1] * dx) * inverse
        inside = (w1 >= -1e-7) & (w2 >= -1e-7) & (w1 + w2 <= 1.0 + 1e-7)
        inside &= (row < size) & (column < size)
        flat = (row * size + column)[inside]
        owner[flat] = t[inside]
        w1, w2 = w1[inside], w2[inside]
        weights[flat, 0] = 1.0 - w1 - w2
        weights[flat, 1] = w1
        weights[flat, 2] = w2
    index = np.flatnonzero(owner >= 0).astype(np.int32)
    return Texels(size, index, owner[index], weights[index])


def spread(covered: NDArray[np.bool_], rings: int) -> tuple[Int32, Int32]:
    """Empty texels within ``rings`` of a chart, and the covered texel each takes its value from.

    ``covered`` ``(H, W)``; both results are flat indices, ``(M,)``.
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
        of = np.tile(origin, len(moves))
        free = ~taken_flat[new] & ~outside_flat[new]
        new, first = np.unique(new[free], return_index=True)
        of = of[free][first]
        taken_flat[new] = True
        target.append(new)
        source.append(of)
        frontier, origin = new, of
    out = []
    for part in (np.concatenate(target), np.concatenate(source)):
        out.append(((part // stride - 1) * width + part % stride - 1).astype(np.int32))
    return out[0], out[1]


@dataclass(frozen=True)
class TexelFrame:
    """Shape of a texel on the skin, one value per triangle.

    With the unit tangent T along +u and the unit bitangent B = N x T (up in the picture, where the
    charts are not mirrored): a step of one texel along +u is ``right_mm`` T, a step of one texel up
    is ``shear_mm`` T + ``up_mm`` B.  ``to_texels`` ``(F, 2, 3)`` takes a displacement on the skin in
    millimetres to (right, up) texels.
    """

    right_mm: Float32
    shear_mm: Float32
    up_mm: Float32
    to_texels: Float32


def texel_frame(positions_mm: Float32, uvs: Float32, faces: Int32, size: int) -> TexelFrame:
    """Work out the texels' shapes from the triangles' own derivatives."""
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
        length.astype(np.float32), shear.astype(np.float32), height.astype(np.float32),
        inverse.astype(np.float32),
    )
