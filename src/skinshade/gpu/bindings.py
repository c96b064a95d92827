"""Bind points and override constants of a WGSL program, by their names in its text."""

from __future__ import annotations

import re
from dataclasses import dataclass

from .._core.errors import ArgumentError

__all__ = ["BindPoint", "bind_points", "override_ids"]

VARIABLE = re.compile(
    r"((?:@(?:binding|group)\(\d+\)\s*){2})var\s*(?:<([^>]*)>)?\s*(\w+)\s*:\s*([\w<>, ]+);"
)
NUMBER = re.compile(r"@(binding|group)\((\d+)\)")
OVERRIDE = re.compile(r"@id\((\d+)\)\s*override\s+(\w+?)(?:_0)?\s*:")


@dataclass(frozen=True)
class BindPoint:
    """Bind point: a resource variable of a program.

    Attributes
    ----------
    group, binding
        Numbers of the bind group and of the binding in it.
    kind
        WGSL type of the variable.
    space
        Address space: ``uniform``, ``storage`` or ``storage, read_write``; empty for a texture or sampler.
    """

    group: int
    binding: int
    kind: str
    space: str = ""


def bind_points(wgsl: str) -> dict[str, BindPoint]:
    """Return the bind points of a program by name, without the suffix ``_0`` of the Slang compiler.

    Raises
    ------
    ArgumentError
        If the text has no bind point.
    """
    points = {}
    for numbers, space, name, kind in VARIABLE.findall(wgsl):
        number = {word: int(digits) for word, digits in NUMBER.findall(numbers)}
        points[name.removesuffix("_0")] = BindPoint(
            number["group"], number["binding"], kind.strip(), space.removesuffix(", read")
        )
    if not points:
        raise ArgumentError("the program has no @group(…) @binding(…) variable")
    return points


def override_ids(wgsl: str) -> dict[str, str]:
    """Return the ids of a program's override constants by name."""
    return {name: number for number, name in OVERRIDE.findall(wgsl)}
