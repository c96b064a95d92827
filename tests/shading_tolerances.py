"""Tolerances of shading, scenes, pictures and the command line, by name, with their reasons."""

from tolerances import FLOAT32, ROUNDING, ROUNDING_SUMS, Tolerance

__all__ = ["FLOAT32", "ROUNDING", "ROUNDING_SUMS"]

# -- normal maps -----------------------------------------------------------------------------------

BLEND_RESIDUAL = Tolerance(
    0.07, "three fetches cannot fit periods of .4 to 5 mm exactly; .067 measured, in blue"
)
BLEND_RESIDUAL_RMS = Tolerance(0.03, "as BLEND_RESIDUAL; .028 measured, in green")
BLEND_GRID = Tolerance(
    1.05, "squared error over that of the published blurs, between search steps; 1.027 measured"
)
BLEND_LIMIT = Tolerance(
    1e-3, "profiles a hundred times narrower or wider than the periods of the relief"
)
BLEND_SIGMA = Tolerance(0.08, "the search of blurs has steps of 9 %; relative")
BLEND_WEIGHT = Tolerance(0.04, "the published weights have three digits and belong to other blurs")
TWO_FETCH_WEIGHT = Tolerance(
    0.015, "the published weights have two digits, and their blur of .46 is between search steps"
)
BLEND_OPTIMUM = Tolerance(
    0.02, "root of the squared error over 200 frequencies; weights with a sum above 1 are scaled"
)

# -- direct light ----------------------------------------------------------------------------------

TABLE_EDGE = Tolerance(
    2.1e-3, "the last of 512 columns has its centre 1/512 before N·L = 1; float32"
)
TIER_CUBE = Tolerance(0.105, "difference of ring times decay from the sphere, over (σ/r)³")
CUBIC = Tolerance(0.1, "exponent between radii of 5 and 20 σ")
MIXTURE_TIERS = Tolerance(
    1.0, "mm⁴ over r⁴: for mixtures T(√2κ) is T²(κ) to fourth order only; .95 measured"
)
BUMP = Tolerance(1e-9, "closed form and adaptive quadrature of values up to 1")
NO_SLOPE = Tolerance(1e-9, "slopes are at least 1e-9, which avoids 0/0")
STEEP = Tolerance(1e-6, "square roots of differences that cancel; lights not along the normal")
MESH_TENSOR = Tolerance(
    0.02, "curvature on 2,562 vertices: the accuracy that the fit promises; relative"
)

# -- shadows and ambient light ---------------------------------------------------------------------

INVERSE = Tolerance(1e-7, "the inverse of a smoothstep has a root's infinite slope at its ends")
MIRRORED = Tolerance(1e-7, "both halves of an edge are rounded to float32")
OPAQUE_EDGE = Tolerance(1e-6, "a profile of .1 µm in a table, at its texel centres")
SHADOW_FFT = Tolerance(1e-3, "1024 columns interpolated bilinearly, and an FFT on a grid of .05 mm")
QUADRATURE = Tolerance(
    1e-9, "Gauss quadrature is exact for the degree; the constants have ten digits or more"
)
NINE_HARMONICS = Tolerance(
    0.01, "bands above 2 of the clamped cosine, the figure of the source; relative"
)
BOUNCE_FIT = Tolerance(6e-4, "at full visibility the published cubic is .9996 + .0005 albedo")

# -- deep scatter ----------------------------------------------------------------------------------

DEPTH = Tolerance(
    1e-9, "at a far/near ratio of 500 a stored depth has fewer digits by that factor; relative"
)
CENTRED = Tolerance(0.02, "mean tap; the taps are scaled back to the disk after they are centred")
TAPS_APART = Tolerance(0.9, "least distance of two taps times √taps; a hexagonal lattice has 1.9")
EVEN_DISK = Tolerance(0.12, "mean square radius; an even disk has .5, 8 taps vary")
TAIL = Tolerance(1e-6, "at 20 decay lengths the second term is e⁻⁴⁰; relative")
SLAB_DECAY = (
    Tolerance(0.03, "red: median |ln| of the ratio over 14 thicknesses; .023 measured"),
    Tolerance(0.08, "green, as red; .075 measured"),
    Tolerance(0.20, "blue, as red over 12 thicknesses; .1945 measured"),
)
SLAB_FITTED = (
    Tolerance(0.02, "red, as SLAB_DECAY with the best σ, .270/mm; .018 measured"),
    Tolerance(0.04, "green, as SLAB_DECAY with the best σ, .706/mm; .035 measured"),
    Tolerance(0.08, "blue, as SLAB_DECAY with the best σ, 1.33/mm; .068 measured"),
)

# -- specular light, tone, 2014 --------------------------------------------------------------------

SPECULAR_QUADRATURE = Tolerance(1e-6, "panels of 8 nodes over lobes with powers up to 2¹³")
COAT_TABLE = Tolerance(
    1e-3, "64×32 texels, bilinear, and 160 nodes; 9e-4 measured, at N·V = 0 and gloss .98"
)
COAT_UNIT_TABLE = Tolerance(
    8e-3, "as COAT_TABLE with Fresnel 1, whose tail the nodes resolve less; .006 measured"
)
COAT_ANGLE = Tolerance(0.02, "radians between the mean directions of the table and the quadrature")
COAT_OTHER_REFLECTANCE = Tolerance(
    0.02, "E at F₀ of .02 to .04 from the table of .028; .015 measured, for a mirror at N·V = .2"
)
COAT_FURNACE = Tolerance(2e-3, "what the coat reflects and what the body returns are 1 together")
COAT_SKY = Tolerance(
    0.15, "RMS over the mean radiance of the studio: a Phong lobe for a skewed one of long tails"
)
VIEW_FACTOR_MEAN = Tolerance(5e-3, "two nodes, at any index of refraction; .0032 at 1 and black")
VIEW_FACTOR_MEAN_OF_SKIN = Tolerance(2e-4, "two nodes, at an index of 1.4; 1.6e-4 for black")
VIEW_FACTOR_WALK = Tolerance(
    0.025, "a simulated half-space from μ = .03 on; .018 measured in blue, at .03; relative"
)
VIEW_FACTOR_CLOSURE = Tolerance(2e-3, "two nodes for the half that enters by the cosine")
SHARP_LOBE = Tolerance(
    5e-3, "share of the light that lobes with powers of 550 and more lose to shadowing"
)
COAT_AND_BODY = Tolerance(
    0.04, "the diffuse share is from a fit for preconvolved light; .036 measured"
)
GRAZING = Tolerance(0.1, "(1 − v·h)⁵ is .93 at v·h = .014")
SRGB = Tolerance(1e-7, "the two branches of the standard differ by 3e-8 where they meet")
SRGB_DIGITS = Tolerance(5e-7, "the expected values have seven digits")
CLASSIC_PLANE = Tolerance(
    0.015, "8 bits of ±.25 have steps of .002; the table's least curvature is above 0"
)

# -- the whole pixel -------------------------------------------------------------------------------

TURNED = Tolerance(1e-6, "rounding errors, magnified by arccosines and tables")
PLANE = Tolerance(3e-3, "TABLE_EDGE and the last texel of the shadow table; light 1")
DARK_END = Tolerance(2e-3, "the first texel of the shadow table has its centre half a texel from 0")

# -- compared with diffusion on surfaces -----------------------------------------------------------

CLASSIC_OVER_THREE_FETCHES = Tolerance(5.0, "published ratio of errors; 6.9 to 8.7 measured")
BUMPY_PER_SLOPE = {
    "classic": (
        Tolerance(0.11, "RMS error over RMS slope: least"),
        Tolerance(0.15, "greatest; .12 to .14 measured"),
    ),
    "2 fetches": (
        Tolerance(0.04, "as classic"),
        Tolerance(0.06, "greatest; .043 to .058 measured"),
    ),
    "3 fetches": (
        Tolerance(0.01, "as classic"),
        Tolerance(0.02, "greatest; .014 to .019 measured"),
    ),
}
RING_ON_CYLINDER = Tolerance(3e-4, "RMS; TABLE_EDGE gives 2.0e-4, which is the measured value")
LAMBERT_ON_CYLINDER = Tolerance(
    1e-3, "1024 samples of a function with a kink, and its series; 3e-4 measured; relative"
)

# -- pictures --------------------------------------------------------------------------------------

BYTE_STEP = Tolerance(1.0, "steps of 8 bits: EXR stores float32, PNG is rounded from float64")
PNG16_STEP = Tolerance(
    0.51 / 65535.0, "half a step of 16 bits, and the rounding of float32; share of the range"
)
OTHER_UNIT = Tolerance(1e-4, "positions are written with 9 digits in one unit and 12 in the other")
COVER = Tolerance(0.03, "area of a ball of 642 vertices with 2 samples a pixel; relative")

# -- the rasteriser --------------------------------------------------------------------------------

RASTER = Tolerance(1e-6, "barycentrics are ill-conditioned at 1e-9 from an edge of a thin triangle")
RASTER_SLOPE = Tolerance(
    1e-4, "central differences over 2e-5 pixels; relative above 1, absolute below"
)
FAR_FLOOR = Tolerance(1e-6, "depths of 1 to 10 on a floor whose side is 10⁴; relative")
FACETED_BALL = Tolerance(
    5e-3, "depth of the chords between 10,242 vertices at slopes of up to 2; radius 1"
)

# -- whole pictures --------------------------------------------------------------------------------

BALL_COVER = Tolerance(0.02, "area of a ball of 642 vertices in 3,000 pixels; relative")
FACETED_SHADING = Tolerance(
    3e-3, "points between 2,562 vertices lie inside the ball; .0018 measured"
)
NO_SCATTER = Tolerance(2e-3, "TABLE_EDGE of two lights, times an albedo of .48; .0008 measured")
FURNACE = Tolerance(
    3e-4,
    "harmonics of the visible sky between the vertices of a ball of 642; .00016 measured; relative",
)
MIRRORED_BALL = Tolerance(
    1e-4, "ball and lights are mirrored, shadow taps are not; .000014 measured"
)
SHOWN = Tolerance(2e-3, "display values of normals and curvature between 642 vertices; float32")
SHADOW_TEXEL_MM = Tolerance(
    0.1, "depth in the middle of a facet between 642 vertices of a ball, mm"
)

# -- shadow maps -----------------------------------------------------------------------------------

CONTACT_EDGE = Tolerance(0.1, "12 taps, each interpolated between texels of .27 mm")
CONTACT_BLEED = Tolerance(
    0.01, "an edge 1/8 mm wide instead of a step, and 2048 columns interpolated bilinearly"
)
CONTACT_FOLDS = Tolerance(
    0.5, "ratio of RMS with contact to RMS without, on folds of 1 mm in a map of .56 mm"
)
SHADOW_PROFILE = Tolerance(
    0.05, "48 taps, each interpolated between texels of .1 to .8 mm; .044 measured"
)
SHADOW_PROFILE_16_TAPS = Tolerance(0.14, "as SHADOW_PROFILE with 16 taps; .131 measured")
SHADOW_DISK = {
    48: Tolerance(0.063, "steps of 1/48; .061 measured in the worst direction"),
    16: Tolerance(0.155, "steps of 1/16; .151 measured in the worst direction"),
}
VARIANCE_PROFILE = Tolerance(
    0.06, "a Gaussian instead of a smoothstep, .020, and .4 mm of bias; .055 measured, spot light"
)
CHORD_MM = Tolerance(1.0, "texels of .12 mm at slopes of up to 2.3, and facets, mm; .7 measured")
SLAB_MM = Tolerance(0.3, "texels of .28 mm at a slant of 40°, mm")

# -- textures --------------------------------------------------------------------------------------

BILINEAR = Tolerance(1e-6, "float64 weights of float32 texels with values up to 1")

# -- cameras and lights ----------------------------------------------------------------------------

UNPROJECTED_MM = Tolerance(1e-6, "a matrix of condition 10⁴ and its inverse, mm")
CONE_KINK = Tolerance(
    2e-3, "change of the slope of a smoothstep over 6° within .005°: at most 6/36·.005"
)
CONE_ROUNDING = Tolerance(1e-7, "rounding of the angle, magnified at distances of a few mm")

# -- environments ----------------------------------------------------------------------------------

EVEN_SKY = Tolerance(1e-3, "a constant integrated over 128 rows of directions; .0003 measured")
COSINE_LOBE = Tolerance(
    0.01, "bands above 2 of a clamped cosine; .007 measured; relative to the greatest"
)
SUN_KEPT = Tolerance(1e-5, "suns in float32, averaged by area in float64; relative")
LEVEL_MEAN = Tolerance(5e-4, "mean of a level of 128×64 and mean of the picture; relative")
EVEN_REFLECTION = Tolerance(
    0.01, "harmonics up to degree 64 on 128 rows; .006 measured, at the poles"
)
PHONG_LOBE = Tolerance(
    3e-4,
    "per unit of power, relative to the brightest light: narrow lobes approach the texels' size",
)

# -- ambient light at the vertices -----------------------------------------------------------------

CAVITY_LEAK = Tolerance(1e-9, "no ray leaves a closed body")
BOWL_MEAN = Tolerance(
    0.01, "256 directions over faces that are chords of the sphere; share of the sky"
)
BOWL_RMS = Tolerance(0.02, "as BOWL_MEAN, RMS over the vertices")
BOUNCES = Tolerance(0.03, "as BOWL_MEAN, after four bounces; relative")
SLAB_THROUGH = Tolerance(0.06, "16 directions behind a vertex; relative")

THIN_PARTS = Tolerance(
    0.2, "mean of the back of a cylinder of 3 to 6 mm, red; .12 measured; relative"
)

# -- the built-in head -----------------------------------------------------------------------------

FOLDED_CORNERS = Tolerance(
    5e-4, "share of corners whose normal points away from their face: 24 of 119,928, in the ears"
)
FACE_HALVES_MM = Tolerance(
    5.0, "distance of a mirrored vertex to the nearest one; edges of 4.5 mm; 4.0 measured"
)
CHART_AREA = Tolerance(
    2e-3, "share of the 512² texels with a covered centre, and area of the charts"
)

# -- the tiers of geometry, compared with diffusion on a mesh --------------------------------------

TIER_OVER_PUBLISHED = Tolerance(
    1.1, "the published figures are for other lights and other meshes of the same bodies; factor"
)
TIER_DIGIT = Tolerance(0.5e-4, "half of the last published digit")
TIER_ON_SPHERE = Tolerance(1e-4, "ring times decay is the sphere's kernel to σ³κ³; 10,242 vertices")

# -- pictures of the GPU and of the CPU, in levels of 255 of display values ------------------------

DISPLAY_BYTES = Tolerance(0.55, "levels of 255: rounding to half a level, and float32")
MULTISAMPLED_MEAN = Tolerance(1.0, "levels of 255; edges and the sharpest highlights; .67 measured")
MULTISAMPLED_MEDIAN = Tolerance(
    2.0, "levels of 255 without edges; one shading per pixel of a small picture; 1.0 measured"
)
BACKENDS_MEAN = Tolerance(
    0.05, "mean; float32, maps and tables in half floats; .003 measured on llvmpipe"
)
BACKENDS_TAIL = Tolerance(1.5, "99.9 % of pixels, the rest at edges; .36 measured on llvmpipe")
OPACITY_EDGES = Tolerance(
    0.015,
    "share of pixels at the edges of opacity maps, where GPUs round filter weights; .008 measured",
)

ENGINE_EDGES = Tolerance(1e-3, "share of pixels that only one of two renderers covers")
ENGINE_MEAN = Tolerance(2e-4, "mean, linear light; float32, texture filters")
ENGINE_TAIL = Tolerance(3e-3, "as ENGINE_MEAN, 99.9 % of pixels")

GPU_LOOKUP = Tolerance(1e-4, "light of up to 1 from tables in half or single precision")

# -- pictures of pygfx, in linear light ------------------------------------------------------------

LAMP_COLOUR = Tolerance(2e-6, "sRGB and its inverse in float32; relative")
LAMP_MATRIX = Tolerance(2e-6, "matrix in float32; relative to its greatest element")
PYGFX_TAIL = Tolerance(
    8e-4, "99.9 % of pixels, one colour, no shadow; half floats; .00048 measured"
)
PYGFX_WORST = Tolerance(4e-3, "as PYGFX_TAIL, all pixels; at edges rounding selects the triangle")
PYGFX_SHADOW = Tolerance(
    0.015,
    "99 % of pixels with shadow, deep scatter and albedo map: pygfx has one mip level for both axes",
)
PYGFX_SHADOW_SHARE = Tolerance(
    6e-3, "as PYGFX_SHADOW, share of pixels that differ by more than 4/255"
)
PYGFX_SPOT = Tolerance(
    2e-3, "99.9 % of pixels, one colour, spot light; half floats; .00097 measured"
)
PYGFX_BEHIND = Tolerance(2.5e-3, "99 % of pixels, one colour, three times the light from behind")

BAKED_ATTRIBUTES = Tolerance(
    4e-6,
    "curvature of up to 3/mm in single precision, and a node that scales lengths by up to 1 + 1e-6, 1/mm",
)
BAKED_PICTURE = Tolerance(
    1e-3, "display values; curvature in single precision; a quarter of a level of 255"
)
LEAST_SQUARES = Tolerance(
    1e-6,
    "residual against that of SciPy's nnls; columns that are parallel within 1e-6 count as one",
)

# -- eyes ------------------------------------------------------------------------------------------

EYE_SURFACE = Tolerance(1e-8, "mm and 1; a spline whose end slopes are differences, 3e-10 measured")
EYE_SLOPE_JUMP = Tolerance(1e-6, "both sides of an edge, 1e-9 mm apart")
EYE_SLOPE = Tolerance(1e-6, "central differences of 1e-5 mm")
EYE_ON_SURFACE = Tolerance(1e-9, "mm; points of a cone or conic, from a quadratic in float64")
EYE_REFRACTION = Tolerance(0.02, "mm RMS at each angle to 80°; .019 measured at 80°")
EYE_REFRACTION_ALL = Tolerance(0.0112, "mm RMS over six angles; .0109 measured")
EYE_OTHER_CORNEAS = Tolerance(
    0.0025, "index that fits best, around 1.3405; 1.339 to 1.341 measured"
)
EYE_PUPIL = Tolerance(0.01, "magnification 1.13 of the entrance pupil")
EYE_TABLE_ORACLE = Tolerance(0.02, "RMS irradiance, 0 to 60°; .006 to .013 measured")
EYE_TABLE_ENTRY = Tolerance(0.05, "mm RMS; .026 to .033 measured")
EYE_TABLE_PHOTONS = {
    angle: Tolerance(value, f"RMS irradiance with noise of the photons; {measured} measured")
    for angle, value, measured in (
        (0.0, 0.035, 0.029),
        (28.0, 0.030, 0.024),
        (57.0, 0.022, 0.017),
        (76.0, 0.020, 0.015),
        (88.0, 0.050, 0.041),
        (98.0, 0.042, 0.033),
    )
}
EYE_TABLE_FLUX = Tolerance(0.01, "flux on the iris; the photons' noise is .002; relative")
EYE_FLUX_BALANCE = Tolerance(1e-9, "sums of all photons; relative")
EYE_FLUX_SHARE = Tolerance(0.006, "shares that are stated in whole per cent")
EYE_EVEN_SKY = Tolerance(0.02, "irradiance under an even sky, with photons' noise of .012")
EYE_BAND_1 = Tolerance(0.03, "part that rises with the cosine, with photons' noise of .015")
EYE_BAND_2 = Tolerance(0.03, "light of band 2 that the factor leaves out, at the rim")
EYE_LIDS_OPEN = Tolerance(0.022, "RMS share of an even sky, with noise of .02; .019 measured")
EYE_LIDS_LAMP = Tolerance(0.015, "RMS share of a lamp of 3°; .012 measured")
EYE_LIDS_IRIS = Tolerance(0.040, "RMS share of an even sky; .024 measured at the usual opening")
EYE_LIDS_IRIS_ALL = Tolerance(
    0.045, "as EYE_LIDS_IRIS, from wide open to half closed; .038 measured"
)
HIGHLIGHT_ENERGY = Tolerance(0.01, "integral over directions; small angles; relative")
FRESNEL_EXACT = Tolerance(1e-12, "Fresnel's amplitudes from angles")
