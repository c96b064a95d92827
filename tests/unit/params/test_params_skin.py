from dataclasses import FrozenInstanceError, replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from skinshade._core.errors import ArgumentError
from skinshade.params import SkinParams
from skinshade.params.fields import meaning, number_fields
from skinshade.params.gloss import POWER_OCTAVES, gloss_from_roughness
from tolerances import ROUNDING, ROUNDING_SUMS

FIELDS = number_fields(SkinParams)
EVERY_FIELD = pytest.mark.parametrize("field", FIELDS, ids=lambda field: field.name)


def like(field, value):
    return (value,) * 3 if isinstance(field.default, tuple) else value


@EVERY_FIELD
def test_a_field_has_unit_range_and_description(field):
    m = meaning(field)
    assert m.low < m.high
    assert m.about.endswith(".")
    assert m.unit in ("1", "mm", "1/mm")
    suffix = {"mm": "_mm", "1/mm": "_per_mm", "1": ""}[m.unit]
    assert field.name.endswith(suffix)
    assert not (m.unit == "1" and field.name.endswith("mm"))


@EVERY_FIELD
def test_a_value_outside_the_closed_range_is_refused(field):
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


@pytest.mark.parametrize(
    "field", [field for field in FIELDS if isinstance(field.default, tuple)], ids=lambda f: f.name
)
def test_one_channel_outside_the_range_is_refused(field):
    for channel in range(3):
        values = [meaning(field).low] * 3
        values[channel] = meaning(field).high * 2.0 + 1.0
        with pytest.raises(ArgumentError, match=field.name):
            replace(SkinParams(), **{field.name: tuple(values)})


@EVERY_FIELD
def test_defaults_are_within_their_range(field):
    values = np.atleast_1d(field.default)
    assert (values >= meaning(field).low).all()
    assert (values <= meaning(field).high).all()


def test_parameters_are_immutable():
    with pytest.raises(FrozenInstanceError):
        SkinParams().gloss = 2.0


def test_the_default_reflectance_is_that_of_index_1_4():
    assert SkinParams().reflectance == pytest.approx(((1.4 - 1.0) / (1.4 + 1.0)) ** 2, abs=5e-4)


# -- roughness instead of gloss --------------------------------------------------------------------


@given(st.floats(0.15, 1.0))
def test_roughness_gives_the_gloss_of_equal_width(roughness):
    """A Blinn-Phong lobe is as wide as GGX at a power of 2/r⁴ − 2 [Walter2007]."""
    power = 2.0 / roughness**4 - 2.0
    gloss = SkinParams(roughness=roughness).gloss
    if power >= 1.0:
        assert gloss * POWER_OCTAVES == pytest.approx(np.log2(power), abs=ROUNDING_SUMS.value)
    else:
        assert gloss == 0.0


def test_roughness_equals_the_gloss_that_it_stands_for():
    params = SkinParams(roughness=0.45)
    assert type(params.gloss) is float
    assert params == SkinParams(gloss=params.gloss)
    assert params.pack() == SkinParams(gloss=params.gloss).pack()
    assert SkinParams(roughness=None) == SkinParams()


@pytest.mark.parametrize(("roughness", "gloss"), [(0.0, 1.0), (1e-9, 1.0), (1.0, 0.0)])
def test_the_ends_of_roughness_are_the_ends_of_gloss(roughness, gloss):
    assert SkinParams(roughness=roughness).gloss == gloss


@given(st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_gloss_decreases_with_roughness(one, other):
    low, high = sorted((one, other))
    assert SkinParams(roughness=low).gloss >= SkinParams(roughness=high).gloss


@pytest.mark.parametrize("bad", [-1e-9, 1.0 + 1e-9, np.nan, np.inf, "rough", (0.3, 0.4, 0.5)])
def test_a_roughness_outside_0_to_1_is_refused(bad):
    with pytest.raises(ArgumentError, match="roughness"):
        SkinParams(roughness=bad)


def test_roughness_is_no_field_and_other_parameters_are_checked_beside_it():
    assert "roughness" not in [field.name for field in FIELDS]
    with pytest.raises(ArgumentError, match="reflectance"):
        SkinParams(roughness=0.5, reflectance=2.0)
    changed = replace(SkinParams(roughness=0.45), reflectance=0.04)
    assert changed.gloss == SkinParams(roughness=0.45).gloss


@pytest.mark.parametrize("shape", [(), (4,), (2, 3)])
def test_gloss_of_an_array_has_its_shape(shape):
    roughness = np.linspace(0.2, 0.9, int(np.prod(shape))).reshape(shape)
    gloss = gloss_from_roughness(roughness)
    assert gloss.shape == shape
    single = [SkinParams(roughness=value).gloss for value in roughness.ravel()]
    assert np.allclose(gloss.ravel(), single, rtol=0, atol=ROUNDING.value)
