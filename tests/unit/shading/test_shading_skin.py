"""A skin: its profile and decay, its lookups, and that threads can share it."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import FrozenInstanceError, replace

import numpy as np
import pytest

from skinshade._core.errors import ArgumentError
from skinshade.params import SkinParams
from skinshade.profile import Profile
from skinshade.shading.compose import shade
from skinshade.shading.pixel import Incident, Surface
from skinshade.shading.skin import Skin
from skinshade.shading.tables import BUILT_FOR, ENGINE_LUTS

THREADS, CHUNKS, PIXELS = 8, 64, 50


@pytest.fixture(scope="module")
def skin():
    return Skin.of(Profile.preset("skin-deon2007"), SkinParams())


@pytest.fixture(scope="module")
def bare():
    """A skin without tables or blends."""
    return Skin.of(Profile.preset("skin-deon2007"), SkinParams(), luts=(), fetches=())


def test_scatter_scale_multiplies_the_lengths_of_the_profile(bare):
    profile = Profile.preset("skin-deon2007")
    wide = Skin.of(profile, SkinParams(scatter_scale=2.0), luts=())
    assert np.allclose(wide.profile.rms_radius_mm, 2.0 * profile.rms_radius_mm)
    assert np.allclose(2.0 * wide.sigma_per_mm, bare.sigma_per_mm)


def test_a_decay_of_zero_is_the_default_of_the_profile(bare):
    params = SkinParams(deep_scatter_sigma_per_mm=(0.3, 0.0, 1.5))
    sigma_per_mm = Skin.of(Profile.preset("skin-deon2007"), params, luts=()).sigma_per_mm
    assert sigma_per_mm.tolist() == [0.3, bare.sigma_per_mm[1], 1.5]


def test_a_table_that_the_skin_was_made_without_is_an_error(bare):
    with pytest.raises(ArgumentError, match="the skin has no table 'ring'; make it with luts="):
        bare.lut("ring")
    assert not bare.tables.luts


def test_a_blend_that_the_skin_was_made_without_is_an_error(bare, skin):
    with pytest.raises(ArgumentError, match=r"no weights of 2 fetches; make it with fetches=\(2,"):
        skin.blend(2)
    with pytest.raises(ArgumentError, match="no weights of 3 fetches"):
        bare.scatter_params()
    assert not bare.tables.blends


def test_including_returns_another_skin_with_the_same_tables_and_further_ones(skin):
    more = skin.including(("classic_shadow",), (2,))
    assert set(more.tables.luts) == {*ENGINE_LUTS, "classic_shadow"}
    assert all(more.lut(name) is skin.lut(name) for name in ENGINE_LUTS)
    assert more.blend(2).sigmas_mm.shape == (1,)
    assert set(skin.tables.luts) == set(ENGINE_LUTS)
    assert set(skin.tables.blends) == {3}


def test_other_parameters_keep_the_tables(skin):
    other = skin.with_params(SkinParams(gloss=0.7))
    assert other.tables is skin.tables
    assert other.params.gloss == 0.7
    assert skin.params.gloss == SkinParams().gloss


@pytest.mark.parametrize("name", BUILT_FOR)
def test_parameters_that_need_other_tables_are_an_error(name, skin):
    params = replace(skin.params, **{name: 1.5 * getattr(skin.params, name)})
    with pytest.raises(ArgumentError, match=f"{name} is .*, but the tables were built for"):
        skin.with_params(params)


def test_scatter_params_hold_the_axes_of_all_tables_and_the_weights_of_the_fetches(skin):
    both = skin.including((), (2,))
    for fetches, blend in ((2, both.blend(2)), (3, both.blend(3))):
        packed = both.scatter_params(fetches)
        for name in ENGINE_LUTS:
            assert getattr(packed, f"{name}_axes") == skin.lut(name).axes
        weights = np.array([packed.blend_red, packed.blend_green, packed.blend_blue])
        assert np.array_equal(weights[:, :fetches], blend.weights)
        assert not weights[:, fetches:].any()
        assert packed.normal_sigmas_mm[: fetches - 1] == tuple(blend.sigmas_mm)


def test_a_skin_is_immutable(skin):
    for instance, name in (
        (skin, "params"),
        (skin, "tables"),
        (skin.tables, "luts"),
        (skin.tables, "blends"),
        (skin.params, "gloss"),
        (skin.lut("ring"), "values"),
        (skin.blend(), "weights"),
    ):
        with pytest.raises(FrozenInstanceError):
            setattr(instance, name, None)


def surface_and_light(seed):
    """Return a random surface and light at `PIXELS` pixels."""
    rng = np.random.default_rng(seed)

    def unit(*shape):
        v = rng.normal(size=(*shape, 3))
        return v / np.linalg.norm(v, axis=-1, keepdims=True)

    normal = unit(PIXELS)
    surface = Surface(
        view=unit(PIXELS),
        mesh_normal=normal,
        fetched=np.repeat(normal[:, None], 3, axis=1),
        curvature_per_mm=rng.uniform(-0.1, 0.1, PIXELS),
        albedo=rng.random((PIXELS, 3)),
        gloss=rng.random(PIXELS),
        reflectance=rng.uniform(0.0, 0.2, PIXELS),
        tint=rng.random((PIXELS, 3)),
        tensor_world=rng.uniform(-0.1, 0.1, (PIXELS, 6)),
    )
    lit, thickness_mm = rng.random(PIXELS), rng.uniform(0.0, 20.0, PIXELS)
    return surface, Incident(unit(PIXELS), rng.random((PIXELS, 3)), lit, thickness_mm)


def test_threads_that_share_a_skin_compute_the_light_of_one_thread(skin):
    luts, blends = dict(skin.tables.luts), dict(skin.tables.blends)

    def light(seed):
        surface, incident = surface_and_light(seed)
        return shade(skin, surface, [incident], None)

    expected = [light(seed) for seed in range(CHUNKS)]
    with ThreadPoolExecutor(THREADS) as pool:
        results = list(pool.map(light, range(CHUNKS)))
    for result, terms in zip(results, expected, strict=True):
        assert all(np.array_equal(result[name], terms[name]) for name in terms)
    assert all(skin.tables.luts[name] is lut for name, lut in luts.items())
    assert all(skin.tables.blends[count] is blend for count, blend in blends.items())
    assert len(skin.tables.luts) == len(luts)
    assert len(skin.tables.blends) == len(blends)


def test_threads_can_extend_one_skin_at_the_same_time(skin):
    with ThreadPoolExecutor(THREADS) as pool:
        futures = [pool.submit(skin.including, ("classic_shadow",), (2,)) for _ in range(THREADS)]
        extended = [future.result() for future in futures]
    first = extended[0].lut("classic_shadow").values
    assert all(np.array_equal(other.lut("classic_shadow").values, first) for other in extended)
    assert set(skin.tables.luts) == set(ENGINE_LUTS)
    assert set(skin.tables.blends) == {3}
