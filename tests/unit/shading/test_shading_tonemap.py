"""Tone curves: sRGB of the standard, and the published filmic fit."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import shading_tolerances as tol
from skinshade.params.choices import ToneCurve
from skinshade.shading.tonemap import filmic, linear_from_srgb, srgb_from_linear, tonemap

LIGHT = hnp.arrays(float, 8, elements=st.floats(0.0, 1e4))
DISPLAY = hnp.arrays(float, 8, elements=st.floats(0.0, 1.0))


@given(LIGHT)
def test_the_filmic_curve_is_the_published_fit(light):
    x = np.maximum(0.0, light - 0.004)
    published = (x * (6.2 * x + 0.5)) / (x * (6.2 * x + 1.7) + 0.06)
    assert np.allclose(filmic(light), published, rtol=tol.ROUNDING.value, atol=0.0)


def test_the_filmic_curve_has_values_computed_by_hand():
    """x = 0 below the toe; x = 1: 6.7/7.96; x = .1: .112/.292; the limit is 1."""
    display = filmic(np.array([0.0, 0.004, 0.104, 1.004]))
    assert display == pytest.approx([0.0, 0.0, 0.112 / 0.292, 6.7 / 7.96], abs=tol.ROUNDING.value)
    assert filmic(np.array(1e9)) == pytest.approx(1.0, abs=1e-8)


@pytest.mark.parametrize("curve", [filmic, srgb_from_linear])
@given(light=LIGHT)
def test_a_curve_is_monotonic_and_within_0_and_1(curve, light):
    display = curve(np.sort(light))
    assert (np.diff(display) >= 0.0).all()
    assert display.min() >= 0.0
    assert display.max() <= 1.0


@given(DISPLAY)
def test_both_directions_of_srgb_are_inverses(display):
    assert np.allclose(srgb_from_linear(linear_from_srgb(display)), display, atol=tol.SRGB.value)
    assert np.allclose(linear_from_srgb(srgb_from_linear(display)), display, atol=tol.SRGB.value)


def test_srgb_has_the_values_of_the_standard():
    """IEC 61966-2-1: the linear part, its end, middle grey, and the ends of the range."""
    linear = np.array([0.0, 0.001, 0.0031308, 0.18, 0.5, 1.0, 7.0])
    display = [0.0, 0.01292, 0.0404499, 0.4613561, 0.7353570, 1.0, 1.0]
    assert srgb_from_linear(linear) == pytest.approx(display, abs=tol.SRGB_DIGITS.value)
    assert linear_from_srgb(np.array([128.0 / 255.0])) == pytest.approx(
        0.2158605, abs=tol.SRGB_DIGITS.value
    )


@given(LIGHT, st.floats(0.0, 8.0))
def test_exposure_multiplies_the_light_before_the_curve(light, exposure):
    exposed = light * exposure
    assert np.array_equal(tonemap(light, ToneCurve.FILMIC, exposure), filmic(exposed))
    assert np.array_equal(tonemap(light, ToneCurve.SRGB, exposure), srgb_from_linear(exposed))
    assert np.array_equal(tonemap(light, ToneCurve.SRGB), srgb_from_linear(light))
