"""Where a WGSL program wants what: bind points by the names in its text."""

from __future__ import annotations

import re
from dataclasses import dataclass

from .._core.errors import ArgumentError

__all__ = ["BindPoint", "bind_points", "override_ids"]

VARIABLE = re.compile(
    r"((?:@(?:binding|group)\(\d+\)\s*){2})var\s*(?:<([^>]*)>)?\s*(\w+)\s*:\s*([\w<>, ]+);"
)
PLACE = re.compile(r"@(binding|group)\((\d+)\)")
OVERRIDE = re.compile(r"@id\((\d+)\)\s*override\s+(\w+?)(?:_0)?\s*:")


@dataclass(frozen=True)
class BindPoint:
    """One global of a program.

    Attributes
    ----------
    group, binding
        Numbers.
    kind
        Its WGSL type.
    space
        ``uniform`` or ``storage``, with ``, read_write`` where it says so; empty for a texture or sampler.
    """

    group: int
    binding: int
    kind: str
    space: str = ""


def bind_points(wgsl: str) -> dict[str, BindPoint]:
    """Return the bind points of a program by name, without the compiler's counter.

    Raises
    ------
    ArgumentError
        If the text has none.
    """
    found = {}
    for places, space, name, kind in VARIABLE.findall(wgsl):
        place = {word: int(number) for word, number in PLACE.findall(places)}
        found[name.removesuffix("_0")] = BindPoint(
            place["group"], place["binding"], kind.strip(), space.removesuffix(", read")
        )
    if not found:
        raise ArgumentError("the program has no @group(…) @binding(…) variable")
    return found


def override_ids(wgsl: str) -> dict[str, str]:
    """Return the numbers of a program's override constants by name, as pipelines want them."""
    return {name: number for number, name in OVERRIDE.findall(wgsl)}
