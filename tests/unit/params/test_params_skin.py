from dataclasses import FrozenInstanceError, fields, replace

import numpy as np
import pytest

from skinshade._core.errors import ArgumentError
from skinshade.params import SkinParams
from skinshade.params.fields import meaning

FIELDS = fields(SkinParams)
each_field = pytest.mark.parametrize("field", FIELDS, ids=lambda field: field.name)


def like(field, value):
    return (value,) * 3 if isinstance(field.default, tuple) else value


@each_field
def test_a_field_says_what_it_is(field):
    m = meaning(field)
    assert m.low < m.high
    assert m.about.endswith(".")
    assert m.unit in ("1", "mm", "1/mm")
    suffix = {"mm": "_mm", "1/mm": "_per_mm", "1": ""}[m.unit]
    assert field.name.endswith(suffix)
    assert not (m.unit == "1" and field.name.endswith("mm"))


@each_field
def test_the_ends_of_a_range_are_allowed_and_no_more(field):
    m = meaning(field)
    for value in (m.low, m.high):
        assert getattr(replace(SkinParams(), **{field.name: like(field, value)}), field.name) == (
            like(field, value)
        )
    for value in (np.nextafter(m.low, -np.inf), np.nextafter(m.high, np.inf), np.nan, np.inf):
        with pytest.raises(ArgumentError) as caught:
            replace(SkinParams(), **{field.name: like(field, value)})
        assert field.name in str(caught.value)
        assert f"[{m.low:g}, {m.high:g}]" in str(caught.value)


@each_field
def test_one_bad_channel_of_three_is_enough(field):
    if not isinstance(field.default, tuple):
        return
    for channel in range(3):
        values = [meaning(field).low] * 3
        values[channel] = meaning(field).high * 2.0 + 1.0
        with pytest.raises(ArgumentError, match=field.name):
            replace(SkinParams(), **{field.name: tuple(values)})


@each_field
def test_defaults_are_within_their_range(field):
    values = np.atleast_1d(field.default)
    assert (values >= meaning(field).low).all()
    assert (values <= meaning(field).high).all()


def test_parameters_do_not_change_once_checked():
    with pytest.raises(FrozenInstanceError):
        SkinParams().gloss = 2.0


def test_the_reflectance_of_skin_is_that_of_its_index():
    assert SkinParams().reflectance == pytest.approx(((1.4 - 1.0) / (1.4 + 1.0)) ** 2, abs=5e-4)
