"""Monte Carlo of the light that reaches an eye between lids of a ball, without code of the model."""

from __future__ import annotations

import numpy as np

from eye_truth import unit

HALF_WIDTH_MM, CORNER_MM, BALL_MM = 12.5, 4.5, 14.2


def margin_plane(height_mm):
    """Return the plane n, D through both corners of the lids and the margin's middle, by a cross product."""
    corner = np.array([1.0, 0.0, 0.0])
    middle = np.array([0.0, height_mm, np.sqrt(HALF_WIDTH_MM**2 - height_mm**2)])
    start = np.array([0.0, 0.0, CORNER_MM])
    n = np.cross(corner, middle - start)
    n = unit(n if n[1] * height_mm > 0 else -n)
    return np.array([*n, n @ start])


def lets_through(point, direction, planes):
    """Return whether rays (n, m, 3) from points (n, 3) leave the ball where no lid is, by bisection."""
    low, high = np.zeros(direction.shape[:-1]), np.full(direction.shape[:-1], 40.0)
    for _ in range(32):
        middle = 0.5 * (low + high)
        inside = np.linalg.norm(point[:, None] + middle[..., None] * direction, axis=-1) < BALL_MM
        low, high = np.where(inside, middle, low), np.where(inside, high, middle)
    leave = point[:, None] + low[..., None] * direction
    free = np.ones(low.shape, dtype=bool)
    for plane in planes:
        free &= leave @ plane[:3] < plane[3]
    return free


def hemisphere(normal, count, rng):
    """Return directions (n, count, 3) around unit normals (n, 3), with a density of the cosine."""
    helper = np.where(np.abs(normal[:, :1]) < 0.7, [[1.0, 0.0, 0.0]], [[0.0, 1.0, 0.0]])
    a = unit(np.cross(normal, helper))
    b = np.cross(normal, a)
    radius, phi = (
        np.sqrt(rng.random((len(normal), count))),
        2 * np.pi * rng.random((len(normal), count)),
    )
    x, y, z = radius * np.cos(phi), radius * np.sin(phi), np.sqrt(1 - radius**2)
    return x[..., None] * a[:, None] + y[..., None] * b[:, None] + z[..., None] * normal[:, None]


def true_openness(point, normal, planes, count, rng):
    """Return the visible share (n,) of an even sky's irradiance."""
    return lets_through(point, hemisphere(normal, count, rng), planes).mean(axis=1)


def true_lamp(point, light, angle, planes, count, rng):
    """Return the visible share (n,) of a round lamp of a half angle around unit vectors (n, 3)."""
    around = hemisphere(light, count, rng)
    along = np.sum(around * light[:, None], -1, keepdims=True)
    tangent = around - along * light[:, None]
    directions = unit(light[:, None] + np.tan(angle) * tangent)
    return lets_through(point, directions, planes).mean(axis=1)


def true_iris_openness(eye, planes, side, sky, rng):
    """Return centres (n, 2) of bins of the iris and the visible share (n,) of an even sky's light in them.

    Paths start at the sky: their flux in a bin with the lids is compared with that without.
    """
    outer = eye.limbus + eye.blend
    r, phi = outer * np.sqrt(rng.random(sky)), 2 * np.pi * rng.random(sky)
    x, y = r * np.cos(phi), r * np.sin(phi)
    point, normal = eye.surface(x, y)
    light = hemisphere(normal, 1, rng)[:, 0]
    hit, passed, _ = eye.traced(x, y, light)
    passed = np.where(eye.hidden_by_sclera(point, light), np.nan, passed)
    weight = np.nan_to_num(passed) * (1 - eye.opacity(r)) / normal[:, 2]
    bare = np.ones(sky, dtype=bool)
    for plane in planes:
        bare &= point @ plane[:3] < plane[3]
    open_paths = lets_through(point, light[:, None], planes)[:, 0] & bare
    edges = np.arange(-6.0, 6.0 + side / 2, side)
    folded = [np.abs(hit[:, 0]), hit[:, 1]]
    bins = [edges[edges >= -1e-9], edges]
    every, _, _ = np.histogram2d(*folded, bins, weights=weight)
    visible, _, _ = np.histogram2d(*folded, bins, weights=weight * open_paths)
    centres = 0.5 * (edges[1:] + edges[:-1])
    gx, gy = np.meshgrid(centres[centres > 0], centres, indexing="ij")
    used = np.hypot(gx, gy) < 5.0
    return np.stack([gx[used], gy[used]], -1), visible[used] / every[used]


def exposed_points(eye, planes, count, rng):
    """Return points (n, 3) and normals (n, 3) of the front that no lid covers."""
    r, phi = 9.0 * np.sqrt(rng.random(count)), 2 * np.pi * rng.random(count)
    point, normal = eye.surface(r * np.cos(phi), r * np.sin(phi))
    bare = np.ones(count, dtype=bool)
    for plane in planes:
        bare &= point @ plane[:3] < plane[3]
    return point[bare], normal[bare]
