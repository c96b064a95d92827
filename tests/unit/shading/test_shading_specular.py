"""Two specular lobes: energy, reciprocity, the formulas, and their limits."""

from functools import cache

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import shading_tolerances as tol
from skinshade.shading import specular as term

UNIT_RANGE = st.floats(0.0, 1.0)
SEED = st.integers(0, 2**20)
SKIN_F0 = 0.028


def directions(seed, count=1):
    """Return unit vectors of the upper half, with z of at least .05."""
    rng = np.random.default_rng(seed)
    z = rng.uniform(0.05, 1.0, count)
    phi = rng.uniform(0.0, 2.0 * np.pi, count)
    r = np.sqrt(1.0 - z * z)
    return np.stack([r * np.cos(phi), r * np.sin(phi), z], axis=-1)


def up(like):
    return np.broadcast_to([0.0, 0.0, 1.0], like.shape)


@cache
def half_vectors():
    """Return half vectors and solid angles; panels get narrower towards the normal, as lobes do."""
    edges = np.concatenate([[0.0], np.geomspace(1e-3, np.pi / 2.0, 36)])
    x, w = np.polynomial.legendre.leggauss(8)
    theta = (edges[:-1, None] + np.diff(edges)[:, None] * (x + 1.0) / 2.0).ravel()
    weight = (np.diff(edges)[:, None] * w / 2.0).ravel() * np.sin(theta)
    phi = (np.arange(90) + 0.5) * np.pi / 90.0  # the other half is its mirror image
    t, p = np.meshgrid(theta, phi, indexing="ij")
    h = np.stack([np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t)], axis=-1)
    return h.reshape(-1, 3), np.repeat(weight * 2.0 * np.pi / 90.0, 90)


def reflected_share(gloss, reflectance, n_dot_v):
    """Return the reflected share of light from one direction, by quadrature over half vectors."""
    h, solid_angle = half_vectors()
    v = np.array([np.sqrt(1.0 - n_dot_v**2), 0.0, n_dot_v])
    v_dot_h = h @ v
    light = 2.0 * v_dot_h[:, None] * h - v
    above = (v_dot_h > 0.0) & (light[:, 2] > 0.0)
    light, v_dot_h, solid_angle = light[above], v_dot_h[above], solid_angle[above]
    one = np.ones(len(light))
    radiance = term.specular(
        up(light), np.broadcast_to(v, light.shape), light, gloss * one, reflectance * one
    )
    return float((radiance * 4.0 * v_dot_h * solid_angle).sum() / np.pi)


@pytest.mark.parametrize("gloss", [0.0, 0.2, 0.35, 0.5, 0.7, 1.0])
@pytest.mark.parametrize("n_dot_v", [1.0, 0.7, 0.4, 0.1, 0.02])
def test_at_reflectance_one_no_more_light_is_reflected_than_arrives(gloss, n_dot_v):
    assert 0.0 < reflected_share(gloss, 1.0, n_dot_v) <= 1.0 + tol.SPECULAR_QUADRATURE.value


@pytest.mark.parametrize("gloss", [0.7, 0.85, 1.0])
def test_at_normal_incidence_sharp_lobes_reflect_the_share_of_the_reflectance(gloss):
    """Neither shadowing nor the horizon loses light: this is the normalisation of both lobes."""
    assert reflected_share(gloss, 1.0, 1.0) == pytest.approx(1.0, abs=tol.SHARP_LOBE.value)
    assert reflected_share(gloss, SKIN_F0, 1.0) == pytest.approx(SKIN_F0, rel=tol.SHARP_LOBE.value)


@pytest.mark.parametrize("gloss", [0.0, 0.35, 0.7, 1.0])
@pytest.mark.parametrize("n_dot_v", [1.0, 0.6, 0.4, 0.2, 0.05])
def test_specular_and_diffuse_light_together_are_no_more_than_arrives(gloss, n_dot_v):
    body = term.diffuse_share(np.array(n_dot_v), np.array(gloss), np.array(SKIN_F0))
    total = reflected_share(gloss, SKIN_F0, n_dot_v) + float(body)
    assert total <= 1.0 + tol.COAT_AND_BODY.value


@given(st.floats(0.0, 1.0))
def test_the_distribution_of_each_lobe_is_normalised(gloss):
    """∫ D·cosθ = 1; the visibility is a quarter where both cosines are 1."""
    power = term.specular_power(np.array(gloss))
    h, solid_angle = half_vectors()
    one = np.ones(len(h))
    for p in (power, min(power**2, term.SHARPEST_POWER)):
        distribution = 4.0 * term._lobe(h[:, 2], one, one, p)
        covered = (distribution * h[:, 2] * solid_angle).sum()
        assert covered == pytest.approx(1.0, abs=tol.SPECULAR_QUADRATURE.value)


@given(SEED, UNIT_RANGE, UNIT_RANGE)
def test_the_reflection_is_reciprocal(seed, gloss, reflectance):
    v, light = directions(seed), directions(seed + 1)
    g, f0 = np.array([gloss]), np.array([reflectance])
    forward = term.specular(up(v), v, light, g, f0) / light[:, 2]
    backward = term.specular(up(v), light, v, g, f0) / v[:, 2]
    assert np.allclose(forward, backward, rtol=tol.ROUNDING_SUMS.value, atol=0.0)


@given(SEED, UNIT_RANGE, UNIT_RANGE)
def test_both_lobes_follow_the_formula(seed, gloss, reflectance):
    v, light = directions(seed, 20), directions(seed + 1, 20)
    h = (v + light) / np.linalg.norm(v + light, axis=1)[:, None]
    truth = np.zeros(20)
    first = 2.0 ** (13.0 * gloss)
    for share, p in ((0.95, first), (0.05, min(first**2, 2.0**13))):
        k = 1.0 / np.sqrt(np.pi * p / 4.0 + np.pi / 2.0)
        smith = (k + (1.0 - k) * light[:, 2]) * (k + (1.0 - k) * v[:, 2])
        truth += share * (p + 2.0) / (2.0 * np.pi) * h[:, 2] ** p * 0.25 / smith
    fresnel = reflectance + (1.0 - reflectance) * (1.0 - np.sum(v * h, axis=1)) ** 5
    truth *= np.pi * fresnel * light[:, 2]
    result = term.specular(up(v), v, light, np.full(20, gloss), np.full(20, reflectance))
    assert np.allclose(result, truth, rtol=tol.ROUNDING_SUMS.value, atol=1e-300)


def test_fresnel_is_f0_at_normal_incidence_and_one_at_grazing_incidence():
    eye = np.array([[0.0, 0.0, 1.0]])
    g = np.array([0.5])
    facing = [term.specular(eye, eye, eye, g, np.array([f0]))[0] for f0 in (0.028, 1.0)]
    assert facing[0] / facing[1] == pytest.approx(0.028, rel=tol.ROUNDING_SUMS.value)
    low = np.array([[0.9999, 0.0, np.sqrt(1 - 0.9999**2)]])
    opposite = low * (-1.0, 1.0, 1.0)
    grazing = [term.specular(eye, low, opposite, g, np.array([f0]))[0] for f0 in (0.028, 1.0)]
    assert grazing[0] / grazing[1] == pytest.approx(1.0, abs=tol.GRAZING.value)


@given(SEED, UNIT_RANGE)
def test_a_surface_that_faces_away_from_the_light_has_no_highlight(seed, gloss):
    v, below = directions(seed), directions(seed + 1) * (1.0, 1.0, -1.0)
    assert term.specular(up(v), v, below, np.array([gloss]), np.array([0.5]))[0] == 0.0


@given(SEED)
def test_the_mirror_direction_has_the_same_angle_on_the_other_side_of_the_normal(seed):
    n, v = directions(seed), directions(seed + 1)
    r = term.reflected(n, v)
    assert np.linalg.norm(r) == pytest.approx(1.0, abs=tol.ROUNDING.value)
    assert np.sum(r * n) == pytest.approx(np.sum(v * n), abs=tol.ROUNDING.value)
    assert abs(np.linalg.det(np.concatenate([n, v, r]))) <= tol.ROUNDING.value


@given(UNIT_RANGE, UNIT_RANGE, UNIT_RANGE)
def test_ambient_fresnel_follows_the_formula_between_f0_and_one(n_dot_v, gloss, f0):
    fresnel = term.ambient_specular_fresnel(np.array(n_dot_v), np.array(gloss), np.array(f0))
    truth = f0 + (1.0 - f0) * (1.0 - n_dot_v) ** 5 / (4.0 - 3.0 * gloss)
    assert fresnel == pytest.approx(truth, abs=tol.ROUNDING.value)
    assert f0 <= fresnel <= 1.0 + tol.ROUNDING.value
    assert term.diffuse_share(np.array(n_dot_v), np.array(gloss), np.array(f0)) == pytest.approx(
        1.0 - truth, abs=tol.ROUNDING.value
    )


@given(st.floats(0.13, 1.0))
def test_gloss_from_roughness_has_the_power_of_the_same_width(roughness):
    power = np.clip(2.0 / roughness**4 - 2.0, 1.0, 2.0**13)
    gloss = term.gloss_from_roughness(roughness)
    assert 0.0 <= gloss <= 1.0
    assert term.specular_power(gloss) == pytest.approx(power, rel=tol.ROUNDING_SUMS.value)


def test_roughness_0_and_1_are_gloss_1_and_0():
    assert term.gloss_from_roughness(np.array([0.0, 1.0])).tolist() == [1.0, 0.0]


@given(UNIT_RANGE, st.floats(0.05, 1.0))
def test_relief_within_a_texel_adds_its_variance_to_that_of_the_lobe(gloss, length):
    """Slopes have variance (1 − |N|)/|N|, the lobe 1/p."""
    power = 2.0 ** (13.0 * gloss)
    widened = 1.0 / (1.0 / power + (1.0 - length) / length)
    result = term.gloss_of_relief(np.array(gloss), np.array(length))
    assert 0.0 <= result <= gloss + tol.ROUNDING.value
    assert term.specular_power(result) == pytest.approx(
        max(widened, 1.0), rel=tol.ROUNDING_SUMS.value
    )
