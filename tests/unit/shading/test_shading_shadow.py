"""Light across the edge of a shadow: the sharpened edge, the shadow table, and the variance bound."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import shading_tolerances as tol
from skinshade.lut import build_shadow_lut
from skinshade.profile import Profile
from skinshade.shading.shadow import (
    LEAST_COSINE,
    LEAST_VARIANCE_MM2,
    diffused_shadow,
    sharpened_shadow,
    smoothstep,
    variance_shadow,
)

WIDTH_MM, SHARPENING = 8.0, 8.0
SHARE = st.floats(0.0, 1.0)
COLUMNS = 256


def table(profile, rows=64):
    width = (WIDTH_MM, WIDTH_MM / LEAST_COSINE)
    return build_shadow_lut(profile, size=(COLUMNS, rows), width_mm=width, sharpening=SHARPENING)


@pytest.fixture(scope="module")
def skin_table():
    return table(Profile.preset("skin-deon2007"))


def opaque():
    return Profile.gaussians(variances_mm2=[1e-8], weights=[[1.0, 1.0, 1.0]], albedo=0.5)


def at_centres(lut, n_dot_l):
    u = lut.columns.centres(COLUMNS)
    return diffused_shadow(lut, u, np.full(COLUMNS, n_dot_l), WIDTH_MM)


@given(SHARE, SHARE)
def test_a_smoothstep_rises_from_0_to_1_and_is_symmetric_about_its_middle(a, b):
    low, high = sorted((a, b))
    assert smoothstep(np.array(low)) <= smoothstep(np.array(high)) + tol.ROUNDING.value
    assert smoothstep(np.array(1.0 - a)) == pytest.approx(1.0 - smoothstep(np.array(a)), abs=1e-15)
    assert smoothstep(np.array([-3.0, 0.0, 0.5, 1.0, 7.0])).tolist() == [0.0, 0.0, 0.5, 1.0, 1.0]


@given(SHARE)
def test_sharpening_by_one_changes_nothing(u):
    assert sharpened_shadow(np.array(u), 1.0) == pytest.approx(u, abs=tol.INVERSE.value)


@given(st.floats(-0.2, 1.2), st.floats(1.0, 50.0))
def test_sharpening_by_n_gives_the_smoothstep_of_an_nth_of_the_width(position, sharpening):
    """Both smoothsteps have the same middle."""
    narrowed = smoothstep(np.array((position - 0.5) * sharpening + 0.5))
    sharpened = sharpened_shadow(smoothstep(np.array(position)), sharpening)
    assert sharpened == pytest.approx(narrowed, abs=sharpening * tol.INVERSE.value)


@pytest.mark.parametrize("cosine", [0.02, 0.05, 0.3, 0.7, 1.0])
def test_light_rises_across_the_edge_from_0_to_1(skin_table, cosine):
    light = at_centres(skin_table, cosine)
    assert (np.diff(light, axis=0) >= -tol.FLOAT32.value).all()
    assert light.min() >= 0.0
    assert light.max() <= 1.0
    ends = diffused_shadow(skin_table, np.array([0.0, 1.0]), np.full(2, cosine), WIDTH_MM)
    half_a_texel = light[0].max()
    assert ends[0].max() <= half_a_texel + tol.FLOAT32.value
    assert np.abs(ends[0] - (1.0 - ends[1])).max() <= tol.MIRRORED.value


@pytest.mark.parametrize("cosine", [0.05, 0.3, 1.0])
def test_what_bleeds_into_the_dark_is_missing_in_the_light(skin_table, cosine):
    light = at_centres(skin_table, cosine)
    assert np.abs(light + light[::-1] - 1.0).max() <= tol.MIRRORED.value


def test_matter_that_does_not_scatter_keeps_the_sharpened_edge():
    lut = table(opaque())
    u = lut.columns.centres(COLUMNS)
    truth = sharpened_shadow(u, SHARPENING)[:, None]
    for cosine in (0.1, 0.5, 1.0):
        assert np.abs(at_centres(lut, cosine) - truth).max() <= tol.OPAQUE_EDGE.value


def test_red_bleeds_farthest_into_the_shadow_and_blue_least(skin_table):
    light = at_centres(skin_table, 0.8)
    dark = light[: COLUMNS // 4].mean(axis=0)
    assert dark[0] > 2.0 * dark[1] > 2.0 * dark[2] > 0.0


def test_bleeding_is_a_smaller_share_of_the_filter_in_grazing_light(skin_table):
    """On the surface the filter is width/(N·L) wide."""
    bled = [at_centres(skin_table, c)[: COLUMNS // 4, 0].mean() for c in (0.1, 0.3, 0.6, 1.0)]
    assert np.all(np.diff(bled) > 0.0)


def test_below_the_least_cosine_the_light_is_that_of_the_least_cosine(skin_table):
    at_least = at_centres(skin_table, LEAST_COSINE)
    for cosine in (-1.0, 0.0, 0.6 * LEAST_COSINE):
        assert np.array_equal(at_centres(skin_table, cosine), at_least)


def test_the_light_across_a_straight_edge_is_the_edge_convolved_with_the_profile():
    """By FFT on a plane that faces the light, except at the filter's ends, where it is 0 and 1."""
    skin = Profile.preset("skin-deon2007")
    lut = build_shadow_lut(skin, size=(1024, 256), width_mm=(60.0, 61.0), sharpening=SHARPENING)
    x = np.arange(-4096, 4096) * 0.05
    edge = smoothstep(x * SHARPENING / 60.5 + 0.5)
    both = np.concatenate([edge, edge[::-1]])
    k = 2.0 * np.pi * np.fft.rfftfreq(both.size, 0.05)
    blurred = np.fft.irfft(np.fft.rfft(both)[:, None] * skin.transfer(k), both.size, axis=0)
    near = np.abs(x) < 15.0
    light = diffused_shadow(lut, smoothstep(x[near] / 60.5 + 0.5), np.ones(near.sum()), 60.5)
    assert np.abs(light - blurred[: x.size][near]).max() <= tol.SHADOW_FFT.value


@given(st.floats(0.02, 0.98), st.floats(2.0, 100.0), st.floats(-50.0, 50.0))
def test_on_the_far_one_of_two_walls_the_variance_bound_is_the_share_of_that_wall(share, gap, near):
    """Chebyshev's bound is exact, as for a floor under a roof."""
    far = near + gap
    mean = (1.0 - share) * near + share * far
    square = (1.0 - share) * near**2 + share * far**2
    bound = variance_shadow(np.array(mean), np.array(square), np.array(far))
    assert bound == pytest.approx(share, abs=LEAST_VARIANCE_MM2)


@given(st.floats(-100.0, 100.0), st.floats(0.0, 400.0), st.floats(0.0, 50.0))
def test_the_variance_bound_is_1_before_the_mean_depth_and_falls_behind_it(mean, spread, behind):
    square = mean * mean + spread
    depths = mean + np.array([-behind, 0.0, behind, 2.0 * behind, 1e4])
    bound = variance_shadow(np.full(5, mean), np.full(5, square), depths)
    assert (bound[:2] == 1.0).all()
    assert (np.diff(bound[1:]) <= 0.0).all()
    assert 0.0 < bound[-1] <= (spread + LEAST_VARIANCE_MM2 + 1e-9) / 9e7
