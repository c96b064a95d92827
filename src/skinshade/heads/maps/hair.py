"""Eyebrows and lashes of the built-in head, drawn hair by hair into a texture."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .blur import gaussian_blur
from .texels import Float32, Int32, TexelFrame

__all__ = ["eyebrows", "lashes"]

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
"""Lines of the closed lids of the left (+x) and the right eye, mm, from the inner corner."""


def trace(
    roots: Int32,
    heading_mm: NDArray[np.float64],
    bend_mm: NDArray[np.float64],
    length_mm: NDArray[np.float64],
    owner: Int32,
    frame: TexelFrame,
    steps: int,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the paths of hairs over the skin.

    Parameters
    ----------
    roots
        (N, 2) row and column of every hair's root.
    heading_mm, bend_mm
        (N, 3) unit direction at the root, and the change of the direction from root to tip.
    length_mm
        (N,) lengths, mm.
    owner
        (H, W) triangle at every texel, -1 where there is none.
    frame
        Shape of the texels.
    steps
        Points along a hair.

    Returns
    -------
    path, visible
        (steps, N, 2) texel coordinates (column, row), and (steps, N) 1 until a hair leaves its chart, 0
        afterwards.
    """
    size = owner.shape[0]
    position = roots[:, ::-1].astype(np.float64)
    alive = np.ones(len(roots))
    path, visible = [], []
    for k in range(steps):
        column, row = np.clip(np.rint(position), 0, size - 1).astype(np.int64).T
        face = owner[row, column]
        alive = alive * (face >= 0)
        path.append(position.copy())
        visible.append(alive)
        direction = heading_mm + bend_mm * (k / max(steps - 1, 1))
        direction = direction / np.linalg.norm(direction, axis=1, keepdims=True)
        step = np.einsum("nij,nj->ni", frame.to_texels[np.maximum(face, 0)], direction)
        step *= (length_mm / steps)[:, None] * alive[:, None]
        position = position + step * [1.0, -1.0]
    return np.stack(path), np.stack(visible)


def draw(
    canvas: Float32,
    path: NDArray[np.float64],
    visible: NDArray[np.float64],
    half_width_texels: NDArray[np.float64],
    strength: NDArray[np.float64],
    *,
    taper: bool = True,
) -> None:
    """Draw strokes onto a canvas (2H, 2W) in place; overlapping strokes keep the darker value.

    `path` (steps, N, 2) and `half_width_texels` (N,) are in texels of (H, W).
    """
    size = canvas.shape[0]
    path, half_width_texels = path * 2.0, half_width_texels * 2.0
    points = []
    # Each step of the path gets four points, so that strokes do not break up into dots.
    for k in range(len(path) - 1):
        for t in (0.0, 0.25, 0.5, 0.75):
            along = (k + t) / (len(path) - 1)
            width = min(1.0, 0.55 + 1.8 * along) * (1.0 - along**1.6) ** 0.8
            opacity = min(1.0, 4.0 * (1.0 - along))
            if not taper:
                width, opacity = min(1.0, 0.4 + 4.0 * min(along, 1.0 - along)), 1.0
            points.append(
                np.column_stack(
                    [
                        path[k] * (1 - t) + path[k + 1] * t,
                        half_width_texels * width,
                        strength * visible[k + 1] * opacity,
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
            distance = np.hypot(left + i - x, top + j - y)
            # Coverage of a texel by a line that is thinner or wider than the texel.
            coverage = dark * np.clip(half + 0.5 - distance, 0.0, 1.0) * np.minimum(1.0, 2.0 * half)
            inside = (coverage > 0.0) & (left + i >= 0) & (left + i < size)
            inside &= (top + j >= 0) & (top + j < size)
            texel = (top[inside] + j) * size + left[inside] + i
            np.maximum.at(flat, texel, coverage[inside].astype(np.float32))


def _texel_mm(frame: TexelFrame, face: Int32) -> NDArray[np.float64]:
    """Return the mean width of the texels of triangles, mm."""
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
    """Draw both brows: hairs point up at the nose, outwards in the middle, and down at the outer end.

    `index` (N,), `points_mm` (N, 3) and `weight` (N,) describe the texels that hairs may grow on.
    """
    candidates = np.flatnonzero(weight > 0.03)
    if len(candidates) == 0:
        return
    size = owner.shape[0]
    area = _texel_mm(frame, owner.ravel()[index[candidates]]) ** 2
    cumulative = np.cumsum(weight[candidates].astype(np.float64) ** 0.8 * area)
    count = int(cumulative[-1] * 2.6)
    chosen = candidates[np.searchsorted(cumulative, rng.uniform(0.0, cumulative[-1], count))]
    p = points_mm[chosen].astype(np.float64)
    roots = np.stack(np.divmod(index[chosen], size), axis=1)
    outward = np.clip((np.abs(p[:, 0]) - 11.0) / 40.0, 0.0, 1.0)
    spine = (
        17.0
        + 7.2 * np.sin(np.clip(outward * 1.5, 0, 1.5))
        - 5.5 * np.maximum(outward - 0.62, 0) ** 1.2
    )
    # The left brow sits half a millimetre lower than the right one.
    above = np.clip((p[:, 1] + 0.5 * np.sign(p[:, 0]) - spine) / 4.5, -1.0, 1.0)
    angle_deg = 82.0 - 105.0 * outward**0.6 - 22.0 * above * (outward > 0.15)
    angle = np.radians(angle_deg + rng.normal(0.0, 8.0, count))
    side = np.sign(p[:, 0])
    heading = np.stack([side * np.cos(angle), np.sin(angle), -0.35 * outward], axis=1)
    bend = np.stack([side * 0.5, -0.35 - 0.3 * above, -0.3 * np.ones(count)], axis=1)
    length = rng.normal(7.6, 1.4, count).clip(4.0, 11.0) * (1.0 - 0.42 * outward)
    length *= 0.6 + 0.4 * weight[chosen]
    path, visible = trace(roots, heading, bend, length, owner, frame, 16)
    half = 0.5 * rng.uniform(0.18, 0.34, count) / _texel_mm(frame, owner[roots[:, 0], roots[:, 1]])
    draw(canvas, path, visible, half, rng.uniform(0.55, 0.92, count))


def lashes(
    canvas: Float32,
    index: Int32,
    points_mm: Float32,
    owner: Int32,
    frame: TexelFrame,
    rng: np.random.Generator,
) -> None:
    """Draw the dark line of the closed lids, and the lashes below this line."""
    size = owner.shape[0]
    for line in LASH_LINES_MM:
        knots = np.array(line)
        low, high = knots.min(axis=0) - 4.0, knots.max(axis=0) + 4.0
        near = np.flatnonzero(np.all((points_mm > low) & (points_mm < high), axis=1))
        if len(near) == 0:
            continue
        count = 95
        t = np.sort(rng.uniform(0.04, 1.0, count)) * (len(knots) - 1)
        segment = np.minimum(t.astype(np.int64), len(knots) - 2)
        root_mm = knots[segment] + (knots[segment + 1] - knots[segment]) * (t - segment)[:, None]
        root_mm += rng.normal(0.0, 0.15, root_mm.shape)
        near_mm = points_mm[near]
        nearest = near[
            [int(np.argmin(np.sum((near_mm - point) ** 2, axis=1))) for point in root_mm]
        ]
        roots = np.stack(np.divmod(index[nearest], size), axis=1)
        along = t / (len(knots) - 1)
        side = np.sign(root_mm[:, 0])
        fan = np.radians(-90.0 + 75.0 * (along - 0.38) + rng.normal(0.0, 6.0, count))
        heading = np.stack([side * np.cos(fan), np.sin(fan), np.zeros(count)], axis=1)
        bend = np.stack([side * 0.25, 0.35 * np.ones(count), np.zeros(count)], axis=1)
        length = rng.normal(4.6, 0.7, count).clip(2.5, 7.0) * (0.6 + 0.5 * np.sqrt(along))
        path, visible = trace(roots, heading, bend, length, owner, frame, 12)
        texel = _texel_mm(frame, owner[roots[:, 0], roots[:, 1]])
        draw(
            canvas,
            path,
            visible,
            0.5 * rng.uniform(0.12, 0.2, count) / texel,
            rng.uniform(0.5, 0.85, count),
        )
        # The dark line goes through the nearest texels, corrected by their distance from the line.
        dense = np.linspace(0.0, len(knots) - 1.0, 80)
        line_mm = np.column_stack(
            [np.interp(dense, np.arange(len(knots)), coordinate) for coordinate in knots.T]
        )
        nearest = near[
            [int(np.argmin(np.sum((near_mm - point) ** 2, axis=1))) for point in line_mm]
        ]
        row, column = np.divmod(index[nearest], size)
        offset_mm = line_mm - points_mm[nearest]
        offset = np.einsum("nij,nj->ni", frame.to_texels[owner[row, column]], offset_mm)
        line_path = np.column_stack([column + offset[:, 0], row - offset[:, 1]])
        line_path = gaussian_blur(line_path, 3.0, 0, "edge")[:, None]
        draw(
            canvas,
            line_path,
            np.ones((80, 1)),
            np.array([0.24 / float(texel.mean())]),
            np.array([0.7]),
            taper=False,
        )
