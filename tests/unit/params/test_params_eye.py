"""Parameters of an eye: ranges, parts that must fit each other, and the planes of lids."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
import pytest

from skinshade._core.errors import ArgumentError
from skinshade.params import EyeParams, EyePlaceParams
from skinshade.params.eye import CANTHUS_DEPTH_MM, CANTHUS_RADIUS_MM, lid_plane
from skinshade.params.fields import meaning
from skinshade.shading.eye import eye_cornea
from skinshade.shading.eye_tables import build_eye_lut, eye_place
from tolerances import ROUNDING

EVERY_FIELD = pytest.mark.parametrize("field", fields(EyeParams), ids=lambda field: field.name)


@EVERY_FIELD
def test_a_field_of_an_eye_has_unit_range_and_description(field):
    m = meaning(field)
    assert m.low < m.high
    assert m.about.endswith(".")
    suffix = {"mm": "_mm", "deg": "_deg", "1": ""}[m.unit]
    assert field.name.endswith(suffix)


@EVERY_FIELD
def test_a_value_outside_its_range_is_refused_by_name(field):
    m = meaning(field)
    for value in (np.nextafter(m.low, -np.inf), np.nextafter(m.high, np.inf), np.nan):
        row = (value,) * 4 if isinstance(field.default, tuple) else value
        with pytest.raises(ArgumentError, match=rf"{field.name} is .*\[{m.low:g}, {m.high:g}\]"):
            replace(EyeParams(), **{field.name: row})


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"cornea_radius_mm": 6.0, "cornea_asphericity": 0.3}, "cornea .* is not that wide"),
        ({"sclera_radius_mm": 8.0, "limbus_radius_mm": 7.5, "cornea_radius_mm": 10.0}, "sclera"),
        ({"iris_radius_mm": 3.0, "pupil_radius_mm": 3.0}, "pupil_radius_mm is 3"),
        ({"iris_radius_mm": 8.0, "iris_depth_mm": 1.0}, "lies outside the sclera"),
    ],
)
def test_parts_that_do_not_fit_each_other_are_refused(changes, message):
    with pytest.raises(ArgumentError, match=message):
        EyeParams(**changes)


def test_the_arguments_of_the_functions_hold_the_fields():
    eye = EyeParams(pupil_radius_mm=3.0, iris_slope=-0.1)
    r, index = np.array(eye.cornea_radius_mm), np.array(eye.refraction_index)
    cornea = eye_cornea(r, np.array(eye.cornea_asphericity), index, eye.limbus)
    assert np.abs(eye.cornea - cornea).max() <= ROUNDING.value * 13.0
    assert eye.limbus.tolist() == [5.9, 0.6, 12.0, 0.0]
    assert eye.iris.tolist() == [eye.apex_mm - 3.55, -0.1, 6.0, 3.0]


@pytest.mark.parametrize("height", [-5.6, -1.0, 0.0, 2.0, 4.2, 9.0])
def test_the_plane_of_a_lid_passes_through_its_margin_and_both_corners(height):
    x, y, z, d = lid_plane(height)
    n = np.array([x, y, z])
    margin = np.array([0.0, height, np.sqrt(CANTHUS_RADIUS_MM**2 - height**2)])
    assert abs(n @ n - 1.0) <= ROUNDING.value
    for point in (margin, [12.0, 0.0, CANTHUS_DEPTH_MM], [-12.0, 0.0, CANTHUS_DEPTH_MM]):
        assert abs(n @ point - d) <= ROUNDING.value * 13.0
    beyond = margin + np.array([0.0, 1.0 if height >= 0.0 else -1.0, 0.0])
    assert n @ beyond > d


@pytest.mark.parametrize(
    ("name", "values"), [("height_mm", (12.5, 4.5)), ("canthus_depth_mm", (4.0, -1.0))]
)
def test_a_lid_out_of_reach_is_refused(name, values):
    with pytest.raises(ArgumentError, match=f"{name} is"):
        lid_plane(*values)


def test_the_axes_of_a_placement_are_those_of_the_tables():
    placement = EyePlaceParams()
    built = eye_place(build_eye_lut().by_name(), placement)
    for name in ("lamp_axes", "surroundings_axes"):
        difference = np.subtract(getattr(built, name), getattr(placement, name))
        assert np.abs(difference).max() <= ROUNDING.value * 6.0
    other = eye_place(build_eye_lut(EyeParams(iris_radius_mm=5.0)).by_name())
    assert other.lamp_axes[0] == pytest.approx(-5.0 * 32.0 / 31.0)
