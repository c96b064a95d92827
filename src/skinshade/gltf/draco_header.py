"""Counts in the header of a Draco mesh, read before it is decoded.

The layout is that of the Draco bitstream specification, version 2.2: header, metadata, connectivity.
"""

from __future__ import annotations

import struct

from .._core.errors import ArgumentError

__all__ = ["draco_counts"]

HAS_METADATA = 0x8000
"""Flag of a header that metadata follow."""
MESH, SEQUENTIAL, EDGEBREAKER = 1, 0, 1
"""Type of the geometry, and methods of encoding its connectivity."""
MOST_ENTRIES = 10_000
"""Greatest number of entries and pieces of metadata; exporters write a few."""


class _Reader:
    """Reader of bytes and of whole numbers of variable length; it raises IndexError at the end."""

    def __init__(self, data: bytes, offset: int) -> None:
        self.data, self.offset, self.entries = data, offset, 0

    def byte(self) -> int:
        """Return the next byte."""
        self.offset += 1
        return self.data[self.offset - 1]

    def number(self) -> int:
        """Return the next whole number, which has 7 bits in each byte, the lowest first."""
        result = 0
        for shift in range(0, 70, 7):
            byte = self.byte()
            result |= (byte & 127) << shift
            if byte < 128:
                break
        return result

    def skip(self, count: int) -> None:
        """Pass over `count` bytes."""
        self.offset += count

    def count_entry(self) -> None:
        """Count an entry or a piece of metadata."""
        self.entries += 1
        if self.entries > MOST_ENTRIES:
            raise ArgumentError("too many entries")


def draco_counts(data: bytes) -> tuple[int, int] | None:
    """Return the numbers of triangles and vertices of a Draco mesh; None if its header is not of version 2.2.

    Raises
    ------
    IndexError, ArgumentError
        If the data end within the header, or there are more than `MOST_ENTRIES` pieces of metadata.
    """
    if len(data) < 11 or data[:5] != b"DRACO" or (data[5], data[6]) != (2, 2) or data[7] != MESH:
        return None
    method, (flags,) = data[8], struct.unpack_from("<H", data, 9)
    reader = _Reader(data, 11)
    if flags & HAS_METADATA:
        _skip_metadata(reader)
    if method == SEQUENTIAL:
        triangles = reader.number()
        return triangles, reader.number()
    if method == EDGEBREAKER:
        reader.byte()  # kind of traversal
        vertices = reader.number()
        return reader.number(), vertices
    return None


def _skip_metadata(reader: _Reader) -> None:
    """Pass over the metadata of attributes, then of the mesh."""
    for _ in range(min(reader.number(), MOST_ENTRIES)):
        reader.number()  # index of the attribute
        _skip_pieces(reader)
    _skip_pieces(reader)


def _skip_pieces(reader: _Reader) -> None:
    """Pass over a piece of metadata, and the named pieces inside it at any depth."""
    waiting = _skip_entries(reader)
    while waiting:
        reader.skip(reader.byte())  # name
        waiting += _skip_entries(reader) - 1


def _skip_entries(reader: _Reader) -> int:
    """Pass over the entries of a piece of metadata; return the number of pieces inside it."""
    for _ in range(reader.number()):
        reader.count_entry()
        reader.skip(reader.byte())  # name
        reader.skip(reader.number())
    reader.count_entry()
    return reader.number()
