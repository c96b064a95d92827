"""Data of PLY files in text: a line for every row of an element."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import FloatArray, IntArray
from .._core.errors import MeshFileError
from .decimals import floats
from .ply_header import Column, Element, Header, Lists, Property
from .text import PlainText

__all__ = ["read_text_tables"]


def read_text_tables(text: PlainText, header: Header) -> Mapping[str, Mapping[str, Column]]:
    """Return the columns of every element by their names; blank lines are skipped.

    Raises
    ------
    MeshFileError
        If a row is malformed, or the number of rows is not that of the header.
    """
    values: list[FloatArray] = [np.zeros(0)]
    counts: list[IntArray] = [np.zeros(0, dtype=np.int64)]
    for lines in text.pieces(header.size):
        piece = floats(lines.characters, lines.words, lines.word_ends)
        if piece is None:
            raise MeshFileError(text.no_number(lines, np.ones(lines.words.size, dtype=bool)))
        values.append(piece)
        counts.append(lines.word_counts[lines.word_counts > 0])
    all_values, all_counts = np.concatenate(values), np.concatenate(counts)
    starts = np.cumsum(all_counts) - all_counts
    tables: dict[str, dict[str, Column]] = {}
    row = 0
    for element in header.elements:
        if not element.properties:
            tables[element.name] = {}
            continue
        stop = row + element.rows
        if stop > all_counts.size:
            raise MeshFileError(
                f"{text.file}: ends early; element {element.name} has {all_counts.size - row} of"
                f" {element.rows} rows"
            )
        table = _TextTable(text, header, element, row, starts[row:stop], all_counts[row:stop])
        tables[element.name] = table.columns(all_values)
        row = stop
    if row < all_counts.size:
        raise MeshFileError(_at_row(text, header, row, "follows the last element"))
    return tables


@dataclass(frozen=True)
class _TextTable:
    """Rows of one element: `starts` (R,) and `counts` (R,) of their words."""

    text: PlainText
    header: Header
    element: Element
    row: int
    starts: IntArray
    counts: IntArray

    def columns(self, values: FloatArray) -> dict[str, Column]:
        """Return the columns, from all words of the file as numbers (W,)."""
        columns: dict[str, Column] = {}
        at, ends = self.starts.copy(), self.starts + self.counts
        for entry in self.element.properties:
            self._check(at < ends, "has too few numbers")
            numbers = values[np.minimum(at, values.size - 1)] if at.size else np.zeros(0)
            at += 1
            if entry.count_type is None:
                columns[entry.name] = numbers
                continue
            sizes = np.where(np.abs(numbers) <= values.size, numbers, -1).astype(np.int64)
            self._check((sizes == numbers) & (sizes >= 0), f"has a wrong length of {entry.name}")
            self._check(at + sizes <= ends, f"has too few numbers for the list {entry.name}")
            columns[entry.name] = self._lists(entry, at, sizes, values)
            at += sizes
        self._check(at == ends, "has too many numbers")
        return columns

    def _lists(self, entry: Property, at: IntArray, sizes: IntArray, values: FloatArray) -> Lists:
        """Return the lists that begin at words `at` (R,)."""
        row = np.repeat(np.arange(sizes.size), sizes)
        numbers = values[np.arange(row.size) + (at - np.cumsum(sizes) + sizes)[row]]
        if entry.type.startswith("f"):
            return Lists(sizes, numbers)
        whole = np.isfinite(numbers) & (np.abs(numbers) < 2.0**53)
        whole[whole] = numbers[whole] == np.floor(numbers[whole])
        if not whole.all():
            wrong = np.zeros(sizes.size, dtype=bool)
            wrong[row[~whole]] = True
            self._check(~wrong, f"has a number in the list {entry.name} that is not whole")
        return Lists(sizes, numbers.astype(np.int64))

    def _check(self, good: NDArray[np.bool_], message: str) -> None:
        """Raise for the first row that is not good (R,)."""
        if not good.all():
            row = int(np.argmin(good))
            message = f"(element {self.element.name}, row {row}) {message}"
            raise MeshFileError(_at_row(self.text, self.header, self.row + row, message))


def _at_row(text: PlainText, header: Header, row: int, message: str) -> str:
    """Return the error message for a row, counted through all elements."""
    for lines in text.pieces(header.size):
        filled = np.flatnonzero(lines.word_counts)
        if row < filled.size:
            return text.at_line(lines.offset + int(lines.words[lines.first[filled[row]]]), message)
        row -= filled.size
    return f"{text.file}: {message}"
