"""Diffuse light on spheres and cylinders: long series, quadrature, conservation of energy."""

from functools import cache

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.polynomial import legendre
from scipy.special import eval_legendre

import tolerances as tol
from skinshade.lut.spectral import diffuse_grid
from skinshade.profile import Profile

KERNELS = pytest.mark.parametrize("kernel", ["sphere", "ring"])
RADII_MM = np.array([0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 40.0, 70.0, 100.0])
N_DOT_L = np.union1d(np.linspace(-1.0, 1.0, 31), np.linspace(-0.1, 0.1, 31))
SPHERE_TERMS, RING_TERMS = 12_000, 20_000

PROFILES = {
    "skin-deon2007": Profile.preset("skin-deon2007"),
    "skin1": Profile.preset("skin1"),
    "whole-milk": Profile.preset("whole-milk"),
    "burley": Profile.burley(
        length_mm=(2.67, 0.238, 0.193), kind="mean-free-path-diffuse", albedo=0.5
    ),
}


@cache
def zonal_share(terms: int) -> np.ndarray:
    """Return a_l = (2l+1)/2 ∫₀¹ x P_l(x) dx, by ∫₀¹ P_n = (P_{n−1}(0) − P_{n+1}(0))/(2n+1)."""
    at_zero = eval_legendre(np.arange(terms + 2), 0.0)
    n = np.arange(1, terms + 1)
    integral = np.concatenate([[1.0], (at_zero[:-2] - at_zero[2:]) / (2 * n + 1)])
    l = np.arange(1, terms)  # noqa: E741
    return np.concatenate([[0.25], 0.5 * ((l + 1) * integral[l + 1] + l * integral[l - 1])])


def sphere_by_series(profile, n_dot_l, curvature):
    order = np.arange(SPHERE_TERMS)
    transfer = profile.transfer(np.sqrt(order * (order + 1.0)) * curvature[:, None])
    terms = zonal_share(SPHERE_TERMS)[None, :, None] * transfer
    values = legendre.legval(n_dot_l, np.moveaxis(terms, 1, 0))
    return np.moveaxis(values, 1, -1)


def ring_by_series(profile, n_dot_l, curvature):
    k = np.arange(1, RING_TERMS // 2)
    share = np.zeros(RING_TERMS)
    share[:2] = 1.0 / np.pi, 0.5
    share[2::2] = 2.0 / np.pi * (-1.0) ** (k + 1) / (4.0 * k * k - 1.0)
    cosines = np.cos(np.arange(RING_TERMS)[:, None] * np.arccos(n_dot_l))
    transfer = profile.transfer(np.arange(RING_TERMS) * curvature[:, None])
    return np.einsum("l,mlc,ln->mnc", share, transfer, cosines, optimize=True)


def panels(reach: float) -> tuple[np.ndarray, np.ndarray]:
    """Return Gauss-Legendre nodes and weights over −reach..reach, denser at the terminator at 0."""
    x, w = np.polynomial.legendre.leggauss(40)
    edges = np.concatenate([[0.0], np.geomspace(1e-4, 1.0, 12)]) * reach
    edges = np.concatenate([-edges[:0:-1], edges])
    half = 0.5 * np.diff(edges)[:, None]
    return (edges[:-1, None] + half * (x + 1.0)).ravel(), (half * w).ravel()


@pytest.mark.parametrize("profile", PROFILES.values(), ids=PROFILES)
@KERNELS
def test_the_grid_equals_the_long_series(profile, kernel):
    reference = {"sphere": sphere_by_series, "ring": ring_by_series}[kernel]
    expected = reference(profile, N_DOT_L, 1.0 / RADII_MM)
    error = np.abs(diffuse_grid(profile, N_DOT_L, 1.0 / RADII_MM, kernel) - expected).max()
    exact = profile.name == "skin-deon2007"
    assert error <= (tol.SERIES if exact else tol.SERIES_FITTED).value


@KERNELS
def test_the_grid_of_a_measured_profile_equals_the_long_series(measured, kernel):
    reference = {"sphere": sphere_by_series, "ring": ring_by_series}[kernel]
    expected = reference(measured, N_DOT_L, 1.0 / RADII_MM)
    error = np.abs(diffuse_grid(measured, N_DOT_L, 1.0 / RADII_MM, kernel) - expected).max()
    assert error <= tol.SERIES_FITTED.value


@pytest.mark.parametrize("sigma", [0.15, 0.4, 1.0])
@pytest.mark.parametrize("theta", [0.0, 0.7, 1.5, 1.7, 2.6, np.pi])
def test_the_sphere_equals_light_convolved_with_the_heat_kernel(sigma, theta):
    # The integral over the sphere of kernel(γ) times the mean light at distance γ from the point.
    order = np.arange(int(9.0 / sigma) + 8)
    shares = (2 * order + 1) / (4 * np.pi) * np.exp(-0.5 * sigma**2 * order * (order + 1.0))
    x, w = np.polynomial.legendre.leggauss(60)
    kinks = np.unique(
        np.clip([0.0, abs(np.pi / 2 - theta), np.pi - abs(np.pi / 2 - theta), np.pi], 0, np.pi)
    )
    half = 0.5 * np.diff(kinks)[:, None]
    distance, weight = (kinks[:-1, None] + half * (x + 1)).ravel(), (half * w).ravel()
    swing = (np.arange(4000) + 0.5) * np.pi / 4000
    height = np.cos(theta) * np.cos(distance)[:, None] + np.sin(theta) * np.sin(distance)[
        :, None
    ] * np.cos(swing)
    light = np.maximum(height, 0.0).mean(axis=1)
    expected = (
        2 * np.pi * (weight * np.sin(distance) * legendre.legval(np.cos(distance), shares)) @ light
    )

    profile = Profile.gaussians(variances_mm2=[sigma**2], weights=[[1, 1, 1]], albedo=0.5)
    value = diffuse_grid(profile, np.array([np.cos(theta)]), np.array([1.0]), "sphere")
    assert np.abs(value - expected).max() <= tol.HEAT_KERNEL.value


@pytest.mark.parametrize("profile", PROFILES.values(), ids=PROFILES)
def test_the_sphere_conserves_energy(profile):
    x, w = panels(1.0)
    mean = 0.5 * np.einsum("mnc,n->mc", diffuse_grid(profile, x, 1.0 / RADII_MM, "sphere"), w)
    assert np.abs(mean - 0.25).max() <= tol.SPHERE_MEAN.value


@pytest.mark.parametrize("profile", PROFILES.values(), ids=PROFILES)
def test_the_ring_conserves_energy(profile):
    x, w = panels(np.pi / 2)
    mean = (
        np.einsum("mnc,n->mc", diffuse_grid(profile, np.sin(x), 1.0 / RADII_MM, "ring"), w) / np.pi
    )
    assert np.abs(mean - 1.0 / np.pi).max() <= tol.RING_MEAN.value


def test_the_sphere_conserves_energy_with_a_measured_profile(measured):
    x, w = panels(1.0)
    mean = 0.5 * np.einsum("mnc,n->mc", diffuse_grid(measured, x, 1.0 / RADII_MM, "sphere"), w)
    assert np.abs(mean - 0.25).max() <= tol.SPHERE_MEAN.value


@pytest.mark.parametrize("profile", PROFILES.values(), ids=PROFILES)
@KERNELS
def test_a_flat_surface_is_lambertian(profile, kernel):
    for radius_mm in (1e8, np.inf):
        value = diffuse_grid(profile, N_DOT_L, np.array([1.0 / radius_mm]), kernel)[0]
        assert np.abs(value - np.maximum(N_DOT_L, 0.0)[:, None]).max() <= tol.FLAT_LIMIT.value


@pytest.mark.parametrize(("kernel", "level"), [("sphere", 0.25), ("ring", 1.0 / np.pi)])
def test_light_on_a_tiny_body_is_uniform(deon, kernel, level):
    value = diffuse_grid(deon, N_DOT_L, np.array([100.0 / deon.kernel.sigmas_mm[0]]), kernel)
    assert np.abs(value - level).max() <= tol.ROUND_LIMIT.value


@KERNELS
@given(
    variances=st.lists(st.floats(1e-3, 10.0), min_size=1, max_size=3),
    radius=st.floats(0.5, 200.0),
    factor=st.floats(0.1, 10.0),
)
def test_scaling_the_profile_equals_scaling_the_radius(kernel, variances, radius, factor):
    weights = np.ones((len(variances), 3))
    profile = Profile.gaussians(variances_mm2=variances, weights=weights, albedo=0.5)
    one = diffuse_grid(profile, N_DOT_L, np.array([1.0 / radius]), kernel)
    other = diffuse_grid(
        profile.scaled(factor), N_DOT_L, np.array([1.0 / (radius * factor)]), kernel
    )
    assert np.abs(one - other).max() <= tol.SERIES.value


@KERNELS
@given(
    variances=st.lists(st.floats(1e-4, 20.0), min_size=1, max_size=4), radius=st.floats(0.3, 300.0)
)
def test_light_decreases_from_the_lit_pole_to_the_dark_pole(kernel, variances, radius):
    weights = np.ones((len(variances), 3))
    profile = Profile.gaussians(variances_mm2=variances, weights=weights, albedo=0.5)
    value = diffuse_grid(profile, N_DOT_L, np.array([1.0 / radius]), kernel)[0]
    assert (np.diff(value, axis=0) >= -tol.SERIES.value).all()
    assert value.min() >= -tol.SERIES.value
    assert value.max() <= 1.0 + tol.SERIES.value


@KERNELS
def test_the_odd_part_of_the_light_is_the_decayed_first_harmonic(deon, kernel):
    # max(0, x) − max(0, −x) = x: the odd part is cosθ, multiplied by T at its frequency.
    value = diffuse_grid(deon, N_DOT_L, 1.0 / RADII_MM, kernel)
    mirrored = diffuse_grid(deon, -N_DOT_L, 1.0 / RADII_MM, kernel)
    frequency = np.sqrt(2.0) if kernel == "sphere" else 1.0
    decay = deon.transfer(frequency / RADII_MM)[:, None, :]
    assert np.abs(value - mirrored - decay * N_DOT_L[:, None]).max() <= tol.SERIES.value
