"""Binary data of PLY files."""

from __future__ import annotations

import struct
from array import array
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import IntArray
from .._core.errors import MeshFileError
from .ply_header import Column, Element, Header, Lists, Property

__all__ = ["read_binary_tables"]

PADDING = b"\0 \t\r\n\v\f"
"""Bytes that may follow the last element."""
LONGEST_ROW = 1 << 24
"""Bytes of the longest row that is read as a record of NumPy, whose size is limited."""
STRUCT_CODES = dict(zip(("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8"), "bBhHiIqQ", strict=True))


def read_binary_tables(
    file: Path, content: bytes, header: Header
) -> Mapping[str, Mapping[str, Column]]:
    """Return the columns of every element by their names.

    Raises
    ------
    MeshFileError
        If the data end early or go on after the last element, or a list has a negative length.
    """
    tables: dict[str, Mapping[str, Column]] = {}
    at = header.size
    for element in header.elements:
        if element.properties and element.rows:
            table = _Table(file, content, header.byte_order, element, at)
            tables[element.name], at = table.equal_rows() or table.any_rows()
        else:
            tables[element.name] = {entry.name: _empty(entry) for entry in element.properties}
    if content[at:].strip(PADDING):
        raise MeshFileError(
            f"{file}: {len(content) - at} bytes follow the last element; the header states fewer rows"
        )
    return tables


def _empty(entry: Property) -> Column:
    numbers = np.zeros(0, dtype=entry.type)
    return numbers if entry.count_type is None else Lists(np.zeros(0, dtype=np.int64), numbers)


@dataclass
class _ListOffsets:
    """Offsets of the lists of one property.

    Attributes
    ----------
    gap
        Bytes between the previous list of the row, or its start, and the length of the list.
    count_at
        Function that returns the length that begins at an offset.
    count_size, number_size
        Bytes of the length, and of a number of the list.
    starts, sizes
        Offsets of the first numbers, and lengths.
    """

    gap: int
    count_at: Callable[[int], int]
    count_size: int
    number_size: int
    starts: array[int] = field(default_factory=lambda: array("q"))
    sizes: array[int] = field(default_factory=lambda: array("q"))


@dataclass(frozen=True)
class _Table:
    """Rows of an element, whose data begin at an offset."""

    file: Path
    content: bytes
    byte_order: str
    element: Element
    start: int

    def equal_rows(self) -> tuple[Mapping[str, Column], int] | None:
        """Return the columns and the end of the data, or None if the lists of a property differ in length."""
        _, lists, _ = self._walk(1)
        lengths = iter([offsets.sizes[0] for offsets in lists])
        fields: list[tuple[str, str, int]] = []
        for number, entry in enumerate(self.element.properties):
            length = 1
            if entry.count_type is not None:
                fields.append((f"count {number}", self.byte_order + entry.count_type, 1))
                length = next(lengths)
            fields.append((f"{number}", self.byte_order + entry.type, length))
        row_size = sum(length * np.dtype(type_).itemsize for _, type_, length in fields)
        end = self.start + row_size * self.element.rows
        if row_size > LONGEST_ROW or end > len(self.content):
            return None
        # A length of 1 as a shape (1,) keeps all fields alike.
        record = np.dtype([(name, type_, (length,)) for name, type_, length in fields])
        records = np.frombuffer(self.content, record, self.element.rows, self.start)
        columns: dict[str, Column] = {}
        for number, entry in enumerate(self.element.properties):
            values = records[f"{number}"]
            if entry.count_type is None:
                columns[entry.name] = values[:, 0]
                continue
            length = values.shape[1]
            if not (records[f"count {number}"] == length).all():
                return None
            columns[entry.name] = Lists(np.full(self.element.rows, length), values.ravel())
        return columns, end

    def any_rows(self) -> tuple[Mapping[str, Column], int]:
        """Return the columns and the end of the data, for lists of any length."""
        row_starts, lists, end = self._walk(self.element.rows)
        columns: dict[str, Column] = {}
        after, remaining = np.array(row_starts), iter(lists)
        for entry in self.element.properties:
            type_ = np.dtype(self.byte_order + entry.type)
            if entry.count_type is None:
                columns[entry.name] = self._numbers(after, type_)
                after = after + type_.itemsize
                continue
            offsets = next(remaining)
            starts, sizes = np.array(offsets.starts), np.array(offsets.sizes)
            after = starts + sizes * type_.itemsize
            columns[entry.name] = Lists(sizes, self._between(starts, after).view(type_))
        return columns, end

    def _walk(self, rows: int) -> tuple[array[int], list[_ListOffsets], int]:
        """Return offsets of the first rows, of their lists, and of the end of the last of them."""
        lists: list[_ListOffsets] = []
        gap = 0
        for entry in self.element.properties:
            if entry.count_type is None:
                gap += np.dtype(entry.type).itemsize
            else:
                size, number_size = (np.dtype(t).itemsize for t in (entry.count_type, entry.type))
                lists.append(_ListOffsets(gap, self._reader(entry.count_type), size, number_size))
                gap = 0
        row_starts, at = array("q"), self.start
        for row in range(rows):
            row_starts.append(at)
            try:
                for entries in lists:
                    at += entries.gap
                    length = entries.count_at(at)
                    at += entries.count_size
                    entries.starts.append(at)
                    entries.sizes.append(length)
                    at += length * entries.number_size
                    if length < 0:
                        raise MeshFileError(self._at_row(row, f"has a list of {length} numbers"))
            except (IndexError, struct.error, OverflowError):
                at = len(self.content) + 1
            at += gap
            if at > len(self.content):
                raise MeshFileError(self._at_row(row, "goes on past the end of the file"))
        return row_starts, lists, at

    def _reader(self, count_type: str) -> Callable[[int], int]:
        if count_type == "u1":  # the usual one, and the fastest to read
            return self.content.__getitem__
        unpack = struct.Struct(self.byte_order + STRUCT_CODES[count_type]).unpack_from
        return lambda offset: int(unpack(self.content, offset)[0])

    def _numbers(self, offsets: IntArray, type_: np.dtype[np.number]) -> NDArray[np.number]:
        """Return the numbers (R,) that begin at offsets (R,)."""
        data = np.frombuffer(self.content, dtype=np.uint8)
        return data[offsets[:, None] + np.arange(type_.itemsize)].view(type_)[:, 0]

    def _between(self, starts: IntArray, ends: IntArray) -> NDArray[np.uint8]:
        """Return the bytes between offsets (R,) and (R,), both strictly increasing."""
        low, high = int(starts[0]), int(ends[-1])
        steps = np.zeros(high - low + 1, dtype=np.int8)
        steps[starts - low] += 1
        steps[ends - low] -= 1
        inside = np.cumsum(steps[:-1], dtype=np.int8).view(np.bool_)
        return np.frombuffer(self.content, dtype=np.uint8)[low:high][inside]

    def _at_row(self, row: int, message: str) -> str:
        return f"{self.file}: element {self.element.name}, row {row}, {message}"
