"""Numbers from text equal those of Python, and words that are no numbers are found."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from skinshade.mesh.decimals import floats, separators, whole_numbers
from skinshade.mesh.text import Lines


def parsed(words, separator=" "):
    lines = Lines.of(separator.join(words).encode() or b"\n", 0)
    return floats(lines.characters, lines.words, lines.word_ends)


DIGITS = st.text("0123456789", max_size=20)
DECIMAL = st.builds(
    lambda sign, whole, point, part: (
        f"{sign}{whole or ('' if part and point else '0')}" + (f".{part}" if point else "")
    ),
    st.sampled_from(["", "-", "+"]),
    DIGITS,
    st.booleans(),
    DIGITS,
)
WORD = DECIMAL | st.floats().map(repr) | st.floats(width=32).map(lambda value: f"{value:.9g}")


@given(st.lists(WORD, min_size=1, max_size=40))
def test_numbers_are_rounded_as_by_python(words):
    expected = np.array([float(word) for word in words])
    result = parsed(words)
    np.testing.assert_array_equal(result, expected)
    np.testing.assert_array_equal(np.signbit(result), np.signbit(expected))


def test_numbers_of_every_number_of_digits_are_rounded_as_by_python():
    rng = np.random.default_rng(5)
    words = [
        f"{sign}{''.join(map(str, rng.integers(0, 10, whole)))}."
        f"{''.join(map(str, rng.integers(0, 10, part)))}"
        for sign in ("", "-", "+")
        for whole in range(1, 20)
        for part in range(20)
    ]
    np.testing.assert_array_equal(parsed(words), [float(word) for word in words])


@pytest.mark.parametrize(
    "word",
    [
        *("", ".", "-", "+.", "1-", "1-2", "1.-2", "--1", "1.2.3", "1_0", "0x1", "1e", "e5", "1,5"),
        *("a", "1\0", "\u0661"),
    ],
)
def test_a_word_that_is_no_number_is_found_among_numbers(word):
    for words in ([word], ["1", word], [word, "2.5"], ["1.5"] * 30 + [word] + ["1e5"] * 30):
        if word:
            assert parsed(words) is None
        else:
            assert parsed(words).size == len(words) - 1


@given(st.lists(st.integers(0, 10**18 - 1).map(str) | st.just(""), min_size=1, max_size=30))
def test_whole_numbers_are_exact(parts):
    text = ",".join(parts) + "\n"
    stops = np.cumsum([len(part) + 1 for part in parts]) - 1
    starts = np.concatenate([[0], stops[:-1] + 1])
    characters = np.frombuffer(text.encode(), np.uint8)
    values, missing, faulty = whole_numbers(characters, starts, stops)
    assert values.tolist() == [int(part or 0) for part in parts]
    assert missing.tolist() == [part == "" for part in parts]
    assert not faulty.any()


@pytest.mark.parametrize("part", ["1" * 19, "1a", "-1", "+1", "1.0", "1 ", "\u0661"])
def test_parts_other_than_digits_are_faulty(part):
    characters = np.frombuffer(part.encode() + b"\n", np.uint8)
    size = characters.size - 1
    values, missing, faulty = whole_numbers(characters, np.array([0]), np.array([size]))
    assert (values[0], missing[0], faulty[0]) == (0, False, True)


@given(st.lists(st.text("ab/", min_size=1, max_size=5), min_size=1, max_size=20), st.integers(1, 2))
def test_separators_are_found_in_every_word(words, most):
    text = "x/x " + " /".join(words) + "\n"  # separators outside of the words do not count
    stops = 4 + np.cumsum([len(word) + 2 for word in words]) - 2
    starts = stops - [len(word) for word in words]
    columns, more = separators(np.frombuffer(text.encode(), np.uint8), starts, stops, "/", most)
    for number, column in enumerate(columns):
        for word, start, stop, offset in zip(words, starts, stops, column, strict=True):
            places = [place for place, letter in enumerate(word) if letter == "/"]
            assert offset == (start + places[number] if number < len(places) else stop)
    assert more.tolist() == [word.count("/") > most for word in words]
