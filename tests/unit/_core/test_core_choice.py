import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from skinshade._core.choice import Choice
from skinshade._core.errors import ArgumentError


class Colour(Choice):
    """Three colours."""

    RED = "red"
    DARK_GREEN = "dark-green"
    BLUE = "blue"


@pytest.mark.parametrize("colour", list(Colour))
def test_a_member_is_equal_to_its_text(colour):
    assert colour == colour.value
    assert hash(colour) == hash(colour.value)
    assert f"{colour}" == colour.value
    assert json.dumps(colour) == json.dumps(colour.value)


@pytest.mark.parametrize("colour", list(Colour))
def test_a_text_and_the_member_itself_give_the_member(colour):
    assert Colour.of(colour.value, "colour") is colour
    assert Colour.of(colour, "colour") is colour


def test_numbers_are_positions_in_the_enumeration():
    assert [colour.number for colour in Colour] == [0, 1, 2]
    assert Colour.DARK_GREEN.number == 1


def test_an_unknown_text_is_refused_with_the_name_and_the_choices():
    with pytest.raises(ArgumentError) as caught:
        Colour.of("pink", "wall")
    assert str(caught.value) == "wall is 'pink'; it must be one of red, dark-green, blue"


@pytest.mark.parametrize("value", ["", "RED", " red", "DARK_GREEN", None, 0, 1.5, ["red"], {}])
def test_a_value_that_is_no_text_of_a_member_is_refused(value):
    with pytest.raises(ArgumentError, match="colour is"):
        Colour.of(value, "colour")


@given(st.text())
def test_any_text_gives_a_member_of_this_text_or_an_argument_error(text):
    try:
        assert Colour.of(text, "colour").value == text
    except ArgumentError as error:
        assert text not in list(Colour)
        assert repr(text) in str(error)
