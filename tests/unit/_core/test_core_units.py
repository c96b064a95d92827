import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from skinshade._core.errors import UnitError
from skinshade._core.units import MM_PER_UNIT, checked_unit_mm, parse_unit_mm


@pytest.mark.parametrize(
    ("name", "mm"), [("mm", 1.0), ("cm", 10.0), ("m", 1000.0), ("in", 25.4), ("ft", 12 * 25.4)]
)
def test_a_named_unit_is_its_length_in_mm(name, mm):
    assert MM_PER_UNIT[name] == pytest.approx(mm, rel=1e-15)
    assert parse_unit_mm(f" {name.upper()} ") == MM_PER_UNIT[name]


@given(st.floats(1e-6, 1e9))
def test_a_number_is_a_length_in_mm(mm):
    assert parse_unit_mm(repr(mm)) == mm
    assert checked_unit_mm(mm, "head.obj") == mm


@pytest.mark.parametrize("text", ["", "furlong", "10 cm", "0x10"])
def test_text_that_is_no_unit_is_refused_with_the_known_names(text):
    with pytest.raises(UnitError) as caught:
        parse_unit_mm(text)
    assert all(name in str(caught.value) for name in MM_PER_UNIT)


@pytest.mark.parametrize("text", ["0", "-1", "nan", "inf"])
def test_a_number_that_is_no_plausible_length_is_refused(text):
    with pytest.raises(UnitError, match="positive"):
        parse_unit_mm(text)


@pytest.mark.parametrize("value", [0.0, -1.0, math.nan, math.inf, "cm", None, [1.0, 2.0]])
def test_a_value_that_is_no_length_is_refused_with_the_callers_name(value):
    with pytest.raises(UnitError, match=r"head\.obj"):
        checked_unit_mm(value, "head.obj")
