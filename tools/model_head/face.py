"""Nose, closed eyes, lips and soft relief of the face, added to the large forms."""

from __future__ import annotations

import numpy as np

from .fields import (
    Array,
    along,
    bump,
    ellipsoid,
    ramp,
    rotation,
    round_cone,
    smooth_subtraction,
    smooth_union,
    spline,
    sweep,
    within,
)

PUPIL_X_MM = 31.5


def _both(p: Array) -> Array:
    """Return points mirrored to the +X half, smoothly at X = 0, where a crease would be visible."""
    s = p.copy()
    s[:, 0] = np.sqrt(p[:, 0] ** 2 + 0.25)
    return s


def relief_mm(p: Array) -> Array:
    """Return the outward displacement of 1-4 mm by muscle, fat and bone."""
    x, y, z = np.abs(p[:, 0]), p[:, 1], p[:, 2]
    front = ramp(z, 20.0, 50.0)

    def spot(cx: float, cy: float, wx: float, wy: float, turn_deg: float = 0.0) -> Array:
        c, s = np.cos(np.radians(turn_deg)), np.sin(np.radians(turn_deg))
        out = np.zeros(len(p))
        for sign in (1.0, -1.0):
            dx, dy = sign * p[:, 0] - cx, y - cy
            u, v = c * dx + s * dy, -s * dx + c * dy
            out += np.exp(-0.5 * ((u / wx) ** 2 + (v / wy) ** 2))
        return out

    h = 1.3 * spot(20, 22, 11, 4.5, 12)  # superciliary arch
    h += 1.0 * spot(47, 17, 7, 5, -35)  # outer orbital rim
    h -= 0.7 * spot(0, 15, 4, 4) * 0.5
    h += 2.0 * spot(49, -18, 11, 7.5, -25)  # cheekbone
    h -= 0.9 * spot(24, -15, 9, 3.0, -22)  # tear trough
    h += 0.9 * spot(30, -9, 10, 3.5, 0)  # lower lid pad
    h += 1.5 * spot(29, -36, 8, 9, 0)  # cheek pad beside the nose
    h -= 1.9 * spot(29.5, -54, 3.6, 11, -28)  # nasolabial fold
    h += 0.8 * spot(36, -57, 6, 9, -25)
    h -= 0.9 * spot(31, -76, 3.5, 6, -10)  # beside the mouth corner
    h -= 1.5 * spot(47, -52, 9, 13, -20)  # hollow under the cheekbone
    h += 0.9 * spot(8, -101, 8.5, 7)  # chin
    h -= 1.1 * spot(0, -86.5, 11, 3.0) * 0.5  # mentolabial sulcus
    h -= 0.7 * spot(22, -92, 6, 7, 30)
    h += 1.2 * spot(24, 62, 14, 11) * 0.6  # frontal eminence
    return h * front * ramp(x + z, 10, 40)


def _nose_core(p: Array) -> Array:
    s = _both(p)
    body = round_cone(p, (0, 8, 80.5), (0, -36, 93), 7.0, 13.0)
    ridge = sweep(
        p,
        [(0, 12, 85.5), (0, 3, 85), (0, -10, 90), (0, -22, 97.5), (0, -31, 103.5)],
        [5.0, 4.2, 4.8, 5.6, 6.2],
    )
    out = smooth_union(body, ridge, 7.0)
    tip = ellipsoid(s, (2.9, -36.0, 105.8), (7.5, 7.2, 8.4))
    out = smooth_union(out, tip, 8.0)
    ala = ellipsoid(s, (11.0, -40.6, 97.2), (6.8, 6.8, 10.4), rotation(12, -18, -6))
    out = smooth_union(out, ala, 5.0)
    lobule = round_cone(p, (0, -43.0, 107.0), (0, -46.5, 97.0), 3.4, 3.4)
    return smooth_union(out, lobule, 3.0)


def _nostrils(p: Array) -> Array:
    s = _both(p)
    mouth = ellipsoid(s, (8.6, -47.5, 100.5), (4.6, 6.4, 6.4), rotation(0, -20, -6))
    depth = round_cone(s, (9.0, -42.0, 100.5), (5.5, -31.0, 95.5), 4.6, 2.2)
    return smooth_union(mouth, depth, 3.0)


def add_nose(f: Array, p: Array) -> Array:
    """Return the union of face and nose, without the nostrils, whose walls are 2-4 mm thick."""
    near = within(p, (-45, -75, 50), (45, 40, 140))
    q = p[near]
    s = _both(q)
    blend = 7.0 + 5.0 * ramp(q[:, 1], -40.0, -10.0)
    g = f[near]
    h = np.maximum(blend - np.abs(g - _nose_core(q)), 0.0)
    g = np.minimum(g, _nose_core(q)) - h * h * (0.25 / blend)
    groove = sweep(
        s,
        [(14.5, -33, 99), (18.4, -37.5, 94.5), (19.3, -43, 90.5), (16.5, -47.5, 91.5)],
        [0.1, 0.7, 1.0, 0.4],
    )
    g = smooth_subtraction(g, groove, 4.0)
    crease = spline(
        [
            (19.6, -43, 90.5),
            (18.6, -37.5, 94.5),
            (15, -33.3, 99),
            (11.6, -32.6, 103.8),
            (10.6, -36.5, 107),
            (10.4, -42, 107.5),
        ],
        28,
    )
    gap, parameter = along(s, crease)
    g = g + 1.35 * bump(gap, 1.6) * np.sin(np.pi * np.clip(parameter, 0.0, 1.0)) ** 0.6
    g = smooth_subtraction(g, _nostrils(q), 1.6)
    out = f.copy()
    out[near] = g
    return out


def lash_height_mm(x: Array) -> Array:
    """Return the height ``y`` of the line of the closed lids at a distance ``x`` from the midline."""
    t = (x - PUPIL_X_MM) / 14.8
    return np.asarray(-5.6 + 4.3 * t**2 + 0.7 * t + 0.3 * t**3)


def fold_height_mm(x: Array) -> Array:
    """Return the height ``y`` of the fold of the upper lid at a distance ``x`` from the midline."""
    t = (x - PUPIL_X_MM) / 16.0
    return np.asarray(7.2 - 5.0 * t**2 + 0.2 * t)


def add_eyes(f: Array, p: Array) -> Array:
    """Return the face with eyeballs under closed lids."""
    near = within(p, (-60, -30, 40), (60, 35, 100))
    q = p[near]
    s = _both(q)
    x, y = s[:, 0], s[:, 1]
    g = f[near]
    ball = ellipsoid(s, (PUPIL_X_MM - 0.3, -0.8, 64.6), (15.4, 13.6, 13.4), rotation(0, 14, 0))
    g = smooth_union(g, ball, 7.0)
    t = (x - PUPIL_X_MM) / 15.2
    along_line = ramp(np.abs(t), 1.12, 0.85)
    d = y - lash_height_mm(x)
    upper = np.exp(-np.maximum(d, 0.0) / 3.2)
    step = ramp(d, -0.8, 0.8) * upper * 0.85
    crease = bump(d + 0.5, 1.1) * 0.55
    lower = bump(d + 3.0, 1.5) * 0.35
    h = (step - crease + lower) * along_line
    fold = y - fold_height_mm(x)
    fold_on = ramp(np.abs((x - PUPIL_X_MM) / 16.0), 1.12, 0.75)
    h += (-0.8 * bump(fold, 0.9) + 0.7 * bump(fold - 2.6, 1.9)) * fold_on
    under = y - (-13.0 + 4.2 * ((x - 29.0) / 15.0) ** 2)
    h -= 0.45 * bump(under, 1.2) * ramp(np.abs((x - 27.0) / 15.0), 1.1, 0.5)
    h -= 0.8 * bump(np.hypot(x - 15.6, (y + 3.2) * 1.2), 1.6)  # inner corner
    g = g - h
    out = f.copy()
    out[near] = g
    return out


def lip_curves_mm(x: Array) -> tuple[Array, Array, Array]:
    """Return the heights of the upper border, the mouth line and the lower border at ``|x|``."""
    t = np.clip(np.abs(x) / 25.5, 0.0, 1.0)
    line = -69.0 - 0.9 * bump(t, 0.16) + 0.7 * bump(t - 0.32, 0.14) - 0.8 * t**3
    open_up = np.maximum(1.0 - t**1.7, 0.0) ** 0.8
    upper = line + 7.0 * open_up * (1.0 - 0.16 * bump(t, 0.1) + 0.06 * bump(t - 0.22, 0.1))
    open_down = np.maximum(1.0 - t**2.2, 0.0) ** 0.7
    lower = line - 9.0 * open_down
    return upper, line, lower


def add_lips(f: Array, p: Array) -> Array:
    """Return the face with lips, philtrum and the line of the mouth."""
    near = within(p, (-45, -100, 55), (45, -40, 125))
    q = p[near]
    x, y = np.sqrt(q[:, 0] ** 2 + 0.25), q[:, 1]
    upper, line, lower = lip_curves_mm(x)
    t = np.clip(x / 25.5, 0.0, 1.3)
    fade = ramp(t, 1.06, 0.8)
    g = f[near]
    # Bodies of the lips: tubes that are thicker in the middle.
    high = sweep(
        np.column_stack([x, y, q[:, 2]]),
        [(0, -66.0, 93.6), (6, -65.4, 93.3), (13, -66.4, 89.9), (20, -68.3, 85.2), (25, -69.6, 80)],
        [4.5, 4.3, 3.6, 2.5, 1.0],
    )
    low = sweep(
        np.column_stack([x, y, q[:, 2]]),
        [(0, -74.4, 92.6), (7, -74.2, 92.0), (14, -73.2, 88.6), (20, -71.6, 84.6), (25, -70, 79.6)],
        [5.7, 5.5, 4.4, 2.7, 1.0],
    )
    g = smooth_union(g, high, 9.0)
    g = smooth_union(g, low, 6.0)
    h = -1.25 * bump(y - line, 0.95) * ramp(t, 1.08, 0.8)
    h -= 0.7 * bump(y - line, 2.2) * fade
    h += 0.45 * bump(y - upper, 0.9) * fade  # white roll
    h += 0.25 * bump(y - lower, 1.0) * fade
    h += 0.5 * bump(np.hypot(x / 1.3, y + 67.0), 2.4)  # tubercle
    h -= 1.1 * bump(np.hypot((x - 27.0) / 1.0, (y + 70.2) / 1.2), 2.3)  # corner
    philtrum = ramp(y, -63.0, -59.0) * ramp(y, -46.0, -50.0)
    h += (-1.1 * bump(x, 2.4) + 0.75 * bump(x - 5.3, 1.7)) * philtrum
    out = f.copy()
    out[near] = g - h
    return out
