"""Every tolerance of the tests, by name, with its reason."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Tolerance:
    """Greatest error that a test accepts.

    Attributes
    ----------
    value
        In the unit of the compared values; relative where the reason says so.
    reason
        Why it is not less and not more.
    """

    value: float
    reason: str


# -- arithmetic ------------------------------------------------------------------------------------

ROUNDING = Tolerance(1e-12, "identities in float64 of a few operations; relative")
ROUNDING_SUMS = Tolerance(
    1e-9, "identities in float64 with sums or solutions of thousands of terms; relative"
)
FLOAT32 = Tolerance(3e-7, "float32 of magnitude about 1: two units in the last place")

# -- profiles --------------------------------------------------------------------------------------

PUBLISHED_DIGIT = Tolerance(0.501, "units of the last digit that a source prints")
HANKEL = Tolerance(1e-9, "closed form against quadrature over panels of the same smooth integrand")
HANKEL_TABULATED = Tolerance(
    2e-5, "T of tabulated flux comes from a spline over log k; 1.1e-5 was measured on the data"
)
MOMENT = Tolerance(1e-9, "second moment by quadrature over panels; relative")
SKIN_CLOSURE_EDGE = Tolerance(
    0.02, "RMS of T against Cycles' walk; .0089 .0094 .0167 measured, .18 with the wrong length"
)
GAUSSIAN_FIT = Tolerance(3e-4, "|ΔT| of the fit of every profile, as MODEL states")
FIT_RANGE_K_RMS = Tolerance(
    150.0, "greatest k times rms radius of the fit: a wavelength of a 24th of the radius"
)
RMS_OF_BINNED_FLUX = Tolerance(
    2e-3, "mean square radius; uniform flux within bins of 5 % adds 0.17 %; relative"
)
FRESNEL_FIT = Tolerance(
    0.0015, "the fit of diffuse reflectance by Egan and Hilgeman, index 1.1 to 1.5"
)
SMALL_K_SERIES = Tolerance(1e-4, "1 - T over k²ρ²/4 at kρ = 0.01: the next term is of order (kρ)²")

# -- lookup tables ---------------------------------------------------------------------------------

LUT_QUADRATURE = Tolerance(1e-5, "both tables against adaptive quadrature, as MODEL states")
SERIES = Tolerance(
    1e-8, "mixtures of Gaussians against a series of 12,000 terms; 3.4e-9 was measured"
)
SERIES_FITTED = Tolerance(1e-6, "other profiles against the same series; 6.2e-7 was measured")
SPHERE_MEAN = Tolerance(1e-9, "the mean over the sphere is 1/4")
RING_MEAN = Tolerance(1e-9, "the mean around the ring is 1/π")
HEAT_KERNEL = Tolerance(
    1e-7, "convolution of light with the heat kernel by quadrature, for wide lobes"
)
FLAT_LIMIT = Tolerance(1e-6, "Lambert at a radius of 100 km: s/√(2π) at the terminator")
ROUND_LIMIT = Tolerance(1e-9, "uniform light at a radius of 1/100 of the narrowest lobe")
MC_SPHERE_5MM = Tolerance(0.016, "mean over channels of the RMS, A·E0, at r = 5 mm; .0148 measured")
MC_SPHERE_20MM = Tolerance(0.003, "as MC_SPHERE_5MM at r = 20 mm; .0022 measured")
MC_SPHERE_5MM_POOLED = Tolerance(0.018, "RMS over all channels, A·E0; .0177 measured")
MC_SPHERE_20MM_POOLED = Tolerance(0.003, "RMS over all channels, A·E0; .0025 measured")
GAIN_TOTAL = Tolerance(
    0.08, "light that a whole sphere returns; greatest for red at 5 mm; relative"
)
COARSE_ROWS = Tolerance(3e-4, "bilinear interpolation of 32 rows; MODEL states 2e-4")
GAIN_GAP = Tolerance(
    3.0, "least ratio of the errors of Lambert, ring and sphere without gain to that with gain"
)
CLASSIC_STEPS = Tolerance(1.0, "steps of 8 bits between the table and the construction of 2014")
WHOLE_STEP = Tolerance(2e-4, "steps of 8 bits: float32 rounding of whole numbers up to 255")
SAMPLE = Tolerance(1e-6, "rounding of bilinear weights at texel centres; values up to 2")
TRANSFER_INTERPOLATED = Tolerance(
    2e-6, "linear between 2,048 columns of equal steps of the root of k"
)
PINNED_END = Tolerance(0.02, "ends of rows are half a texel from the positions of 0 and 1")
PNG_HALF_STEP = Tolerance(0.5, "steps of 16 bits, without the rounding of float32")

# -- meshes ----------------------------------------------------------------------------------------

CURVATURE_RMS = Tolerance(0.02, "RMS of the error over RMS of mean curvature, as documented")
CURVATURE_RMS_OWN_NORMALS = Tolerance(
    0.025, "as CURVATURE_RMS with computed normals; .023 on random meshes of 16,000 vertices"
)
CURVATURE_NOISE = Tolerance(0.10, "as CURVATURE_RMS with 1° of noise on each tangent component")
CURVATURE_GAIN_A_LEVEL = Tolerance(
    0.75, "ratio of errors at four times as many vertices: 0.5 is first order in the edge"
)
PRINCIPAL_RMS = Tolerance(
    0.02, "RMS of the error of a principal curvature over RMS of the greater one"
)
TUBE_TENSOR = Tolerance(
    0.01,
    "a tube of 96 sides: four passes average tensors turned by up to 15°; .0079 measured",
)
NATIVE_NORMALS = Tolerance(
    1e-11, "compiled against NumPy; the quadric's matrix has a condition of up to 1e5"
)
NATIVE_CURVATURE = Tolerance(
    1e-11, "compiled against NumPy on surfaces; sums in another order; relative to the greatest"
)
NATIVE_ANY_MESH = Tolerance(
    1e-6, "as NATIVE_CURVATURE on any faces: the fit of parallel edges has a condition of 1e9"
)
NATIVE_FETCH = Tolerance(
    1e-12, "compiled against NumPy: bilinear weights of values of magnitude 1 in float64"
)
NATIVE_RASTER = Tolerance(
    1e-9, "compiled against NumPy: sums of edge functions in another order; relative"
)
NATIVE_TAPS = Tolerance(
    2e-3, "float32 taps against float64: positions err by 1e-4 texels of a map 1,024 texels wide"
)
SPHERE_CURVATURE = Tolerance(1e-6, "the fit is exact on a sphere except for its ridge; relative")
ROTATION = Tolerance(1e-7, "a rotation changes the rounding, which the fit amplifies; relative")
EDGES_2014 = Tolerance(0.02, "difference to the 18 % RMS that MODEL states for the method of 2014")
NORMALS_DEG = Tolerance(
    0.15, "RMS of the error of computed normals on 16,000 random vertices, degrees"
)
TANGENT_DEG = Tolerance(2.0, "tangents on a sphere of 2,562 vertices, degrees")
MATRIX_FUNCTION = Tolerance(
    1e-7, "diffusion errs by 1e-8 of the norm of the field, most of which can lie at one vertex"
)
MATRIX_FUNCTION_SLACK = Tolerance(
    1.0, "error over the requested tolerance, both relative to the input"
)
NATIVE_LAPLACIAN = Tolerance(
    1e-12, "compiled against NumPy; sums in another order; relative to the greatest of a mesh"
)
NATIVE_DIFFUSION = Tolerance(
    1e-12, "compiled against NumPy over a hundred products; relative to the greatest value"
)
EIGENVALUE_BOUND = Tolerance(
    0.12, "bound over the greatest eigenvalue on a sphere of 642 vertices; .108 measured; relative"
)
EIGENFUNCTION = Tolerance(5e-3, "cotangent Laplacian of 2,562 vertices, second order in the edge")
CONSERVED = Tolerance(1e-7, "constants and integrals, relative to the field, as documented")
SELF_ADJOINT = Tolerance(1e-7, "<u, Hv> = <Hu, v> within the error of the iteration; relative")
SEMIGROUP = Tolerance(1e-7, "two steps of v against one of 2v, within the error of the iteration")
DIFFUSED_NORMALS = Tolerance(
    1e-3, "length of diffused normals on a sphere of 2,562 vertices; relative"
)
COARSE_NORMALS = Tolerance(
    2e-3, "length of the error of computed normals on a sphere of 162 vertices"
)
CONVEX = Tolerance(
    0.02, "rays from rounded vertices of a sphere, which meet no face but neighbours; relative"
)
CURVATURE_OF_ROUNDED = Tolerance(1e-4, "curvature from positions rounded to float32; relative")
FLOAT32_FILE = Tolerance(1e-6, "positions of magnitude 1 stored as float32 or 8 digits of text")
SCAN_SIZE_MM = Tolerance(1.0, "the size of the scan is known to the millimetre")
SCAN_FILES_AGREE_MM = Tolerance(
    0.01, "positions in two files of one scan, rounded to six digits, mm"
)
SCAN_CURVATURE = Tolerance(0.05, "percentiles of curvature of both files, relative to its RMS")
SCAN_CORRELATION = Tolerance(0.93, "correlation of curvature of both files, whose triangles differ")
QUANTISED_NORMALS = Tolerance(
    3e-3, "normals in 8 bits err by 0.2° of the 17° that an edge spans, then smoothed; relative"
)
THICKNESS = Tolerance(
    0.01, "64 rays in a cone, on the facets of a sphere of 2,562 vertices; relative"
)
THICKNESS_FEW_RAYS = Tolerance(
    0.02, "walls that are not smooth over the cone, or coarse meshes; relative"
)
THICKNESS_SHARED = Tolerance(
    0.03, "rays that neighbours share on a smooth body, at 95 % of the vertices; relative"
)
THICKNESS_HALF_CONE = Tolerance(
    0.02, "half of the rays of a spiral, cut through its centre; relative"
)
EMBREE_WALL = Tolerance(2e-6, "single precision; relative to the size of the body")
EMBREE_THICKNESS = Tolerance(
    1e-4, "as EMBREE_WALL, for a slab with a thickness of 1/30 of its width; relative"
)
MAP_INTERPOLATED = Tolerance(
    1e-6, "a linear ramp at texel centres, by barycentric coordinates of the rasterizer"
)
UV_DENSITY = Tolerance(1e-9, "square root of the ratio of two areas; relative")
COARSE_EXTENT = Tolerance(
    0.02, "the extremes of a rotated sphere of 162 vertices lie between vertices"
)
MEMORY_OF_A_BOMB = Tolerance(2.0, "memory over that of a valid file of equal content")

# -- sun of an environment -------------------------------------------------------------------------

SUN_FLUX = Tolerance(1e-3, "irradiance of a drawn sun; float32 texels give 1e-6; relative")
SUN_DIRECTION_DEG = Tolerance(0.1, "degrees; the drawn disc has samples of a ninth of a texel")
SUN_CONSERVATION = Tolerance(1e-6, "sums of float32 texels in float64; relative")
SUN_SHARE = Tolerance(0.005, "shares are stated in whole per cent")

# -- pictures against path tracing -----------------------------------------------------------------

FLIP_OF_SHADING = {
    "lambert": Tolerance(0.0202, "FLIP; .0194 measured"),
    "classic": Tolerance(0.0315, "FLIP; .0304 measured"),
    "transfer": Tolerance(0.0133, "FLIP; .0129 measured"),
}
FLIP_FLOOR = Tolerance(0.0100, "FLIP of 128 samples beside 512; .0095 measured")
PIXEL_FILTER = Tolerance(
    8e-5, "mean |Δ| of coverage, 4 × 4 samples a pixel; 4.7e-5 measured, 2.0e-4 with a box"
)
PASS_SUM = Tolerance(1e-6, "float32 sums of eight terms of magnitude 1")
NORMAL_CDF = Tolerance(4e-16, "Taylor polynomials between nodes of math.erfc, and four roundings")
NORMAL_CDF_TAIL = Tolerance(1e-7, "the fifth power of 37 / 512 over 120; relative")
