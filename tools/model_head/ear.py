"""Outer ear: a thin bent sheet.

In the frame of the ear, ``u`` points backwards, ``v`` up along the ear, and ``w`` out of its plane. The
cartilage is a sheet of 2.6-4 mm about a height ``w = m(u, v)`` within an outline in ``(u, v)``. The rim
(helix) and the tragus are tubes on top of it.
"""

from __future__ import annotations

import numpy as np

from .fields import (
    Array,
    along,
    bump,
    ellipsoid,
    polygon,
    ramp,
    round_cone,
    smooth_intersection,
    smooth_subtraction,
    smooth_union,
    spline,
    sweep,
    within,
)

ORIGIN_MM = np.array([69.5, -7.0, -3.0])
TILT_DEG = 13.0
STAND_OFF_DEG = 27.0

_OUTLINE = [
    (-2, -24),
    (1.5, -29.5),
    (6, -31.5),
    (11, -30),
    (15, -25.5),
    (20, -18.5),
    (26.5, -9),
    (30.5, 2),
    (31, 13),
    (27.5, 23),
    (20, 29),
    (11, 30.3),
    (3.5, 26.5),
    (-0.5, 19),
    (-2.5, 9),
    (-4, -2),
    (-4, -13),
]
_RIM = [
    (9.0, -3.5, -6.0),
    (4.0, 2.5, -1.8),
    (0.8, 11, 1.8),
    (2.3, 21, 2.8),
    (8.5, 27, 2.8),
    (18.0, 26.6, 2.6),
    (25.6, 20.6, 2.6),
    (28.6, 11.5, 2.6),
    (28.0, 1.5, 2.4),
    (24.5, -8, 2.2),
    (19.0, -16.5, 1.6),
    (14.5, -22.5, 1.0),
]
_RIM_RADIUS = [0.8, 1.4, 2.0, 2.3, 2.4, 2.4, 2.4, 2.3, 2.2, 2.0, 1.6, 1.0]
_ANTIHELIX = [(10, -17.5), (15.5, -14), (20.2, -7), (21.2, 1.5), (19.5, 9.5), (16, 16.5), (13, 22)]
_LOWER_CRUS = [(20.0, 6.5), (15.5, 11.2), (10.0, 13.2), (5.0, 13.4)]
_CONCHA = [(4.5, -9.5), (9.0, -8.5), (12.3, -3.0), (12.3, 2.5), (8.5, 6.5)]


def frame() -> Array:
    """Return the axes ``u, v, w`` of the left ear in head coordinates, the rows of a ``(3, 3)`` matrix."""
    tilt, off = np.radians(TILT_DEG), np.radians(STAND_OFF_DEG)
    back = np.array([0.0, -np.sin(tilt), -np.cos(tilt)])
    v = np.array([0.0, np.cos(tilt), -np.sin(tilt)])
    side = np.array([1.0, 0.0, 0.0])
    u = np.cos(off) * back + np.sin(off) * side
    w = np.cos(off) * side - np.sin(off) * back
    return np.stack([u, v, w])


def to_ear(p: Array) -> Array:
    """Return ear coordinates ``(N, 3)`` of points ``(N, 3)`` on either side of the head, mm."""
    s = p.copy()
    s[:, 0] = np.abs(p[:, 0])
    return np.asarray((s - ORIGIN_MM) @ frame().T)


def _height_mm(uv: Array) -> Array:
    """Return the height ``w`` of the middle of the sheet, mm."""
    u, v = uv[:, 0], uv[:, 1]
    anti, parameter = along(uv, spline(_ANTIHELIX, 30))
    crus, _ = along(uv, np.asarray(_LOWER_CRUS, dtype=np.float64))
    bowl, _ = along(uv, np.asarray(_CONCHA, dtype=np.float64))
    m = 0.055 * np.maximum(u - 8.0, 0.0) - 0.0025 * np.maximum(u - 8.0, 0.0) ** 2
    m += 3.4 * bump(anti, 3.2) * (0.75 + 0.25 * np.cos(2.0 * (parameter - 0.35)))
    m += 2.0 * bump(crus, 2.4) * ramp(u, 3.0, 8.0)
    m -= 10.0 * ramp(bowl, 10.2, 1.5) * ramp(anti, 0.0, 6.5)
    m -= 2.8 * bump(np.hypot(u - 10.0, (v - 18.5) * 1.25), 3.6)  # triangular fossa
    m -= 1.2 * ramp(v, -19.0, -28.0)
    return np.asarray(m)


def ear(p: Array) -> Array:
    """Return the distance to the ears alone; points of both sides are mapped onto one ear."""
    e = to_ear(p)
    uv = e[:, :2]
    outline = spline(_OUTLINE, 72, closed=True)
    inside = polygon(uv, outline)
    middle = _height_mm(uv)
    slope = 1e-2
    du = (_height_mm(uv + np.array([slope, 0.0])) - middle) / slope
    dv = (_height_mm(uv + np.array([0.0, slope])) - middle) / slope
    steep = np.sqrt(1.0 + np.minimum(du * du + dv * dv, 9.0))
    half = 1.35 + 0.9 * ramp(uv[:, 1], -15.0, -24.0)
    sheet = np.abs(e[:, 2] - middle) / steep - half
    body = smooth_intersection(sheet, inside + 0.6, 1.6)
    rim = sweep(e, _RIM, _RIM_RADIUS, samples=48)
    body = smooth_union(body, rim, 2.0)
    tragus = sweep(
        e,
        [(-4.0, 2.5, -2.0), (0.0, -3.5, 1.4), (1.6, -8.5, 2.2), (0.5, -13.5, 0.6)],
        [2.0, 2.1, 2.2, 1.6],
    )
    body = smooth_union(body, tragus, 3.0)
    antitragus = round_cone(e, (8.5, -17.5, 2.2), (12.0, -14.8, 2.6), 1.9, 1.7)
    body = smooth_union(body, antitragus, 3.0)
    lobe = round_cone(e, (4.5, -24.5, 0.0), (9.5, -24.0, 0.2), 2.4, 2.2)
    return smooth_union(body, lobe, 5.0)


def add_ears(f: Array, p: Array) -> Array:
    """Return the union of the head and both ears; the gap behind the ears stays open."""
    near = within(p * [0, 1, 1] + np.abs(p) * [1, 0, 0], (52, -50, -55), (112, 42, 25))
    out = f.copy()
    q = p[near]
    e = to_ear(q)
    bowl = ellipsoid(e, (8.0, -3.0, -0.5), (8.6, 12.5, 8.2))
    canal = round_cone(e, (3.5, -5.5, -5.0), (-3.0, -4.0, -17.0), 3.6, 2.4)
    hollow = smooth_union(bowl, canal, 3.0)
    out[near] = smooth_union(smooth_subtraction(f[near], hollow, 2.5), ear(q), 3.0)
    return out
