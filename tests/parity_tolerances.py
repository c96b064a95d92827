"""Allowed differences between shaders in float32 and their twins in float64, with reasons."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Parity:
    """|shader − twin| ≤ absolute + relative·|twin|."""

    absolute: float
    relative: float
    reason: str


FLOAT32 = Parity(2e-6, 2e-6, "some twenty roundings of 6e-8")
BUMP = Parity(
    8e-6,
    2e-6,
    "a polynomial approximates the bump within 3.3e-6 of its slope; its terms cancel: 7e-6",
)
TABLES = Parity(5e-5, 2e-6, "BUMP, and filter weights of 8 bits between columns 1/256 apart")

PARITY = {
    "skin_relief_bump": BUMP,
    "skin_direct_scalar": TABLES,
    "skin_direct_tensor": TABLES,
    "skin_direct_diffused_normals": TABLES,
    "skin_relief_length": Parity(4e-5, 2e-6, "T(k) from a table of 2048 by weights of 8 bits"),
    "skin_diffused_shadow": Parity(
        1e-4, 2e-6, "filter weights of 8 bits between columns 1/512 apart"
    ),
    "skin_classic_direct": Parity(
        1e-4, 2e-6, "filter weights of 8 bits between columns 1/256 apart"
    ),
    "skin_directional_curvature": Parity(
        2e-6, 1e-5, "a quotient of small vectors where the light is nearly overhead"
    ),
    "skin_sharpened_shadow": Parity(
        2e-4, 0.0, "asin at ±1 keeps half the bits, times a sharpening of 12"
    ),
    "skin_thickness": Parity(
        2e-3,
        2e-6,
        "a depth of 2000 mm is exact to 1e-3 near the far plane",
    ),
    "skin_eye_cornea_hit": Parity(1e-4, 0.0, "a quotient that grows where a ray grazes the cornea"),
    "skin_eye_iris_hit": Parity(4e-5, 0.0, "up to 20 mm along a ray that is oblique to the iris"),
    "skin_eye_iris_uv": Parity(2e-4, 0.0, "browsers may err by 2^-11 in the sine of the turn"),
    "skin_lamp_highlight": Parity(
        5e-3, 1e-3, "a difference of directions, rounded to 6e-8, over an edge of .02"
    ),
    "skin_eye_light": Parity(
        6e-3,
        0.0,
        "filter weights of 8 bits between texels, whose values differ by up to .5 in x and y",
    ),
    "skin_eye_ambient": Parity(2e-3, 0.0, "filter weights of 8 bits between texels"),
    "skin_linear_depth": Parity(0.0, 2e-6, "up to 2000 mm; depth to one rounding of its far plane"),
    "skin_equirectangular_uv": Parity(
        1e-6, 0.0, "a polynomial approximates the arc tangent within 4e-7 of a turn"
    ),
    "skin_reflected_radiance": Parity(
        4e-3, 4e-3, "the position in the map, and filter weights of 8 bits between its texels"
    ),
    "skin_variance_shadow": Parity(
        2e-5, 2e-4, "a difference of squares of up to 150 mm keeps 1e-3 mm²"
    ),
    "skin_light_coordinates": Parity(
        2e-4, 4e-6, "depths of up to 1300 mm, rounded to 1e-4; the same in UV of up to 200"
    ),
    "skin_shadow_receiver": Parity(
        2e-4,
        0.0,
        "positions of up to 300 mm; a direction along the surface from nearly equal vectors",
    ),
    "skin_shadow_slope": Parity(
        2e-4, 2e-5, "a quotient that is up to 8, of a small sum of nearly opposite vectors"
    ),
    "skin_shadow_filter": Parity(
        1e-3, 0.0, "positions in the map of 128 texels, rounded to 1e-5 of a texel, times the slope"
    ),
    "skin_contact_slope": Parity(
        2e-4, 2e-5, "a quotient that is up to 20, of a small sum of nearly opposite vectors"
    ),
    "skin_contact_filter": Parity(
        1e-3, 0.0, "positions in the map of 128 texels, rounded to 1e-5 of a texel"
    ),
    "skin_faded_contact": Parity(4e-6, 0.0, "a cosine's rounding of 6e-8 over the range .1"),
    "skin_contact_shadow": Parity(
        1e-4, 2e-6, "filter weights of 8 bits between columns 1/512 apart"
    ),
    "skin_inward_offset": Parity(4e-5, 0.0, "positions of up to 300 mm, rounded to 3e-5"),
    "skin_specular_power": Parity(0.0, 4e-6, "exp2 of up to 13"),
    "skin_specular": Parity(
        4e-5, 1e-3, "the power of up to 8192 multiplies the rounding of n_dot_h, 6e-8"
    ),
    "skin_coat": Parity(
        2e-4, 2e-6, "filter weights of 8 bits between columns and rows that differ by up to .06"
    ),
    "skin_coat_highlight": Parity(
        4e-6, 2e-5, "exp2 of up to 13, and the square of a sum of squares that is near α²"
    ),
    "skin_coat_radiance": Parity(
        4e-3, 4e-3, "the position in the map, and filter weights of 8 bits between its texels"
    ),
    "skin_gloss_of_relief": Parity(4e-6, 0.0, "log2 near 1"),
    "skin_gloss_from_roughness": Parity(4e-6, 0.0, "log2 near 1"),
    "skin_occluded_reflection": Parity(
        5e-4, 1e-4, "bounced light over a hidden share of .02, a difference of nearly equal numbers"
    ),
    "skin_specular_visibility": Parity(
        2e-5, 0.0, "the root of a difference of nearly equal numbers, near a base of 0"
    ),
}
"""Allowances of the functions that need more than `FLOAT32`."""
