"""Headers of PLY files: the elements, their properties and the comments."""

from __future__ import annotations

import re
from collections.abc import Container
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import IntArray
from .._core.errors import MeshFileError
from .text import BYTE_ORDER_MARK

__all__ = ["Column", "Element", "Header", "Lists", "Property", "read_header"]

LONGEST_HEADER = 1 << 20
"""Bytes of the longest header; those of programs have a few thousand."""
FORMATS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
"""Byte orders of the formats in NumPy's notation; text has none."""
SHORT_TYPES = {
    "char": "i1",
    "uchar": "u1",
    "short": "i2",
    "ushort": "u2",
    "int": "i4",
    "uint": "u4",
    "float": "f4",
    "double": "f8",
}
SIZED_TYPES = {
    **{f"int{8 * size}": f"i{size}" for size in (1, 2, 4, 8)},
    **{f"uint{8 * size}": f"u{size}" for size in (1, 2, 4, 8)},
    **{f"float{8 * size}": f"f{size}" for size in (4, 8)},
}
TYPES = SHORT_TYPES | SIZED_TYPES
"""Types in NumPy's notation, by the names of the format's description, and by names with a size."""
LINE_END = re.compile(rb"\r\n|\r|\n")


@dataclass(frozen=True)
class Property:
    """Property of an element: a number, or a list of numbers.

    Attributes
    ----------
    name
        Name in the file.
    type
        Type of the number, or of the numbers of the list, in NumPy's notation.
    count_type
        Type of the length of the list; None for a number.
    """

    name: str
    type: str
    count_type: str | None = None


@dataclass(frozen=True)
class Element:
    """Table of the file.

    Attributes
    ----------
    name
        Name in the file.
    rows
        Number of rows that the header states.
    properties
        Columns of the table.
    """

    name: str
    rows: int
    properties: tuple[Property, ...]


@dataclass(frozen=True)
class Lists:
    """Column of lists.

    Attributes
    ----------
    sizes
        (R,) lengths of the lists.
    values
        (sum of sizes,) their numbers.
    """

    sizes: IntArray
    values: NDArray[np.number]


Column = NDArray[np.number] | Lists
"""Numbers (R,) or lists of the rows of an element."""


@dataclass(frozen=True)
class Header:
    """Header of a file.

    Attributes
    ----------
    byte_order
        ``<`` or ``>`` for binary files, empty for text.
    elements
        Elements in the order of the file.
    comments
        Text of the comments.
    size
        Number of bytes of the header.
    """

    byte_order: str
    elements: tuple[Element, ...]
    comments: tuple[str, ...]
    size: int


def read_header(file: Path, content: bytes) -> Header:
    """Return the header of a PLY file.

    Raises
    ------
    MeshFileError
        If the header is malformed; naming the line and its number.
    """
    lines, size = _header_lines(file, content)
    byte_order: str | None = None
    comments: list[str] = []
    tables: dict[str, tuple[int, dict[str, Property]]] = {}
    properties: dict[str, Property] | None = None  # of the last element
    for number, line in enumerate(lines[1:], 2):
        keyword, _, rest = line.partition(" ")
        words = rest.split()
        try:
            match keyword:
                case "comment":
                    comments.append(rest)
                case "format":
                    byte_order = _byte_order(words)
                case "element":
                    name, rows = _element(words, tables)
                    properties = {}
                    tables[name] = rows, properties
                case "property":
                    if properties is None:
                        raise MeshFileError("is before all elements")
                    entry = _property(words, properties)
                    properties[entry.name] = entry
                case _:  # obj_info, and the second line of a comment, which some programs write
                    pass
        except MeshFileError as error:
            raise MeshFileError(
                f"{file}: line {number} of the header, {line[:60]!r}, {error}"
            ) from None
    if byte_order is None:
        raise MeshFileError(f"{file}: the header states no format")
    elements = [
        Element(name, rows, tuple(table.values())) for name, (rows, table) in tables.items()
    ]
    return Header(byte_order, tuple(elements), tuple(comments), size)


def _header_lines(file: Path, content: bytes) -> tuple[list[str], int]:
    """Return the lines of a header, single spaces between their words, and the number of its bytes."""
    start = len(BYTE_ORDER_MARK) if content.startswith(BYTE_ORDER_MARK) else 0
    head = content[start : start + LONGEST_HEADER]
    first = LINE_END.search(head)
    if first is None or head[: first.start()].strip() != b"ply":
        raise MeshFileError(f"{file}: not a PLY file; its first line is not 'ply'")
    # After CR alone, an LF is the first byte of the data.
    line_end = rb"\r" if first[0] == b"\r" else rb"(?:\r\n|\n)"
    end = re.search(rb"[\r\n][ \t]*end_header[ \t]*" + line_end, head)
    if end is None:
        raise MeshFileError(
            f"{file}: the header has no line 'end_header' within {LONGEST_HEADER} bytes"
        )
    text = head[: end.start()].decode("utf-8", "replace")
    return [" ".join(line.split()) for line in re.split(r"\r\n|\r|\n", text)], start + end.end()


def _byte_order(words: list[str]) -> str:
    if len(words) != 2 or words[0] not in FORMATS:
        raise MeshFileError(f"must name one of {', '.join(FORMATS)}, and the version")
    if words[1] != "1.0":
        raise MeshFileError("has a version other than 1.0")
    return FORMATS[words[0]]


def _element(words: list[str], names: Container[str]) -> tuple[str, int]:
    if len(words) != 2 or not re.fullmatch(r"[0-9]{1,18}", words[1]):
        raise MeshFileError("must have a name and a number of rows, 0 or more")
    if words[0] in names:
        raise MeshFileError("repeats the name of an element")
    return words[0], int(words[1])


def _property(words: list[str], names: Container[str]) -> Property:
    is_list = len(words) == 4 and words[0] == "list"
    if len(words) != 2 and not is_list:
        raise MeshFileError("must have a type and a name, or 'list', two types and a name")
    *types, name = words[1:] if is_list else words
    for type_ in types:
        if type_ not in TYPES:
            raise MeshFileError(f"has the unknown type {type_!r}")
    if name in names:
        raise MeshFileError("repeats the name of a property")
    if not is_list:
        return Property(name, TYPES[types[0]])
    if TYPES[types[0]].startswith("f"):
        raise MeshFileError("counts a list by a type that is not whole")
    return Property(name, TYPES[types[1]], TYPES[types[0]])
