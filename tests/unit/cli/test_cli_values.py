import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from skinshade._core.errors import ArgumentError
from skinshade.cli.values import parse_numbers, parse_pair, parse_size

FINITE = st.floats(allow_nan=False, allow_infinity=False)


@given(st.lists(FINITE, min_size=1, max_size=5))
def test_numbers_are_read_as_they_are_printed(values):
    text = ", ".join(map(repr, values))
    assert parse_numbers(text, len(values), "--light") == tuple(values)


def test_a_pair_is_two_numbers():
    assert parse_pair("1e2,-3", "--view") == (100.0, -3.0)


@pytest.mark.parametrize(
    ("text", "count"),
    [("", 1), ("1", 2), ("1,2,3", 2), ("1,", 2), ("a,b", 2), ("1;2", 2), ("1,nan", 2), ("inf", 1)],
)
def test_another_number_of_numbers_is_an_error_that_quotes_the_text(text, count):
    with pytest.raises(ArgumentError) as caught:
        parse_numbers(text, count, "--light")
    expected = f"--light is {text!r}; it must be {count} numbers separated by commas"
    assert str(caught.value) == expected


@given(st.text(max_size=12), st.integers(1, 3))
def test_any_text_is_numbers_or_an_argument_error(text, count):
    try:
        values = parse_numbers(text, count, "--light")
    except ArgumentError:
        return
    assert len(values) == count
    assert np.isfinite(values).all()


@pytest.mark.parametrize("text", ["1280x720", "1280X720", "01280x0720"])
def test_a_size_is_width_and_height(text):
    assert parse_size(text) == (1280, 720)


@pytest.mark.parametrize(
    "text", ["", "x", "64", "64x", "x64", "64x64x64", "-1x5", "1.5x2", "64 x 64", "64,64", "²x²"]
)
def test_a_text_that_is_no_size_is_an_error_that_quotes_it(text):
    with pytest.raises(ArgumentError) as caught:
        parse_size(text, "--extent")
    expected = f"--extent is {text!r}; it must be WIDTHxHEIGHT, such as 1280x720"
    assert str(caught.value) == expected


@given(st.text(max_size=8))
def test_any_text_is_a_size_or_an_argument_error(text):
    try:
        width, height = parse_size(text)
    except ArgumentError:
        return
    assert width >= 0
    assert height >= 0
