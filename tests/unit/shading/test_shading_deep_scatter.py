import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import brentq

import shading_tolerances as tol
from skinshade._core.errors import ArgumentError
from skinshade.shading.deep_scatter import (
    ambient_deep_scatter,
    classic_transmittance,
    default_sigma_per_mm,
    direct_deep_scatter,
    inward_offset,
    linear_depth,
    poisson_disk,
    thickness,
    thickness_from_depths,
    transmittance,
)

ALBEDO = st.floats(0.02, 0.98)
SIGMA = st.floats(0.05, 10.0)
LENGTH = st.floats(0.0, 40.0)


def depth_rows(kind, near, far, low, high):
    """Third and fourth row of a left-handed projection that maps near..far to low..high."""
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
def test_distance_comes_back_from_every_kind_of_depth(kind, handed, span, distance, near, depth):
    z = near + distance * depth
    projection = np.eye(4)
    projection[2:] = depth_rows(kind, near, near + depth, *RANGES[span])
    along = z
    if handed == "right":  # looks down −z
        projection = projection @ np.diag([1.0, 1.0, -1.0, 1.0])
        along = -z
    clip = projection @ [0.0, 0.0, along, 1.0]
    stored = clip[2] / clip[3]
    low, high = sorted(RANGES[span])
    assert low - 1e-9 <= stored <= high + 1e-9
    found = linear_depth(np.array(stored), projection)
    assert found == pytest.approx(z, rel=tol.DEPTH.value)


@pytest.mark.parametrize("taps", [1, 8, 32, 64])
def test_a_disk_of_taps_is_even_centred_and_always_the_same(taps):
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
        apart = np.linalg.norm(points[:, None] - points, axis=2)[~np.eye(taps, dtype=bool)]
        # Disks of that diameter would fill two fifths of the area at least; at most .907 is possible.
        assert apart.min() >= tol.TAPS_APART.value * np.sqrt(1.0 / taps)
        mean_square = np.square(radius).mean()
        assert mean_square == pytest.approx(0.5, abs=tol.EVEN_DISK.value)


@pytest.mark.parametrize("taps", [0, -1, 257])
def test_a_disk_without_a_sensible_number_of_taps_is_refused(taps):
    with pytest.raises(ArgumentError, match=str(taps)):
        poisson_disk(taps)


@given(st.floats(0.0, 50.0), st.lists(st.floats(0.0, 50.0), min_size=1, max_size=8))
def test_thickness_is_the_mean_depth_of_what_lies_before(receiver, occluders):
    found = thickness_from_depths(np.array(receiver), np.array(occluders))
    assert found == pytest.approx(np.mean([max(0.0, receiver - o) for o in occluders]))
    behind = thickness_from_depths(np.array(receiver), receiver + np.array(occluders))
    assert behind == 0.0


def test_the_receiver_moves_into_the_body():
    moved = inward_offset(np.array([[1.0, 2.0, 3.0]]), np.array([[0.0, 0.0, 1.0]]), 0.6)
    assert np.allclose(moved, [[1.0, 2.0, 2.4]], atol=tol.ROUNDING.value)


@given(ALBEDO, SIGMA, LENGTH)
def test_transmittance_is_the_formula_of_kubelka_and_munk(albedo, sigma, t):
    a = (1.0 + albedo**2) / (2.0 * albedo)
    b = np.sqrt(a * a - 1.0)  # their b; (1 − A²)/2A is the same
    x = sigma * t
    truth = 0.0 if x > 700.0 else b / (a * np.sinh(x) + b * np.cosh(x))
    found = transmittance(np.array(t), np.full(3, albedo), np.full(3, sigma))
    assert np.allclose(found, truth, rtol=tol.ROUNDING_SUMS.value, atol=1e-300)


@given(ALBEDO, SIGMA, LENGTH, st.floats(1e-3, 5.0))
def test_light_fades_with_thickness_from_all_to_none(albedo, sigma, t, more):
    a, s = np.full(3, albedo), np.full(3, sigma)
    at, farther, none = (transmittance(np.array(x), a, s) for x in (t, t + more, 0.0))
    assert np.abs(none - 1.0).max() <= tol.ROUNDING_SUMS.value
    assert (at <= 1.0 + tol.ROUNDING_SUMS.value).all()
    assert ((farther < at) | (at == 0.0)).all()
    assert transmittance(np.array(1e6), a, s).max() <= 1e-300


@given(ALBEDO, SIGMA)
def test_the_tail_is_exponential(albedo, sigma):
    t = np.array([20.0, 21.0]) / sigma
    far = transmittance(t, np.full(3, albedo), np.full(3, sigma))
    assert np.allclose(far[1] / far[0], np.exp(-1.0), rtol=tol.TAIL.value)


@given(st.floats(0.1, 0.9), st.floats(0.0, 10.0), st.floats(0.0, 10.0))
def test_two_slabs_let_through_what_one_of_their_thickness_does(albedo, first, second):
    """T₁₂ = T₁T₂/(1 − R₁R₂), with R from R² = 1 + T² − 2a·R of the same theory."""
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
    """σ of light deep in a medium that scatters evenly: 2κ/c = ln((1+κ)/(1−κ)), in mean free paths."""
    total = scattering + absorption
    c = scattering / total
    root = brentq(lambda k: np.log((1 + k) / (1 - k)) - 2.0 * k / c, 1e-6, 1.0 - 1e-12)
    return root * total


def test_slabs_let_through_what_was_simulated_with_the_mediums_own_decay(slab):
    sigma = [asymptotic_decay(s, a) for s, a in zip(*slab[4], strict=True)]
    assert (medians(slab, sigma) <= [t.value for t in tol.SLAB_DECAY]).all()


def test_slabs_let_through_what_was_simulated_with_a_decay_fitted_to_each_channel(slab):
    rivals = np.geomspace(0.1, 3.0, 800)
    each = np.array([medians(slab, np.full(3, sigma)) for sigma in rivals])
    assert (each.min(axis=0) <= [t.value for t in tol.SLAB_FITTED]).all()


def test_the_form_beats_the_gaussian_of_2014_in_the_tail(slab):
    thickness, total, known, _, _ = slab
    sigma = [asymptotic_decay(s, a) for s, a in zip(*slab[4], strict=True)]
    thick = thickness >= 8.0
    for channel in range(2):
        deep = thick & known[channel]
        truth = np.log(total[channel, deep])
        rivals = np.log([classic_transmittance(thickness[deep], r) for r in np.linspace(2, 9, 60)])
        ours = np.log(transmittance(thickness[deep], slab[3], np.array(sigma))[:, channel])
        best_gaussian = np.abs(rivals - truth).max(axis=1).min()
        assert np.abs(ours - truth).max() < 0.25 * best_gaussian


@given(st.floats(0.1, 10.0))
def test_the_default_decay_is_inverse_to_the_radius(scale):
    rms = np.array([3.0, 1.5, 0.9])
    assert np.allclose(default_sigma_per_mm(scale * rms) * scale, default_sigma_per_mm(rms))


@given(st.floats(0.5, 20.0))
def test_the_falloff_of_2014_is_a_gaussian(radius):
    t = radius * np.array([0.0, 1.0, 2.0])
    assert np.allclose(classic_transmittance(t, radius), np.exp([0.0, -0.5, -2.0]))


@given(st.floats(-1.0, 1.0), st.floats(0.0, 3.0))
def test_light_enters_where_the_far_side_faces_it(cosine, strength):
    passed = np.array([[0.5, 0.3, 0.1]])
    found = direct_deep_scatter(passed, np.array([cosine]), strength)
    assert np.allclose(found, strength * passed * max(0.0, -cosine), rtol=tol.ROUNDING.value)
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
def test_a_wall_before_a_receiver_is_as_thick_as_it_is_far(taps):
    uv = np.random.default_rng(0).random((20, 2))
    receiver = np.linspace(300.0, 500.0, 20)
    found = thickness(
        np.full((64, 48), stored(280.0)), PARALLEL, uv, receiver, 0.1 + 0.0 * uv, taps
    )
    assert np.abs(found - (receiver - 280.0)).max() <= tol.ROUNDING_SUMS.value * FAR


def test_taps_past_the_body_and_behind_the_receiver_find_no_wall():
    half = np.full((64, 64), 1.0)
    half[:, :32] = stored(290.0)
    uv = np.array([[0.5, 0.5], [0.9, 0.5], [0.1, 0.5]])
    found = thickness(half, PARALLEL, uv, np.full(3, 300.0), np.full((3, 2), 0.1), 32)
    assert 0.3 * 10.0 < found[0] < 0.7 * 10.0
    assert found[1] == 0.0
    assert abs(found[2] - 10.0) <= tol.ROUNDING_SUMS.value * FAR
    behind = thickness(half, PARALLEL, uv[2:], np.array([280.0]), np.full((1, 2), 0.1), 8)
    assert behind[0] == 0.0
