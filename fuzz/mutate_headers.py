"""Mutations of binary headers that keep lengths and checksums right, so that they reach the decoder."""

from __future__ import annotations

import io
import re
import struct
import warnings
import zipfile
import zlib
from collections.abc import Callable, Sequence
from random import Random

from .mutate_json import json_span, mutate_json_bytes, mutate_json_text
from .mutate_text import mutate_text

__all__ = [
    "mutate_exr",
    "mutate_glb",
    "mutate_jpeg",
    "mutate_npz",
    "mutate_ply",
    "mutate_png",
    "mutate_stl",
    "mutate_tiff",
]

COUNTS = (
    0,
    1,
    2,
    3,
    5,
    7,
    8,
    16,
    100,
    255,
    256,
    4096,
    65535,
    65536,
    1 << 24,
    (1 << 31) - 1,
    1 << 31,
    (1 << 32) - 1,
)
"""Counts and lengths of headers."""
Chunks = list[tuple[bytes, bytes]]
"""Type and content of every chunk of a file."""


def _patched(data: bytes, random: Random) -> bytes:
    """Return bytes with one other byte; at least one byte."""
    if not data:
        return b"\0"
    position = random.randrange(len(data))
    return data[:position] + bytes([random.randrange(256)]) + data[position + 1 :]


def _with_count(data: bytes, position: int, random: Random, form: str = "<I") -> bytes:
    """Return bytes with another integer at a position."""
    size = struct.calcsize(form)
    value = random.choice(COUNTS)
    if random.random() < 0.3 and position + size <= len(data):
        value = struct.unpack_from(form, data, position)[0] + random.choice((1, -1, 4, -4))
    return data[:position] + struct.pack(form, value % (1 << 8 * size)) + data[position + size :]


def _rearranged(
    chunks: Chunks, random: Random, change: Callable[[bytes, bytes], bytes], new: Chunks
) -> None:
    """Change, drop, repeat, move or add a chunk."""
    row = random.randrange(len(chunks))
    kind, content = chunks[row]
    choice = random.randrange(8)
    if choice <= 3:
        chunks[row] = kind, change(kind, content)
    elif choice == 4:
        del chunks[row]
    elif choice == 5:
        chunks[row:row] = [(kind, content)]
    elif choice == 6:
        chunks[row:row] = [random.choice(new)]
    else:
        chunks.insert(random.randrange(len(chunks)), chunks.pop(row))


# -- GLB -------------------------------------------------------------------------------------------


def mutate_glb(data: bytes, random: Random, seeds: Sequence[bytes]) -> bytes:
    """Return a GLB with a change of its JSON, its binary chunk, or the structure of its chunks."""
    chunks = _glb_chunks(data)
    if not chunks:
        return _patched(data, random)
    kind = random.random()
    if kind < 0.8:
        others = [
            content for seed in random.choices(seeds, k=1) for _, content in _glb_chunks(seed)[:1]
        ]
        text = mutate_json_bytes(chunks[0][1], random, others or [b"{}"])
        chunks[0] = chunks[0][0], text + b" " * (-len(text) % 4)
    elif kind < 0.92:
        row = random.randrange(len(chunks))
        content = chunks[row][1]
        position = random.randrange(len(content) + 1)
        value = random.choice((0.0, -1.0, 1e38, 1e-42, 1e15, float("nan"), float("inf"), 1e20))
        content = content[:position] + struct.pack("<f", value) + content[position + 4 :]
        chunks[row] = (
            chunks[row][0],
            random.choice((content, _patched(content, random), content[:position])),
        )
    else:
        new = [(b"JSON", b"{}  "), (b"BIN\0", b"\0" * 8), (b"ABCD", b"data")]
        _rearranged(chunks, random, lambda _, content: _patched(content, random), new)
    body = b"".join(struct.pack("<I", len(content)) + name + content for name, content in chunks)
    packed = struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body
    if random.random() < 0.03:
        packed = _with_count(packed, random.choice((4, 8, 12)), random)
    return packed


def _glb_chunks(data: bytes) -> Chunks:
    """Return type and content of the chunks of a GLB, as far as they are complete."""
    chunks, position = [], 12
    while position + 8 <= len(data):
        length = struct.unpack_from("<I", data, position)[0]
        content = data[position + 8 : position + 8 + length]
        chunks.append((data[position + 4 : position + 8], content))
        position += 8 + length
    return chunks


# -- PNG -------------------------------------------------------------------------------------------

PNG_MAGIC = b"\x89PNG\r\n\x1a\n"
NEW_CHUNKS = [
    (b"PLTE", b"\0" * 9), (b"tRNS", b"\0\0"), (b"gAMA", b"\0\0\0\0"),
    (b"iCCP", b"p\0\0" + zlib.compress(b"\0" * 200)), (b"tEXt", b"Description\0{}"),
    (b"zTXt", b"Comment\0\0" + zlib.compress(b"a" * 100_000)), (b"eXIf", b"MM\0*\0\0\0\x08"),
    (b"iTXt", b"Description\0\1\0\0\0" + zlib.compress(b"\xff\xd8")),
    (b"IDAT", zlib.compress(b"\0" * 1_000_000)), (b"bKGD", b"\0"), (b"hIST", b"\0\0"),
    (b"sBIT", b"\xff\xff\xff"), (b"cHRM", b"\xff" * 32), (b"acTL", b"\0" * 8), (b"IEND", b""),
    (b"zzzz", b"unknown"), (b"cICP", b"\1\1\0\1"),
]  # fmt: skip


def mutate_png(data: bytes, random: Random, seeds: Sequence[bytes]) -> bytes:
    """Return a PNG with a change of a chunk, of its header or of its pixels; the checksums are right."""
    chunks, position = [], 8
    while position + 12 <= len(data):
        length = struct.unpack_from(">I", data, position)[0]
        chunks.append(
            (data[position + 4 : position + 8], data[position + 8 : position + 8 + length])
        )
        position += 12 + length
    if not chunks:
        return _patched(data, random)

    def change(kind: bytes, content: bytes) -> bytes:
        if kind == b"IHDR" and len(content) == 13:
            if random.random() < 0.5:
                return _with_count(content, random.choice((0, 4)), random, ">I")
            position = random.randrange(8, 13)
            return (
                content[:position]
                + bytes([random.choice((0, 1, 2, 3, 4, 6, 8, 16, 255))])
                + content[position + 1 :]
            )
        if kind == b"IDAT" and random.random() < 0.7:
            try:
                rows = zlib.decompress(content)
            except zlib.error:
                rows = content
            rows = random.choice((_patched(rows, random), rows[: len(rows) // 2], rows * 2, b""))
            return zlib.compress(rows, random.choice((0, 1, 9)))
        return (
            _with_other_json(content, random) if json_span(content) else _patched(content, random)
        )

    _rearranged(chunks, random, change, NEW_CHUNKS)
    parts = [PNG_MAGIC]
    for kind, content in chunks:
        length = random.choice(COUNTS) if random.random() < 0.01 else len(content)
        parts.append(
            struct.pack(">I", length)
            + kind
            + content
            + struct.pack(">I", zlib.crc32(kind + content))
        )
    return b"".join(parts)


def _with_other_json(data: bytes, random: Random, *, same_length: bool = False) -> bytes:
    """Return bytes with a change of the JSON inside them; it can keep its length, as EXR needs."""
    span = json_span(data)
    if span is None:
        return _patched(data, random)
    text = data[slice(*span)].decode("latin-1")
    changed = mutate_json_text(text, random, [text]).encode("utf-8", "surrogateescape")
    if same_length:
        changed = changed.replace(b", ", b",").replace(b": ", b":").ljust(len(text))[: len(text)]
    return data[: span[0]] + changed + data[span[1] :]


# -- other images ----------------------------------------------------------------------------------


def mutate_jpeg(data: bytes, random: Random, seeds: Sequence[bytes]) -> bytes:
    """Return a JPEG with a change of a segment whose length is right."""
    chunks, position = [], 2
    while position + 4 <= len(data) and data[position] == 0xFF and data[position + 1] != 0xDA:
        length = struct.unpack_from(">H", data, position + 2)[0]
        chunks.append((data[position : position + 2], data[position + 4 : position + 2 + length]))
        position += 2 + max(length, 2)
    if not chunks:
        return _patched(data, random)

    def change(kind: bytes, content: bytes) -> bytes:
        if 0xC0 <= kind[1] <= 0xC2 and len(content) > 5:
            return _with_count(content, random.choice((1, 3)), random, ">H")
        return _patched(content, random)

    new = [
        (b"\xff\xe1", b"Exif\0\0MM\0*\0\0\0\x08\0\1"),
        (b"\xff\xdd", b"\0\1"),
        (b"\xff\xee", b"Adobe\0d\0\0\0\0\2"),
    ]
    _rearranged(chunks, random, change, new)
    segments = [
        kind + struct.pack(">H", (len(content) + 2) % 65536) + content for kind, content in chunks
    ]
    return b"\xff\xd8" + b"".join(segments) + data[position:]


EXR_INTEGERS = re.compile(
    rb"(?:dataWindow|displayWindow)\0box2i\0|tiles\0tiledesc\0|compression\0compression\0|channels\0chlist\0"
    rb"|lineOrder\0lineOrder\0|type\0string\0|chunkCount\0int\0"
)
"""Names of the attributes of EXR that decide how the rest is read."""


def mutate_exr(data: bytes, random: Random, seeds: Sequence[bytes]) -> bytes:
    """Return an EXR with a change of its version, an attribute, its JSON, or its offsets."""
    kind = random.random()
    if kind < 0.3 and json_span(data):
        return _with_other_json(data, random, same_length=True)
    matches = list(EXR_INTEGERS.finditer(data))
    if kind < 0.8 and matches:
        start = random.choice(matches).end()
        return _with_count(data, start + random.choice((0, 4, 8, 12, 16)), random)
    position = random.randrange(4, max(5, min(len(data), 1000)))
    return random.choice((_patched(data, random), _with_count(data, position, random)))


def mutate_tiff(data: bytes, random: Random, seeds: Sequence[bytes]) -> bytes:
    """Return a TIFF with a change of an entry of its directory."""
    if len(data) < 8 or data[:2] not in (b"II", b"MM"):
        return _patched(data, random)
    order = "<" if data[:2] == b"II" else ">"
    start = struct.unpack_from(f"{order}I", data, 4)[0]
    if start + 2 > len(data):
        return _with_count(data, 4, random, f"{order}I")
    count = struct.unpack_from(f"{order}H", data, start)[0]
    position = start + 2 + 12 * random.randrange(max(min(count, 64), 1))
    field, form = random.choice(((0, "H"), (2, "H"), (4, "I"), (8, "I"), (8, "H"), (-2, "H")))
    return _with_count(data, position + field, random, order + form)


# -- meshes ----------------------------------------------------------------------------------------


def mutate_stl(data: bytes, random: Random, seeds: Sequence[bytes]) -> bytes:
    """Return an STL with another count of facets or another number."""
    if random.random() < 0.4:
        return _with_count(data, 80, random)
    value = random.choice((float("nan"), float("inf"), 1e38, 1e-42, 0.0))
    position = 84 + 4 * random.randrange(max((len(data) - 84) // 4, 1))
    return data[:position] + struct.pack("<f", value) + data[position + 4 :]


def mutate_ply(data: bytes, random: Random, seeds: Sequence[bytes]) -> bytes:
    """Return a PLY with a change of its header alone, whose body stays as it is."""
    head, mark, body = data.partition(b"end_header")
    return mutate_text(head, random, seeds) + mark + body


# -- npz -------------------------------------------------------------------------------------------

HEADERS = (
    "'descr': '<f4'", "'descr': '>f8'", "'descr': '|O'", "'descr': '<U5'", "'descr': '|V4'",
    "'descr': '<M8[s]'", "'descr': [('a', '<f4')]", "'fortran_order': True", "'fortran_order': 1",
    "'shape': (4, 5, 3)", "'shape': ()", "'shape': (-1, 5, 3)", "'shape': (2**40, 5, 3)",
    "'shape': (1000000000, 1000000, 3)", "'shape': (0, 5, 3)", "'shape': (60,)", "'shape': 60",
    "'extra': 1", "'shape': (True, 5, 3)", "'descr': '<f2'", "'descr': '<c8'",
)  # fmt: skip
"""Entries of the header of an array, which take the position of another."""


def mutate_npz(data: bytes, random: Random, seeds: Sequence[bytes]) -> bytes:
    """Return an npz archive with a change of a member; its checksums are right."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            members = [(name.encode(), archive.read(name)) for name in archive.namelist()]
    except (zipfile.BadZipFile, zlib.error, OSError, RuntimeError, ValueError, NotImplementedError):
        members = []
    if not members:
        return _patched(data, random)

    def change(kind: bytes, content: bytes) -> bytes:
        if random.random() < 0.3:
            return _patched(content, random)
        if kind.startswith(b"description") and random.random() < 0.7:
            return _with_other_description(content, random)
        return _with_other_array_header(content, random)

    new = [
        (b"values.npy", b""),
        (b"x.npy", b"\x93NUMPY\1\0"),
        (b"../values.npy", b"x"),
        (b"values.npy", b"\0" * 1_000_000),
    ]
    _rearranged(members, random, change, new)
    stream = io.BytesIO()
    method = random.choice((zipfile.ZIP_DEFLATED, zipfile.ZIP_STORED))
    with warnings.catch_warnings(), zipfile.ZipFile(stream, "w", method) as archive:
        warnings.simplefilter("ignore")  # two members of one name are intended
        for name, content in members:
            archive.writestr(zipfile.ZipInfo(name.decode()), content)
    return stream.getvalue()


def _npy(header: str, body: bytes, version: int = 1) -> bytes:
    text = header.encode("latin-1", "replace").ljust(53) + b"\n"
    length = (
        struct.pack("<H", min(len(text), 0xFFFF)) if version == 1 else struct.pack("<I", len(text))
    )
    return b"\x93NUMPY" + bytes([version, 0]) + length + text + body


def _with_other_array_header(content: bytes, random: Random) -> bytes:
    length = int.from_bytes(content[8:10], "little")
    header, body = content[10 : 10 + length].decode("latin-1").strip(), content[10 + length :]
    entry = random.choice(HEADERS)
    name = entry.partition(":")[0]
    changed = re.sub(rf"{name}: (?:\([^)]*\)|[^,}}]*)", lambda _: entry, header)
    if random.random() < 0.1:
        changed = random.choice(
            ("{", "[" * 5000, "__import__('os')", header * 300, "{**{}}", "1" * 5000)
        )
    return _npy(
        changed,
        body[: random.choice((len(body), len(body), len(body) // 2))],
        random.choice((1, 1, 2, 3, 9)),
    )


def _with_other_description(content: bytes, random: Random) -> bytes:
    """Return the array of a text whose JSON has a change."""
    length = int.from_bytes(content[8:10], "little")
    text = content[10 + length :].decode("utf-32-le", "replace")
    changed = mutate_json_text(text, random, [text])
    header = f"{{'descr': '<U{len(changed)}', 'fortran_order': False, 'shape': (), }}"
    return _npy(header, changed.encode("utf-32-le", "surrogatepass"))
