"""Large forms: cranium, face and jaw as one star-shaped surface, and the neck.

The star-shaped surface is a radius over directions from the middle of the head: a thin-plate spline
through half contours, which were drawn by hand to published averages of adult heads (length 195 mm,
breadth 152 mm, bizygomatic breadth 138 mm, bigonial breadth 108 mm, face height from nasion to menton
120 mm, eye line at half the height).
"""

from __future__ import annotations

from functools import cache

import numpy as np
from scipy.interpolate import RBFInterpolator
from scipy.ndimage import map_coordinates, spline_filter

from .fields import Array, ellipsoid, ramp, round_cone, smooth_union, sweep

# Midline without the nose: height y and depth z, mm; the face looks along +Z.
MIDLINE_MM = [
    (116, -10),
    (114.5, 12),
    (110, 33),
    (102, 53),
    (91, 69),
    (77, 81.5),
    (62, 89),
    (45, 93.3),
    (30, 95.8),
    (20, 96.2),
    (10, 91.5),
    (2, 88),
    (-12, 87),
    (-26, 88),
    (-38, 91.5),
    (-47, 95.8),
    (-56, 97.2),
    (-63, 97.6),
    (-69, 96.6),
    (-76, 94.6),
    (-84, 91.3),
    (-90, 91.5),
    (-99, 93.8),
    (-106, 93),
    (-112, 88),
    (-115.5, 79),
    (-116, 66),
    (-114, 50),
    (-108, 30),
    (114.5, -32),
    (107, -56),
    (93, -77),
    (73, -91),
    (48, -97.5),
    (22, -98),
    (0, -93),
    (-20, -83),
    (-42, -70),
    (-70, -45),
]

# Half contours at heights y: (x, z) from near the midline of the face to the back, mm.
CONTOURS_MM: dict[int, list[tuple[float, float]]] = {
    110: [(12, 32), (24, 22), (31, 4), (33, -14), (28, -34), (15, -47)],
    98: [(18, 56), (34, 46), (45, 29), (51.5, 6), (53, -20), (43, -48), (22, -66)],
    80: [(20, 76), (37, 66), (49, 51), (58, 31), (64, 6), (66, -22), (58.5, -53), (39, -76)],
    60: [
        (18, 87.5),
        (35, 80),
        (48, 67),
        (57, 50),
        (64, 27),
        (70, 2),
        (73.5, -24),
        (68, -56),
        (46, -83),
    ],
    40: [
        (15, 92.6),
        (30, 88),
        (43, 79),
        (52.5, 66),
        (58.5, 51),
        (64.5, 29),
        (71, 5),
        (76, -22),
        (72.5, -52),
        (50, -84),
    ],
    25: [
        (10, 95.2),
        (22, 92.8),
        (34, 87.5),
        (44, 79.5),
        (52, 69.5),
        (57.5, 57),
        (62, 42),
        (67, 22),
        (73, -8),
        (75.5, -24),
        (71.5, -52),
        (49, -84),
    ],
    15: [
        (8, 92.8),
        (16, 88),
        (25, 85.5),
        (34, 83.5),
        (43, 78.5),
        (51, 70.5),
        (57.5, 58),
        (62, 45),
        (67, 22),
        (73, -10),
        (74.5, -26),
        (70, -52),
        (48, -83),
    ],
    7: [
        (8, 87),
        (15, 79.5),
        (23, 77.5),
        (32, 76.5),
        (41, 73),
        (49, 67),
        (56.5, 57),
        (62, 45),
        (67.5, 23),
    ],
    0: [
        (8, 84),
        (14, 76),
        (22, 73.5),
        (31, 73),
        (40, 70),
        (48, 64.5),
        (56, 56),
        (62, 45),
        (68, 24),
        (71, 0),
        (73, -22),
        (69.5, -49),
        (46, -81),
    ],
    -12: [
        (8, 84.5),
        (15, 78.5),
        (23, 76.5),
        (32, 75.5),
        (41, 72.5),
        (49, 67.5),
        (57, 58.5),
        (63, 47.5),
        (68, 32),
        (70.5, 14),
        (71, -6),
        (70, -30),
        (58, -58),
        (38, -76),
    ],
    -25: [
        (9, 86),
        (17, 82),
        (26, 79.5),
        (36, 76),
        (46, 70),
        (54.5, 61),
        (61.5, 49),
        (66, 33),
        (68.5, 14),
        (69, -6),
        (66, -30),
        (52, -54),
    ],
    -40: [
        (10, 90.5),
        (18, 87),
        (27, 81.5),
        (37, 74.5),
        (46.5, 65),
        (54.5, 54),
        (60, 41.5),
        (64, 25),
        (65.5, 8),
        (64, -12),
        (54, -38),
    ],
    -55: [
        (9, 95.3),
        (17, 91.3),
        (25, 85),
        (34.5, 76.5),
        (44, 64),
        (52, 50),
        (57.5, 36),
        (61, 20),
        (61, 4),
        (57, -14),
    ],
    -69: [
        (9, 95.3),
        (17, 91),
        (25, 84),
        (33.5, 75),
        (42, 62),
        (49, 48),
        (54.5, 34),
        (57.5, 19),
        (57, 5),
        (51, -10),
    ],
    -85: [(9, 90.3), (19, 85.5), (28, 76), (36, 64), (43, 50), (49, 35), (52, 20), (49, 7)],
    -99: [
        (8, 93.3),
        (15.5, 89.5),
        (23, 81.5),
        (28.8, 70.3),
        (35.3, 57),
        (40.2, 43.5),
        (41.5, 30),
        (37, 16),
    ],
    -108: [(8, 91.5), (15, 87.5), (21.3, 79), (27, 67.5), (31, 54), (31.5, 40)],
    -114: [(7, 83.5), (13, 78.5), (17, 69), (17, 56)],
}

_CENTRE_MM = np.array([0.0, 0.0, 0.0])
_STEPS = (361, 181)


@cache
def _radius_table_mm() -> Array:
    """Return the radius over azimuth (-180..180°, from +Z) and elevation (-90..90°), one sample a degree."""
    half = [(0.0, y, z) for y, z in MIDLINE_MM]
    half += [(x, y, z) for y, row in CONTOURS_MM.items() for x, z in row]
    points = np.array(half, dtype=np.float64)
    mirrored = points[points[:, 0] > 0.0] * np.array([-1.0, 1.0, 1.0])
    points = np.concatenate([points, mirrored]) - _CENTRE_MM
    radius = np.linalg.norm(points, axis=1)
    fit = RBFInterpolator(
        points / radius[:, None], radius, kernel="thin_plate_spline", smoothing=2e-4
    )
    azimuth, elevation = np.meshgrid(
        np.linspace(-np.pi, np.pi, _STEPS[0]),
        np.linspace(-np.pi / 2, np.pi / 2, _STEPS[1]),
        indexing="ij",
    )
    rays = np.stack(
        [
            np.sin(azimuth) * np.cos(elevation),
            np.sin(elevation),
            np.cos(azimuth) * np.cos(elevation),
        ],
        axis=-1,
    )
    return np.asarray(spline_filter(fit(rays.reshape(-1, 3)).reshape(_STEPS), mode="nearest"))


def mask(p: Array) -> Array:
    """Return the distance to cranium, face and jaw, without nose, lids, lips and ears."""
    q = p - _CENTRE_MM
    radius = np.linalg.norm(q, axis=1)
    azimuth = np.arctan2(q[:, 0], q[:, 2])
    elevation = np.arcsin(np.clip(q[:, 1] / np.maximum(radius, 1e-9), -1.0, 1.0))
    coordinates = np.stack(
        [
            (azimuth / (2 * np.pi) + 0.5) * (_STEPS[0] - 1),
            (elevation / np.pi + 0.5) * (_STEPS[1] - 1),
        ]
    )
    table = map_coordinates(
        _radius_table_mm(), coordinates, order=3, mode="nearest", prefilter=False
    )
    return np.asarray(radius - table)


def neck(p: Array) -> Array:
    """Return the distance to the neck with its muscles, the larynx, and the upper shoulders."""
    s = p * np.array([1.0, 1.0, 1.0])
    s[:, 0] = np.sqrt(p[:, 0] ** 2 + 4.0)
    # A column of ellipses whose centres lie further forward the higher they are.
    y = p[:, 1]
    lift = np.clip((y + 190.0) / 110.0, -0.5, 1.4)
    middle_z = -34.0 + 16.0 * lift
    half_x = 53.0 - 1.0 * lift + 9.0 * np.clip(-lift + 0.25, 0, 1) ** 2 * 4
    half_z = 54.0 - 3.0 * lift
    dz = p[:, 2] - middle_z
    k = np.sqrt((p[:, 0] / half_x) ** 2 + (dz / half_z) ** 2)
    column = (k - 1.0) * np.minimum(half_x, half_z)
    # Sternocleidomastoid: from behind the ear down to the jugular notch.
    muscle = sweep(
        s,
        [(57, -36, -22), (50, -75, -16), (41, -115, -1), (28, -155, 13), (12, -192, 20)],
        [8, 9.5, 10, 8.5, 6],
    )
    out = smooth_union(np.maximum(column, y + 40.0), muscle, 12.0)
    trapezius = sweep(
        s,
        [(18, -30, -62), (22, -80, -54), (34, -128, -56), (64, -170, -56), (112, -196, -52)],
        [14, 16, 19, 22, 23],
    )
    out = smooth_union(out, trapezius, 26.0)
    shoulder = sweep(s, [(0, -225, -30), (70, -222, -36), (125, -222, -46)], [42, 40, 32])
    out = smooth_union(out, shoulder, 34.0)
    collar = sweep(
        s, [(12, -196, 17), (38, -196, 14), (70, -192, -2), (110, -192, -22)], [6, 5.5, 5, 5]
    )
    out = smooth_union(out, collar, 14.0)
    throat = round_cone(p, (0, -132, 24), (0, -146, 26), 9.0, 8.0)
    out = smooth_union(out, throat, 14.0)
    windpipe = round_cone(p, (0, -140, 16), (0, -195, 10), 12.0, 12.0)
    return smooth_union(out, windpipe, 10.0)


def bust_cut(p: Array) -> Array:
    """Return the distance to the ellipsoid, extended upwards, with which the bust is intersected."""
    q = p.copy()
    q[:, 1] = np.minimum(p[:, 1], -60.0)
    return ellipsoid(q, (0, -60, -20), (118, 146, 160))


def jaw_fillet_mm(p: Array) -> Array:
    """Return the width of the fillet between jaw and neck: narrow under the chin, wide at the nape."""
    return 6.0 + 26.0 * ramp(-p[:, 2], -30.0, 40.0)
