"""Structure of PNG files, checked before a library reads them.

The library prints the faults of a PNG on standard error, also those that it reports in other forms.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import takewhile
from pathlib import Path
from typing import Any

from .errors import ArgumentError, FileError
from .limits import limit_advice, limits

__all__ = ["PngPixels", "check_png"]

SIGNATURE = b"\x89PNG\r\n\x1a\n"
TEXT = {b"zTXt": 1, b"iTXt": 3, b"iCCP": 1}
"""Chunks of text and colour profiles, and their fields that end with a zero byte before compressed bytes.
The byte of the method of compression is not one of them."""
MOST_CHUNKS = 2**19
"""Greatest number of chunks: 4 GiB in chunks of 8 KiB, as programs write them. Each takes time to read."""
CRITICAL = (b"IHDR", b"PLTE", b"IDAT", b"IEND")
"""Chunks that a reader must understand, by the capital first letter of their types."""
PALETTE = 3
"""Type of colour of images with a palette."""
CHANNELS = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}
"""Stored channels of a pixel, by the type of colour."""
DEPTHS = {0: (1, 2, 4, 8, 16), 2: (8, 16), 3: (1, 2, 4, 8), 4: (8, 16), 6: (8, 16)}
"""Bits of a channel, by the type of colour."""
PASSES = (
    (0, 0, 8, 8),
    (4, 0, 8, 8),
    (0, 4, 4, 8),
    (2, 0, 4, 4),
    (0, 2, 2, 4),
    (1, 0, 2, 2),
    (0, 1, 1, 2),
)
"""First column and row, and steps between columns and rows, of the passes of an interlaced image."""
FILTERS = 5
BEYOND = 1 << 62
"""Offset after the last row of any image."""
STEP = 1 << 20
"""Bytes that are read or decompressed at once."""


@dataclass(frozen=True)
class PngPixels:
    """Compressed pixels of a PNG file.

    Attributes
    ----------
    width, height
        Size that the header states, pixels.
    rows
        Number of rows and bytes of a row of each pass; one pass unless the image is interlaced.
    parts
        Offsets and lengths of the compressed bytes in the file, bytes.
    """

    file: Path
    width: int
    height: int
    rows: tuple[tuple[int, int], ...]
    parts: tuple[tuple[int, int], ...]

    def check(self, error: type[FileError]) -> None:
        """Decompress the pixels in steps of 1 MiB, and raise if they are corrupt or end early.

        Raises
        ------
        FileError
            Of the type `error`.
        """
        try:
            self._check_rows()
        except zlib.error as reason:
            # zlib says "Error -3 while decompressing data: incorrect data check".
            raise error(f"{self.file}: corrupt ({str(reason).rpartition(': ')[2]})") from None
        except ArgumentError as reason:
            raise error(f"{self.file}: corrupt ({reason})") from None

    def _check_rows(self) -> None:
        wanted = sum(count * (1 + size) for count, size in self.rows)
        starts = self._row_starts()
        start, done = next(starts, BEYOND), 0
        inflater = zlib.decompressobj()
        for block in self._decompressed(inflater):
            while start < done + len(block):
                if block[start - done] >= FILTERS:
                    raise ArgumentError(f"a row has the unknown filter {block[start - done]}")
                start = next(starts, BEYOND)
            done += len(block)
            if done > wanted + STEP:
                raise ArgumentError("its pixels go on after the last row")
        if done < wanted:
            raise ArgumentError(f"cut short; {wanted - done} bytes of its pixels are missing")
        if not inflater.eof:
            raise ArgumentError("cut short; the end of its compressed pixels is missing")

    def _row_starts(self) -> Iterator[int]:
        """Yield the offset of the filter of every row in the decompressed bytes."""
        offset = 0
        for count, size in self.rows:
            for _ in range(count):
                yield offset
                offset += 1 + size

    def _decompressed(self, inflater: Any) -> Iterator[bytes]:
        with self.file.open("rb") as stream:
            for offset, length in self.parts:
                stream.seek(offset)
                for start in range(0, length, STEP):
                    data = stream.read(min(STEP, length - start))
                    yield from _inflated_blocks(inflater, data)


def check_png(file: Path, error: type[FileError]) -> PngPixels | None:
    """Return the place of the pixels of a PNG file, or None for other files.

    All chunks have to be complete and have their checksums. Compressed text and colour profiles are limited,
    because a thousand bytes of a chunk can decompress to a million, and the library that reads PNG keeps a
    thousand chunks.

    Raises
    ------
    FileError
        Of the type `error`, if the file is corrupt or its text is too large.
    """
    with file.open("rb") as stream:
        if stream.read(len(SIGNATURE)) != SIGNATURE:
            return None
    most, text = limits().image_text_bytes, 0
    chunks: list[_Chunk] = []
    try:
        for chunk in _chunks(file, most):
            if chunk.kind in TEXT:
                text += _inflated(chunk, most + 1 - text)
                chunk = replace(chunk, data=b"")
            chunks.append(chunk)
            if text > most:
                advice = limit_advice("image_text_bytes", 2 * most)
                raise error(f"{file}: its text takes more than {most} bytes; {advice}")
        return _pixels(file, chunks)
    except ArgumentError as reason:
        raise error(f"{file}: corrupt ({reason})") from None


@dataclass(frozen=True)
class _Chunk:
    """Type, offset and length of a chunk, and the content of a header or of text."""

    kind: bytes
    offset: int
    length: int
    data: bytes


def _pixels(file: Path, chunks: list[_Chunk]) -> PngPixels:
    """Return the pixels from all chunks."""
    kinds = [chunk.kind for chunk in chunks]
    if kinds.count(b"IHDR") != 1 or kinds[0] != b"IHDR":
        raise ArgumentError("its first chunk, and no other one, must be IHDR")
    if kinds.count(b"PLTE") > 1:
        raise ArgumentError("it has several palettes")
    if b"IDAT" not in kinds:
        raise ArgumentError("cut short; it ends before its pixels")
    for kind in kinds:
        if (kind[:1].isupper() and kind not in CRITICAL) or not (
            kind.isalpha() and kind[2:3].isupper()
        ):
            raise ArgumentError(f"it has the unknown chunk {_name(kind)}")
    width, height, colour, rows = _header(chunks[0].data)
    first = kinds.index(b"IDAT")
    if colour == PALETTE:
        colours = next((chunk.length for chunk in chunks[:first] if chunk.kind == b"PLTE"), 0)
        if colours % 3 or not 3 <= colours <= 3 << 8:
            raise ArgumentError(f"its palette has {colours} bytes")
    parts = takewhile(lambda chunk: chunk.kind == b"IDAT", chunks[first:])
    places = tuple((chunk.offset, chunk.length) for chunk in parts)
    return PngPixels(file, width, height, rows, places)


def _chunks(file: Path, most: int) -> Iterator[_Chunk]:
    """Yield all chunks up to IEND. The content of a chunk of text has at most `most` bytes and 1 MiB."""
    size = file.stat().st_size
    with file.open("rb") as stream:
        stream.seek(len(SIGNATURE))
        for _ in range(MOST_CHUNKS):
            head = stream.read(8)
            if not head:
                return
            length, kind = struct.unpack(">I4s", head.ljust(8, b"\0"))
            offset = stream.tell()
            if len(head) < 8 or offset + length + 4 > size:
                raise ArgumentError(f"cut short in the chunk {_name(kind)}")
            data, checksum = bytearray(), zlib.crc32(kind)
            for start in range(0, length, STEP):
                block = stream.read(min(STEP, length - start))
                checksum = zlib.crc32(block, checksum)
                if kind == b"IHDR" or (kind in TEXT and len(data) <= most):
                    data += block
            if stream.read(4) != struct.pack(">I", checksum):
                raise ArgumentError(f"wrong checksum of the chunk {_name(kind)}")
            yield _Chunk(kind, offset, length, bytes(data))
            if kind == b"IEND":
                return
    raise ArgumentError(f"it has more than {MOST_CHUNKS} chunks")


def _name(kind: bytes) -> str:
    return kind.decode("ascii") if kind.isalpha() else kind.hex()


def _header(header: bytes) -> tuple[int, int, int, tuple[tuple[int, int], ...]]:
    """Return width, height, type of colour, and rows as in `PngPixels`, from the content of IHDR."""
    if len(header) != 13:
        raise ArgumentError(f"its header has {len(header)} bytes instead of 13")
    width, height, depth, colour, *methods, interlaced = struct.unpack(">IIBBBBB", header)
    if min(width, height) < 1 or max(width, height) >= 1 << 31:
        raise ArgumentError(f"its header states {width}×{height} pixels")
    if depth not in DEPTHS.get(colour, ()) or any(methods) or interlaced > 1:
        raise ArgumentError("its header states an unknown form of pixels")
    bits = depth * CHANNELS[colour]
    sizes = []
    for left, top, across, down in PASSES if interlaced else ((0, 0, 1, 1),):
        columns, count = -(-(width - left) // across), -(-(height - top) // down)
        if columns > 0 and count > 0:
            sizes.append((count, -(-columns * bits // 8)))
    return width, height, colour, tuple(sizes)


def _inflated(chunk: _Chunk, most: int) -> int:
    """Return the number of bytes that the compressed part of a chunk decompresses to, up to `most`."""
    kind, data = chunk.kind, chunk.data
    if chunk.length > most:
        return most
    if kind == b"iTXt":
        keyword, _, rest = data.partition(b"\0")
        if rest[:1] != b"\1":  # not compressed
            return 0
        data = keyword + b"\0" + rest[2:]
    fields = data.split(b"\0", TEXT[kind])
    compressed = fields[-1][1:] if kind != b"iTXt" else fields[-1]
    total = 0
    with suppress(zlib.error):  # readers ignore such text
        for block in _inflated_blocks(zlib.decompressobj(), compressed):
            total += len(block)
            if total >= most:
                return most
    return total


def _inflated_blocks(inflater: Any, data: bytes) -> Iterator[bytes]:
    """Yield what compressed bytes decompress to, in blocks of at most 1 MiB."""
    while data and not inflater.eof:
        yield inflater.decompress(data, STEP)
        data = inflater.unconsumed_tail
