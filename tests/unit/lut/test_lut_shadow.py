"""The shadow table: texels against quadrature, ends of the rows, the inverse smoothstep."""

from functools import cache

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

import tolerances as tol
from skinshade._core.errors import ArgumentError
from skinshade.lut import Lut, build_shadow_lut
from skinshade.lut.shadow import diffused_smoothstep, inverse_smoothstep
from skinshade.profile import Profile

SHARPENING = 10.0
ROWS = [0, 5, 40, 130, 250, 400, 511]
COLUMNS = [0, 1, 5, 20, 64, 150, 230, 255, 256, 280, 370, 450, 500, 510, 511]


def smoothstep(p):
    p = np.clip(p, 0.0, 1.0)
    return p * p * (3.0 - 2.0 * p)


def blurred_by_quadrature(p: float, s: float) -> float:
    """Return smoothstep ⊗ Gaussian, over ±9 σ with the kinks and the centre as break points."""

    def integrand(t):
        return smoothstep(t) * np.exp(-0.5 * ((t - p) / s) ** 2) / (s * np.sqrt(2.0 * np.pi))

    low, high = p - 9.0 * s, p + 9.0 * s
    marks = [m for m in (0.0, 1.0, p) if low < m < high]
    return quad(integrand, low, high, points=marks, epsabs=1e-10, epsrel=1e-10, limit=200)[0]


@cache
def full_table() -> Lut:
    return build_shadow_lut(Profile.preset("skin-deon2007"), sharpening=SHARPENING)


def test_the_table_equals_the_integral_scaled_to_0_and_1_at_its_ends(deon):
    table = full_table()
    u = np.concatenate([table.columns.centres(512)[COLUMNS], [0.0, 1.0]])
    p = np.array([inverse_by_bisection(x) for x in u])
    p = (p - 0.5) * SHARPENING + 0.5
    for row in ROWS:
        s = deon.kernel.sigmas_mm * SHARPENING * table.rows.centres(512)[row]
        lobes = np.array([[blurred_by_quadrature(x, width) for x in p] for width in s])
        light = np.einsum("lu,lc->uc", lobes, deon.kernel.weights)
        expected = (light[:-2] - light[-2]) / (light[-1] - light[-2])
        assert np.abs(table.values[row, COLUMNS] - expected).max() <= tol.LUT_QUADRATURE.value


def inverse_by_bisection(u: float) -> float:
    """Return the root of 3p² − 2p³ − u between 0 and 1."""
    low, high = 0.0, 1.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if smoothstep(middle) < u else (low, middle)
    return 0.5 * (low + high)


@given(st.floats(0.0, 1.0))
def test_the_inverse_smoothstep_is_exact(u):
    p = inverse_smoothstep(np.array(u))
    assert 0.0 <= p <= 1.0
    assert smoothstep(p) == pytest.approx(u, abs=tol.ROUNDING.value)


@given(st.floats(-3.0, 4.0), st.floats(0.01, 5.0))
def test_the_blurred_smoothstep_is_odd_about_its_centre(p, s):
    values = diffused_smoothstep(np.array([p, 1.0 - p]), np.array(s))
    assert values.sum() == pytest.approx(1.0, abs=tol.ROUNDING_SUMS.value * max(1.0, s**3))


@given(st.floats(-2.0, 3.0))
def test_a_narrow_blur_changes_the_smoothstep_by_less_than_3_s2(p):
    # The second derivative is at most 6: a blur of width s changes the value by at most 3s².
    value = diffused_smoothstep(np.array(p), np.array(1e-4))
    assert value == pytest.approx(smoothstep(p), abs=3.1e-8)


@given(st.floats(0.02, 4.0), st.floats(-6.0, 7.0), st.floats(1e-3, 1.0))
def test_a_blurred_smoothstep_increases(s, p, step):
    low, high = diffused_smoothstep(np.array([p, p + step]), np.array(s))
    assert high - low >= -tol.ROUNDING_SUMS.value


@st.composite
def skins(draw):
    variances = draw(st.lists(st.floats(1e-3, 10.0), min_size=1, max_size=4))
    weights = np.array([draw(st.tuples(*[st.floats(0.01, 1.0)] * 3)) for _ in variances])
    return Profile.gaussians(variances_mm2=variances, weights=weights, albedo=0.5)


@given(skins(), st.floats(1.0, 100.0), st.floats(0.5, 20.0))
def test_rows_increase_from_0_to_1(profile, sharpening, least):
    table = build_shadow_lut(
        profile, size=(1024, 4), width_mm=(least, least * 10.0), sharpening=sharpening
    )
    assert table.values.min() >= 0.0
    assert table.values.max() <= 1.0
    assert (np.diff(table.values, axis=1) >= -tol.FLOAT32.value).all()
    # The line through the first two texels reaches 0 within one texel, that of the last two 1.
    first, last = table.values[:, 0], table.values[:, -1]
    assert (first <= np.diff(table.values[:, :2], axis=1)[:, 0] + tol.PINNED_END.value).all()
    assert (1.0 - last <= np.diff(table.values[:, -2:], axis=1)[:, 0] + tol.PINNED_END.value).all()


@given(skins())
def test_a_filter_value_of_one_half_stays_one_half(profile):
    table = build_shadow_lut(profile, size=(9, 3))
    assert np.allclose(table.values[:, 4], 0.5, atol=tol.FLOAT32.value)
    mirrored = 1.0 - table.values[:, ::-1]
    assert np.allclose(table.values, mirrored, rtol=0, atol=2.0 * tol.FLOAT32.value)


def test_the_shadow_is_sharper_in_rows_of_greater_width():
    quarter = full_table().values[:, 140]
    assert (np.diff(quarter, axis=0) >= -tol.FLOAT32.value).all()
    assert (quarter[-1] > quarter[0]).all()


def test_the_dark_side_is_brightest_in_red_and_darkest_in_blue():
    texel = full_table().values[500, 150]
    assert texel[0] > texel[1] > texel[2]


def test_scaling_the_profile_equals_scaling_the_widths(deon):
    one = build_shadow_lut(deon, size=(32, 8), width_mm=(8.0, 100.0))
    other = build_shadow_lut(deon.scaled(2.0), size=(32, 8), width_mm=(16.0, 200.0))
    assert np.allclose(one.values, other.values, rtol=0, atol=tol.FLOAT32.value)


def test_the_axes_are_the_filter_and_the_inverse_width():
    table = full_table()
    assert table.kind == "shadow"
    assert (table.columns.low, table.columns.high) == (0.0, 1.0)
    assert (table.rows.low, table.rows.high) == (0.01, 0.125)
    assert table.rows.spacing == "linear"
    assert table.provenance["sharpening"] == SHARPENING


@pytest.mark.parametrize(
    ("options", "complaint"),
    [
        ({"size": (1, 8)}, "size is 1×8"),
        ({"width_mm": (0.0, 1.0)}, "must be positive and increase"),
        ({"width_mm": (2.0, 2.0)}, "must be positive and increase"),
        ({"width_mm": (np.nan, 2.0)}, r"width_mm\[0\] is nan"),
        ({"sharpening": 0.5}, r"sharpening is 0.5; it must lie in \[1, 100\]"),
        ({"sharpening": 101.0}, "sharpening is 101"),
        ({"sharpening": (1.0, 2.0)}, "sharpening: shape"),
    ],
)
def test_an_invalid_argument_is_refused(deon, options, complaint):
    with pytest.raises(ArgumentError, match=complaint):
        build_shadow_lut(deon, **({"size": (4, 4)} | options))
