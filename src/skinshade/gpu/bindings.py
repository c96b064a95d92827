"""Where a WGSL program wants what: bind points by the names in its text."""

from __future__ import annotations

import re
from dataclasses import dataclass

from .._core.errors import ArgumentError

__all__ = ["BindPoint", "bind_points", "override_ids"]

VARIABLE = re.compile(
    r"@binding\((\d+)\)\s*@group\((\d+)\)\s*var\s*(?:<[^>]*>)?\s*(\w+)\s*:\s*([\w<>, ]+);"
    r"|@group\((\d+)\)\s*@binding\((\d+)\)\s*var\s*(?:<[^>]*>)?\s*(\w+)\s*:\s*([\w<>, ]+);"
)
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
    """

    group: int
    binding: int
    kind: str


def bind_points(wgsl: str) -> dict[str, BindPoint]:
    """Return the bind points of a program by name, without the compiler's counter.

    Raises
    ------
    ArgumentError
        If the text has none.
    """
    found = {}
    for a in VARIABLE.finditer(wgsl):
        binding, group, name, kind = a.group(1, 2, 3, 4)
        if name is None:
            group, binding, name, kind = a.group(5, 6, 7, 8)
        found[name.removesuffix("_0")] = BindPoint(int(group), int(binding), kind.strip())
    if not found:
        raise ArgumentError("the program has no @group(…) @binding(…) variable")
    return found


def override_ids(wgsl: str) -> dict[str, str]:
    """Return the numbers of a program's override constants by name, as pipelines want them."""
    return {name: number for number, name in OVERRIDE.findall(wgsl)}
