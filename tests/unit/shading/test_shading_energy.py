"""The energy gain of a curved body: its formula, bounds and limits."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import shading_tolerances as tol
from skinshade.shading.energy import energy_gain

RGB = (3,)
ALBEDO = hnp.arrays(np.float64, RGB, elements=st.floats(0.0, 0.999))
RADIUS = hnp.arrays(np.float64, RGB, elements=st.floats(0.001, 50.0))


def test_the_gain_has_the_value_computed_by_hand():
    # u = 1.2·(1−0.6)·2·0.5 = 0.48; uA/(1−A) = 0.72; g = 1 + 0.48/√1.5184
    gain = energy_gain(np.full(3, 0.6), np.full(3, 2.0), np.array([0.5]))
    assert np.allclose(gain, 1.0 + 0.48 / np.sqrt(1.5184), rtol=tol.ROUNDING.value)


@given(ALBEDO, RADIUS, st.floats(-10.0, 10.0))
def test_the_gain_lies_between_1_and_1_over_the_albedo(albedo, radius, curvature):
    gain = energy_gain(albedo, radius, np.array([curvature]))
    assert (gain >= 1.0).all()
    assert (gain * albedo <= 1.0 + tol.ROUNDING.value).all()


@given(ALBEDO, RADIUS, st.floats(-10.0, 0.0))
def test_the_gain_of_flat_and_concave_surfaces_is_1(albedo, radius, curvature):
    assert (energy_gain(albedo, radius, np.array([curvature])) == 1.0).all()


@given(ALBEDO, RADIUS, st.floats(0.001, 5.0), st.floats(1.01, 3.0))
def test_the_gain_increases_with_the_product_of_curvature_and_radius(
    albedo, radius, curvature, more
):
    less = energy_gain(albedo, radius, np.array([curvature]))
    curved = energy_gain(albedo, radius, np.array([curvature * more]))
    wide = energy_gain(albedo, radius * more, np.array([curvature]))
    assert (curved >= less).all()
    assert np.allclose(curved, wide, rtol=tol.ROUNDING_SUMS.value)


@given(st.floats(0.05, 0.95))
def test_the_gain_of_a_tiny_sphere_is_1_over_the_albedo(albedo):
    gain = energy_gain(np.full(3, albedo), np.ones(3), np.array([1e7]))
    assert np.allclose(gain, 1.0 / albedo, rtol=1e-6)


@pytest.mark.parametrize("shape", [(), (4,), (2, 5)])
def test_channels_are_the_last_axis(shape):
    assert energy_gain(np.full(3, 0.5), np.ones(3), np.zeros((*shape, 1))).shape == (*shape, 3)
