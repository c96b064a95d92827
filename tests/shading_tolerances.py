"""Tolerances of shading, scenes, pictures and the command line, by name, with their reasons."""

from tolerances import FLOAT32, ROUNDING, ROUNDING_SUMS, Tolerance

__all__ = ["FLOAT32", "ROUNDING", "ROUNDING_SUMS"]

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
    1.0, "mm⁴ over r⁴: T(√2κ) is T²(κ) of a single lobe, of a mixture only to fourth order; .95"
)
BUMP = Tolerance(1e-9, "closed form against adaptive quadrature, of values up to 1")
NO_SLOPE = Tolerance(1e-9, "the slope is floored at 1e-9 to keep out 0/0")
STEEP = Tolerance(1e-6, "square roots of differences of rounding, for lights off the normal")
MESH_TENSOR = Tolerance(0.02, "curvature towards the light of 2,562 vertices; the fit's promise")

# -- shadows and ambient light ---------------------------------------------------------------------

INVERSE = Tolerance(1e-7, "the inverse of a smoothstep is a root where its slope is nothing")
MIRRORED = Tolerance(1e-7, "both halves of an edge, each rounded to float32")
OPAQUE_EDGE = Tolerance(1e-6, "a profile of 0.1 µm, in a table sampled at its texel centres")
SHADOW_FFT = Tolerance(1e-3, "bilinear between 1024 columns, against an FFT on a grid of 0.05 mm")
QUADRATURE = Tolerance(
    1e-9, "Gauss quadrature that is exact for the degree; ten digits of constants"
)
NINE_HARMONICS = Tolerance(
    0.01, "bands above 2 of the clamped cosine; the source's figure; relative"
)
BOUNCE_FIT = Tolerance(6e-4, "the published fit's cubic is .9996 + .0005 albedo at full visibility")

# -- light through the body ------------------------------------------------------------------------

DEPTH = Tolerance(
    1e-9, "a stored depth at far/near of 500 has lost that many of its digits; relative"
)
CENTRED = Tolerance(0.02, "of the mean tap; scaled back to the disk after it was centred")
TAPS_APART = Tolerance(
    0.9, "least distance of two taps over 1/√taps, near 1.9 for a hexagonal lattice"
)
EVEN_DISK = Tolerance(0.12, "mean square radius over that of an even disk, a half; 8 taps are few")
TAIL = Tolerance(1e-6, "the term that dies out is e⁻⁴⁰ at 20 decay lengths; relative")
SLAB_DECAY = (
    Tolerance(0.03, "median |ln| of 14 thicknesses, red, all light; .023 measured"),
    Tolerance(0.08, "as red, green; .075 measured"),
    Tolerance(0.20, "as red, blue, 12 thicknesses; .1945 measured, .19 was hoped for"),
)
SLAB_FITTED = (
    Tolerance(0.02, "as SLAB_DECAY with the best σ, .270/mm; .018 measured"),
    Tolerance(0.04, "as SLAB_DECAY with the best σ, .706/mm; .035 measured"),
    Tolerance(0.08, "as SLAB_DECAY with the best σ, 1.33/mm; .068 measured"),
)

# -- highlights, tone, 2014 ------------------------------------------------------------------------

SPECULAR_QUADRATURE = Tolerance(1e-6, "panels of 8 nodes over lobes of powers up to 2¹³")
SHARP_LOBE = Tolerance(5e-3, "of all light; powers from 550 up lose that little to shadowing")
COAT_AND_BODY = Tolerance(0.04, "the share left for the body is a fit of preconvolved light; .036")
GRAZING = Tolerance(0.1, "(1 − v·h)⁵ at v·h = .014 is .93")
SRGB = Tolerance(1e-7, "the standard's two branches meet to 3e-8")
SRGB_DIGITS = Tolerance(5e-7, "values worked out to seven digits")
CLASSIC_PLANE = Tolerance(
    0.015, "8 bits of ±.25 are steps of .002; the least curvature of the table is not nothing"
)

# -- the whole pixel -------------------------------------------------------------------------------

TURNED = Tolerance(1e-6, "a rotation turns rounding into rounding, through arccosines and tables")
PLANE = Tolerance(3e-3, "TABLE_EDGE, and the shadow table's own last texel; of light 1")
DARK_END = Tolerance(2e-3, "the first texel of the shadow table, half a texel from where it is 0")

# -- against diffusion over surfaces ---------------------------------------------------------------

CLASSIC_OVER_THREE_FETCHES = Tolerance(5.0, "the promise; 6.9 to 8.7 times measured")
BUMPY_PER_SLOPE = {
    "classic": (Tolerance(0.11, "RMS over RMS slope, least"), Tolerance(0.15, "greatest; .12-.14")),
    "2 fetches": (Tolerance(0.04, "as classic"), Tolerance(0.06, "greatest; .043-.058 measured")),
    "3 fetches": (Tolerance(0.01, "as classic"), Tolerance(0.02, "greatest; .014-.019 measured")),
}
RING_ON_CYLINDER = Tolerance(
    3e-4, "RMS around it; a table that ends 1/512 before N·L = 1 gives 2.0e-4, as was measured"
)
LAMBERT_ON_CYLINDER = Tolerance(1e-3, "1024 samples of a kink against its series; 3e-4; relative")

# -- pictures --------------------------------------------------------------------------------------

BYTE_STEP = Tolerance(1.0, "steps of 8 bits: EXR keeps float32, PNG is rounded from float64")
PNG16_STEP = Tolerance(
    0.51 / 65535.0, "half a step of 16 bits of the range, and float32's rounding"
)
OTHER_UNIT = Tolerance(1e-4, "positions written with 9 digits in one unit and 12 in another")
COVER = Tolerance(0.03, "area of a ball of 642 vertices on 2 samples a pixel; relative")

# -- the rasteriser --------------------------------------------------------------------------------

RASTER = Tolerance(
    1e-6, "samples 1e-9 from an edge of thin triangles: ill-conditioned barycentrics"
)
RASTER_SLOPE = Tolerance(1e-4, "central differences over 2e-5 pixels; relative, absolute below 1")
FAR_FLOOR = Tolerance(1e-6, "depths of 1 to 10 on a floor of 10⁴; relative")
FACETED_BALL = Tolerance(
    5e-3, "depth of 10,242 vertices' chords, at slopes of up to 2; of radius 1"
)

# -- whole pictures --------------------------------------------------------------------------------

BALL_COVER = Tolerance(0.02, "area of a ball of 642 vertices at 3,000 pixels; relative")
FACETED_SHADING = Tolerance(3e-3, "points between 2,562 vertices lie off the ball; .0018 measured")
NO_SCATTER = Tolerance(2e-3, "TABLE_EDGE, of two lamps on albedo .48; .0008 measured")
FURNACE = Tolerance(1e-4, "harmonics of a constant, float32; .00002 measured; relative")
MIRRORED_BALL = Tolerance(1e-4, "shadow taps are not mirrored, the ball and lamps are; .000014")
SHOWN = Tolerance(2e-3, "display values of normals and curvature between 642 vertices; float32")
SHADOW_TEXEL_MM = Tolerance(0.1, "a ball's depth at its middle on facets of 642 vertices, mm")

# -- shadow maps -----------------------------------------------------------------------------------

SHADOW_PROFILE = Tolerance(0.05, "48 taps, each bilinear in texels of .1 to .8 mm; .044 measured")
CHORD_MM = Tolerance(1.0, "texels of .12 mm on slopes of up to 2.3, and facets; .7 mm measured")
SLAB_MM = Tolerance(0.3, "a texel of .28 mm on a slope of 40°, mm")

# -- textures --------------------------------------------------------------------------------------

BILINEAR = Tolerance(1e-6, "weights in float64 of texels in float32, values up to 1")

# -- cameras and lights ----------------------------------------------------------------------------

UNPROJECTED_MM = Tolerance(1e-6, "through the inverse of a matrix of condition 10⁴ and back, mm")
CONE_KINK = Tolerance(2e-3, "change of slope over .005° of a smoothstep over 6°: 6/36·.005 at most")
CONE_ROUNDING = Tolerance(1e-7, "rounding of the angle, magnified by distances down to a few mm")

# -- environments ----------------------------------------------------------------------------------

EVEN_SKY = Tolerance(1e-3, "a constant by 128 rows of directions at their middles; .0003 measured")
COSINE_LOBE = Tolerance(0.01, "bands above 2 of a clamped cosine; .007 measured; of the greatest")
SUN_KEPT = Tolerance(1e-5, "light of suns in float32, averaged by area in float64; relative")
LEVEL_MEAN = Tolerance(5e-4, "mean of a level of 128×64 over that of the picture; relative")
EVEN_REFLECTION = Tolerance(0.01, "harmonics up to 64 by 128 rows at their middles; .006 at poles")
PHONG_LOBE = Tolerance(
    3e-4, "of the brightest light and per unit of power: lobes narrow towards the texels of a level"
)

# -- ambient light at the vertices -----------------------------------------------------------------

CAVITY_LEAK = Tolerance(
    0.02, "walls seen along themselves, within the bias of 1.5 mm; .013 measured"
)
BOWL_MEAN = Tolerance(0.04, "80 directions, walls of 1.5 mm bias; share of the sky")
BOWL_RMS = Tolerance(0.07, "as BOWL_MEAN, at each vertex")
FIRST_BOUNCE = Tolerance(0.3, "the bounce is a model of nearby light, not a solution; relative")
CHORD_TEXELS_MM = Tolerance(3.0, "of a ball of 80 mm in texels of .75 mm; their depth is added")
SLAB_THROUGH = Tolerance(
    0.33, "80 directions, .5 mm·tan added at a slant; red; .27 measured; relative"
)

# -- the built-in head -----------------------------------------------------------------------------

FOLDED_CORNERS = Tolerance(
    5e-4, "corners whose normal turns from their face: 24 of 119,928, in ears"
)
FACE_HALVES_MM = Tolerance(
    5.0, "from a mirrored vertex to the next one: edges of 4.5 mm; 4.0 found"
)
CHART_AREA = Tolerance(2e-3, "texels of 512² whose centre is covered, against the area of charts")

# -- the tiers of geometry, beside diffusion over a mesh ------------------------------------------------

TIER_OVER_PUBLISHED = Tolerance(1.1, "other lights and other meshes of the same bodies")
TIER_DIGIT = Tolerance(0.5e-4, "half of the last digit that was published")
TIER_ON_SPHERE = Tolerance(1e-4, "ring times factor is the sphere's kernel to σ³κ³; mesh of 10,242")

# -- the GPU's picture beside the CPU's, in steps of 1/255 after tone mapping -----------------------------

VARIANCE_PROFILE = Tolerance(
    0.06, "a Gaussian for a smoothstep .020, .4 mm of bias; .032, of a lamp's own texels .055"
)

SHOWN = Tolerance(0.55, "levels of 255: half of one by rounding, and float32")
MULTISAMPLED_MEAN = Tolerance(1.0, "levels of 255; edges and the sharpest highlights; .67")
MULTISAMPLED_MEDIAN = Tolerance(
    2.0, "levels of 255 inside, shaded once a pixel of a small picture; 1.0"
)
BACKENDS_MEAN = Tolerance(0.05, "mean; .003 on llvmpipe; float32, maps and tables in half floats")
BACKENDS_TAIL = Tolerance(
    1.5, "99.9 % of pixels; .36 on llvmpipe; others lie on edges, where samples tie"
)

ENGINE_EDGES = Tolerance(1e-3, "share of pixels that one renderer covers and the other does not")
ENGINE_MEAN = Tolerance(2e-4, "linear light; float32, texture filters")
ENGINE_TAIL = Tolerance(3e-3, "99.9 % of pixels")

# -- pygfx's picture beside ours, in linear light ---------------------------------------------------------

LAMP_COLOUR = Tolerance(2e-6, "through sRGB and back in float32; relative")
LAMP_MATRIX = Tolerance(2e-6, "float32 of a matrix, over its largest element")
PYGFX_TAIL = Tolerance(8e-4, "99.9 % of pixels of one colour, no shadow: half floats; .00048 found")
PYGFX_WORST = Tolerance(4e-3, "as PYGFX_TAIL, worst pixel; its triangle is a matter of rounding")
PYGFX_SHADOW = Tolerance(
    0.015,
    "99 % of pixels, shadow, light through, albedo map: pygfx's mips are one level for both axes",
)
PYGFX_SHADOW_SHARE = Tolerance(6e-3, "share of pixels off by more than 4/255, as PYGFX_SHADOW")
PYGFX_SPOT = Tolerance(2e-3, "99.9 % of pixels of one colour in a cone; half floats; .00097 found")
PYGFX_BEHIND = Tolerance(
    2.5e-3, "99 % of pixels of one colour lit from behind by 3 times the light"
)

BAKED_ATTRIBUTES = Tolerance(1e-6, "1/mm of up to 3, stored in single precision")
BAKED_PICTURE = Tolerance(
    1e-3, "display values; curvature in single precision, a quarter of a level"
)
