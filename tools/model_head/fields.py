"""Signed distance primitives and the operators that blend them.

Every field takes points ``(N, 3)`` in millimetres and gives ``(N,)`` signed distances in
millimetres, negative inside.  Ellipsoids and blends are first-order distances: the zero set is
exact, the values away from it are bounds good enough for marching cubes and Newton steps.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import CubicSpline

Array = NDArray[np.float64]
Field = Callable[[Array], Array]


def smooth_union(a: Array, b: Array, width_mm: float) -> Array:
    """Union of two fields with a fillet about ``width_mm`` wide (polynomial blend)."""
    h = np.maximum(width_mm - np.abs(a - b), 0.0)
    return np.asarray(np.minimum(a, b) - h * h * (0.25 / width_mm))


def smooth_intersection(a: Array, b: Array, width_mm: float) -> Array:
    """Intersection of two fields with a rounded edge about ``width_mm`` wide."""
    return -smooth_union(-a, -b, width_mm)


def smooth_subtraction(a: Array, b: Array, width_mm: float) -> Array:
    """Take ``b`` away from ``a``, the rim rounded over about ``width_mm``."""
    return -smooth_union(-a, b, width_mm)


def rotation(x_deg: float = 0.0, y_deg: float = 0.0, z_deg: float = 0.0) -> Array:
    """Rotation matrix ``(3, 3)``: first about X, then Y, then Z, angles in degrees."""
    cx, cy, cz = np.cos(np.radians([x_deg, y_deg, z_deg]))
    sx, sy, sz = np.sin(np.radians([x_deg, y_deg, z_deg]))
    rx = np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]])
    ry = np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
    rz = np.array([[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]])
    return np.asarray(rz @ ry @ rx)


def ellipsoid(
    p: Array, centre_mm: ArrayLike, radii_mm: ArrayLike, turn: Array | None = None
) -> Array:
    """Ellipsoid with semi-axes ``radii_mm``, its axes turned by the matrix ``turn``."""
    q = p - np.asarray(centre_mm, dtype=np.float64)
    if turn is not None:
        q = q @ turn
    r = np.asarray(radii_mm, dtype=np.float64)
    k0 = np.sqrt(np.sum((q / r) ** 2, axis=1))
    k1 = np.sqrt(np.sum((q / (r * r)) ** 2, axis=1))
    return np.asarray(np.where(k1 > 1e-9, k0 * (k0 - 1.0) / np.maximum(k1, 1e-9), -r.min()))


def sphere(p: Array, centre_mm: ArrayLike, radius_mm: float) -> Array:
    """Sphere."""
    return np.asarray(np.linalg.norm(p - np.asarray(centre_mm), axis=1) - radius_mm)


def round_cone(
    p: Array, a_mm: ArrayLike, b_mm: ArrayLike, radius_a_mm: float, radius_b_mm: float
) -> Array:
    """Capsule whose radius goes linearly from ``radius_a_mm`` at A to ``radius_b_mm`` at B."""
    a, b = np.asarray(a_mm, dtype=np.float64), np.asarray(b_mm, dtype=np.float64)
    axis = b - a
    t = np.clip((p - a) @ axis / (axis @ axis), 0.0, 1.0)
    gap = np.linalg.norm(p - a - t[:, None] * axis, axis=1)
    return np.asarray(gap - (radius_a_mm + (radius_b_mm - radius_a_mm) * t))


def spline(knots: ArrayLike, samples: int, *, closed: bool = False) -> Array:
    """Sample a cubic spline through ``knots`` ``(K, D)`` at ``samples`` points ``(samples, D)``.

    The parameter is centripetal, so that unevenly spaced knots do not overshoot.
    """
    k = np.asarray(knots, dtype=np.float64)
    if closed:
        k = np.concatenate([k, k[:1]])
    chord = np.linalg.norm(np.diff(k[:, :3], axis=0), axis=1)
    t = np.concatenate([[0.0], np.cumsum(np.sqrt(chord))])
    curve = CubicSpline(t, k, bc_type="periodic" if closed else "natural")
    return np.asarray(curve(np.linspace(0.0, t[-1], samples, endpoint=not closed)))


def along(points: Array, polyline: Array) -> tuple[Array, Array]:
    """Distance ``(N,)`` to a polyline ``(K, D)`` and the parameter 0..1 ``(N,)`` of its foot."""
    best = np.full(len(points), np.inf)
    where = np.zeros(len(points))
    n = len(polyline) - 1
    for i in range(n):
        a, axis = polyline[i], polyline[i + 1] - polyline[i]
        q = points - a
        t = np.clip(q @ axis / max(float(axis @ axis), 1e-12), 0.0, 1.0)
        d = np.sum((q - t[:, None] * axis) ** 2, axis=1)
        nearer = d < best
        best = np.where(nearer, d, best)
        where = np.where(nearer, (i + t) / n, where)
    return np.sqrt(best), where


def sweep(p: Array, knots_mm: ArrayLike, radii_mm: Sequence[float], samples: int = 24) -> Array:
    """Tube along a spline through ``knots_mm`` ``(K, 3)`` with radii given at the knots."""
    table = np.column_stack([np.asarray(knots_mm, dtype=np.float64), np.asarray(radii_mm)])
    curve = spline(table, samples)
    gap, where = along(p, curve[:, :3])
    radius = np.interp(where, np.linspace(0.0, 1.0, samples), curve[:, 3])
    return np.asarray(gap - radius)


def polygon(points: Array, outline: Array) -> Array:
    """Signed distance ``(N,)`` in the plane to a closed polygon ``(K, 2)``, negative inside."""
    gap, _ = along(points, np.concatenate([outline, outline[:1]]))
    inside = np.zeros(len(points), dtype=bool)
    x, y = points[:, 0], points[:, 1]
    for a, b in zip(outline, np.roll(outline, -1, axis=0), strict=True):
        crosses = (a[1] > y) != (b[1] > y)
        rise = b[1] - a[1] if b[1] != a[1] else 1.0
        inside ^= crosses & (x < (b[0] - a[0]) * (y - a[1]) / rise + a[0])
    return np.where(inside, -gap, gap)


def bump(distance: Array, width_mm: float) -> Array:
    """Gaussian of a distance: 1 at zero, ``exp(-1/2)`` at ``width_mm``."""
    return np.asarray(np.exp(-0.5 * (distance / width_mm) ** 2))


def ramp(value: Array, low: float, high: float) -> Array:
    """Smoothstep from 0 at ``low`` to 1 at ``high`` (``low > high`` gives a falling step)."""
    t = np.clip((value - low) / (high - low), 0.0, 1.0)
    return np.asarray(t * t * (3.0 - 2.0 * t))


def within(p: Array, low_mm: ArrayLike, high_mm: ArrayLike) -> NDArray[np.bool_]:
    """Which points ``(N,)`` lie in an axis-aligned box."""
    return np.asarray(np.all((p > np.asarray(low_mm)) & (p < np.asarray(high_mm)), axis=1))
