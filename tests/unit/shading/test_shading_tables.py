"""The tables of a skin: names, parameters that they depend on, and additions without rebuilding."""

from dataclasses import fields, replace

import numpy as np
import pytest

from skinshade._core.errors import ArgumentError
from skinshade.lut import DiffusionGeometry
from skinshade.params import ScatterParams, SkinParams
from skinshade.shading import tables
from skinshade.shading.energy import energy_gain
from skinshade.shading.skin import Skin
from skinshade.shading.tables import (
    BUILT_FOR,
    ENGINE_LUTS,
    LUTS,
    SkinTables,
    build_curvature_lut,
)

OTHER_PARAMS = SkinParams(
    normal_strength=0.5,
    gloss=0.6,
    reflectance=0.05,
    deep_scatter_strength=2.0,
    deep_scatter_offset_mm=1.0,
    deep_scatter_filter_mm=4.0,
    deep_scatter_sigma_per_mm=(0.3, 0.6, 0.9),
    deep_scatter_tint=(0.9, 0.5, 0.4),
    classic_deep_scatter_radius_mm=3.0,
    specular="blinn-phong",
    boundary="blender-skin",
)
"""Parameters with other values in every field that no table depends on."""
QUICK_LUTS = [name for name in LUTS if name not in ("classic", "coat")]
"""All tables but one that takes two seconds, and whose builder reads the profile alone, and that of the coat,
whose reflectance is in the scatter block."""


@pytest.fixture
def builds(monkeypatch):
    """Names of the tables and numbers of fetches that are built, in order; tables are small."""
    built = []

    def counted(name):
        def build(profile, params):
            built.append(name)
            return build_curvature_lut(profile, size=(2, 2))

        return build

    def blend(profile, *, fetches):
        built.append(fetches)
        return object()

    for name in LUTS:
        monkeypatch.setitem(LUTS, name, counted(name))
    monkeypatch.setattr(tables, "normal_blend", blend)
    return built


def test_engines_use_tables_of_the_list_and_every_table_has_axes_in_the_scatter_block():
    assert set(ENGINE_LUTS) <= set(LUTS)
    axes = {field.name for field in fields(ScatterParams) if field.name.endswith("_axes")}
    assert {f"{name}_axes" for name in LUTS} == axes


def test_only_the_requested_tables_and_blends_are_built(builds, deon):
    built = SkinTables.build(deon, SkinParams(), ("ring", "shadow"), (2,))
    assert builds == ["ring", "shadow", 2]
    assert set(built.luts) == {"ring", "shadow"}
    assert set(built.blends) == {2}


def test_by_default_the_tables_of_engines_and_three_fetches_are_built(builds, deon):
    SkinTables.build(deon, SkinParams())
    assert builds == [*ENGINE_LUTS, 3]


def test_including_builds_only_what_is_missing(builds, deon):
    first = SkinTables.build(deon, SkinParams(), ("ring",), (2,))
    builds.clear()
    second = first.including(("ring", "shadow"), (2, 3))
    assert builds == ["shadow", 3]
    assert second.luts["ring"] is first.luts["ring"]
    assert second.blends[2] is first.blends[2]
    assert set(second.luts) == {"ring", "shadow"}
    assert set(second.blends) == {2, 3}


def test_including_changes_no_tables_that_exist(builds, deon):
    first = SkinTables.build(deon, SkinParams(), ("ring",), (2,))
    second = first.including(("sphere",), (3,))
    assert second is not first
    assert set(first.luts) == {"ring"}
    assert set(first.blends) == {2}


def test_including_what_exists_returns_the_same_object(builds, deon):
    first = SkinTables.build(deon, SkinParams(), ("ring", "shadow"), (2, 3))
    builds.clear()
    assert first.including(("shadow", "ring"), (3,)) is first
    assert first.including(()) is first
    assert builds == []


def test_an_unknown_table_is_reported_with_the_known_names(deon):
    message = "there is no table 'torus'; there are ring, sphere, transfer, shadow, classic"
    with pytest.raises(ArgumentError, match=message):
        SkinTables.build(deon, SkinParams(), ("torus",), ())


@pytest.mark.parametrize("name", BUILT_FOR)
def test_check_names_the_parameter_that_needs_other_tables(name, deon):
    params = SkinParams()
    built = SkinTables.build(deon, params, (), ())
    old = getattr(params, name)
    message = f"{name} is {1.5 * old}, but the tables were built for {old}"
    with pytest.raises(ArgumentError, match=message):
        built.check(replace(params, **{name: 1.5 * old}))


def test_check_accepts_other_values_of_all_other_parameters(deon):
    defaults = SkinParams()
    free = {field.name for field in fields(SkinParams)} - set(BUILT_FOR)
    assert all(getattr(OTHER_PARAMS, name) != getattr(defaults, name) for name in free)
    assert SkinTables.build(deon, defaults, (), ()).check(OTHER_PARAMS) is None


@pytest.mark.parametrize("name", QUICK_LUTS)
def test_a_table_depends_on_no_parameter_that_check_accepts(name, deon):
    default, other = (LUTS[name](deon, params) for params in (SkinParams(), OTHER_PARAMS))
    assert np.array_equal(default.values, other.values)
    assert default.axes == other.axes


def test_the_table_of_the_coat_depends_on_the_reflectance_alone(deon):
    same = replace(OTHER_PARAMS, reflectance=SkinParams().reflectance)
    default, equal, other = (LUTS["coat"](deon, p) for p in (SkinParams(), same, OTHER_PARAMS))
    assert np.array_equal(default.values, equal.values)
    assert not np.array_equal(default.values, other.values)


def test_new_parameters_keep_the_reflectance_of_the_table_of_the_coat(deon):
    skin = Skin.of(deon, SkinParams(), luts=("coat",), fetches=(3,))
    brighter = skin.with_params(SkinParams(reflectance=0.05))
    assert brighter.scatter_params().coat_reflectance == SkinParams().reflectance
    assert brighter.lut("coat") is skin.lut("coat")
    rebuilt = Skin.of(deon, SkinParams(reflectance=0.05), luts=("coat",), fetches=(3,))
    assert rebuilt.scatter_params().coat_reflectance == 0.05


@pytest.mark.parametrize("name", ["shadow_filter_width_mm", "shadow_sharpening"])
def test_the_shadow_table_depends_on_the_width_and_the_sharpening_of_the_filter(name, deon):
    default = SkinParams()
    other = replace(default, **{name: 2.0 * getattr(default, name)})
    first, second = (LUTS["shadow"](deon, params) for params in (default, other))
    same_values = np.array_equal(first.values, second.values)
    assert not same_values or first.axes != second.axes


@pytest.mark.parametrize("kernel", DiffusionGeometry)
def test_the_energy_gain_multiplies_the_rows_of_a_curvature_table(kernel, deon):
    with_gain, without = (
        build_curvature_lut(deon, size=(8, 16), kernel=kernel, energy_gain=gain)
        for gain in (True, False)
    )
    curvature = without.rows.centres(16)
    gain = energy_gain(deon.albedo, deon.rms_radius_mm, curvature[:, None])
    expected = (without.values * gain[:, None, :]).astype(np.float32)
    assert np.allclose(with_gain.values, expected, rtol=1e-6, atol=0.0)
    assert with_gain.provenance["energy_gain"] is True
    assert without.provenance["energy_gain"] is False
