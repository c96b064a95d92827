import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

import tolerances as tol
from skinshade._core.errors import ArgumentError
from skinshade.profile import Profile
from skinshade.profile.dipole import fresnel_diffuse_reflectance

COEFFICIENT = st.floats(0.01, 20.0)


def within_printed_digits(values, published, digit):
    return (np.abs(values - np.array(published)) <= tol.PUBLISHED_DIGIT.value * digit).all()


@pytest.mark.parametrize(
    ("name", "albedo"),
    [("skin1", (0.436, 0.227, 0.131)), ("skin2", (0.623, 0.433, 0.343))],
)
def test_the_albedo_is_the_published_diffuse_reflectance(name, albedo):
    assert within_printed_digits(Profile.preset(name).albedo, albedo, 1e-3)


@pytest.mark.parametrize(
    ("name", "mm"),
    [
        ("skin1", (3.67, 1.37, 0.68)),
        ("skin2", (4.82, 1.69, 1.09)),
        ("marble", (8.51, 5.57, 3.95)),
    ],
)
def test_the_diffuse_mean_free_path_is_the_published_one(name, mm):
    assert within_printed_digits(1.0 / Profile.preset(name).kernel.sigma_tr_per_mm, mm, 1e-2)


@pytest.mark.parametrize(("name", "mm"), [("skin2", (0.907, 0.602, 0.517))])
def test_the_mean_free_path_is_the_published_one(name, mm):
    depth, _ = Profile.preset(name).kernel.depths_mm
    assert within_printed_digits(depth, mm, 1e-3)


def internal_reflectance(ior):
    """Return the mean of Fresnel's equations over diffuse light from inside."""

    def reflectance(cosine):
        sine = ior * np.sqrt(1.0 - cosine**2)
        if sine >= 1.0:
            return 2.0 * cosine
        out = np.sqrt(1.0 - sine**2)
        parallel = (cosine - ior * out) / (cosine + ior * out)
        across = (ior * cosine - out) / (ior * cosine + out)
        return cosine * (parallel**2 + across**2)

    critical = np.sqrt(1.0 - 1.0 / ior**2)
    return quad(reflectance, 0.0, critical)[0] + quad(reflectance, critical, 1.0)[0]


@pytest.mark.parametrize("ior", [1.1, 1.3, 1.4, 1.5])
def test_the_boundary_reflects_by_fresnels_equations(ior):
    error = abs(fresnel_diffuse_reflectance(ior) - internal_reflectance(ior))
    assert error <= tol.FRESNEL_FIT.value


def test_a_matched_boundary_reflects_nothing():
    assert fresnel_diffuse_reflectance(1.0) == 0.0
    kernel = Profile.dipole(sigma_s_prime_per_mm=3.0, sigma_a_per_mm=1.0, ior=1.0).kernel
    real, virtual = kernel.depths_mm
    assert np.allclose(real, 0.25, rtol=tol.ROUNDING.value)
    assert np.allclose(virtual, 0.25 * 7.0 / 3.0, rtol=tol.ROUNDING.value)


@given(COEFFICIENT, st.floats(1.0, 1.6))
def test_a_medium_without_absorption_has_albedo_1(scattering, ior):
    profile = Profile.dipole(
        sigma_s_prime_per_mm=scattering, sigma_a_per_mm=1e-12 * scattering, ior=ior
    )
    assert (profile.albedo < 1.0).all()
    assert np.allclose(profile.albedo, 1.0, atol=2e-5)


@given(COEFFICIENT, COEFFICIENT, st.floats(1.0, 3.0), st.floats(0.1, 10.0))
def test_the_albedo_depends_only_on_the_ratio_of_the_coefficients(s, a, ior, unit):
    one = Profile.dipole(sigma_s_prime_per_mm=s, sigma_a_per_mm=a, ior=ior)
    other = Profile.dipole(sigma_s_prime_per_mm=s * unit, sigma_a_per_mm=a * unit, ior=ior)
    assert np.allclose(one.albedo, other.albedo, rtol=tol.ROUNDING_SUMS.value)
    assert np.allclose(one.rms_radius_mm, other.rms_radius_mm * unit, rtol=tol.ROUNDING_SUMS.value)


@given(COEFFICIENT, COEFFICIENT, st.floats(1.1, 3.0))
def test_more_absorption_lowers_the_albedo_and_the_radius(s, a, more):
    pale = Profile.dipole(sigma_s_prime_per_mm=s, sigma_a_per_mm=a)
    dark = Profile.dipole(sigma_s_prime_per_mm=s, sigma_a_per_mm=a * more)
    assert (dark.albedo < pale.albedo).all()
    assert (dark.rms_radius_mm < pale.rms_radius_mm).all()


def test_a_given_albedo_replaces_that_of_the_dipole():
    profile = Profile.dipole(sigma_s_prime_per_mm=1.0, sigma_a_per_mm=0.1, albedo=(0.1, 0.2, 0.3))
    assert profile.albedo.tolist() == [0.1, 0.2, 0.3]


@pytest.mark.parametrize("bad", [0.0, -1.0, np.nan, (1.0, 1.0)])
@pytest.mark.parametrize("name", ["sigma_s_prime_per_mm", "sigma_a_per_mm"])
def test_coefficients_that_are_not_positive_are_refused(name, bad):
    values = {"sigma_s_prime_per_mm": 1.0, "sigma_a_per_mm": 1.0} | {name: bad}
    with pytest.raises(ArgumentError, match=name):
        Profile.dipole(**values)


@pytest.mark.parametrize("ior", [0.9, 3.1, np.nan, (1.3, 1.3, 1.3)])
def test_a_refractive_index_outside_1_to_3_is_refused(ior):
    with pytest.raises(ArgumentError, match="ior"):
        Profile.dipole(sigma_s_prime_per_mm=1.0, sigma_a_per_mm=1.0, ior=ior)
