"""Tables of an eye: files, what they depend on, and what they are refused for."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
import pytest

import skinshade as sk
from skinshade._core.errors import ArgumentError, LutFileError
from skinshade.shading import eye_tables
from skinshade.shading.eye_rays import through_cornea
from skinshade.shading.eye_tables import TABLES_HOLD, EyeLuts, build_eye_lut


@pytest.fixture(scope="module")
def luts():
    return build_eye_lut()


@pytest.mark.parametrize("suffix", [".exr", ".npz"])
def test_tables_survive_files_exactly(luts, tmp_path, suffix):
    luts.save(tmp_path / "eye", suffix)
    again = EyeLuts.load(tmp_path / "eye", suffix)
    for name, lut in luts.by_name().items():
        other = again.by_name()[name]
        assert np.array_equal(other.values, lut.values)
        assert other.axes == lut.axes
        assert other.provenance == lut.provenance


def test_tables_are_computed_once_and_read_from_the_cache(luts, monkeypatch):
    def fail(*_):
        pytest.fail("the tables were computed again")

    monkeypatch.setattr(eye_tables, "_lamp_values", fail)
    again = build_eye_lut(sk.EyeParams(pupil_radius_mm=4.0, refraction_index=1.4))
    assert np.array_equal(again.lamp.values, luts.lamp.values)


@pytest.mark.slow
def test_two_computations_are_equal(luts, monkeypatch):
    monkeypatch.setattr(eye_tables, "load_cached", lambda name: None)
    again = build_eye_lut()
    for name, lut in luts.by_name().items():
        assert np.array_equal(again.by_name()[name].values, lut.values)


@pytest.mark.parametrize("name", TABLES_HOLD)
def test_tables_of_another_eye_are_refused_by_the_parameter(luts, name):
    value = getattr(sk.EyeParams(), name)
    luts.check(sk.EyeParams(pupil_radius_mm=3.0))
    with pytest.raises(ArgumentError, match=f"{name} is .*build_eye_lut"):
        luts.check(sk.EyeParams(**{name: value + 0.001}))


@pytest.mark.parametrize("name", [field.name for field in fields(sk.EyeParams)])
def test_rays_depend_on_the_parameters_that_the_tables_hold_and_on_no_other(name):
    x, y = np.linspace(-6.2, 6.2, 40), np.linspace(3.0, -2.0, 40)
    light = np.tile([0.6, 0.0, 0.8], (40, 1))
    eye = sk.EyeParams()
    value = getattr(eye, name)
    other = tuple(v + 0.01 for v in value) if isinstance(value, tuple) else value + 0.01
    changed = replace(eye, **{name: other})
    before, after = (np.stack(through_cornea(params, x, y, light)) for params in (eye, changed))
    # The radius of the iris changes no ray: it is the extent of the tables.
    depends = name in TABLES_HOLD and name != "iris_radius_mm"
    assert np.array_equal(before, after) is not depends


def test_a_table_of_another_kind_is_refused(luts, tmp_path):
    with pytest.raises(ArgumentError, match="surroundings: kind is 'eye-lamp'"):
        EyeLuts(luts.lamp, luts.lamp)
    with pytest.raises(LutFileError, match=r"eye_lamp_lut\.exr"):
        EyeLuts.load(tmp_path)


def test_the_table_of_a_lamp_has_16_slices_of_16_rows_and_32_columns(luts):
    assert luts.lamp.values.shape == (256, 32, 3)
    assert luts.surroundings.values.shape == (2, 32, 3)
    assert (luts.lamp.values[..., 0] >= 0.0).all()
