"""Faster parsing of the names of C types, which the binding of wgpu does at the first use of every type."""

from __future__ import annotations

import re
from typing import Any

__all__ = ["parse_used_names"]

PREFIX = "typedef "
"""Start of the keys of types in the table of declarations."""


def parse_used_names(ffi: Any) -> None:
    """Let an interface of cffi parse a type with the declarations of the names in it alone.

    cffi declares all 400 types of wgpu's header again for each name such as ``WGPULimits *``, which takes
    .04 s: 3 s for a picture. A name is parsed alike with the types that occur in it. Parsers of
    cffi with other attributes stay as they are.

    Parameters
    ----------
    ffi
        Interface that has read its header.
    """
    parser: Any = getattr(ffi, "_parser", None)
    parse = getattr(parser, "_parse", None)
    declarations = getattr(parser, "_declarations", None)
    if parse is None or not isinstance(declarations, dict):
        return

    def parse_names(source: str) -> Any:
        declared = parser._declarations
        names = {PREFIX + name for name in re.findall(r"\w+", source)}
        parser._declarations = {
            key: value
            for key, value in declared.items()
            if not key.startswith(PREFIX) or key in names
        }
        try:
            return parse(source)
        finally:
            parser._declarations = declared

    parser._parse = parse_names
