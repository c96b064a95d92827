"""Deep scatter: thickness from depth maps, and transmittance against simulated slabs."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import brentq

import shading_tolerances as tol
from skinshade._core.errors import ArgumentError
from skinshade.shading.deep_scatter import (
    THICKNESS_TAPS,
    ambient_deep_scatter,
    classic_transmittance,
    default_sigma_per_mm,
    direct_deep_scatter,
    inward_offset,
    linear_depth,
    mean_thickness,
    poisson_disk,
    thickness,
    transmittance,
)

ALBEDO = st.floats(0.02, 0.98)
SIGMA = st.floats(0.05, 10.0)
LENGTH = st.floats(0.0, 40.0)


def depth_rows(kind, near, far, low, high):
    """Return rows 2 and 3 of a left-handed projection that maps near..far to low..high."""
    if kind == "parallel":
        scale = (high - low) / (far - near)
        return [0.0, 0.0, scale, low - near * scale], [0.0, 0.0, 0.0, 1.0]
    scale = (high * far - low * near) / (far - near)
    return [0.0, 0.0, scale, near * (low - scale)], [0.0, 0.0, 1.0, 0.0]


RANGES = {
    "0..1": (0.0, 1.0),
    "-1..1": (-1.0, 1.0),
    "reversed": (1.0, 0.0),
    "-1..1 reversed": (1, -1),
}


@pytest.mark.parametrize("span", RANGES)
@pytest.mark.parametrize("handed", ["left", "right"])
@pytest.mark.parametrize("kind", ["parallel", "perspective"])
@given(distance=st.floats(0.0, 1.0), near=st.floats(1.0, 50.0), depth=st.floats(10.0, 500.0))
def test_linear_depth_inverts_every_kind_of_projection(kind, handed, span, distance, near, depth):
    z = near + distance * depth
    projection = np.eye(4)
    projection[2:] = depth_rows(kind, near, near + depth, *RANGES[span])
    along = z
    if handed == "right":  # looks along −z
        projection = projection @ np.diag([1.0, 1.0, -1.0, 1.0])
        along = -z
    clip = projection @ [0.0, 0.0, along, 1.0]
    stored = clip[2] / clip[3]
    low, high = sorted(RANGES[span])
    assert low - 1e-9 <= stored <= high + 1e-9
    result = linear_depth(np.array(stored), projection)
    assert result == pytest.approx(z, rel=tol.DEPTH.value)


@pytest.mark.parametrize("taps", [1, 8, 32, 64])
def test_a_poisson_disk_is_even_centred_and_deterministic(taps):
    points = poisson_disk(taps)
    radius = np.linalg.norm(points, axis=1)
    assert points.shape == (taps, 2)
    assert radius.max() <= 1.0 + tol.ROUNDING.value
    assert np.abs(points.mean(axis=0)).max() <= tol.CENTRED.value
    poisson_disk.cache_clear()
    assert np.array_equal(points, poisson_disk(taps))
    with pytest.raises(ValueError, match="read-only"):
        points[0] = 0.0
    if taps > 1:
        distances = np.linalg.norm(points[:, None] - points, axis=2)[~np.eye(taps, dtype=bool)]
        # Circles of that diameter fill a fifth of the disk; at most .907 is possible.
        assert distances.min() >= tol.TAPS_APART.value * np.sqrt(1.0 / taps)
        mean_square = np.square(radius).mean()
        assert mean_square == pytest.approx(0.5, abs=tol.EVEN_DISK.value)


@pytest.mark.parametrize("taps", [0, -1, 257])
def test_a_number_of_taps_outside_1_to_256_is_an_error(taps):
    with pytest.raises(ArgumentError, match=f"taps is {taps}; it must be 1..256"):
        poisson_disk(taps)


@pytest.mark.parametrize("taps", THICKNESS_TAPS)
@given(receiver=st.floats(0.0, 50.0), seed=st.integers(0, 2**20))
def test_thickness_is_the_mean_of_the_positive_differences_of_depth(taps, receiver, seed):
    rng = np.random.default_rng(seed)
    depths = rng.uniform(0.0, 50.0, (24, 32))
    depths[rng.random(depths.shape) < 0.2] = np.inf
    uv, radius = rng.random((5, 2)), rng.uniform(0.0, 0.3, (5, 2))
    result = mean_thickness(depths, uv, np.full(5, receiver), radius, taps)
    for point in range(5):
        at = (uv[point] + radius[point] * poisson_disk(taps)) * (32, 24)
        column, row = np.clip(at, 0, (31, 23)).astype(int).T
        differences = [max(0.0, receiver - depth) for depth in depths[row, column]]
        assert result[point] == pytest.approx(np.mean(differences), abs=tol.ROUNDING.value)


@given(st.floats(0.0, 50.0), st.floats(0.0, 50.0))
def test_surfaces_behind_the_receiver_add_no_thickness(receiver, behind):
    depths, middle = np.full((4, 4), receiver + behind), np.full((1, 2), 0.5)
    result = mean_thickness(depths, middle, np.array([receiver]), np.full((1, 2), 0.2), 8)
    assert result == 0.0


def test_the_receiver_moves_against_its_normal():
    moved = inward_offset(np.array([[1.0, 2.0, 3.0]]), np.array([[0.0, 0.0, 1.0]]), 0.6)
    assert np.allclose(moved, [[1.0, 2.0, 2.4]], atol=tol.ROUNDING.value)


@given(ALBEDO, SIGMA, LENGTH)
def test_transmittance_is_the_formula_of_kubelka_and_munk(albedo, sigma, t):
    a = (1.0 + albedo**2) / (2.0 * albedo)
    b = np.sqrt(a * a - 1.0)  # equal to (1 − A²)/2A
    x = sigma * t
    truth = 0.0 if x > 700.0 else b / (a * np.sinh(x) + b * np.cosh(x))
    result = transmittance(np.array(t), np.full(3, albedo), np.full(3, sigma))
    assert np.allclose(result, truth, rtol=tol.ROUNDING_SUMS.value, atol=1e-300)


@given(ALBEDO, SIGMA, LENGTH, st.floats(1e-3, 5.0))
def test_transmittance_falls_with_thickness_from_1_to_0(albedo, sigma, t, more):
    a, s = np.full(3, albedo), np.full(3, sigma)
    thin, thicker, zero = (transmittance(np.array(x), a, s) for x in (t, t + more, 0.0))
    assert np.abs(zero - 1.0).max() <= tol.ROUNDING_SUMS.value
    assert (thin <= 1.0 + tol.ROUNDING_SUMS.value).all()
    assert ((thicker < thin) | (thin == 0.0)).all()
    assert transmittance(np.array(1e6), a, s).max() <= 1e-300


@given(ALBEDO, SIGMA)
def test_transmittance_of_thick_slabs_is_exponential(albedo, sigma):
    t = np.array([20.0, 21.0]) / sigma
    far = transmittance(t, np.full(3, albedo), np.full(3, sigma))
    assert np.allclose(far[1] / far[0], np.exp(-1.0), rtol=tol.TAIL.value)


@given(st.floats(0.1, 0.9), st.floats(0.0, 10.0), st.floats(0.0, 10.0))
def test_two_slabs_transmit_as_much_as_one_of_their_total_thickness(albedo, first, second):
    """T₁₂ = T₁T₂/(1 − R₁R₂), with R from R² = 1 + T² − 2aR of the same theory."""
    a = (1.0 + albedo**2) / (2.0 * albedo)

    def slab(t):
        T = float(transmittance(np.array(t), np.full(3, albedo), np.full(3, 0.7))[0])
        b = (1.0 - albedo**2) / (2.0 * albedo)
        x = 0.7 * t
        return T, np.sinh(x) / (a * np.sinh(x) + b * np.cosh(x))

    (t1, r1), (t2, r2), (both, _) = slab(first), slab(second), slab(first + second)
    assert both == pytest.approx(t1 * t2 / (1.0 - r1 * r2), rel=tol.ROUNDING_SUMS.value)


@pytest.fixture(scope="module")
def slab(data_dir):
    with np.load(data_dir / "truth" / "mc_slab.npz") as archive:
        data = dict(archive)
    total = data["T_matched_diffuse"] + data["Tballistic_matched_diffuse"]
    known = total > 5.0 * data["Terr_matched_diffuse"]
    coefficients = data["sigma_s_prime"], data["sigma_a"]
    return data["thickness_mm"], total, known, data["R_matched_diffuse"][:, -1], coefficients


def medians(slab, sigma):
    thickness, total, known, albedo, _ = slab
    ratio = transmittance(thickness, albedo, np.asarray(sigma)).T / np.where(known, total, 1.0)
    return np.array([np.median(np.abs(np.log(r[k]))) for r, k in zip(ratio, known, strict=True)])


def asymptotic_decay(scattering, absorption):
    """Return σ deep in an isotropic medium, from 2κ/c = ln((1+κ)/(1−κ)) in mean free paths."""
    total = scattering + absorption
    c = scattering / total
    root = brentq(lambda k: np.log((1 + k) / (1 - k)) - 2.0 * k / c, 1e-6, 1.0 - 1e-12)
    return root * total


def test_transmittance_with_the_asymptotic_decay_agrees_with_simulated_slabs(slab):
    sigma = [asymptotic_decay(s, a) for s, a in zip(*slab[4], strict=True)]
    assert (medians(slab, sigma) <= [t.value for t in tol.SLAB_DECAY]).all()


def test_transmittance_with_fitted_decays_agrees_with_simulated_slabs(slab):
    sigmas = np.geomspace(0.1, 3.0, 800)
    errors = np.array([medians(slab, np.full(3, sigma)) for sigma in sigmas])
    assert (errors.min(axis=0) <= [t.value for t in tol.SLAB_FITTED]).all()


def test_for_thick_slabs_the_formula_is_four_times_as_accurate_as_the_gaussian_of_2014(slab):
    thickness, total, known, _, _ = slab
    sigma = [asymptotic_decay(s, a) for s, a in zip(*slab[4], strict=True)]
    thick = thickness >= 8.0
    for channel in range(2):
        deep = thick & known[channel]
        truth = np.log(total[channel, deep])
        gaussians = np.log(
            [classic_transmittance(thickness[deep], r) for r in np.linspace(2, 9, 60)]
        )
        result = np.log(transmittance(thickness[deep], slab[3], np.array(sigma))[:, channel])
        best_gaussian = np.abs(gaussians - truth).max(axis=1).min()
        assert np.abs(result - truth).max() < 0.25 * best_gaussian


@given(st.floats(0.1, 10.0))
def test_the_default_decay_is_inversely_proportional_to_the_rms_radius(scale):
    rms = np.array([3.0, 1.5, 0.9])
    assert np.allclose(default_sigma_per_mm(scale * rms) * scale, default_sigma_per_mm(rms))


@given(st.floats(0.5, 20.0))
def test_the_falloff_of_2014_is_a_gaussian(radius):
    t = radius * np.array([0.0, 1.0, 2.0])
    assert np.allclose(classic_transmittance(t, radius), np.exp([0.0, -0.5, -2.0]))


@given(st.floats(-1.0, 1.0), st.floats(0.0, 3.0))
def test_deep_scatter_is_proportional_to_strength_and_to_the_cosine_of_the_far_side(
    cosine, strength
):
    passed = np.array([[0.5, 0.3, 0.1]])
    result = direct_deep_scatter(passed, np.array([cosine]), strength)
    assert np.allclose(result, strength * passed * max(0.0, -cosine), rtol=tol.ROUNDING.value)
    assert np.allclose(
        ambient_deep_scatter(passed, np.array([[2.0, 1.0, 4.0]]), strength),
        strength * np.array([[1.0, 0.3, 0.4]]),
    )


NEAR, FAR = 100.0, 900.0
PARALLEL = np.array(
    [[1e-2, 0, 0, 0], [0, 1e-2, 0, 0], [0, 0, 1 / (NEAR - FAR), NEAR / (NEAR - FAR)], [0, 0, 0, 1]]
)


def stored(distance_mm):
    return (np.asarray(distance_mm) - NEAR) / (FAR - NEAR)


@pytest.mark.parametrize("taps", [8, 32])
def test_before_a_plane_wall_the_thickness_is_the_distance_to_it(taps):
    uv = np.random.default_rng(0).random((20, 2))
    receiver = np.linspace(300.0, 500.0, 20)
    wall = np.full((64, 48), stored(280.0))
    result = thickness(wall, PARALLEL, uv, receiver, np.full((20, 2), 0.1), taps)
    assert np.abs(result - (receiver - 280.0)).max() <= tol.ROUNDING_SUMS.value * FAR


def test_taps_beside_a_wall_or_with_the_wall_behind_the_receiver_add_no_thickness():
    half = np.full((64, 64), 1.0)
    half[:, :32] = stored(290.0)
    uv = np.array([[0.5, 0.5], [0.9, 0.5], [0.1, 0.5]])
    result = thickness(half, PARALLEL, uv, np.full(3, 300.0), np.full((3, 2), 0.1), 32)
    assert 0.3 * 10.0 < result[0] < 0.7 * 10.0
    assert result[1] == 0.0
    assert abs(result[2] - 10.0) <= tol.ROUNDING_SUMS.value * FAR
    behind = thickness(half, PARALLEL, uv[2:], np.array([280.0]), np.full((1, 2), 0.1), 8)
    assert behind[0] == 0.0
