import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import tolerances as tol
from skinshade._core.errors import ArgumentError
from skinshade.profile import GaussianMixture, Profile, presets

VARIANCES = st.lists(st.floats(1e-4, 100.0), min_size=1, max_size=6)
FITTED = {
    **{name: Profile.preset(name) for name in presets() if name != "skin-deon2007"},
    "burley of one width": Profile.burley(length_mm=1.0, kind="shape", albedo=0.5),
    "burley of three widths": Profile.burley(
        length_mm=(2.67, 0.238, 0.193), kind="mean-free-path-diffuse", albedo=(0.91, 0.34, 0.27)
    ),
}


@st.composite
def mixtures(draw):
    variances = draw(VARIANCES)
    shape = (len(variances), 3)
    weights = draw(hnp.arrays(np.float64, shape, elements=st.floats(0.0, 10.0)))
    weights[draw(st.integers(0, len(variances) - 1))] += 0.1
    return Profile.gaussians(variances_mm2=variances, weights=weights, albedo=0.5)


@given(mixtures(), st.floats(0.0, 30.0))
def test_weights_are_normalised_and_t_is_their_sum_of_gaussians(profile, k):
    assert np.allclose(profile.kernel.weights.sum(axis=0), 1.0, rtol=tol.ROUNDING.value)
    assert np.allclose(profile.transfer(0.0), 1.0, rtol=tol.ROUNDING.value)
    lobes = np.exp(-0.5 * k**2 * profile.kernel.variances_mm2)
    expected = (lobes[:, None] * profile.kernel.weights).sum(axis=0)
    assert np.allclose(profile.transfer(k), expected, rtol=0, atol=tol.ROUNDING.value)


@given(mixtures())
def test_the_mean_square_radius_is_twice_the_mean_variance(profile):
    mean = (profile.kernel.weights * profile.kernel.variances_mm2[:, None]).sum(axis=0)
    assert np.allclose(np.square(profile.rms_radius_mm), 2.0 * mean, rtol=tol.ROUNDING_SUMS.value)


@given(mixtures())
def test_the_fit_of_a_mixture_is_the_mixture_without_residual(profile):
    mixture, residual = profile.gaussian_fit()
    assert mixture is profile.kernel
    assert residual == 0.0


def test_one_gaussian_has_the_density_of_its_formula():
    profile = Profile.gaussians(variances_mm2=[4.0], weights=[[1, 1, 1]], albedo=0.5)
    assert np.allclose(profile.radial(0.0), 1.0 / (2.0 * np.pi * 4.0), rtol=tol.ROUNDING.value)
    assert np.allclose(profile.radial(2.0) / profile.radial(0.0), np.exp(-0.5))


def test_skin_of_deon_and_luebke_has_its_published_rms_radius(deon):
    error = np.abs(deon.rms_radius_mm - (1.663, 0.369, 0.223))
    assert (error <= tol.PUBLISHED_DIGIT.value * 1e-3).all()


@pytest.mark.parametrize("profile", FITTED.values(), ids=FITTED)
def test_the_gaussian_fit_follows_the_transfer_function(profile):
    reach = tol.FIT_RANGE_K_RMS.value / profile.rms_radius_mm.min()
    k = np.concatenate([[0.0], np.geomspace(1e-5 * reach, reach, 3001)])
    mixture, residual = profile.gaussian_fit()
    assert np.abs(mixture.transfer(k) - profile.transfer(k)).max() <= tol.GAUSSIAN_FIT.value
    assert residual <= tol.GAUSSIAN_FIT.value


@pytest.mark.parametrize("profile", FITTED.values(), ids=FITTED)
def test_the_fit_has_weights_that_are_positive_and_sum_to_one(profile):
    fit, _ = profile.gaussian_fit()
    assert isinstance(fit, GaussianMixture)
    assert (fit.weights >= 0.0).all()
    assert (fit.weights.max(axis=1) > 0.0).all()
    assert np.allclose(fit.weights.sum(axis=0), 1.0, rtol=tol.ROUNDING.value)


@pytest.mark.parametrize("profile", FITTED.values(), ids=FITTED)
def test_the_residual_is_the_greatest_error_of_the_fit(profile):
    reach = tol.FIT_RANGE_K_RMS.value / profile.rms_radius_mm.min()
    k = np.concatenate([[0.0], np.geomspace(1e-5 * reach, reach, 4001)])
    mixture, residual = profile.gaussian_fit()
    error = np.abs(mixture.transfer(k) - profile.transfer(k)).max()
    assert 0.9 * residual <= error
    assert error <= 1.05 * residual + tol.ROUNDING_SUMS.value


@given(factor=st.floats(0.1, 10.0))
def test_the_fit_scales_with_the_profile(burley, factor):
    fit, _ = burley.gaussian_fit()
    scaled, _ = burley.scaled(factor).gaussian_fit()
    k = np.geomspace(0.01, 100.0, 50)
    error = np.abs(scaled.transfer(k / factor) - fit.transfer(k)).max()
    assert error <= 2.0 * tol.GAUSSIAN_FIT.value


@pytest.mark.parametrize(
    ("variances", "weights", "complaint"),
    [
        ([0.0], [[1, 1, 1]], "every variance must be positive"),
        ([-1.0, 1.0], np.ones((2, 3)), "every variance must be positive"),
        ([], np.ones((0, 3)), "every variance must be positive"),
        ([np.nan], [[1, 1, 1]], r"variances_mm2\[0\] is nan"),
        ([1.0], [[1, 1, 0]], "each sum must be positive"),
        ([1.0], [[1, 1, -1]], r"weights\[0, 2\] is -1"),
        ([1.0, 2.0], [[1, 1, 1]], "weights: shape"),
        ([[1.0]], [[1, 1, 1]], "variances_mm2: shape"),
    ],
)
def test_a_mixture_that_is_no_density_is_refused(variances, weights, complaint):
    with pytest.raises(ArgumentError, match=complaint):
        Profile.gaussians(variances_mm2=variances, weights=weights, albedo=0.5)
