"""Values that are written as one word on the command line."""

from __future__ import annotations

import math

from .._core.errors import ArgumentError

__all__ = ["numbers", "pair", "size"]


def numbers(text: str, count: int, what: str) -> tuple[float, ...]:
    """Return `count` finite numbers separated by commas.

    Raises
    ------
    ArgumentError
        Naming the option and the text.
    """
    try:
        values = tuple(float(part) for part in text.split(","))
    except ValueError:
        values = ()
    if len(values) != count or not all(math.isfinite(value) for value in values):
        raise ArgumentError(f"{what} is {text!r}; it must be {count} numbers separated by commas")
    return values


def pair(text: str, what: str) -> tuple[float, float]:
    """Return two numbers separated by a comma."""
    first, second = numbers(text, 2, what)
    return first, second


def size(text: str, what: str = "--size") -> tuple[int, int]:
    """Return width and height, written 1280x720.

    Raises
    ------
    ArgumentError
        If the text is no such pair.
    """
    width, _, height = text.lower().partition("x")
    if not (text.isascii() and width.isdigit() and height.isdigit()):
        raise ArgumentError(f"{what} is {text!r}; it must be WIDTHxHEIGHT, such as 1280x720")
    return int(width), int(height)
