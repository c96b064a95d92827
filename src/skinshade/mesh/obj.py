"""Wavefront OBJ: polygons with UVs and normals, vertices with colours."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import FloatArray, IntArray
from .._core.errors import MeshFileError
from ..gltf import TriangleSet
from .corners import fan_triangles, first_of_equal_rows, merged_corners
from .decimals import Flags, floats, separators, whole_numbers
from .text import Lines, PlainText, is_space

__all__ = ["read_obj"]

TABLES = ("vertex", "UV", "normal")
"""Tables of the file, in the order of a corner's indices."""
NUMBER_COUNTS = ((3, 4, 6, 7), (1, 2, 3), (3,))
"""Numbers of a line: x y z, then a weight, or a colour, or a colour and alpha; u v w; x y z."""
WIDTHS = (3, 2, 3)
"""Numbers that are used."""
COLOUR = slice(3, 6)
"""Columns of the colour of a vertex, if a line has as many."""
LEADING_COMMENTS = re.compile(rb"(?:[ \t]*(?:#[^\n]*)?(?:\n|\Z))*")

Indices = NDArray[np.signedinteger]
"""Indices of 32 bits, or 64 in files that need them."""


@dataclass(frozen=True)
class _Faces:
    """Faces of a piece of the text.

    Attributes
    ----------
    offset
        Offset of the piece in the text.
    words
        (C,) offsets of the corners in the piece.
    sizes
        (F,) number of corners of every face.
    indices
        (C,) for every table, from 0; −1 where the corner has none; None where no corner has one.
    """

    offset: int
    words: Indices
    sizes: Indices
    indices: tuple[Indices | None, ...]


@dataclass
class _Content:
    """Content of the pieces that were read."""

    text: PlainText
    counts: list[int] = field(default_factory=lambda: [0, 0, 0])
    tables: list[list[FloatArray]] = field(default_factory=lambda: [[], [], []])
    colours: list[FloatArray | None] = field(default_factory=list)
    faces: list[_Faces] = field(default_factory=list)


def read_obj(file: Path) -> tuple[TriangleSet, list[str]]:
    """Return the triangles of an OBJ file, and its comments before the first statement.

    Polygons become fans. Vertices with equal position, UV and normal are merged; vertices that no face
    uses are left out. Normals are 0 at corners that lack one; UVs are left out if a corner lacks one. The
    attribute ``color`` (V, 3) holds the colours if all vertices have a finite one. Groups, materials,
    lines, points and free-form geometry are ignored.

    Raises
    ------
    MeshFileError
        If a line is malformed, an index is 0 or out of range, or there are no faces.
    """
    text = PlainText.of(file, file.read_bytes())
    comments = LEADING_COMMENTS.match(text.data)
    leading = comments[0].decode("utf-8", "replace") if comments else ""
    content = _Content(text.with_lines_joined())
    for lines in content.text.pieces(comments=True):
        _read_piece(content, lines)
    if not content.faces:
        raise MeshFileError(f"{file}: holds no triangles")
    _check_indices(content)
    return _triangle_set(content), [line.strip().lstrip("#") for line in leading.splitlines()]


def _read_piece(content: _Content, lines: Lines) -> None:
    """Add the numbers and faces of a piece."""
    filled = np.flatnonzero(lines.word_counts)
    keywords = lines.words[lines.first[filled]]
    last = lines.characters.size - 1
    one, two, three = (lines.characters[np.minimum(keywords + i, last)] for i in range(3))
    one_letter, two_letters = is_space(two), is_space(three)
    kinds = [
        (one == ord("v")) & one_letter,
        (one == ord("v")) & (two == ord("t")) & two_letters,
        (one == ord("v")) & (two == ord("n")) & two_letters,
    ]
    is_face = (one == ord("f")) & (
        one_letter | ((two == ord("o")) & two_letters)
    )  # fo is an old name
    if is_face.any():
        before = [
            count + np.cumsum(kind)[is_face]
            for count, kind in zip(content.counts, kinds, strict=True)
        ]
        content.faces.append(_read_faces(content.text, lines, filled[is_face], before))
    for table, kind in enumerate(kinds):
        if kind.any():
            _read_numbers(content, table, lines, filled[kind])


def _read_numbers(content: _Content, table: int, lines: Lines, chosen: IntArray) -> None:
    """Add the numbers of the chosen lines (indices) to a table."""
    counts = lines.word_counts[chosen] - 1
    *others, most = NUMBER_COUNTS[table]
    wrong = np.flatnonzero(~np.isin(counts, NUMBER_COUNTS[table]))
    if wrong.size:
        allowed = f"{', '.join(map(str, others))} or {most}" if others else str(most)
        offset = lines.offset + int(lines.words[lines.first[chosen[wrong[0]]]])
        message = f"has {counts[wrong[0]]} numbers; a {TABLES[table]} has {allowed}"
        raise MeshFileError(content.text.at_line(offset, message))
    which = lines.words_after_first(chosen)
    values = floats(lines.characters, lines.words[which], lines.word_ends[which])
    if values is None:
        raise MeshFileError(content.text.no_number(lines, which))
    content.counts[table] += counts.size
    content.tables[table].append(_rows(values, counts, WIDTHS[table]))
    if table == 0:
        coloured = bool((counts >= COLOUR.stop).all())
        content.colours.append(_rows(values, counts, COLOUR.stop)[:, COLOUR] if coloured else None)


def _rows(values: FloatArray, counts: IntArray, width: int) -> FloatArray:
    """Return the first `width` numbers (n, width) of lines with `counts` numbers (n,); 0 if they lack one."""
    if (counts == counts[0]).all() and counts[0] >= width:
        return values.reshape(-1, counts[0])[:, :width]
    starts = np.cumsum(counts) - counts
    rows = np.zeros((counts.size, width))
    for column in range(width):
        has = counts > column
        rows[has, column] = values[starts[has] + column]
    return rows


def _read_faces(text: PlainText, lines: Lines, chosen: IntArray, before: list[IntArray]) -> _Faces:
    """Return the faces of the chosen lines (indices).

    Parameters
    ----------
    text, lines
        Text and lines of a piece.
    chosen
        (F,) indices of the lines.
    before
        (F,) for every table: number of its rows before each line.
    """
    sizes = lines.word_counts[chosen] - 1
    if not sizes.all():
        empty = int(lines.words[lines.first[chosen[np.flatnonzero(sizes == 0)[0]]]])
        raise MeshFileError(text.at_line(lines.offset + empty, "has a face without corners"))
    which = lines.words_after_first(chosen)
    words, ends = lines.words[which], lines.word_ends[which]

    def at_first(wrong: Flags, message: str) -> str:
        """Return the error message for the first corner that is wrong."""
        offset = lines.offset + int(words[np.flatnonzero(wrong)[0]])
        return text.at_line(offset, message.format(text.word(offset)))

    slashes, too_many = separators(lines.characters, words, ends, "/", 2)
    if too_many.any():
        raise MeshFileError(
            at_first(too_many, "has the corner {}; it must have at most three indices")
        )
    begins = [words, *(slash + 1 for slash in slashes)]
    indices: list[Indices | None] = []
    small: type[np.signedinteger] = np.int32 if len(text.data) < 1 << 31 else np.int64
    for table, (begin, stop) in enumerate(zip(begins, [*slashes, ends], strict=True)):
        if table and (stop <= begin).all():
            indices.append(None)
            continue
        sign = lines.characters.take(begin, mode="clip")
        negative = (sign == ord("-")) & (begin < stop)
        signed = negative | ((sign == ord("+")) & (begin < stop))
        values, missing, faulty = whole_numbers(lines.characters, begin + signed, stop)
        faulty |= missing & signed
        if faulty.any():
            raise MeshFileError(
                at_first(
                    faulty, "has the corner {}; it must be indices as in 1, 1/2, 1//3 or 1/2/3"
                )
            )
        if table == 0 and missing.any():
            raise MeshFileError(at_first(missing, "has the corner {}, which has no vertex index"))
        zero = (values == 0) & ~missing
        if zero.any():
            raise MeshFileError(at_first(zero, f"has {TABLES[table]} index 0; OBJ counts from 1"))
        if negative.any():
            values = np.where(negative, np.repeat(before[table], sizes) + 1 - values, values)
            past = negative & (values <= 0)
            if past.any():
                name = TABLES[table]
                raise MeshFileError(
                    at_first(past, f"has the corner {{}}, which counts back past the first {name}")
                )
        values = np.minimum(values, len(text.data) + 1)  # greater ones are out of range
        indices.append((values - 1).astype(small))
    return _Faces(lines.offset, words.astype(small), sizes.astype(small), tuple(indices))


def _check_indices(content: _Content) -> None:
    """Raise if an index is past the end of its table; faces can precede their vertices."""
    for faces in content.faces:
        for name, count, indices in zip(TABLES, content.counts, faces.indices, strict=True):
            if indices is None or int(indices.max()) < count:
                continue
            offset = faces.offset + int(faces.words[np.argmax(indices >= count)])
            word, plural = content.text.word(offset), {"vertex": "vertice"}.get(name, name) + "s"
            raise MeshFileError(
                content.text.at_line(offset, f"has the corner {word}; there are {count} {plural}")
            )


def _triangle_set(content: _Content) -> TriangleSet:
    positions, uvs, normals = (
        np.concatenate(rows) if rows else np.zeros((0, width))
        for rows, width in zip(content.tables, WIDTHS, strict=True)
    )
    position, uv, normal = (
        _joined([faces.indices[table] for faces in content.faces], content.faces)
        for table in range(3)
    )
    sizes = np.concatenate([faces.sizes for faces in content.faces]).astype(np.int64)
    with_uvs, with_normals = int(uv.min()) >= 0, int(normal.max()) >= 0
    columns = [position, *([uv] if with_uvs else []), *([normal] if with_normals else [])]
    kept, vertex = merged_corners(columns)
    tables = [positions[position[kept]]]
    if with_uvs:
        tables.append(uvs[uv[kept]])
    if with_normals:
        normals = np.concatenate([normals, np.zeros((1, 3))])  # row −1: corners without a normal
        tables.append(normals[normal[kept]])
    first = first_of_equal_rows(np.concatenate(tables, axis=1))
    unique = first == np.arange(first.size)
    vertex = (np.cumsum(unique) - 1)[first][vertex]
    tables = [table[unique] for table in tables]
    attributes: dict[str, FloatArray] = {}
    colours = [rows for rows in content.colours if rows is not None]
    if len(colours) == len(content.colours):
        colour = np.concatenate(colours)[position[kept][unique]]
        attributes |= {"color": colour} if np.isfinite(colour).all() else {}
    return TriangleSet(
        tables[0],
        vertex[fan_triangles(sizes)],
        tables[-1] if with_normals else None,
        tables[1] * (1.0, -1.0) + (0.0, 1.0) if with_uvs else None,
        attributes,
    )


def _joined(columns: list[Indices | None], faces: list[_Faces]) -> IntArray:
    """Return the indices (C,) of all pieces into one table; −1 where a piece has none."""
    return np.concatenate(
        [
            np.full(part.words.size, -1) if column is None else column
            for column, part in zip(columns, faces, strict=True)
        ]
    ).astype(np.int64)
