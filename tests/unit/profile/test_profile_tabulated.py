import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from scipy.special import j1

import tolerances as tol
from skinshade._core.errors import ArgumentError
from skinshade.profile import Profile

BOUNDARIES = pytest.mark.parametrize("boundary", ["matched", "ior14"])


def monte_carlo_profile(halfspace, boundary):
    return Profile.tabulated(
        edges_mm=halfspace["edges_mm"],
        flux=halfspace[f"flux_{boundary}"],
        albedo=halfspace[f"albedo_{boundary}"],
    )


def sum_of_annuli(edges, flux, k):
    """Return the Hankel transform of uniform annuli, as differences of disks, in a loop."""
    total = np.zeros((k.size, 3))
    shares = (flux / flux.sum(axis=1, keepdims=True)).T
    for a, b, light in zip(edges[:-1], edges[1:], shares, strict=True):
        disks = b * j1(k * b) - (a * j1(k * a) if a > 0.0 else 0.0)
        total += 2.0 * (disks / (k * (b * b - a * a)))[:, None] * light
    return total


@BOUNDARIES
def test_the_transform_of_the_monte_carlo_profile_is_the_sum_of_its_annuli(halfspace, boundary):
    profile = monte_carlo_profile(halfspace, boundary)
    k = np.geomspace(1e-3, 1e3, 1500)
    expected = sum_of_annuli(halfspace["edges_mm"], halfspace[f"flux_{boundary}"], k)
    assert np.abs(profile.transfer(k) - expected).max() <= tol.HANKEL_TABULATED.value


@BOUNDARIES
def test_the_rms_radius_is_that_of_the_simulated_photons(halfspace, boundary):
    profile = monte_carlo_profile(halfspace, boundary)
    ratio = np.square(profile.rms_radius_mm) / halfspace[f"meanr2_{boundary}"]
    assert np.abs(ratio - 1.0).max() <= tol.RMS_OF_BINNED_FLUX.value


@BOUNDARIES
def test_gaussians_fit_the_monte_carlo_profile(halfspace, boundary):
    profile = monte_carlo_profile(halfspace, boundary)
    k = np.geomspace(1e-3, tol.FIT_RANGE_K_RMS.value / profile.rms_radius_mm.min(), 2000)
    mixture, _ = profile.gaussian_fit()
    assert np.abs(mixture.transfer(k) - profile.transfer(k)).max() <= tol.GAUSSIAN_FIT.value


@st.composite
def tables(draw):
    steps = draw(st.lists(st.floats(0.05, 1.0), min_size=2, max_size=12))
    edges = np.concatenate([[0.0], np.cumsum(steps)])
    flux = draw(hnp.arrays(np.float64, (3, len(steps)), elements=st.floats(0.0, 5.0)))
    flux[:, 0] += 0.01
    return edges, flux


@given(tables())
@example(table=(np.append(np.arange(8.0), 7.0546875), np.ones((3, 8))))
def test_the_transform_of_any_table_is_the_sum_of_its_annuli(table):
    profile = Profile.tabulated(edges_mm=table[0], flux=table[1], albedo=0.5)
    k = np.geomspace(1e-3, 40.0, 60)
    expected = sum_of_annuli(*table, k)
    assert np.abs(profile.transfer(k) - expected).max() <= tol.HANKEL_TABULATED.value


@given(tables(), st.floats(1e-3, 1e3))
def test_the_scale_of_the_flux_does_not_matter(table, scale):
    one = Profile.tabulated(edges_mm=table[0], flux=table[1], albedo=0.5)
    other = Profile.tabulated(edges_mm=table[0], flux=table[1] * scale, albedo=0.5)
    assert np.allclose(one.kernel.flux, other.kernel.flux, rtol=tol.ROUNDING_SUMS.value)
    assert np.allclose(one.kernel.flux.sum(axis=1), 1.0, rtol=tol.ROUNDING.value)


@given(tables())
def test_the_second_moment_is_that_of_uniform_annuli(table):
    profile = Profile.tabulated(edges_mm=table[0], flux=table[1], albedo=0.5)
    a, b = table[0][:-1], table[0][1:]
    share = table[1] / table[1].sum(axis=1, keepdims=True)
    expected = (share * 0.5 * (a * a + b * b)).sum(axis=1)
    assert np.allclose(np.square(profile.rms_radius_mm), expected, rtol=tol.ROUNDING_SUMS.value)


def test_the_density_is_uniform_within_an_annulus_and_0_outside():
    flux = np.array([[1.0, 3.0]] * 3)
    profile = Profile.tabulated(edges_mm=[1.0, 2.0, 4.0], flux=flux, albedo=0.5)
    inner, outer = 0.25 / (3.0 * np.pi), 0.75 / (12.0 * np.pi)
    values = profile.radial([0.5, 1.0, 1.9, 2.0, 3.9, 4.0, 9.0])[:, 0]
    assert np.allclose(values, [0.0, inner, inner, outer, outer, 0.0, 0.0])


@pytest.mark.parametrize("k", [0.0, 1e-12, 1e-7])
def test_the_transform_is_1_below_the_range_of_the_spline(measured, k):
    assert np.allclose(measured.transfer(k), 1.0, atol=tol.ROUNDING_SUMS.value)


def test_the_transform_is_0_above_the_range_of_the_spline(measured):
    assert (measured.transfer(1e7) == 0.0).all()


@pytest.mark.parametrize(
    ("edges", "flux", "complaint"),
    [
        ([0.0], np.ones((3, 0)), "two or more radii, and they must increase"),
        ([0.0, 0.0], np.ones((3, 1)), "two or more radii, and they must increase"),
        ([0.0, 2.0, 1.0], np.ones((3, 2)), "two or more radii, and they must increase"),
        ([-1.0, 1.0], np.ones((3, 1)), r"edges_mm\[0\] is -1"),
        ([0.0, np.inf], np.ones((3, 1)), r"edges_mm\[1\] is inf"),
        ([0.0, 1.0], np.ones((3, 2)), "flux: shape"),
        ([0.0, 1.0], np.ones((1, 3)), "flux: shape"),
        ([0.0, 1.0], [[1.0], [-1.0], [1.0]], r"flux\[1, 0\] is -1"),
        ([0.0, 1.0], [[1.0], [0.0], [1.0]], "each sum must be positive"),
    ],
)
def test_edges_or_flux_that_are_no_profile_are_refused(edges, flux, complaint):
    with pytest.raises(ArgumentError, match=complaint):
        Profile.tabulated(edges_mm=edges, flux=flux, albedo=0.5)
