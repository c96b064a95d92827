"""The sRGB curve of the host, against the equations of IEC 61966-2-1."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from shading_tolerances import SRGB
from skinshade._core.srgb import linear_from_srgb, srgb_from_linear
from tolerances import ROUNDING

LIGHT = st.floats(0.0, 1.0)


def encoded(light: float) -> float:
    """Return the display value of light, by the equation of the standard."""
    return 12.92 * light if light <= 0.0031308 else 1.055 * light ** (1.0 / 2.4) - 0.055


def decoded(display: float) -> float:
    """Return the light of a display value, by the equation of the standard."""
    return display / 12.92 if display <= 0.04045 else ((display + 0.055) / 1.055) ** 2.4


@given(LIGHT)
def test_encoding_is_the_equation_of_the_standard(light):
    assert srgb_from_linear(np.array(light)) == pytest.approx(encoded(light), abs=ROUNDING.value)


@given(LIGHT)
def test_decoding_is_the_equation_of_the_standard(display):
    assert linear_from_srgb(np.array(display)) == pytest.approx(
        decoded(display), abs=ROUNDING.value
    )


@pytest.mark.parametrize("light", [0.0031307, 0.0031308, 0.0031309])
def test_both_branches_agree_at_their_boundary(light):
    curve = 1.055 * light ** (1.0 / 2.4) - 0.055
    assert srgb_from_linear(np.array(light)) == pytest.approx(curve, abs=SRGB.value)
    assert srgb_from_linear(np.array(light)) == pytest.approx(12.92 * light, abs=SRGB.value)


@pytest.mark.parametrize("curve", [srgb_from_linear, linear_from_srgb])
def test_the_ends_are_0_and_1(curve):
    assert curve(np.array(0.0)) == 0.0
    assert curve(np.array(1.0)) == pytest.approx(1.0, abs=ROUNDING.value)


@pytest.mark.parametrize("steps", [255.0, 65535.0])
def test_every_stored_step_is_recovered(steps):
    display = np.arange(steps + 1.0) / steps
    assert np.array_equal(
        np.rint(srgb_from_linear(linear_from_srgb(display)) * steps) / steps, display
    )


@given(st.floats(-1e6, 1e6))
def test_values_outside_0_to_1_are_clipped(value):
    clipped = np.clip(value, 0.0, 1.0)
    for curve in (srgb_from_linear, linear_from_srgb):
        assert curve(np.array(value)) == curve(np.array(clipped))


@given(hnp.arrays(np.float64, hnp.array_shapes(max_dims=3), elements=LIGHT))
def test_the_shape_is_kept_and_the_input_unchanged(light):
    before = light.copy()
    for curve in (srgb_from_linear, linear_from_srgb):
        assert curve(light).shape == light.shape
        assert np.array_equal(light, before)
