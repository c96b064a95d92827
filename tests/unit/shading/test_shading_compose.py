"""The whole pixel: sums, scalings, limits and fallbacks of the three lighting models."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import shading_tolerances as tol
from skinshade.params import SkinParams
from skinshade.params.choices import Shading, Tier
from skinshade.profile import Profile
from skinshade.shading.coat import coat, coat_highlight
from skinshade.shading.compose import TERMS, shade
from skinshade.shading.deep_scatter import transmittance
from skinshade.shading.direct import directional_curvature, relief_length
from skinshade.shading.energy import energy_gain
from skinshade.shading.pixel import Ambient, Incident, Surface
from skinshade.shading.skin import Skin
from skinshade.shading.tables import LUTS
from skinshade.shading.view_factor import view_factor

SEED = st.integers(0, 2**20)
COUNT = 12
VECTORS = ("view", "mesh_normal", "fetched", "diffused_normals")


@pytest.fixture(scope="module")
def skin():
    params = SkinParams(deep_scatter_tint=(0.9, 0.5, 0.4))
    return Skin.of(Profile.preset("skin-deon2007"), params, luts=LUTS)


def unit(rng, *shape):
    v = rng.normal(size=(*shape, 3))
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def random_surface(seed, kappa=0.05):
    rng = np.random.default_rng(seed)
    n = unit(rng, COUNT)
    view = n + 0.5 * unit(rng, COUNT)
    u = np.cross(n, unit(rng, COUNT))
    u /= np.linalg.norm(u, axis=1)[:, None]
    v = np.cross(n, u)
    k1, k2 = rng.uniform(-kappa, 2 * kappa, (2, COUNT, 1, 1))
    shape = k1 * u[:, :, None] * u[:, None] + k2 * v[:, :, None] * v[:, None]
    fetched = n[:, None] + 0.2 * unit(rng, COUNT, 3)
    return Surface(
        view=view / np.linalg.norm(view, axis=1)[:, None],
        mesh_normal=n,
        fetched=fetched / np.linalg.norm(fetched, axis=-1, keepdims=True),
        curvature_per_mm=0.5 * (k1 + k2)[:, 0, 0],
        albedo=rng.uniform(0.1, 0.9, (COUNT, 3)),
        gloss=rng.uniform(0.1, 0.8, COUNT),
        reflectance=rng.uniform(0.01, 0.1, COUNT),
        tint=rng.uniform(0.2, 1.0, (COUNT, 3)),
        tensor_world=shape[:, [0, 0, 0, 1, 1, 2], [0, 1, 2, 1, 2, 2]],
        diffused_normals=np.repeat(n[:, None], 3, axis=1) * rng.uniform(0.9, 1.0, (COUNT, 3, 1)),
        diffused_curvature_per_mm=np.repeat(0.5 * (k1 + k2)[:, :, 0], 3, axis=1),
        mesh_relief=rng.uniform(0.9, 1.0, (COUNT, 3)),
    )


def random_light(seed):
    rng = np.random.default_rng(seed)
    return Incident(
        unit(rng, COUNT),
        rng.uniform(0.1, 3.0, (COUNT, 3)),
        rng.uniform(0.0, 1.0, COUNT),
        rng.uniform(0.0, 15.0, COUNT),
    )


def random_sky(seed):
    rng = np.random.default_rng(seed)
    sh = rng.normal(size=(9, 3)) * 0.1
    sh[0] += 2.0
    visibility, bounced, reflected, through = rng.uniform(0.0, 1.0, (4, COUNT, 3))
    return Ambient(sh, visibility, 0.1 * bounced, reflected, 0.2 * through)


def facing(albedo=1.0, **changes):
    """Return a pixel of a flat surface that faces the eye, white by default."""
    up = np.array([[0.0, 0.0, 1.0]])
    plain = Surface(
        view=up,
        mesh_normal=up,
        fetched=np.repeat(up[:, None], 3, axis=1),
        curvature_per_mm=np.zeros(1),
        albedo=np.full((1, 3), albedo),
        gloss=np.full(1, 0.35),
        reflectance=np.full(1, 0.028),
        tint=np.ones((1, 3)),
        tensor_world=np.zeros((1, 6)),
        diffused_normals=np.repeat(up[:, None], 3, axis=1),
        diffused_curvature_per_mm=np.zeros((1, 3)),
        mesh_relief=np.ones((1, 3)),
    )
    return replace(plain, **changes)


def reflected_share(skin, n_dot_v):
    """Return the directional albedo of the coat of `facing`."""
    gloss, reflectance = np.array([0.35]), np.array([0.028])
    return coat(skin.lut("coat"), np.array([n_dot_v]), gloss, reflectance, 0.028)[0][0]


def lamp(to_light, thickness=None, shadow=1.0):
    t = None if thickness is None else np.array([thickness])
    return Incident(np.array([to_light]), np.ones((1, 3)), np.array([shadow]), t)


every_shading = pytest.mark.parametrize("shading", Shading)


@every_shading
@given(seed=SEED)
def test_every_term_is_returned_and_no_light_is_negative(skin, shading, seed):
    terms = shade(skin, random_surface(seed), [random_light(seed)], random_sky(seed), shading)
    assert tuple(terms) == TERMS
    assert all(value.shape == (COUNT, 3) for value in terms.values())
    assert min(value.min() for value in terms.values()) >= 0.0


@every_shading
@given(seed=SEED)
def test_the_light_of_two_lights_is_the_sum_of_both(skin, shading, seed):
    surface, one, other = random_surface(seed), random_light(seed), random_light(seed + 1)
    together = shade(skin, surface, [one, other], None, shading)
    separate = [shade(skin, surface, [light], None, shading) for light in (one, other)]
    for name in TERMS:
        total = separate[0][name] + separate[1][name]
        assert np.allclose(together[name], total, rtol=tol.ROUNDING_SUMS.value, atol=1e-15)


@every_shading
@given(seed=SEED, factor=st.floats(0.0, 10.0))
def test_every_term_is_proportional_to_the_light(skin, shading, seed, factor):
    surface, light, sky = random_surface(seed), random_light(seed), random_sky(seed)
    more = replace(light, radiance=factor * light.radiance)
    parts = {
        n: factor * getattr(sky, n) for n in ("radiance_sh", "bounced", "reflected", "through")
    }
    plain = shade(skin, surface, [light], sky, shading)
    brighter = shade(skin, surface, [more], replace(sky, **parts), shading)
    for name in TERMS:
        assert np.allclose(brighter[name], factor * plain[name], rtol=1e-9, atol=1e-15)


@every_shading
def test_without_light_every_term_is_zero(skin, shading):
    terms = shade(skin, random_surface(1), [], None, shading)
    assert all(not value.any() for value in terms.values())
    dark = replace(random_light(1), radiance=np.zeros((COUNT, 3)))
    terms = shade(skin, random_surface(1), [dark], None, shading)
    assert all(not value.any() for value in terms.values())


@every_shading
@given(seed=SEED)
def test_albedo_multiplies_every_term_except_specular_ones(skin, shading, seed):
    surface, light, sky = random_surface(seed), random_light(seed), random_sky(seed)
    white = replace(surface, albedo=np.ones((COUNT, 3)))
    plain, bright = (shade(skin, s, [light], sky, shading) for s in (surface, white))
    albedo = surface.albedo
    if shading == Shading.TRANSFER:  # the view factor of white is 1
        n_dot_v = np.sum(surface.sharp * surface.view, axis=1)
        albedo = albedo * view_factor(albedo, n_dot_v, np.array(skin.params.reflectance))
    for name in TERMS:
        factor = 1.0 if "specular" in name else albedo
        assert np.allclose(plain[name], factor * bright[name], rtol=1e-12, atol=0.0)


@every_shading
@given(seed=SEED)
def test_a_rotation_of_surface_and_light_changes_no_term(skin, shading, seed):
    surface, light = random_surface(seed), random_light(seed)
    turn = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))
    xx, xy, xz, yy, yz, zz = surface.tensor_world.T
    shape = np.stack([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]).transpose(2, 0, 1)
    turned_shape = turn @ shape @ turn.T
    turned = replace(
        surface,
        **{name: getattr(surface, name) @ turn.T for name in VECTORS},
        tensor_world=turned_shape[:, [0, 0, 0, 1, 1, 2], [0, 1, 2, 1, 2, 2]],
    )
    plain = shade(skin, surface, [light], None, shading)
    same = shade(skin, turned, [replace(light, to_light=light.to_light @ turn.T)], None, shading)
    for name in TERMS:
        assert np.allclose(plain[name], same[name], atol=tol.TURNED.value)


def test_a_white_lambert_surface_facing_the_light_has_the_radiance_that_passes_its_coat(skin):
    terms = shade(skin, facing(), [lamp([0.0, 0.0, 1.0])], None, Shading.LAMBERT)
    assert np.allclose(terms["direct"], 1.0 - reflected_share(skin, 1.0), rtol=tol.ROUNDING.value)
    up = np.array([[0.0, 0.0, 1.0]])
    highlight = coat_highlight(up, up, up, np.full(1, 0.35), np.full(1, 0.028))
    assert np.allclose(terms["specular"], highlight, rtol=tol.ROUNDING.value)
    bare = Skin.of(skin.profile, SkinParams(reflectance=0.0), luts=("coat",), fetches=())
    surface, light = facing(reflectance=np.zeros(1)), lamp([0.0, 0.0, 1.0])
    without_coat = shade(bare, surface, [light], None, Shading.LAMBERT)["direct"]
    assert np.abs(without_coat - 1.0).max() <= tol.ROUNDING.value


@pytest.mark.parametrize("tier", Tier)
@pytest.mark.parametrize("cosine", [-0.5, 0.2, 0.7, 1.0])
def test_on_a_plane_transfer_is_lambert_in_every_tier(skin, tier, cosine):
    light = lamp([np.sqrt(1.0 - cosine**2), 0.0, cosine])
    white = facing()  # its view factor is 1
    lambert = shade(skin, white, [light], None, Shading.LAMBERT)
    transfer = shade(skin, white, [light], None, tier=tier)
    assert np.abs(transfer["direct"] - lambert["direct"]).max() <= tol.PLANE.value
    assert np.array_equal(transfer["specular"], lambert["specular"])


@every_shading
def test_in_full_shadow_direct_and_specular_light_are_zero(skin, shading):
    terms = shade(skin, facing(), [lamp([0.0, 0.0, 1.0], shadow=0.0)], None, shading)
    assert terms["direct"].max() <= tol.DARK_END.value
    assert terms["specular"].max() <= tol.ROUNDING.value


@given(st.floats(0.0, 20.0), st.floats(0.0, 1.0))
def test_deep_scatter_is_transmittance_times_tint_times_the_cosine_behind(skin, t, behind):
    light = lamp([np.sqrt(1.0 - behind**2), 0.0, -behind], thickness=t)
    terms = shade(skin, facing(0.5), [light], None, Shading.TRANSFER)
    albedo = skin.profile.albedo
    passed = transmittance(np.array(t), albedo, skin.sigma_per_mm) / albedo
    leaving = view_factor(np.full(3, 0.5), np.array(1.0), np.array(0.028))
    truth = passed * behind * (0.9, 0.5, 0.4) * 0.5 * (1.0 - reflected_share(skin, 1.0)) * leaving
    assert np.allclose(terms["deep_scatter"], truth, rtol=1e-9, atol=1e-15)


def test_lambert_and_a_body_of_unknown_thickness_have_no_deep_scatter(skin):
    behind = [0.0, 0.0, -1.0]
    lambert = shade(skin, facing(), [lamp(behind, 1.0)], None, Shading.LAMBERT)
    assert not lambert["deep_scatter"].any()
    for shading in Shading:
        unknown = shade(skin, facing(), [lamp(behind)], None, shading)
        assert not unknown["deep_scatter"].any()


def uniform_sky(level=1.0, visibility=1.0):
    sh = np.zeros((9, 3))
    sh[0] = level * np.sqrt(4.0 * np.pi)
    zero = np.zeros((1, 3))
    return Ambient(sh, np.full((1, 3), visibility), zero, np.full((1, 3), level))


@pytest.mark.parametrize("shading", [Shading.LAMBERT, Shading.TRANSFER])
@given(view=st.floats(0.05, 1.0))
def test_a_white_plane_under_a_uniform_sky_has_the_radiance_of_the_sky(skin, shading, view):
    tilted = facing(view=np.array([[np.sqrt(1.0 - view**2), 0.0, view]]))
    terms = shade(skin, tilted, [], uniform_sky(), shading)
    assert np.allclose(terms["ambient"] + terms["ambient_specular"], 1.0, atol=1e-9)
    assert np.allclose(terms["ambient_specular"], reflected_share(skin, view), rtol=1e-9)


@every_shading
def test_half_the_visibility_gives_half_the_ambient_light(skin, shading):
    whole, half = (
        shade(skin, facing(), [], uniform_sky(visibility=share), shading)["ambient"]
        for share in (1.0, 0.5)
    )
    assert np.allclose(half, 0.5 * whole, rtol=tol.ROUNDING.value)


@given(seed=SEED)
def test_the_relief_of_the_mesh_is_the_same_from_vertices_and_from_pixels(skin, seed):
    surface, light = random_surface(seed), random_light(seed)
    n = surface.mesh_normal
    _, total = directional_curvature(surface.tensor_world, n, light.to_light)
    flat = np.repeat(n[:, None], 3, axis=1)
    relief = relief_length(skin.transfer, flat, surface.diffused_normals, total)
    at_vertices, at_pixels, without = (
        shade(skin, replace(surface, mesh_relief=length), [light], None)["direct"]
        for length in (relief, None, np.ones_like(relief))
    )
    assert np.allclose(at_vertices, at_pixels, rtol=1e-9, atol=1e-12)
    assert (at_vertices >= without - tol.ROUNDING.value).all()


def test_a_convex_body_multiplies_ambient_light_by_its_energy_gain(skin):
    curved = facing(
        curvature_per_mm=np.full(1, 0.1), diffused_curvature_per_mm=np.full((1, 3), 0.1)
    )
    flat, convex = (
        shade(skin, surface, [], uniform_sky())["ambient"] for surface in (facing(), curved)
    )
    gain = energy_gain(skin.profile.albedo, skin.profile.rms_radius_mm, np.array([0.1]))
    assert np.allclose(convex / flat, gain, rtol=1e-9)


@given(SEED)
def test_a_tier_without_its_data_falls_back_to_a_tier_that_has_it(skin, seed):
    surface, lights = random_surface(seed), [random_light(seed)]
    without_both = replace(surface, tensor_world=None, diffused_normals=None)
    without_one = replace(surface, diffused_normals=None)
    pairs = (
        (without_both, Tier.DIFFUSED_NORMALS, Tier.SCALAR),
        (without_both, Tier.TENSOR, Tier.SCALAR),
        (without_one, Tier.DIFFUSED_NORMALS, Tier.TENSOR),
    )
    for incomplete, requested, used in pairs:
        result = shade(skin, incomplete, lights, None, tier=requested)
        expected = shade(skin, surface, lights, None, tier=used)
        assert np.array_equal(result["direct"], expected["direct"])
