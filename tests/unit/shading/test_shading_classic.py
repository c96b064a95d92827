"""The formulas of 2014."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import shading_tolerances as tol
from skinshade.lut.classic import classic_curvature_lut
from skinshade.profile import Profile
from skinshade.shading import classic
from skinshade.shading.deep_scatter import classic_transmittance

SEED = st.integers(0, 2**20)


@pytest.fixture(scope="module")
def table():
    return classic_curvature_lut(Profile.preset("skin-deon2007"), size=(256, 64))


def unit(seed, count):
    v = np.random.default_rng(seed).normal(size=(count, 3))
    return v / np.linalg.norm(v, axis=1)[:, None]


def normalised(v):
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


@given(SEED)
def test_direct_light_follows_the_formulas_of_2014(table, seed):
    """R uses the blurred normal, B the sharp one where lit, G a mix; the table's difference is added."""
    count = 30
    blurred, light = unit(seed, count), unit(seed + 1, count)
    sharp = normalised(blurred + 0.3 * unit(seed + 2, count))
    curvature = np.random.default_rng(seed).uniform(-0.5, 0.5, count)
    n_dot_l = (blurred * light).sum(axis=1)
    k = np.clip(1.0 - n_dot_l, 0.0, 1.0)[:, None] ** 2
    green = normalised(sharp + (0.3 + 0.7 * k) * (blurred - sharp))
    blue = normalised(sharp + k * (blurred - sharp))
    truth = np.stack([n_dot_l, (green * light).sum(1), (blue * light).sum(1)], axis=1)
    difference = table.sample(n_dot_l, np.abs(curvature)) - np.maximum(n_dot_l, 0.0)[:, None]
    truth = np.clip(np.clip(truth, 0.0, 1.0) + difference, 0.0, 1.0)
    result = classic.direct(table, sharp, blurred, light, curvature)
    assert np.abs(result - truth).max() <= tol.FLOAT32.value


def test_a_smooth_plane_is_lambert_within_the_steps_of_the_table(table):
    cosine = np.linspace(-1.0, 1.0, 201)
    light = np.stack([np.sqrt(1.0 - cosine**2), 0.0 * cosine, cosine], axis=1)
    n = np.broadcast_to([0.0, 0.0, 1.0], light.shape)
    result = classic.direct(table, n, n, light, np.zeros(201))
    assert np.abs(result - np.maximum(cosine, 0.0)[:, None]).max() <= tol.CLASSIC_PLANE.value


@given(SEED)
def test_convex_and_concave_curvature_of_one_magnitude_give_the_same_light(table, seed):
    n, light = unit(seed, 5), unit(seed + 1, 5)
    kappa = np.linspace(0.0, 0.4, 5)
    plus, minus = (classic.direct(table, n, n, light, s * kappa) for s in (1.0, -1.0))
    assert np.array_equal(plus, minus)


@given(SEED)
def test_ambient_normals_are_blurred_for_red_mixed_for_green_and_sharp_for_blue(seed):
    sharp, blurred = unit(seed, 4), unit(seed + 1, 4)
    red, green, blue = np.moveaxis(classic.ambient_normals(sharp, blurred), -2, 0)
    assert np.array_equal(red, blurred)
    assert np.array_equal(blue, sharp)
    assert np.allclose(green, normalised(0.7 * sharp + 0.3 * blurred), atol=tol.ROUNDING.value)


@given(st.floats(0.0, 1.0), st.floats(1.0, 20.0))
def test_the_shadow_of_specular_light_is_the_published_smoothstep(u, sharpening):
    """smoothstep(.9·S·u + ½ − .45·S)."""
    p = np.clip(0.9 * sharpening * u + 0.5 - 0.45 * sharpening, 0.0, 1.0)
    result = classic.sharpened_shadow(np.array(u), sharpening)
    assert result == pytest.approx(p * p * (3.0 - 2.0 * p), abs=tol.ROUNDING_SUMS.value)


@given(st.floats(0.0, 30.0), st.floats(-1.0, 1.0), st.floats(1.0, 10.0), st.floats(0.0, 3.0))
def test_deep_scatter_is_a_gaussian_of_thickness_times_a_wrapped_cosine(t, cosine, r, strength):
    truth = strength * np.exp(-(t**2) / (2.0 * r**2)) * max(0.0, 0.3 - cosine)
    result = classic.deep_scatter(np.array(t), np.array(cosine), r, strength)
    assert result == pytest.approx(truth, abs=tol.ROUNDING.value)
    assert classic_transmittance(np.array(t), r) <= 1.0


@given(st.floats(0.1, 10.0), st.floats(10.0, 500.0), st.integers(5, 13), st.floats(0.0, 12.0))
def test_the_blur_level_is_that_of_the_radius_in_texels_but_at_least_the_hardwares(
    r, scale, octave, level
):
    size = 2**octave
    truth = max(level, np.log2(max(size * r, scale) / scale))
    result = classic.blur_level(r, scale, size, np.array(level))
    assert result == pytest.approx(truth, abs=tol.ROUNDING.value)
