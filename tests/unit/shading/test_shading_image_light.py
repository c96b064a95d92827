"""Reflections of the environment: levels, both lobes, and the atlas that shaders sample."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import shading_tolerances as tol
from skinshade.scene import Environment
from skinshade.shading.image_light import (
    LEVEL_SIZE,
    LOBE_POWERS,
    equirectangular_uv,
    reflected_radiance,
    reflection_level,
)
from skinshade.shading.specular import SHARP_LOBE_SHARE, specular_power


@pytest.fixture(scope="module")
def studio():
    return Environment.studio().preconvolved()


@pytest.fixture(scope="module")
def uniform():
    return Environment.constant((0.2, 0.5, 2.0)).preconvolved()


def directions(seed, count=40):
    d = np.random.default_rng(seed).normal(size=(count, 3))
    return d / np.linalg.norm(d, axis=1, keepdims=True)


def test_levels_of_the_tabulated_powers_are_whole_and_other_powers_are_clamped():
    assert np.allclose(reflection_level(np.array(LOBE_POWERS)), np.arange(len(LOBE_POWERS)))
    assert reflection_level(np.array([0.01, 1e6])).tolist() == [0.0, len(LOBE_POWERS) - 1.0]


@given(st.floats(0.0, 1.0), st.integers(0, 1000))
def test_a_uniform_environment_reflects_its_radiance_at_any_gloss(uniform, gloss, seed):
    reflected = reflected_radiance(uniform, directions(seed, 5), np.full(5, gloss))
    assert np.abs(reflected / (0.2, 0.5, 2.0) - 1.0).max() <= tol.EVEN_REFLECTION.value


@given(st.floats(0.0, 1.0))
def test_reflections_are_the_weighted_sum_of_both_lobes(studio, gloss):
    d, g = directions(1), np.full(40, gloss)
    power = specular_power(g)
    wide, sharp = studio.sample(d, power / 4.0), studio.sample(d, power * power / 4.0)
    expected = wide + SHARP_LOBE_SHARE * (sharp - wide)
    assert np.allclose(reflected_radiance(studio, d, g), expected, atol=tol.ROUNDING.value)


def test_towards_a_lamp_reflections_get_brighter_with_gloss(studio):
    key = np.array([[-0.62, 0.45, 0.64]]) / np.linalg.norm([-0.62, 0.45, 0.64])
    brightness = [reflected_radiance(studio, key, np.array([g])).sum() for g in (0.1, 0.4, 0.8)]
    assert brightness == sorted(brightness)


def test_the_atlas_is_the_levels_in_order_from_top_to_bottom(studio):
    width, height = LEVEL_SIZE
    assert studio.atlas.shape == (len(LOBE_POWERS) * height, width, 3)
    for index, level in enumerate(studio.levels):
        assert np.array_equal(studio.atlas[index * height : (index + 1) * height], level)


def test_the_equirectangular_uv_of_the_axes():
    u, v = equirectangular_uv(np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]]))
    assert u[:2].tolist() == [0.5, 0.75]
    assert v.tolist() == [0.5, 0.5, 0.0]
