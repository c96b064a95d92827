"""Nose, closed eyes, lips and the soft relief of the face, laid over the large forms."""

from __future__ import annotations

import numpy as np

from .fields import (
    Array,
    bump,
    ellipsoid,
    ramp,
    rotation,
    round_cone,
    smooth_subtraction,
    smooth_union,
    sphere,
    spline,
    sweep,
    within,
)

PUPIL_X_MM = 31.5


def _both(p: Array) -> Array:
    """Points folded onto the +X half, with a soft fold so that no crease shows at X = 0."""
    s = p.copy()
    s[:, 0] = np.sqrt(p[:, 0] ** 2 + 0.25)
    return s


def relief_mm(p: Array) -> Array:
    """Outward displacement of the base: muscle, fat and bone forms of 1-4 mm."""
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
    h += 1.4 * spot(48, -18, 10, 7, -25)  # cheekbone
    h -= 0.9 * spot(24, -15, 9, 3.0, -22)  # tear trough
    h += 0.9 * spot(30, -9, 10, 3.5, 0)  # lower lid pad
    h += 1.3 * spot(29, -36, 8, 9, 0)  # cheek pad beside the nose
    h -= 1.5 * spot(29.5, -54, 3.6, 11, -28)  # nasolabial fold
    h += 0.8 * spot(36, -57, 6, 9, -25)
    h -= 0.9 * spot(31, -76, 3.5, 6, -10)  # beside the mouth corner
    h -= 1.0 * spot(47, -52, 9, 12, -20)  # hollow under the cheekbone
    h += 1.4 * spot(9, -101, 7.5, 7) * 0.9  # chin
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
    tip = sphere(s, (2.6, -36.0, 106.6), 7.6)
    out = smooth_union(out, tip, 6.0)
    ala = ellipsoid(s, (11.2, -40.8, 96.5), (6.6, 6.6, 9.8), rotation(12, -16, -6))
    out = smooth_union(out, ala, 3.5)
    lobule = round_cone(p, (0, -43.0, 107.0), (0, -46.5, 97.0), 3.4, 3.4)
    return smooth_union(out, lobule, 3.0)


def _nostrils(p: Array) -> Array:
    s = _both(p)
    mouth = ellipsoid(s, (7.4, -47.5, 101.0), (3.3, 6.0, 6.0), rotation(0, -20, -6))
    depth = round_cone(s, (7.2, -42.5, 101.5), (5.5, -31.0, 95.5), 3.5, 2.2)
    return smooth_union(mouth, depth, 3.0)


def add_nose(f: Array, p: Array) -> Array:
    """Fuse the nose with the face, then hollow the nostrils (walls of 2-4 mm)."""
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
        [0.3, 1.1, 1.3, 0.6],
    )
    g = smooth_subtraction(g, groove, 3.4)
    facet = sweep(s, [(8.5, -30.5, 107.5), (11.5, -36, 106), (12.6, -42, 104.5)], [0.3, 0.5, 0.3])
    g = smooth_subtraction(g, facet, 4.0)
    g = smooth_subtraction(g, _nostrils(q), 1.6)
    out = f.copy()
    out[near] = g
    return out


def lash_height_mm(x: Array) -> Array:
    """Height ``y`` of the closed lid line at a distance ``x`` from the midline."""
    t = (x - PUPIL_X_MM) / 14.8
    return np.asarray(-5.6 + 4.3 * t**2 + 0.7 * t + 0.3 * t**3)


def fold_height_mm(x: Array) -> Array:
    """Height ``y`` of the fold of the upper lid."""
    t = (x - PUPIL_X_MM) / 16.0
    return np.asarray(9.0 - 6.2 * t**2 + 0.4 * t)


def add_eyes(f: Array, p: Array) -> Array:
    """Closed lids over the eyeballs."""
    near = within(p, (-60, -30, 40), (60, 35, 100))
    q = p[near]
    s = _both(q)
    x, y = s[:, 0], s[:, 1]
    g = f[near]
    ball = ellipsoid(s, (PUPIL_X_MM - 0.3, -0.8, 64.6), (15.2, 13.4, 13.8), rotation(0, 14, 0))
    g = smooth_union(g, ball, 5.0)
    t = (x - PUPIL_X_MM) / 15.2
    along_line = ramp(np.abs(t), 1.12, 0.85)
    d = y - lash_height_mm(x)
    upper = np.where(d > 0.0, np.exp(-np.maximum(d, 0.0) / 3.2), 0.0)
    step = ramp(d, -0.35, 0.35) * upper * 0.95
    crease = bump(d + 0.35, 0.55) * 1.15
    lower = bump(d + 3.0, 1.5) * 0.35
    h = (step - crease + lower) * along_line
    fold = y - fold_height_mm(x)
    fold_on = ramp(np.abs((x - PUPIL_X_MM) / 16.0), 1.12, 0.75)
    h += (-0.95 * bump(fold, 0.85) + 0.55 * bump(fold - 2.4, 1.6)) * fold_on
    under = y - (-13.0 + 4.2 * ((x - 29.0) / 15.0) ** 2)
    h -= 0.45 * bump(under, 1.2) * ramp(np.abs((x - 27.0) / 15.0), 1.1, 0.5)
    h -= 0.8 * bump(np.hypot(x - 15.6, (y + 3.2) * 1.2), 1.6)  # inner corner
    g = g - h
    out = f.copy()
    out[near] = g
    return out


def lip_curves_mm(x: Array) -> tuple[Array, Array, Array]:
    """Heights of the upper border, the mouth line and the lower border at ``|x|``."""
    t = np.clip(np.abs(x) / 25.5, 0.0, 1.0)
    line = -69.0 - 0.9 * bump(t, 0.16) + 0.7 * bump(t - 0.32, 0.14) - 0.8 * t**3
    open_up = np.sqrt(np.maximum(1.0 - t**1.7, 0.0))
    upper = line + 7.6 * open_up * (1.0 - 0.16 * bump(t, 0.1) + 0.06 * bump(t - 0.22, 0.1))
    open_down = np.sqrt(np.maximum(1.0 - t**2.2, 0.0))
    lower = line - 9.2 * open_down
    return upper, line, lower


def add_lips(f: Array, p: Array) -> Array:
    """Lips, philtrum and the line of the mouth."""
    near = within(p, (-45, -100, 55), (45, -40, 125))
    q = p[near]
    x, y = np.sqrt(q[:, 0] ** 2 + 0.25), q[:, 1]
    upper, line, lower = lip_curves_mm(x)
    t = np.clip(x / 25.5, 0.0, 1.3)
    fade = ramp(t, 1.06, 0.8)
    g = f[near]
    # Bodies of the lips: tubes that swell towards the middle.
    high = sweep(
        np.column_stack([x, y, q[:, 2]]),
        [(0, -65.8, 94.6), (6, -65.2, 94.4), (13, -66.3, 90.6), (20, -68.3, 85.6), (25, -69.6, 80)],
        [4.6, 4.4, 3.7, 2.6, 1.2],
    )
    low = sweep(
        np.column_stack([x, y, q[:, 2]]),
        [(0, -74.4, 92.6), (7, -74.2, 92.0), (14, -73.2, 88.6), (20, -71.6, 84.6), (25, -70, 79.6)],
        [5.6, 5.5, 4.5, 2.9, 1.2],
    )
    g = smooth_union(g, high, 5.0)
    g = smooth_union(g, low, 5.0)
    h = -2.0 * bump(y - line, 0.85) * ramp(t, 1.1, 0.95)
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
