"""Profiles of every kind: the transfer function is the Hankel transform of the radial density."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.special import j0

import tolerances as tol
from skinshade._core.errors import ArgumentError
from skinshade.profile import Profile, presets

EDGES_MM = np.concatenate([[0.0], np.geomspace(1e-3, 30.0, 241)])


def tabulated_gaussians() -> Profile:
    """Return a table of the exact flux of d'Eon's skin within annuli."""
    skin = Profile.preset("skin-deon2007").kernel
    outside = np.exp(-0.5 * EDGES_MM[:, None] ** 2 / skin.variances_mm2) @ skin.weights
    return Profile.tabulated(edges_mm=EDGES_MM, flux=-np.diff(outside, axis=0).T, albedo=0.5)


PROFILES = {
    **{name: Profile.preset(name) for name in presets()},
    "burley": Profile.burley(length_mm=(0.6, 0.25, 0.15), kind="shape", albedo=0.5),
    "dipole without a boundary": Profile.dipole(
        sigma_s_prime_per_mm=1.0, sigma_a_per_mm=0.1, ior=1.0
    ),
    "tabulated": tabulated_gaussians(),
}
EVERY_KIND = pytest.mark.parametrize("profile", PROFILES.values(), ids=PROFILES)


def panels(profile: Profile) -> tuple[np.ndarray, np.ndarray]:
    """Return Gauss-Legendre nodes and weights over r, denser towards 0; the annuli end at panel edges."""
    rms = profile.rms_radius_mm
    edges = np.concatenate([[0.0], np.geomspace(1e-7 * rms.min(), 60.0 * rms.max(), 900)])
    if hasattr(profile.kernel, "edges_mm"):
        edges = np.union1d(edges, profile.kernel.edges_mm)
    x, w = np.polynomial.legendre.leggauss(16)
    half = 0.5 * np.diff(edges)[:, None]
    return (edges[:-1, None] + half * (x + 1.0)).ravel(), (half * w).ravel()


def integral_over_the_plane(profile: Profile, values: np.ndarray) -> np.ndarray:
    """Return the integrals of R(r) times rows of values at the nodes of `panels`."""
    r, weight = panels(profile)
    return np.atleast_2d(values) @ (2.0 * np.pi * (r * weight)[:, None] * profile.radial(r))


def hankel_tolerance(profile: Profile) -> float:
    tabulated = hasattr(profile.kernel, "edges_mm")
    return (tol.HANKEL_TABULATED if tabulated else tol.HANKEL).value


@EVERY_KIND
def test_the_transfer_function_is_1_at_0(profile):
    assert np.allclose(profile.transfer(0.0), 1.0, rtol=tol.ROUNDING.value)


@EVERY_KIND
def test_the_radial_profile_integrates_to_one(profile):
    r, _ = panels(profile)
    assert np.allclose(
        integral_over_the_plane(profile, np.ones_like(r)), 1.0, atol=tol.HANKEL.value
    )


@EVERY_KIND
def test_the_transfer_function_is_the_hankel_transform_of_the_radial_profile(profile):
    r, _ = panels(profile)
    k = np.geomspace(0.05 / profile.rms_radius_mm.max(), 20.0 / profile.rms_radius_mm.min(), 24)
    transform = integral_over_the_plane(profile, j0(k[:, None] * r))
    assert np.abs(profile.transfer(k) - transform).max() <= hankel_tolerance(profile)


@EVERY_KIND
def test_the_rms_radius_is_the_second_moment(profile):
    r, _ = panels(profile)
    moment = integral_over_the_plane(profile, np.square(r))[0]
    assert np.allclose(np.square(profile.rms_radius_mm), moment, rtol=tol.MOMENT.value)


@EVERY_KIND
def test_the_transfer_function_begins_as_the_parabola_of_the_rms_radius(profile):
    k = 0.01 / profile.rms_radius_mm.max()
    drop = 1.0 - profile.transfer(k)
    parabola = 0.25 * np.square(k * profile.rms_radius_mm)
    assert np.allclose(drop, parabola, rtol=tol.SMALL_K_SERIES.value)


@EVERY_KIND
@settings(max_examples=15)
@given(factor=st.floats(0.02, 50.0), k=st.floats(0.0, 20.0))
def test_scaling_lengths_scales_frequencies(profile, factor, k):
    scaled = profile.scaled(factor)
    atol = 2.0 * hankel_tolerance(profile)
    assert np.allclose(scaled.transfer(k), profile.transfer(k * factor), rtol=0, atol=atol)
    assert np.allclose(
        scaled.rms_radius_mm, factor * profile.rms_radius_mm, rtol=tol.ROUNDING_SUMS.value
    )
    assert np.allclose(scaled.albedo, profile.albedo, rtol=tol.ROUNDING.value)


@EVERY_KIND
@given(factor=st.floats(0.1, 10.0), r=st.floats(0.01, 10.0))
def test_scaling_preserves_the_integral_of_the_density(profile, factor, r):
    near = profile.radial(r * (1.0 + 1e-9))
    scaled = profile.scaled(factor).radial(r * factor * (1.0 + 1e-9))
    assert np.allclose(scaled * factor**2, near, rtol=tol.ROUNDING_SUMS.value)


@EVERY_KIND
@given(k=st.lists(st.floats(0.0, 1e3), min_size=2, max_size=8))
def test_the_transfer_function_never_exceeds_1(profile, k):
    values = profile.transfer(k)
    assert np.isfinite(values).all()
    assert np.abs(values).max() <= 1.0 + hankel_tolerance(profile)


@pytest.mark.parametrize("name", [n for n in PROFILES if n != "tabulated"])
@given(k=st.lists(st.floats(0.0, 1e3), min_size=2, max_size=8, unique=True))
def test_the_transfer_function_of_mixtures_burley_and_dipole_decreases(name, k):
    values = PROFILES[name].transfer(sorted(k))
    assert (np.diff(values, axis=0) <= tol.ROUNDING.value).all()
    assert (values >= 0.0).all()


@pytest.mark.parametrize("shape", [(), (5,), (2, 3)])
@EVERY_KIND
def test_channels_are_the_last_axis(profile, shape):
    k = np.linspace(0.1, 2.0, int(np.prod(shape))).reshape(shape)
    assert profile.transfer(k).shape == (*shape, 3)
    assert profile.radial(k).shape == (*shape, 3)
    assert np.allclose(
        profile.transfer(k).reshape(-1, 3)[-1],
        profile.transfer(float(k.ravel()[-1])),
        rtol=tol.ROUNDING.value,
        atol=tol.ROUNDING.value,
    )


@pytest.mark.parametrize("bad", [-1.0, np.nan, np.inf, [0.1, -0.1]])
@pytest.mark.parametrize("method", ["transfer", "radial"])
def test_frequencies_and_radii_that_are_negative_or_not_finite_are_refused(deon, method, bad):
    with pytest.raises(ArgumentError, match=r"(k_per_mm|r_mm)(\[1\])? is "):
        getattr(deon, method)(bad)


@pytest.mark.parametrize("factor", [0.0, -1.0, np.nan, [1.0, 2.0]])
def test_a_factor_that_is_not_one_positive_number_is_refused(deon, factor):
    with pytest.raises(ArgumentError, match="factor"):
        deon.scaled(factor)


@pytest.mark.parametrize("albedo", [1.0, -0.1, 1.5, np.nan, (0.5, 0.5), (0.5, 0.5, 1.0)])
@pytest.mark.parametrize(
    "build",
    [
        lambda a: Profile.burley(length_mm=1.0, kind="shape", albedo=a),
        lambda a: Profile.dipole(sigma_s_prime_per_mm=1.0, sigma_a_per_mm=0.1, albedo=a),
        lambda a: Profile.gaussians(variances_mm2=[1.0], weights=[[1, 1, 1]], albedo=a),
        lambda a: Profile.tabulated(edges_mm=[0.0, 1.0], flux=[[1], [1], [1]], albedo=a),
    ],
    ids=["burley", "dipole", "gaussians", "tabulated"],
)
def test_an_albedo_outside_0_to_1_is_refused(build, albedo):
    with pytest.raises(ArgumentError, match="albedo"):
        build(albedo)
