"""Texture coordinates: all charts of the head, flattened, upright, and packed into the unit square."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_dilation
from scipy.signal import fftconvolve

from .ear import to_ear
from .fields import Array
from .flatten import flatten
from .mesh import Faces
from .unwrap import BASE, HEAD, close_holes, cut_up_the_back, label_faces, texel_scale, tutte

EAR_SCALE = 1.35
PADDING_TEXELS = 12.0  # at 2048 texels across
_GRID = 512


@dataclass(frozen=True)
class Unwrapped:
    """A mesh cut along its seams.

    Attributes
    ----------
    source
        (N,) vertex of the welded mesh at every vertex.
    faces
        (F, 3) indices.
    uv
        (N, 2) texture coordinates, 0..1, v down.
    chart
        (N,) number of the chart.
    """

    source: Faces
    faces: Faces
    uv: Array
    chart: Faces


def _upright(p: Array, uv: Array, chart: int) -> Array:
    """Return a chart rotated so that up on the head is up in the texture, with its lower corner at 0, 0."""
    if chart == HEAD:
        target, used = p[:, :2], p[:, 2] > 60.0
    elif chart == BASE:
        target, used = p[:, [0, 2]], np.ones(len(p), dtype=bool)
    else:
        target, used = to_ear(p)[:, :2], np.ones(len(p), dtype=bool)
    a, b = uv[used] - uv[used].mean(axis=0), target[used] - target[used].mean(axis=0)
    if chart not in (HEAD, BASE):
        # only the upward direction is fitted: the flat coordinates of some ears are mirrored
        up = np.linalg.lstsq(a, b[:, 1], rcond=None)[0]
        angle = np.pi / 2 - np.arctan2(up[1], up[0])
    else:
        angle = np.arctan2(np.sum(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]), np.sum(a * b))
    c, s = np.cos(angle), np.sin(angle)
    turned = uv @ np.array([[c, s], [-s, c]])
    return np.asarray(turned - turned.min(axis=0))


def _footprint(uv: Array, faces: Faces, cell: float) -> NDArray[np.bool_]:
    """Return which cells ``(rows, columns)`` a chart covers, bottom row first."""
    size = np.ceil(uv.max(axis=0) / cell).astype(int) + 1
    out = np.zeros((size[1], size[0]), dtype=bool)
    corner = uv[faces]
    steps = 7
    for i in range(steps + 1):
        for j in range(steps + 1 - i):
            w = np.array([i, j, steps - i - j]) / steps
            cells = (np.einsum("k,fkd->fd", w, corner) / cell).astype(int)
            out[cells[:, 1], cells[:, 0]] = True
    return out


def _pack(charts: list[tuple[Array, Faces]]) -> tuple[list[Array], float]:
    """Return the offsets of the charts, and the side of the smallest square tried that contains them."""
    side = max(float(uv.max()) for uv, _ in charts) * 1.012
    ball = np.hypot(*np.mgrid[-2:3, -2:3]) <= 2.3
    while True:
        cell = side / _GRID
        pad = int(np.ceil(PADDING_TEXELS * _GRID / 2048.0))
        occupied = np.ones((_GRID, _GRID), dtype=np.float64)
        occupied[pad:-pad, pad:-pad] = 0.0
        offsets = []
        for uv, faces in charts:
            footprint: NDArray[np.bool_] = np.pad(_footprint(uv, faces, cell), pad + 1)
            for _ in range((pad + 2) // 2):
                footprint = binary_dilation(footprint, ball)
            height, width = footprint.shape
            if height > _GRID or width > _GRID:
                break
            overlap = fftconvolve(occupied, footprint[::-1, ::-1].astype(np.float64), mode="valid")
            free = np.argwhere(overlap < 0.5)
            if len(free) == 0:
                break
            row, column = free[np.argmin(free.sum(axis=1))]
            occupied[row : row + height, column : column + width] += footprint
            offsets.append((np.array([column, row]) + pad + 1.0) * cell)
        else:
            return offsets, side
        side *= 1.012


def unwrap(vertices: Array, faces: Faces) -> Unwrapped:
    """Cut, flatten and pack a welded mesh, mm."""
    label = label_faces(vertices, faces)
    pieces = []
    for chart in np.unique(label):
        source, local = np.unique(faces[label == chart], return_inverse=True)
        local = local.reshape(-1, 3)
        if chart == HEAD:
            local, original = cut_up_the_back(vertices[source], local)
            source = source[original]
        p = vertices[source]
        points, closed = close_holes(p, local)
        if chart == HEAD:
            scale = texel_scale(points[closed].mean(axis=1))
        else:
            scale = np.full(len(closed), 0.5 if chart == BASE else EAR_SCALE)
        flat = flatten(points, closed, scale, tutte(closed, len(points)), 80)[: len(p)]
        pieces.append((chart, source, local, _upright(p, flat, chart)))
    offsets, side = _pack([(uv, local) for _, _, local, uv in pieces])
    first = np.cumsum([0] + [len(s) for _, s, _, _ in pieces])
    uv = np.concatenate([(p[3] + o) / side for p, o in zip(pieces, offsets, strict=True)])
    uv[:, 1] = 1.0 - uv[:, 1]
    return Unwrapped(
        source=np.concatenate([p[1] for p in pieces]),
        faces=np.concatenate([p[2] + k for p, k in zip(pieces, first, strict=False)]),
        uv=uv,
        chart=np.concatenate([np.full(len(p[1]), p[0]) for p in pieces]),
    )
