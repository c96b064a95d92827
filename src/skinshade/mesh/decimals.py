"""Numbers of files: decimal ones from parts of a text, without a loop over the parts, and float64."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import FloatArray, IntArray

__all__ = ["Bytes", "Flags", "as_float64", "floats", "separators", "whole_numbers"]

Bytes = NDArray[np.uint8]
Flags = NDArray[np.bool_]
MOST_DIGITS = 18
"""Digits of the longest whole number, which fits in 64 bits."""
EXACT_DIGITS = 15
"""Digits of the longest number whose digits, as a whole number, are exact in float64."""
EXACT_POWERS = 10.0 ** np.arange(EXACT_DIGITS + 1)


def as_float64(numbers: NDArray[np.number]) -> FloatArray:
    """Return numbers as float64, without a warning of signalling NaN, which a binary file can hold."""
    with np.errstate(invalid="ignore"):
        return numbers.astype(np.float64)


def floats(characters: Bytes, begins: IntArray, ends: IntArray) -> FloatArray | None:
    """Return the numbers (N,) that words hold, rounded as by `float`; None if a word is no number.

    Parameters
    ----------
    characters
        (n,) of the text.
    begins, ends
        (N,) offsets of the first characters of the words, and past their last ones; increasing.
    """
    (point,), several = separators(characters, begins, ends, ".", 1)
    sign = characters[begins]
    signed = (sign == ord("-")) | (sign == ord("+"))
    decimals = np.maximum(ends - point - 1, 0)
    plain = ~several & (point - begins - signed + decimals <= EXACT_DIGITS)
    if 2 * np.count_nonzero(plain) < plain.size:
        return _slow_floats(characters, begins, ends)
    whole, without_whole, bad_whole = whole_numbers(characters, begins + signed, point)
    part, without_part, bad_part = whole_numbers(characters, point + 1, ends)
    plain &= ~(bad_whole | bad_part | (without_whole & without_part))
    # The digits and the power of ten are exact, so that their quotient is the nearest number.
    scale = EXACT_POWERS[np.minimum(decimals, EXACT_DIGITS)]
    result: FloatArray = (whole * scale + part) / scale
    np.negative(result, out=result, where=sign == ord("-"))
    others = np.flatnonzero(~plain)  # with an exponent or many digits, or no number
    if others.size:
        values = _slow_floats(characters, begins[others], ends[others])
        if values is None:
            return None
        result[others] = values
    return result


def _slow_floats(characters: Bytes, begins: IntArray, ends: IntArray) -> FloatArray | None:
    text = characters.tobytes()
    words = [text[a:b] for a, b in zip(begins.tolist(), ends.tolist(), strict=True)]
    try:
        values = np.array(words, dtype=np.float64)
    except ValueError:
        return None
    # Python's numbers can have underscores between digits.
    return None if b"_" in text and any(b"_" in word for word in words) else values


def whole_numbers(
    characters: Bytes, begins: IntArray, ends: IntArray
) -> tuple[IntArray, Flags, Flags]:
    """Return whole numbers without a sign from parts of a text.

    Parameters
    ----------
    characters
        (n,) of the text.
    begins, ends
        (N,) offsets of the first characters of the parts, and past their last ones.

    Returns
    -------
    values, missing, faulty
        (N,) the numbers, 0 where a part has no characters or is faulty; whether it has no characters;
        whether it is something else than 1 to 18 digits.
    """
    lengths = ends - begins
    missing = lengths <= 0
    faulty = lengths > MOST_DIGITS
    longest = int(lengths.max(initial=0, where=~faulty))
    shortest = int(lengths.min(initial=longest))
    values = np.zeros(lengths.size, dtype=np.int64)
    offsets = ends.copy()
    for place in range(longest):
        offsets -= 1
        digits = characters.take(offsets, mode="clip") - np.uint8(ord("0"))
        if place >= shortest:
            digits *= lengths > place
        faulty |= digits > 9
        values += np.multiply(digits, 10**place, dtype=np.int64)
    values[faulty] = 0
    return values, missing, faulty


def separators(
    characters: Bytes, begins: IntArray, ends: IntArray, separator: str, most: int
) -> tuple[list[IntArray], Flags]:
    """Return the offsets of a character in words.

    Parameters
    ----------
    characters
        (n,) of the text.
    begins, ends
        (N,) offsets of the first characters of the words, and past their last ones; increasing.
    separator
        The character.
    most
        Greatest number of times that a word has it.

    Returns
    -------
    offsets, more
        `most` arrays (N,): the end of the word where it has fewer; (N,) whether a word has it more often.
    """
    count = begins.size
    if count == 0:
        return [ends] * most, np.zeros(0, dtype=bool)
    offsets = np.flatnonzero(characters == ord(separator))
    for times in range(1, most + 1):  # in most files all words have it equally often
        if offsets.size == times * count:
            table = offsets.reshape(count, times)
            if (table[:, 0] >= begins).all() and (table[:, -1] < ends).all():
                columns = [*table.T, *(ends for _ in range(most - times))]
                return columns, np.zeros(count, dtype=bool)
    word = np.searchsorted(begins, offsets, side="right") - 1
    inside = (word >= 0) & (offsets < ends[word])
    word, offsets = word[inside], offsets[inside]
    counts = np.bincount(word, minlength=count)
    first = np.cumsum(counts) - counts
    columns = []
    for number in range(most):
        column = ends.copy()
        column[counts > number] = offsets[first[counts > number] + number]
        columns.append(column)
    return columns, counts > most
