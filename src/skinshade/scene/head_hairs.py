"""Eyebrows and lashes of the built-in head, drawn hair by hair."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d

from .head_texels import TexelFrame

Float32 = NDArray[np.float32]
Int32 = NDArray[np.int32]

# Closed lid line of the built-in head's left (+X) and right eye, millimetres, inner corner first.
LASH_LINES_MM = (
    (
        (17.6, -3.2, 75.0),
        (21.3, -4.6, 76.4),
        (25.3, -5.7, 77.5),
        (29.3, -6.2, 78.0),
        (33.3, -6.1, 77.9),
        (37.3, -5.4, 76.9),
        (41.2, -4.0, 75.0),
        (44.2, -2.5, 72.5),
        (46.4, -1.1, 70.0),
    ),
    (
        (-17.2, -2.6, 74.4),
        (-20.7, -4.0, 75.6),
        (-24.7, -5.0, 76.5),
        (-28.7, -5.5, 77.0),
        (-32.7, -5.4, 76.7),
        (-36.7, -4.6, 75.7),
        (-40.8, -3.1, 73.6),
        (-43.8, -1.6, 71.1),
        (-46.0, -0.1, 68.6),
    ),
)


def trace(
    roots: Int32,
    heading_mm: NDArray[np.float64],
    bend_mm: NDArray[np.float64],
    length_mm: NDArray[np.float64],
    owner: Int32,
    frame: TexelFrame,
    steps: int,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Walk hairs over the skin.

    Parameters
    ----------
    roots
        Row and column ``(N, 2)`` of every hair's root.
    heading_mm, bend_mm
        Unit direction at the root and what is added to it by the tip, ``(N, 3)``.
    length_mm
        Lengths ``(N,)``.
    owner
        Triangle shown at every texel ``(H, W)``, -1 where none.
    frame
        Shape of the texels.
    steps
        Points along a hair.

    Returns
    -------
    tuple
        Texel coordinates (column, row) ``(steps, N, 2)`` and a flag ``(steps, N)`` that falls to 0
        once a hair has left its chart.
    """
    size = owner.shape[0]
    at = roots[:, ::-1].astype(np.float64)
    alive = np.ones(len(roots))
    path, shown = [], []
    for k in range(steps):
        column, row = np.clip(np.rint(at), 0, size - 1).astype(np.int64).T
        face = owner[row, column]
        alive = alive * (face >= 0)
        path.append(at.copy())
        shown.append(alive)
        ahead = heading_mm + bend_mm * (k / max(steps - 1, 1))
        ahead = ahead / np.linalg.norm(ahead, axis=1, keepdims=True)
        move = np.einsum("nij,nj->ni", frame.to_texels[np.maximum(face, 0)], ahead)
        move *= (length_mm / steps)[:, None] * alive[:, None]
        at = at + move * [1.0, -1.0]
    return np.stack(path), np.stack(shown)


def draw(
    canvas: Float32,
    path: NDArray[np.float64],
    shown: NDArray[np.float64],
    half_width_texels: NDArray[np.float64],
    strength: NDArray[np.float64],
    *,
    taper: bool = True,
) -> None:
    """Lay strokes onto ``canvas`` ``(2 H, 2 W)`` in place, keeping the darker value.

    ``path`` ``(steps, N, 2)`` and ``half_width_texels`` ``(N,)`` count texels of ``(H, W)``.
    """
    size = canvas.shape[0]
    path, half_width_texels = path * 2.0, half_width_texels * 2.0
    points = []
    # four points between every two of the path, so that strokes do not break up into dots
    for k in range(len(path) - 1):
        for t in (0.0, 0.25, 0.5, 0.75):
            along = (k + t) / (len(path) - 1)
            thin = min(1.0, 0.55 + 1.8 * along) * (1.0 - along**1.6) ** 0.8
            fade = min(1.0, 4.0 * (1.0 - along))
            if not taper:
                thin, fade = min(1.0, 0.4 + 4.0 * min(along, 1.0 - along)), 1.0
            points.append(
                np.column_stack(
                    [
                        path[k] * (1 - t) + path[k + 1] * t,
                        half_width_texels * thin,
                        strength * shown[k + 1] * fade,
                    ]
                )
            )
    x, y, half, dark = np.concatenate(points).T
    keep = (dark > 0.0) & (half > 0.05)
    x, y, half, dark = x[keep], y[keep], half[keep], dark[keep]
    left, top = np.floor(x).astype(np.int64), np.floor(y).astype(np.int64)
    flat = canvas.ravel()
    for i in range(-1, 3):
        for j in range(-1, 3):
            gap = np.hypot(left + i - x, top + j - y)
            # coverage of a texel by a line thinner or thicker than itself
            cover = dark * np.clip(half + 0.5 - gap, 0.0, 1.0) * np.minimum(1.0, 2.0 * half)
            inside = (cover > 0.0) & (left + i >= 0) & (left + i < size)
            inside &= (top + j >= 0) & (top + j < size)
            at = (top[inside] + j) * size + left[inside] + i
            np.maximum.at(flat, at, cover[inside].astype(np.float32))


def _texel_mm(frame: TexelFrame, face: Int32) -> NDArray[np.float64]:
    return np.sqrt(frame.right_mm[face].astype(np.float64) * frame.up_mm[face])


def eyebrows(
    canvas: Float32,
    index: Int32,
    points_mm: Float32,
    weight: Float32,
    owner: Int32,
    frame: TexelFrame,
    rng: np.random.Generator,
) -> None:
    """Draw both brows: hairs stand up at the nose, lie outwards in the middle and down at the end.

    ``index`` ``(N,)``, ``points_mm`` ``(N, 3)`` and ``weight`` ``(N,)`` are the texels to grow on.
    """
    grown = np.flatnonzero(weight > 0.03)
    if len(grown) == 0:
        return
    size = owner.shape[0]
    area = _texel_mm(frame, owner.ravel()[index[grown]]) ** 2
    chance = np.cumsum(weight[grown].astype(np.float64) ** 0.8 * area)
    count = int(chance[-1] * 2.6)
    pick = grown[np.searchsorted(chance, rng.uniform(0.0, chance[-1], count))]
    p = points_mm[pick].astype(np.float64)
    roots = np.stack(np.divmod(index[pick], size), axis=1)
    out = np.clip((np.abs(p[:, 0]) - 11.0) / 40.0, 0.0, 1.0)
    spine = 17.0 + 7.2 * np.sin(np.clip(out * 1.5, 0, 1.5)) - 5.5 * np.maximum(out - 0.62, 0) ** 1.2
    # the left brow sits half a millimetre lower than the right one
    above = np.clip((p[:, 1] + 0.5 * np.sign(p[:, 0]) - spine) / 4.5, -1.0, 1.0)
    angle_deg = 82.0 - 105.0 * out**0.6 - 22.0 * above * (out > 0.15)
    angle = np.radians(angle_deg + rng.normal(0.0, 8.0, count))
    side = np.sign(p[:, 0])
    heading = np.stack([side * np.cos(angle), np.sin(angle), -0.35 * out], axis=1)
    bend = np.stack([side * 0.5, -0.35 - 0.3 * above, -0.3 * np.ones(count)], axis=1)
    length = rng.normal(7.6, 1.4, count).clip(4.0, 11.0) * (1.0 - 0.42 * out)
    length *= 0.6 + 0.4 * weight[pick]
    path, shown = trace(roots, heading, bend, length, owner, frame, 16)
    half = 0.5 * rng.uniform(0.18, 0.34, count) / _texel_mm(frame, owner[roots[:, 0], roots[:, 1]])
    draw(canvas, path, shown, half, rng.uniform(0.55, 0.92, count))


def lashes(
    canvas: Float32,
    index: Int32,
    points_mm: Float32,
    owner: Int32,
    frame: TexelFrame,
    rng: np.random.Generator,
) -> None:
    """Draw the dark line of the closed lids and the lashes that hang from it."""
    size = owner.shape[0]
    for line in LASH_LINES_MM:
        knots = np.array(line)
        low, high = knots.min(axis=0) - 4.0, knots.max(axis=0) + 4.0
        near = np.flatnonzero(np.all((points_mm > low) & (points_mm < high), axis=1))
        if len(near) == 0:
            continue
        count = 95
        t = np.sort(rng.uniform(0.04, 1.0, count)) * (len(knots) - 1)
        leg = np.minimum(t.astype(np.int64), len(knots) - 2)
        wanted = knots[leg] + (knots[leg + 1] - knots[leg]) * (t - leg)[:, None]
        wanted += rng.normal(0.0, 0.15, wanted.shape)
        gap = points_mm[near]
        pick = near[[int(np.argmin(np.sum((gap - w) ** 2, axis=1))) for w in wanted]]
        roots = np.stack(np.divmod(index[pick], size), axis=1)
        along = t / (len(knots) - 1)
        side = np.sign(wanted[:, 0])
        fan = np.radians(-90.0 + 75.0 * (along - 0.38) + rng.normal(0.0, 6.0, count))
        heading = np.stack([side * np.cos(fan), np.sin(fan), np.zeros(count)], axis=1)
        bend = np.stack([side * 0.25, 0.35 * np.ones(count), np.zeros(count)], axis=1)
        length = rng.normal(4.6, 0.7, count).clip(2.5, 7.0) * (0.6 + 0.5 * np.sqrt(along))
        path, shown = trace(roots, heading, bend, length, owner, frame, 12)
        texel = _texel_mm(frame, owner[roots[:, 0], roots[:, 1]])
        draw(
            canvas,
            path,
            shown,
            0.5 * rng.uniform(0.12, 0.2, count) / texel,
            rng.uniform(0.5, 0.85, count),
        )
        # the line itself, with what the nearest texels miss of its points made good
        dense = np.linspace(0.0, len(knots) - 1.0, 80)
        line_mm = np.column_stack([np.interp(dense, np.arange(len(knots)), k) for k in knots.T])
        pick = near[[int(np.argmin(np.sum((gap - w) ** 2, axis=1))) for w in line_mm]]
        row, column = np.divmod(index[pick], size)
        missed_mm = line_mm - points_mm[pick]
        off = np.einsum("nij,nj->ni", frame.to_texels[owner[row, column]], missed_mm)
        follow = np.column_stack([column + off[:, 0], row - off[:, 1]])
        follow = gaussian_filter1d(follow, 3.0, axis=0, mode="nearest")[:, None]
        draw(
            canvas,
            follow,
            np.ones((80, 1)),
            np.array([0.24 / float(texel.mean())]),
            np.array([0.7]),
            taper=False,
        )
