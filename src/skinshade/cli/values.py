"""Parsers of option values that are one word, such as ``1280x720`` or ``1,0.5,0``."""

from __future__ import annotations

import math

from .._core.errors import ArgumentError

__all__ = ["parse_numbers", "parse_pair", "parse_size"]


def parse_numbers(text: str, count: int, option: str) -> tuple[float, ...]:
    """Return the `count` finite numbers of a text that are separated by commas.

    Raises
    ------
    ArgumentError
        If the text has another form; the message names the option and the text.
    """
    try:
        values = tuple(float(part) for part in text.split(","))
    except ValueError:
        values = ()
    if len(values) != count or not all(math.isfinite(value) for value in values):
        raise ArgumentError(f"{option} is {text!r}; it must be {count} numbers separated by commas")
    return values


def parse_pair(text: str, option: str) -> tuple[float, float]:
    """Return the two finite numbers of a text that are separated by a comma.

    Raises
    ------
    ArgumentError
        If the text has another form; the message names the option and the text.
    """
    first, second = parse_numbers(text, 2, option)
    return first, second


def parse_size(text: str, option: str = "--size") -> tuple[int, int]:
    """Return the width and the height in a text such as ``1280x720``.

    Raises
    ------
    ArgumentError
        If the text has another form; the message names the option and the text.
    """
    width, _, height = text.lower().partition("x")
    if not (text.isascii() and width.isdigit() and height.isdigit()):
        raise ArgumentError(f"{option} is {text!r}; it must be WIDTHxHEIGHT, such as 1280x720")
    return int(width), int(height)
