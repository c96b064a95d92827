from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import shading_tolerances as tol
from skinshade.params import SkinParams
from skinshade.profile import Profile
from skinshade.profile.energy import energy_gain
from skinshade.shading.compose import TERMS, shade
from skinshade.shading.deep_scatter import transmittance
from skinshade.shading.direct import directional_curvature, unexplained_length
from skinshade.shading.pixel import Ambient, Incident, Surface
from skinshade.shading.skin import Skin
from skinshade.shading.specular import ambient_specular_fresnel, diffuse_share, specular

MODES = ("lambert", "classic", "transfer")
TIERS = ("scalar", "tensor", "diffused-normals")
SEED = st.integers(0, 2**20)
COUNT = 12
VECTORS = ("view", "mesh_normal", "fetched", "diffused_normals")


@pytest.fixture(scope="module")
def skin():
    return Skin.of(Profile.preset("skin-deon2007"), SkinParams(deep_scatter_tint=(0.9, 0.5, 0.4)))


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
        unexplained=rng.uniform(0.9, 1.0, (COUNT, 3)),
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
    """A flat white pixel that faces the eye."""
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
        unexplained=np.ones((1, 3)),
    )
    return replace(plain, **changes)


def lamp(to_light, thickness=None, shadow=1.0):
    t = None if thickness is None else np.array([thickness])
    return Incident(np.array([to_light]), np.ones((1, 3)), np.array([shadow]), t)


each_mode = pytest.mark.parametrize("mode", MODES)


@each_mode
@given(seed=SEED)
def test_every_term_is_there_and_no_light_is_negative(skin, mode, seed):
    terms = shade(skin, random_surface(seed), [random_light(seed)], random_sky(seed), mode)
    assert tuple(terms) == TERMS
    assert all(value.shape == (COUNT, 3) for value in terms.values())
    assert min(value.min() for value in terms.values()) >= 0.0


@each_mode
@given(seed=SEED)
def test_lights_add_up(skin, mode, seed):
    surface, one, other = random_surface(seed), random_light(seed), random_light(seed + 1)
    together = shade(skin, surface, [one, other], None, mode)
    apart = [shade(skin, surface, [light], None, mode) for light in (one, other)]
    for name in TERMS:
        total = apart[0][name] + apart[1][name]
        assert np.allclose(together[name], total, rtol=tol.ROUNDING_SUMS.value, atol=1e-15)


@each_mode
@given(seed=SEED, factor=st.floats(0.0, 10.0))
def test_twice_the_light_is_twice_the_picture(skin, mode, seed, factor):
    surface, light, sky = random_surface(seed), random_light(seed), random_sky(seed)
    more = replace(light, radiance=factor * light.radiance)
    parts = {
        n: factor * getattr(sky, n) for n in ("radiance_sh", "bounced", "reflected", "through")
    }
    plain = shade(skin, surface, [light], sky, mode)
    brighter = shade(skin, surface, [more], replace(sky, **parts), mode)
    for name in TERMS:
        assert np.allclose(brighter[name], factor * plain[name], rtol=1e-9, atol=1e-15)


@each_mode
def test_without_light_there_is_nothing(skin, mode):
    terms = shade(skin, random_surface(1), [], None, mode)
    assert all(not value.any() for value in terms.values())
    dark = replace(random_light(1), radiance=np.zeros((COUNT, 3)))
    terms = shade(skin, random_surface(1), [dark], None, mode)
    assert all(not value.any() for value in terms.values())


@each_mode
@given(seed=SEED)
def test_albedo_multiplies_what_was_within_the_body_and_nothing_else(skin, mode, seed):
    surface, light, sky = random_surface(seed), random_light(seed), random_sky(seed)
    white = replace(surface, albedo=np.ones((COUNT, 3)))
    plain, bright = (shade(skin, s, [light], sky, mode) for s in (surface, white))
    for name in TERMS:
        factor = 1.0 if "specular" in name else surface.albedo
        assert np.allclose(plain[name], factor * bright[name], rtol=1e-12, atol=0.0)


@each_mode
@given(seed=SEED)
def test_turning_everything_changes_nothing(skin, mode, seed):
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
    plain = shade(skin, surface, [light], None, mode)
    same = shade(skin, turned, [replace(light, to_light=light.to_light @ turn.T)], None, mode)
    for name in TERMS:
        assert np.allclose(plain[name], same[name], atol=tol.TURNED.value)


def test_a_white_lambert_surface_that_faces_the_light_has_radiance_one_less_its_coat(skin):
    terms = shade(skin, facing(), [lamp([0.0, 0.0, 1.0])], None, "lambert")
    coat = diffuse_share(np.ones(1), np.full(1, 0.35), np.full(1, 0.028))[0]
    assert np.allclose(terms["direct"], coat, rtol=tol.ROUNDING.value)
    up = np.array([[0.0, 0.0, 1.0]])
    highlight = specular(up, up, up, np.full(1, 0.35), np.full(1, 0.028))
    assert np.allclose(terms["specular"], highlight, rtol=tol.ROUNDING.value)
    bare = facing(reflectance=np.zeros(1), view=np.array([[0.0, 0.0, 1.0]]))
    assert np.allclose(
        shade(skin, bare, [lamp([0.0, 0.0, 1.0])], None, "lambert")["direct"], 1.0, atol=1e-12
    )


@pytest.mark.parametrize("tier", TIERS)
@pytest.mark.parametrize("cosine", [-0.5, 0.2, 0.7, 1.0])
def test_on_a_flat_lit_plane_transfer_is_lambert(skin, tier, cosine):
    light = lamp([np.sqrt(1.0 - cosine**2), 0.0, cosine])
    lambert = shade(skin, facing(), [light], None, "lambert")
    transfer = shade(skin, facing(), [light], None, "transfer", tier)
    assert np.abs(transfer["direct"] - lambert["direct"]).max() <= tol.PLANE.value
    assert np.array_equal(transfer["specular"], lambert["specular"])


@each_mode
def test_in_full_shadow_there_is_neither_direct_light_nor_a_highlight(skin, mode):
    terms = shade(skin, facing(), [lamp([0.0, 0.0, 1.0], shadow=0.0)], None, mode)
    assert terms["direct"].max() <= tol.DARK_END.value
    assert terms["specular"].max() <= tol.ROUNDING.value


@given(st.floats(0.0, 20.0), st.floats(0.0, 1.0))
def test_light_through_the_body_is_transmittance_tint_and_the_cosine_behind(skin, t, behind):
    light = lamp([np.sqrt(1.0 - behind**2), 0.0, -behind], thickness=t)
    terms = shade(skin, facing(0.5), [light], None, "transfer")
    albedo = skin.profile.albedo
    passed = transmittance(np.array(t), albedo, skin.sigma_per_mm) / albedo
    coat = diffuse_share(np.ones(1), np.full(1, 0.35), np.full(1, 0.028))[0]
    truth = passed * behind * (0.9, 0.5, 0.4) * 0.5 * coat
    assert np.allclose(terms["deep_scatter"], truth, rtol=1e-9, atol=1e-15)


def test_lambert_and_a_body_of_unknown_thickness_let_nothing_through(skin):
    behind = [0.0, 0.0, -1.0]
    assert not shade(skin, facing(), [lamp(behind, 1.0)], None, "lambert")["deep_scatter"].any()
    for mode in MODES:
        assert not shade(skin, facing(), [lamp(behind)], None, mode)["deep_scatter"].any()


def even_sky(level=1.0, visibility=1.0):
    sh = np.zeros((9, 3))
    sh[0] = level * np.sqrt(4.0 * np.pi)
    zero = np.zeros((1, 3))
    return Ambient(sh, np.full((1, 3), visibility), zero, np.full((1, 3), level))


@pytest.mark.parametrize("mode", ["lambert", "transfer"])
@given(view=st.floats(0.05, 1.0))
def test_a_white_plane_under_an_even_sky_cannot_be_told_from_it(skin, mode, view):
    tilted = facing(view=np.array([[np.sqrt(1.0 - view**2), 0.0, view]]))
    terms = shade(skin, tilted, [], even_sky(), mode)
    assert np.allclose(terms["ambient"] + terms["ambient_specular"], 1.0, atol=1e-9)
    fresnel = ambient_specular_fresnel(np.array(view), np.array(0.35), np.array(0.028))
    assert np.allclose(terms["ambient_specular"], fresnel, rtol=1e-9)


@each_mode
def test_half_a_sky_gives_half_the_ambient_light(skin, mode):
    whole, half = (
        shade(skin, facing(), [], even_sky(visibility=share), mode)["ambient"]
        for share in (1.0, 0.5)
    )
    assert np.allclose(half, 0.5 * whole, rtol=tol.ROUNDING.value)


@given(seed=SEED)
def test_what_folds_leave_may_be_found_for_vertices_or_for_pixels(skin, seed):
    surface, light = random_surface(seed), random_light(seed)
    n = surface.mesh_normal
    _, total = directional_curvature(surface.tensor_world, n, light.to_light)
    flat = np.repeat(n[:, None], 3, axis=1)
    found = unexplained_length(skin.transfer, flat, surface.diffused_normals, total)
    at_vertices, at_pixels, none = (
        shade(skin, replace(surface, unexplained=each), [light], None, "transfer")["direct"]
        for each in (found, None, np.ones_like(found))
    )
    assert np.allclose(at_vertices, at_pixels, rtol=1e-9, atol=1e-12)
    bumps = (found < 0.999).any(axis=1) & (light.shadow_filter > 0.01)
    assert (at_vertices >= none - 1e-12).all() or not bumps.any()


def test_a_convex_body_returns_more_of_an_even_sky_by_its_gain(skin):
    curved = facing(
        curvature_per_mm=np.full(1, 0.1), diffused_curvature_per_mm=np.full((1, 3), 0.1)
    )
    flat, round_ = (
        shade(skin, s, [], even_sky(), "transfer")["ambient"] for s in (facing(), curved)
    )
    gain = energy_gain(skin.profile.albedo, skin.profile.rms_radius_mm, np.array([0.1]))
    assert np.allclose(round_ / flat, gain, rtol=1e-9)


@given(SEED)
def test_a_tier_without_its_data_is_the_tier_above(skin, seed):
    surface, lights = random_surface(seed), [random_light(seed)]
    without_both = replace(surface, tensor_world=None, diffused_normals=None)
    without_one = replace(surface, diffused_normals=None)
    pairs = (
        (without_both, "diffused-normals", "scalar"),
        (without_both, "tensor", "scalar"),
        (without_one, "diffused-normals", "tensor"),
    )
    for lacking, asked, had in pairs:
        found = shade(skin, lacking, lights, None, "transfer", asked)
        assert np.array_equal(
            found["direct"], shade(skin, surface, lights, None, "transfer", had)["direct"]
        )


def test_scaling_the_scatter_is_scaling_the_profile():
    profile = Profile.preset("skin-deon2007")
    wide = Skin.of(profile, SkinParams(scatter_scale=2.0))
    assert np.allclose(wide.profile.rms_radius_mm, 2.0 * profile.rms_radius_mm)
    assert np.allclose(2.0 * wide.sigma_per_mm, Skin.of(profile, SkinParams()).sigma_per_mm)
    given_sigma = Skin.of(profile, SkinParams(deep_scatter_sigma_per_mm=(0.3, 0.0, 1.5)))
    default = Skin.of(profile, SkinParams()).sigma_per_mm
    assert given_sigma.sigma_per_mm.tolist() == [0.3, default[1], 1.5]
