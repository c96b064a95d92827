"""Signed distance primitives and the operators that blend them.

Every field maps points ``(N, 3)`` in mm to signed distances ``(N,)`` in mm, negative inside. Ellipsoids
and blends are first-order distances: the zero set is exact, and values away from it are accurate enough
for marching cubes and Newton steps.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import CubicSpline

Array = NDArray[np.float64]
Field = Callable[[Array], Array]


def smooth_union(a: Array, b: Array, width_mm: float) -> Array:
    """Return the union of two fields, with a fillet of about ``width_mm`` (polynomial blend)."""
    h = np.maximum(width_mm - np.abs(a - b), 0.0)
    return np.asarray(np.minimum(a, b) - h * h * (0.25 / width_mm))


def smooth_intersection(a: Array, b: Array, width_mm: float) -> Array:
    """Return the intersection of two fields, with an edge rounded by about ``width_mm``."""
    return -smooth_union(-a, -b, width_mm)


def smooth_subtraction(a: Array, b: Array, width_mm: float) -> Array:
    """Return field ``a`` without field ``b``, with a rim rounded by about ``width_mm``."""
    return -smooth_union(-a, b, width_mm)


def rotation(x_deg: float = 0.0, y_deg: float = 0.0, z_deg: float = 0.0) -> Array:
    """Return the matrix ``(3, 3)`` of rotations about X, then Y, then Z, in degrees."""
    cx, cy, cz = np.cos(np.radians([x_deg, y_deg, z_deg]))
    sx, sy, sz = np.sin(np.radians([x_deg, y_deg, z_deg]))
    rx = np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]])
    ry = np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
    rz = np.array([[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]])
    return np.asarray(rz @ ry @ rx)


def ellipsoid(
    p: Array, centre_mm: ArrayLike, radii_mm: ArrayLike, turn: Array | None = None
) -> Array:
    """Return the distance to an ellipsoid with semi-axes ``radii_mm``, rotated by the matrix ``turn``."""
    q = p - np.asarray(centre_mm, dtype=np.float64)
    if turn is not None:
        q = q @ turn
    r = np.asarray(radii_mm, dtype=np.float64)
    k0 = np.sqrt(np.sum((q / r) ** 2, axis=1))
    k1 = np.sqrt(np.sum((q / (r * r)) ** 2, axis=1))
    return np.asarray(np.where(k1 > 1e-9, k0 * (k0 - 1.0) / np.maximum(k1, 1e-9), -r.min()))


def sphere(p: Array, centre_mm: ArrayLike, radius_mm: float) -> Array:
    """Return the distance to a sphere."""
    return np.asarray(np.linalg.norm(p - np.asarray(centre_mm), axis=1) - radius_mm)


def round_cone(
    p: Array, a_mm: ArrayLike, b_mm: ArrayLike, radius_a_mm: float, radius_b_mm: float
) -> Array:
    """Return the distance to a capsule whose radius changes linearly from A to B."""
    a, b = np.asarray(a_mm, dtype=np.float64), np.asarray(b_mm, dtype=np.float64)
    axis = b - a
    t = np.clip((p - a) @ axis / (axis @ axis), 0.0, 1.0)
    gap = np.linalg.norm(p - a - t[:, None] * axis, axis=1)
    return np.asarray(gap - (radius_a_mm + (radius_b_mm - radius_a_mm) * t))


def spline(knots: ArrayLike, samples: int, *, closed: bool = False) -> Array:
    """Return ``samples`` points ``(samples, D)`` of a cubic spline through ``knots`` ``(K, D)``.

    The parameterization is centripetal, so that unevenly spaced knots do not overshoot.
    """
    k = np.asarray(knots, dtype=np.float64)
    if closed:
        k = np.concatenate([k, k[:1]])
    chord = np.linalg.norm(np.diff(k[:, :3], axis=0), axis=1)
    t = np.concatenate([[0.0], np.cumsum(np.sqrt(chord))])
    curve = CubicSpline(t, k, bc_type="periodic" if closed else "natural")
    return np.asarray(curve(np.linspace(0.0, t[-1], samples, endpoint=not closed)))


def along(points: Array, polyline: Array) -> tuple[Array, Array]:
    """Return the distance ``(N,)`` to a polyline ``(K, D)``, and the parameter 0..1 of the nearest point."""
    squared = np.full(len(points), np.inf)
    parameter = np.zeros(len(points))
    n = len(polyline) - 1
    for i in range(n):
        a, axis = polyline[i], polyline[i + 1] - polyline[i]
        q = points - a
        t = np.clip(q @ axis / max(float(axis @ axis), 1e-12), 0.0, 1.0)
        d = np.sum((q - t[:, None] * axis) ** 2, axis=1)
        nearer = d < squared
        squared = np.where(nearer, d, squared)
        parameter = np.where(nearer, (i + t) / n, parameter)
    return np.sqrt(squared), parameter


def sweep(p: Array, knots_mm: ArrayLike, radii_mm: Sequence[float], samples: int = 24) -> Array:
    """Return the distance to a tube along a spline through ``knots_mm`` ``(K, 3)``, with a radius at each."""
    table = np.column_stack([np.asarray(knots_mm, dtype=np.float64), np.asarray(radii_mm)])
    curve = spline(table, samples)
    gap, parameter = along(p, curve[:, :3])
    radius = np.interp(parameter, np.linspace(0.0, 1.0, samples), curve[:, 3])
    return np.asarray(gap - radius)


def polygon(points: Array, outline: Array) -> Array:
    """Return the signed distance ``(N,)`` to a closed polygon ``(K, 2)`` in the plane, negative inside."""
    gap, _ = along(points, np.concatenate([outline, outline[:1]]))
    inside = np.zeros(len(points), dtype=bool)
    x, y = points[:, 0], points[:, 1]
    for a, b in zip(outline, np.roll(outline, -1, axis=0), strict=True):
        crosses = (a[1] > y) != (b[1] > y)
        rise = b[1] - a[1] if b[1] != a[1] else 1.0
        inside ^= crosses & (x < (b[0] - a[0]) * (y - a[1]) / rise + a[0])
    return np.where(inside, -gap, gap)


def bump(distance: Array, width_mm: float) -> Array:
    """Return a Gaussian of a distance: 1 at zero, ``exp(-1/2)`` at ``width_mm``."""
    return np.asarray(np.exp(-0.5 * (distance / width_mm) ** 2))


def ramp(value: Array, low: float, high: float) -> Array:
    """Return a smoothstep from 0 at ``low`` to 1 at ``high``; it falls if ``low > high``."""
    t = np.clip((value - low) / (high - low), 0.0, 1.0)
    return np.asarray(t * t * (3.0 - 2.0 * t))


def within(p: Array, low_mm: ArrayLike, high_mm: ArrayLike) -> NDArray[np.bool_]:
    """Return whether each point ``(N,)`` lies in an axis-aligned box."""
    return np.asarray(np.all((p > np.asarray(low_mm)) & (p < np.asarray(high_mm)), axis=1))
