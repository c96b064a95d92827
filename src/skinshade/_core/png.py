"""Compressed text of PNG files, checked before a library decompresses it."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path
from typing import BinaryIO

from .errors import FileError
from .limits import limit_advice, limits

__all__ = ["check_png_text"]

SIGNATURE = b"\x89PNG\r\n\x1a\n"
FIELDS_BEFORE = {b"zTXt": 1, b"iTXt": 3, b"iCCP": 1}
"""Fields that end with a zero byte before the compressed bytes of a chunk, by its type. The byte of the
method of compression is not one of them."""
MOST_CHUNKS = 2**19
"""Greatest number of chunks: 4 GiB in chunks of 8 KiB, as programs write them. Each takes time to read."""


def check_png_text(file: Path, error: type[FileError]) -> None:
    """Raise if the compressed text and colour profiles of a PNG file are too large; other files are accepted.

    A thousand bytes of a chunk can decompress to a million, and the library that reads PNG keeps a thousand
    chunks.

    Raises
    ------
    FileError
        Of the type `error`.
    """
    most = limits().image_text_bytes
    with file.open("rb") as stream:
        if stream.read(8) == SIGNATURE and _text_bytes(file, stream, most, error) > most:
            advice = limit_advice("image_text_bytes", 2 * most)
            raise error(f"{file}: its text takes more than {most} bytes; {advice}")


def _text_bytes(file: Path, stream: BinaryIO, most: int, error: type[FileError]) -> int:
    """Return the decompressed bytes of all chunks of text; more than `most` if there are more."""
    total = 0
    for _ in range(MOST_CHUNKS):
        head = stream.read(8)
        if len(head) < 8 or total > most:
            return total
        length, kind = struct.unpack(">I4s", head)
        if kind in FIELDS_BEFORE:
            total += _inflated(kind, stream.read(length), most + 1 - total)
            length = 0
        stream.seek(length + 4, 1)
    raise error(f"{file}: corrupt (it has more than {MOST_CHUNKS} chunks)")


def _inflated(kind: bytes, data: bytes, most: int) -> int:
    """Return the number of bytes that the compressed part of a chunk decompresses to, up to `most`."""
    if kind == b"iTXt":
        keyword, _, rest = data.partition(b"\0")
        if rest[:1] != b"\1":  # not compressed
            return 0
        data = keyword + b"\0" + rest[2:]
    fields = data.split(b"\0", FIELDS_BEFORE[kind])
    compressed = fields[-1][1:] if kind != b"iTXt" else fields[-1]
    total, inflater = 0, zlib.decompressobj()
    try:
        while compressed and total < most:
            total += len(inflater.decompress(compressed, min(most - total, 1 << 20)))
            compressed = inflater.unconsumed_tail
    except zlib.error:
        pass  # the library that reads the file reports it
    return total
