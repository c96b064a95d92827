"""The coat: reciprocity, its share of the light, the white furnace, and its reflection of the sky."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import shading_tolerances as tol
from skinshade.lut import build_coat_lut
from skinshade.params import SkinParams
from skinshade.params.choices import Shading, SpecularModel
from skinshade.params.gloss import alpha_from_gloss, gloss_from_roughness
from skinshade.profile import Profile
from skinshade.scene import Environment
from skinshade.shading import coat as term
from skinshade.shading import lobes
from skinshade.shading.compose import shade
from skinshade.shading.image_light import coat_radiance
from skinshade.shading.pixel import Ambient, Surface
from skinshade.shading.skin import Skin
from skinshade.shading.specular import reflected, specular_power

SEED = st.integers(0, 2**20)
UNIT_RANGE = st.floats(0.0, 1.0)
GGX = [SpecularModel.GGX, SpecularModel.GGX_TWO_LOBES]
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
def skin_of(model):
    params = SkinParams(specular=model)
    return Skin.of(Profile.preset("skin-deon2007"), params, luts=("coat", "sphere", "shadow"))


def flat(n_dot_v, gloss, albedo=1.0, reflectance=SKIN_F0):
    """Return one pixel of a plane."""
    normal = np.array([[0.0, 0.0, 1.0]])
    return Surface(
        view=np.array([[np.sqrt(1.0 - n_dot_v**2), 0.0, n_dot_v]]),
        mesh_normal=normal,
        fetched=np.repeat(normal[:, None], 3, axis=1),
        curvature_per_mm=np.zeros(1),
        albedo=np.full((1, 3), albedo),
        gloss=np.array([gloss]),
        reflectance=np.array([reflectance]),
        tint=np.ones((1, 3)),
    )


def even_sky():
    sh = np.zeros((9, 3))
    sh[0] = np.sqrt(4.0 * np.pi)
    return Ambient(sh, np.ones((1, 3)), np.zeros((1, 3)), np.ones((1, 3)))


@given(SEED, UNIT_RANGE, st.floats(0.0, 0.5))
def test_the_reflection_is_reciprocal(seed, gloss, reflectance):
    v, light = directions(seed), directions(seed + 1)
    g, f0 = np.array([gloss]), np.array([reflectance])
    forward = term.coat_highlight(up(v), v, light, g, f0) / light[:, 2]
    backward = term.coat_highlight(up(v), light, v, g, f0) / v[:, 2]
    assert np.allclose(forward, backward, rtol=tol.ROUNDING_SUMS.value, atol=0.0)


@given(SEED, UNIT_RANGE, st.floats(0.001, 0.2))
def test_the_highlight_follows_the_formula(seed, gloss, reflectance):
    v, light = directions(seed, 20), directions(seed + 1, 20)
    h = (v + light) / np.linalg.norm(v + light, axis=1)[:, None]
    a2 = 2.0 / (2.0 ** (13.0 * gloss) + 2.0)
    density = a2 / (np.pi * (h[:, 2] ** 2 * (a2 - 1.0) + 1.0) ** 2)

    def smith(c):
        return 0.5 * (np.sqrt(1.0 + a2 * (1.0 / c**2 - 1.0)) - 1.0)

    shadowing = 1.0 / (1.0 + smith(v[:, 2]) + smith(light[:, 2]))
    fresnel = term.coat_fresnel(np.sum(v * h, axis=1), np.full(20, reflectance))
    truth = np.pi * density * shadowing * fresnel / (4.0 * v[:, 2])
    result = term.coat_highlight(up(v), v, light, np.full(20, gloss), np.full(20, reflectance))
    assert np.allclose(result, truth, rtol=1e-9, atol=1e-300)


@given(SEED, UNIT_RANGE)
def test_a_surface_that_faces_away_from_the_light_has_no_highlight(seed, gloss):
    v, below = directions(seed), directions(seed + 1) * (1.0, 1.0, -1.0)
    assert term.coat_highlight(up(v), v, below, np.array([gloss]), np.array([0.5]))[0] == 0.0


@given(st.floats(0.126, 0.9))
def test_alpha_is_the_squared_roughness(roughness):
    gloss = gloss_from_roughness(roughness)
    assert alpha_from_gloss(gloss) == pytest.approx(roughness**2, rel=1e-9)


@given(UNIT_RANGE, UNIT_RANGE)
def test_the_share_is_exact_at_the_reflectance_of_the_table_and_at_one(n_dot_v, gloss):
    lut = build_coat_lut()
    table = lut.sample(np.sqrt(n_dot_v), gloss)
    shares = [
        term.coat(lut, np.array(n_dot_v), np.array(gloss), np.array(f0), SKIN_F0)[0]
        for f0 in (SKIN_F0, 1.0, 2.0)
    ]
    assert shares == pytest.approx([table[0], table[2], table[2]], abs=tol.ROUNDING.value)


@given(UNIT_RANGE, UNIT_RANGE, st.floats(0.02, 0.04))
def test_another_reflectance_has_nearly_the_share_of_its_own_table(n_dot_v, gloss, reflectance):
    n, g, f0 = np.array(n_dot_v), np.array(gloss), np.array(round(reflectance, 3))
    near, _ = term.coat(build_coat_lut(), n, g, f0, SKIN_F0)
    own, _ = term.coat(build_coat_lut(reflectance=float(f0)), n, g, f0, float(f0))
    assert near == pytest.approx(own, abs=tol.COAT_OTHER_REFLECTANCE.value)


@pytest.mark.parametrize("model", GGX)
@pytest.mark.parametrize("shading", [Shading.LAMBERT, Shading.TRANSFER])
@given(
    n_dot_v=st.floats(0.0, 1.0),
    gloss=UNIT_RANGE,
    albedo=UNIT_RANGE,
    reflectance=st.floats(0.0, 0.2),
)
def test_in_an_even_sky_no_surface_is_brighter_than_the_sky_and_a_white_one_is_as_bright(
    model, shading, n_dot_v, gloss, albedo, reflectance
):
    def radiance(colour):
        surface = flat(n_dot_v, gloss, colour, reflectance)
        terms = shade(skin_of(model), surface, [], even_sky(), shading)
        return sum(terms.values())

    assert np.abs(radiance(1.0) - 1.0).max() <= tol.COAT_FURNACE.value
    assert radiance(albedo).max() <= 1.0 + tol.ROUNDING.value


@given(UNIT_RANGE, UNIT_RANGE)
def test_two_lobes_reflect_the_weighted_sum_of_their_shares(n_dot_v, gloss):
    surface = flat(n_dot_v, gloss)
    sharper = replace(surface, gloss=np.minimum(2.0 * surface.gloss, 1.0))
    first, second = (
        lobes.sky_share(skin_of(GGX[0]), s, Shading.TRANSFER) for s in (surface, sharper)
    )
    both = lobes.sky_share(skin_of(GGX[1]), surface, Shading.TRANSFER)
    assert both == pytest.approx(0.95 * first + 0.05 * second, abs=tol.ROUNDING.value)


@pytest.mark.parametrize("model", GGX)
def test_an_even_environment_is_reflected_with_its_radiance(model):
    preconvolved = Environment.constant((0.2, 0.5, 2.0)).preconvolved()
    for n_dot_v, gloss in ((0.1, 0.9), (0.5, 0.4), (1.0, 0.0)):
        sky = lobes.reflected_sky(
            skin_of(model), flat(n_dot_v, gloss), preconvolved, Shading.TRANSFER
        )
        assert np.abs(sky / (0.2, 0.5, 2.0) - 1.0).max() <= tol.EVEN_REFLECTION.value


def test_classic_shading_has_the_lobes_of_blinn_phong():
    skin = skin_of(SpecularModel.GGX)
    assert skin.specular_model(Shading.CLASSIC) == SpecularModel.BLINN_PHONG
    assert skin.specular_model(Shading.LAMBERT) == SpecularModel.GGX


@given(SEED)
def test_without_pull_a_lobe_points_to_the_mirror_direction_and_fully_pulled_to_the_normal(seed):
    n, v = directions(seed), directions(seed + 1)
    ends = [term.coat_direction(n, v, np.full(1, pull)) for pull in (0.0, 1.0)]
    assert np.allclose(ends[0], reflected(n, v), atol=tol.ROUNDING.value)
    assert np.allclose(ends[1], n, atol=tol.ROUNDING.value)


def lobe_radiance(environment, n, v, alpha):
    """Return the exact mean radiance (3,) over a GGX lobe, by quadrature over microfacet normals."""
    u, phi = np.meshgrid((np.arange(48) + 0.5) / 48, 2 * np.pi * (np.arange(96) + 0.5) / 96)
    tangent = alpha * np.sqrt(u / (1.0 - u))  # the distribution's quantiles
    side = np.cross(n, [0.6, -0.5, 0.62])
    side /= np.linalg.norm(side)
    across = np.cos(phi)[..., None] * side + np.sin(phi)[..., None] * np.cross(n, side)
    h = n + tangent[..., None] * across
    h /= np.linalg.norm(h, axis=-1, keepdims=True)
    v_dot_h = h @ v
    light = 2.0 * v_dot_h[..., None] * h - v
    n_dot_l, n_dot_h, n_dot_v = light @ n, h @ n, float(n @ v)

    def smith(c):
        return 0.5 * (np.sqrt(1.0 + alpha**2 * (1.0 / c**2 - 1.0)) - 1.0)

    above = (n_dot_l > 0.0) & (v_dot_h > 0.0)
    shadowing = 1.0 / (1.0 + smith(n_dot_v) + smith(np.maximum(n_dot_l, 1e-6)))
    fresnel = term.coat_fresnel(np.clip(v_dot_h, 0.0, 1.0), np.array(SKIN_F0))
    weight = np.where(above, shadowing * fresnel * v_dot_h / n_dot_h, 0.0)
    return np.einsum("ij,ijc->c", weight, environment.sample(light)) / weight.sum()


def test_reflections_of_a_sky_are_the_mean_over_the_lobe():
    environment, lut = Environment.studio(), build_coat_lut()
    preconvolved = environment.preconvolved()
    rng = np.random.default_rng(3)
    errors, level = ([], []), environment.sample(directions(5, 400)).mean()
    for roughness in (0.3, 0.45):
        gloss = gloss_from_roughness(np.array(roughness))
        for _ in range(100):
            n = rng.normal(size=3)
            n /= np.linalg.norm(n)
            side = np.cross(n, rng.normal(size=3))
            side /= np.linalg.norm(side)
            cosine = rng.uniform(0.2, 1.0)
            v = cosine * n + np.sqrt(1.0 - cosine**2) * side
            _, pull = term.coat(lut, np.array(cosine), gloss, np.array(SKIN_F0), SKIN_F0)
            direction = term.coat_direction(n, v, pull)
            exact = lobe_radiance(environment, n, v, roughness**2)
            result = coat_radiance(preconvolved, direction, np.array(cosine), gloss)
            mirrored = preconvolved.sample(reflected(n, v), specular_power(gloss) / 4.0)
            errors[0].append(result - exact)
            errors[1].append(mirrored - exact)
    fitted, blinn_phong = (np.sqrt(np.mean(np.square(one))) / level for one in errors)
    assert fitted <= tol.COAT_SKY.value
    assert fitted < 0.8 * blinn_phong, "the mirror direction and a quarter of the power are worse"
