"""STL, binary and ASCII: triangles without shared vertices."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from .._core.arrays import FloatArray, IntArray
from .._core.errors import MeshFileError
from ..gltf import TriangleSet
from .decimals import as_float64, floats
from .text import BYTE_ORDER_MARK, Lines, PlainText

__all__ = ["read_stl"]

HEADER = 80
"""Bytes of the header of binary files, whose content is free."""
RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
PADDING = b"\0 \t\r\n\v\f"
"""Bytes that may follow the last facet of a binary file."""
KEYWORDS = (b"facet", b"outer", b"vertex", b"endloop", b"endfacet", b"solid", b"endsolid")
"""First words of the lines of ASCII files, in any case."""
SOLID, END_SOLID = 5, 6
FACET = (b"facet", b"outer", b"vertex", b"vertex", b"vertex", b"endloop", b"endfacet")
"""First words of the lines of a facet."""
FACET_NUMBERS = np.array([KEYWORDS.index(keyword) for keyword in FACET])


def read_stl(file: Path) -> tuple[TriangleSet, list[str]]:
    """Return the triangles of an STL file, three vertices for every one, and an empty list of comments.

    Facets of all solids are joined. The normals of facets are ignored: those of vertices are computed.

    Raises
    ------
    MeshFileError
        If the file ends early, a line or the number of facets is wrong, or there are no facets.
    """
    content = file.read_bytes()
    corners = _binary_corners(file, content)
    if corners is None:
        corners = _text_corners(PlainText.of(file, content))
    if not len(corners):
        raise MeshFileError(f"{file}: holds no triangles")
    faces = np.arange(len(corners), dtype=np.int64).reshape(-1, 3)
    return TriangleSet(corners, faces, None, None), []


def _binary_corners(file: Path, content: bytes) -> FloatArray | None:
    """Return the corners (3F, 3) of a binary file, or None if the file is text.

    Some programs begin the header of binary files with ``solid``, as ASCII files begin. A file is binary
    if it has the size that follows from its number of facets, or does not begin with ``solid``.
    """
    start = HEADER + 4
    head = content[:HEADER].removeprefix(BYTE_ORDER_MARK).lstrip().lower()
    count = int.from_bytes(content[HEADER:start], "little")
    end = start + count * RECORD.itemsize
    if len(content) < start or len(content) != end:
        if head.startswith(b"solid"):
            return None
        if len(content) < end or len(content) < start:
            raise MeshFileError(
                f"{file}: ends early, or is no STL file; {count} facets need {end} bytes, and the file"
                f" has {len(content)}"
            )
        if content[end:].strip(PADDING):
            raise MeshFileError(
                f"{file}: {len(content) - end} bytes follow the {count} facets of the header"
            )
    records = np.frombuffer(content, RECORD, count, start)
    return as_float64(records["corners"]).reshape(-1, 3)


def _text_corners(text: PlainText) -> FloatArray:
    """Return the corners (3F, 3) of an ASCII file."""
    corners = [np.zeros((0, 3))]
    facet_lines = 0  # lines of facets that precede the piece
    last = None
    for lines in text.pieces():
        filled = np.flatnonzero(lines.word_counts)
        if not filled.size:
            continue
        kinds = _keyword_numbers(lines, filled)
        inside = (kinds != SOLID) & (kinds != END_SOLID)
        place = (facet_lines + np.cumsum(inside) - inside) % len(FACET)
        wrong = np.flatnonzero(np.where(inside, kinds != FACET_NUMBERS[place], place > 0))
        if wrong.size:
            offset = lines.offset + int(lines.words[lines.first[filled[wrong[0]]]])
            due = FACET[place[wrong[0]]].decode()
            raise MeshFileError(
                text.at_line(offset, f"begins with {text.word(offset)} instead of {due!r}")
            )
        facet_lines += int(np.count_nonzero(inside))
        last = kinds[-1]
        corners.append(_vertices(text, lines, filled[kinds == KEYWORDS.index(b"vertex")]))
    if last != END_SOLID:
        raise MeshFileError(f"{text.file}: ends early; its last line is not 'endsolid'")
    return np.concatenate(corners)


def _keyword_numbers(lines: Lines, filled: IntArray) -> IntArray:
    """Return the index into `KEYWORDS` of the first words of lines (indices); −1 for other words."""
    starts = lines.words[lines.first[filled]]
    lengths = lines.word_ends[lines.first[filled]] - starts
    kinds = np.full(filled.size, -1)
    for number, keyword in enumerate(KEYWORDS):
        candidates = np.flatnonzero(lengths == len(keyword))
        for place, letter in enumerate(keyword):
            letters = lines.characters[starts[candidates] + place] | 0x20  # lower case
            candidates = candidates[letters == letter]
        kinds[candidates] = number
    return kinds


def _vertices(text: PlainText, lines: Lines, chosen: IntArray) -> FloatArray:
    """Return the numbers (n, 3) of the chosen lines (indices), which begin with ``vertex``."""
    counts = lines.word_counts[chosen] - 1
    wrong = np.flatnonzero(counts != 3)
    if wrong.size:
        offset = lines.offset + int(lines.words[lines.first[chosen[wrong[0]]]])
        raise MeshFileError(text.at_line(offset, f"has {counts[wrong[0]]} numbers; a vertex has 3"))
    which = lines.words_after_first(chosen)
    values = floats(lines.characters, lines.words[which], lines.word_ends[which])
    if values is None:
        raise MeshFileError(text.no_number(lines, which))
    return values.reshape(-1, 3)
