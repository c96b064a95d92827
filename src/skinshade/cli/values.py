"""Parsers of option values that are one word, such as ``1280x720`` or ``1,0.5,0``."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

from .._core.errors import ArgumentError, OutputError

__all__ = ["check_output", "parse_limits", "parse_numbers", "parse_pair", "parse_size"]


def check_output(output: Path | None) -> Path | None:
    """Return the path of an output.

    Raises
    ------
    OutputError
        If it is ``-``, which other programs take for standard output.
    """
    if output == Path("-"):
        raise OutputError(
            "--output is '-'; writing to standard output is not supported, give the name of a file or folder"
        )
    return output


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


def parse_limits(texts: Sequence[str], option: str = "--limit") -> dict[str, int]:
    """Return the values in texts such as ``image_pixels=1000000``, by name.

    Names may have hyphens instead of underscores. The last value of a name applies.

    Raises
    ------
    ArgumentError
        If a text has another form; the message names the option and the text.
    """
    values = {}
    for text in texts:
        name, _, value = text.partition("=")
        if not (name and value.isascii() and value.isdigit() and len(value) < 20):
            raise ArgumentError(
                f"{option} is {text!r}; it must be NAME=VALUE with a whole number, such as lights=100"
            )
        values[name.replace("-", "_")] = int(value)
    return values
