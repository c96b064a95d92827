"""Relief under diffusion compared with exact diffusion by FFT, on the cylinders of benchmarks/bumpy.py."""

from __future__ import annotations

import numpy as np
import pytest

import shading_tolerances as tol
from benchmark_scripts import benchmark
from skinshade.profile import Profile

bumpy = benchmark("bumpy")
SKIN = Profile.preset("skin-deon2007")


@pytest.fixture(scope="module")
def tables():
    return bumpy.tables(SKIN)


def small(body):
    return bumpy.BumpyCylinder(body.radius_mm, body.slope, body.tilt, size=(256, 1024))


@pytest.fixture(scope="module", params=bumpy.CASES, ids=repr)
def slope_and_errors(request, tables):
    """RMS slope of the relief of a case, and the RMS error of each model."""
    return request.param.slope, bumpy.errors(small(request.param), SKIN, *tables)


@pytest.mark.slow
def test_three_fetches_are_five_times_as_accurate_as_the_formulas_of_2014(slope_and_errors):
    _, errors = slope_and_errors
    assert errors["classic"] >= tol.CLASSIC_OVER_THREE_FETCHES.value * errors["3 fetches"]


@pytest.mark.slow
def test_the_error_of_each_model_is_within_the_published_range(slope_and_errors):
    slope, errors = slope_and_errors
    for name, limits in tol.BUMPY_PER_SLOPE.items():
        low, high = (limit.value for limit in limits)
        assert low * slope <= errors[name] <= high * slope, name


@pytest.mark.slow
def test_the_error_falls_from_lambert_to_classic_to_two_and_three_fetches(slope_and_errors):
    _, errors = slope_and_errors
    order = [errors[name] for name in ("lambert", "classic", "2 fetches", "3 fetches")]
    assert order == sorted(order, reverse=True)


def test_exact_diffusion_conserves_light_and_lowers_its_contrast():
    body = bumpy.BumpyCylinder(8.0, 0.3, size=(128, 512))
    entered = np.maximum(body.world(body.tangent_normals) @ body.light, 0.0)
    emitted = body.truth(SKIN)
    assert np.abs(emitted.mean(axis=(0, 1)) / entered.mean() - 1.0).max() <= tol.ROUNDING_SUMS.value
    contrast = emitted.std(axis=(0, 1))
    assert contrast[0] < contrast[1] < contrast[2] < entered.std()


def test_the_relief_has_the_requested_slope_and_periods():
    body = bumpy.BumpyCylinder(8.0, 0.3, size=(256, 1024))
    n = body.tangent_normals
    slopes = n[..., :2] / n[..., 2:]
    assert np.sqrt(np.mean(np.sum(slopes**2, axis=-1))) == pytest.approx(
        0.3, rel=tol.ROUNDING_SUMS.value
    )
    assert np.abs(slopes.mean(axis=(0, 1))).max() <= tol.ROUNDING_SUMS.value
    power = np.abs(np.fft.rfft2(slopes[..., 0])) ** 2 + np.abs(np.fft.rfft2(slopes[..., 1])) ** 2
    k = np.hypot(*body.frequencies)
    inside = (k > 2.0 * np.pi / 8.0) & (k < 2.0 * np.pi / 0.25)
    assert power[inside].sum() >= 0.99 * power.sum()


def lambert_error(radius_mm, profile):
    """Return the RMS over circle and channels of N·L clamped at 0 minus its diffusion, by Fourier series.

    cos φ clamped is 1/π + ½ cos φ + (2/π) Σ (−1)ⁿ⁺¹ cos 2nφ/(4n² − 1); diffusion around the cylinder
    multiplies wave n by T(n/r): the difference is the factor 1 − T(n/r).
    """
    wave = np.concatenate([[1.0], np.arange(2.0, 4000.0, 2.0)])
    amplitude = np.concatenate([[0.5], 2.0 / np.pi / (wave[1:] ** 2 - 1.0)])
    difference = amplitude[:, None] * (1.0 - profile.transfer(wave / radius_mm))
    return np.sqrt(0.5 * np.mean(np.sum(difference**2, axis=0)))


def test_without_relief_the_light_on_a_cylinder_is_that_of_the_table(tables):
    """The RMS error is .0057 without diffusion and .0002 with it, from the table's last texel."""
    smooth = bumpy.errors(bumpy.BumpyCylinder(8.0, 1e-6, size=(16, 1024)), SKIN, *tables)
    assert smooth["3 fetches"] <= tol.RING_ON_CYLINDER.value
    assert smooth["2 fetches"] <= tol.RING_ON_CYLINDER.value
    lambert = lambert_error(8.0, SKIN)
    assert smooth["lambert"] == pytest.approx(lambert, rel=tol.LAMBERT_ON_CYLINDER.value)
    assert lambert > 10.0 * tol.RING_ON_CYLINDER.value
