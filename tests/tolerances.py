"""Every tolerance of the tests, by name, with its reason."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Tolerance:
    """How far a figure may lie from the truth.

    Attributes
    ----------
    value
        In the unit of what is compared; relative where the reason says so.
    reason
        Why not less, and why not more.
    """

    value: float
    reason: str


# -- arithmetic ------------------------------------------------------------------------------------

ROUNDING = Tolerance(1e-12, "float64 identities, a few operations; relative")
ROUNDING_SUMS = Tolerance(1e-9, "float64 identities that sum or solve over thousands; relative")
FLOAT32 = Tolerance(3e-7, "stored as float32 of magnitude about 1: two units in the last place")

# -- profiles --------------------------------------------------------------------------------------

PUBLISHED_DIGIT = Tolerance(0.501, "units of the last digit in which a source prints a figure")
HANKEL = Tolerance(1e-9, "closed form against panel quadrature of the same smooth integrand")
HANKEL_TABULATED = Tolerance(
    2e-5, "T of tabulated flux is read from a spline over log k; 1.1e-5 was measured on the data"
)
MOMENT = Tolerance(1e-9, "second moment by panel quadrature; relative")
GAUSSIAN_FIT = Tolerance(3e-4, "|dT| that MODEL promises for the fit of every profile")
FIT_RANGE_K_RMS = Tolerance(
    150.0, "k times rms radius to which the fit is made: waves a 24th of the radius"
)
RMS_OF_BINNED_FLUX = Tolerance(
    2e-3, "mean square radius; flux is uniform within bins 5 % wide, which adds 0.17 %; relative"
)
FRESNEL_FIT = Tolerance(0.0015, "Egan and Hilgeman's fit of diffuse reflectance, index 1.1 to 1.5")
SMALL_K_SERIES = Tolerance(1e-4, "1 - T over k²ρ²/4 at kρ = 0.01: the next term is of order (kρ)²")

# -- lookup tables ---------------------------------------------------------------------------------

LUT_QUADRATURE = Tolerance(1e-5, "the promise of both tables against adaptive quadrature")
SERIES = Tolerance(1e-8, "Gaussian mixtures against a series of 12,000 terms; 3.4e-9 was measured")
SERIES_FITTED = Tolerance(1e-6, "other profiles against the long series; 6.2e-7 was measured")
SPHERE_MEAN = Tolerance(1e-9, "the mean over the sphere is a quarter")
RING_MEAN = Tolerance(1e-9, "the mean around the ring is 1/pi")
HEAT_KERNEL = Tolerance(1e-7, "light convolved with the heat kernel by quadrature, wide lobes")
FLAT_LIMIT = Tolerance(1e-6, "Lambert at a radius of 100 km: s/sqrt(2 pi) at the terminator")
ROUND_LIMIT = Tolerance(1e-9, "uniform light at a radius of a hundredth of the narrowest lobe")
MC_SPHERE_5MM = Tolerance(
    0.016, "RMS per channel, then the mean, A·E0, at r = 5 mm; .0148 measured"
)
MC_SPHERE_20MM = Tolerance(0.003, "as at 5 mm; .0022 measured at r = 20 mm")
MC_SPHERE_5MM_POOLED = Tolerance(0.018, "RMS over all channels at once, A·E0; .0177 measured")
MC_SPHERE_20MM_POOLED = Tolerance(0.003, "RMS over all channels at once, A·E0; .0025 measured")
GAIN_TOTAL = Tolerance(0.08, "light returned by a whole sphere; relative; red at 5 mm is worst")
COARSE_ROWS = Tolerance(3e-4, "32 rows interpolated bilinearly; MODEL promises 2e-4 between them")
GAIN_GAP = Tolerance(
    3.0, "Lambert, ring and sphere without gain are at least this many times worse"
)
CLASSIC_STEPS = Tolerance(1.0, "steps of 8 bits between ours and the construction of 2014")
WHOLE_STEP = Tolerance(2e-4, "steps of 8 bits: what float32 leaves of a whole number up to 255")
SAMPLE = Tolerance(1e-6, "bilinear weights at texel centres, after the axis; values up to 2")
PINNED_END = Tolerance(0.02, "of a row's end, half a texel from where it is pinned")
PNG_HALF_STEP = Tolerance(0.5, "steps of 16 bits, before the rounding of float32")

# -- meshes ----------------------------------------------------------------------------------------

CURVATURE_RMS = Tolerance(0.02, "RMS of the error over RMS of mean curvature, the promise")
CURVATURE_RMS_OWN_NORMALS = Tolerance(
    0.025, "as CURVATURE_RMS with computed normals; random triangulations of 16,000 reach .023"
)
CURVATURE_NOISE = Tolerance(0.10, "as CURVATURE_RMS with 1° of noise on each tangent component")
CURVATURE_GAIN_A_LEVEL = Tolerance(
    0.75, "error at four times the vertices over that before: first order would halve it"
)
PRINCIPAL_RMS = Tolerance(0.02, "RMS of a principal curvature over RMS of the greater one")
TUBE_TENSOR = Tolerance(
    0.01,
    "a tube of 96 sides, four passes: tensors turned by up to 15° are averaged; .0079 measured",
)
SPHERE_CURVATURE = Tolerance(1e-6, "exact on a sphere, but for the ridge of the fit; relative")
ROTATION = Tolerance(1e-7, "a rotation turns rounding into rounding, through the fit; relative")
EDGES_2014 = Tolerance(0.02, "around the 18 % RMS that MODEL reports of the 2014 method")
NORMALS_DEG = Tolerance(0.15, "RMS of computed normals on 16,000 random vertices, degrees")
TANGENT_DEG = Tolerance(2.0, "tangents on a 64×32 patch of a sphere, degrees")
LANCZOS = Tolerance(1e-7, "the iteration stops when no coefficient changes by 1e-8")
LANCZOS_SLACK = Tolerance(1.0, "error over the tolerance asked for, both relative to the input")
EIGENFUNCTION = Tolerance(5e-3, "cotangent Laplacian at 2,562 vertices: second order in the edge")
CONSERVED = Tolerance(1e-7, "constants and integrals; relative to the field")
SELF_ADJOINT = Tolerance(1e-7, "<u, Hv> = <Hu, v>, by where the iteration stops; relative")
SEMIGROUP = Tolerance(1e-7, "two steps of v against one of 2v, by where the iteration stops")
DIFFUSED_NORMALS = Tolerance(1e-3, "their length on a sphere of 2,562 vertices; relative")
COARSE_NORMALS = Tolerance(2e-3, "computed normals of a ball of 162 vertices; length of the error")
CURVATURE_OF_ROUNDED = Tolerance(1e-4, "computed from positions rounded to float32; relative")
FLOAT32_FILE = Tolerance(1e-6, "positions of magnitude 1 kept as float32 or 8 digits of text")
SCAN_SIZE_MM = Tolerance(1.0, "the scan's size is known to the millimetre")
SCAN_FILES_AGREE_MM = Tolerance(0.01, "two files of one scan, rounded to six digits, mm")
SCAN_CURVATURE = Tolerance(0.05, "percentiles of curvature of both files; relative to their RMS")
SCAN_CORRELATION = Tolerance(0.93, "of both files' curvature, split into other triangles")
QUANTISED_NORMALS = Tolerance(
    3e-3, "normals in 8 bits are 0.2° off, of the 17° that a coarse edge spans; smoothed; relative"
)
THICKNESS = Tolerance(0.01, "64 rays of a cone, facets of a sphere of 2,562 vertices; relative")
THICKNESS_FEW_RAYS = Tolerance(
    0.02, "where the wall is not smooth over the cone, or the mesh is coarse; relative"
)
THICKNESS_HALF_CONE = Tolerance(
    0.02, "half the cone's rays, cut along the spiral's middle; relative"
)
EMBREE_WALL = Tolerance(2e-6, "single precision; of the body's size")
EMBREE_THICKNESS = Tolerance(1e-4, "as EMBREE_WALL, of a slab a thirtieth as thick as it is wide")
MAP_INTERPOLATED = Tolerance(1e-6, "a linear ramp at texel centres; barycentrics of the raster")
UV_DENSITY = Tolerance(1e-9, "root of a ratio of two areas; relative")
COARSE_EXTENT = Tolerance(0.02, "the axes of a turned ball of 162 vertices pass between them")
MEMORY_OF_A_BOMB = Tolerance(2.0, "times what the honest file needs, the promise")
