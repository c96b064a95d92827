"""Tolerances of shading, scenes, pictures and the command line, by name, with their reasons."""

from tolerances import ROUNDING, Tolerance

__all__ = ["ROUNDING"]

# -- normal maps -----------------------------------------------------------------------------------

BLEND_RESIDUAL = Tolerance(0.07, "three fetches over periods of 0.4 to 5 mm; .067 in blue measured")
BLEND_RESIDUAL_RMS = Tolerance(0.03, "as BLEND_RESIDUAL; .028 in green measured")
BLEND_GRID = Tolerance(
    1.05, "squared error over that of widths searched without steps; 1.027 measured"
)
BLEND_LIMIT = Tolerance(1e-3, "profiles a hundred times narrower, or wider, than the band")
BLEND_SIGMA = Tolerance(0.08, "widths are searched in steps of 9 %; relative")
BLEND_WEIGHT = Tolerance(0.04, "weights published for other widths of blur, and to three digits")
TWO_FETCH_WEIGHT = Tolerance(0.015, "published to two digits for a width of .46, which is off grid")
BLEND_OPTIMUM = Tolerance(
    0.02, "root of the summed square error over 200 frequencies; a sum above 1 is scaled back"
)

# -- direct light ----------------------------------------------------------------------------------

TABLE_EDGE = Tolerance(
    2.1e-3, "a table of 512 columns ends half a texel, 1/512, before N·L = 1; float32 beside it"
)
TIER_CUBE = Tolerance(0.105, "difference over (σ/r)³ of ring times decay from the sphere's series")
CUBIC = Tolerance(0.1, "exponent found between radii of 5 and 20 σ")
MIXTURE_TIERS = Tolerance(
    0.35, "mm²; a mixture's T(√2κ)/T(κ) is not its T(κ), as a single lobe's is, but to κ²ρ² of red"
)
BUMP = Tolerance(1e-9, "closed form against adaptive quadrature, of values up to 1")
NO_SLOPE = Tolerance(1e-9, "the slope is floored at 1e-9 to keep out 0/0")
STEEP = Tolerance(1e-6, "square roots of differences of rounding, for lights off the normal")
MESH_TENSOR = Tolerance(0.02, "curvature towards the light of 2,562 vertices; the fit's promise")

# -- pictures --------------------------------------------------------------------------------------

BYTE_STEP = Tolerance(1.0, "steps of 8 bits: EXR keeps float32, PNG is rounded from float64")
PNG16_STEP = Tolerance(
    0.51 / 65535.0, "half a step of 16 bits of the range, and float32's rounding"
)
OTHER_UNIT = Tolerance(1e-4, "positions written with 9 digits in one unit and 12 in another")
COVER = Tolerance(0.03, "area of a ball of 642 vertices on 2 samples a pixel; relative")
