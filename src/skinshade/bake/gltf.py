"""glTF 2.0 without loss: the document stays a document, so that what nobody here knows stays too."""

from __future__ import annotations

import base64
import binascii
import json
import math
import struct
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from .._core.errors import ArgumentError, MeshFileError
from .._core.files import existing_file

__all__ = ["GltfFile", "read_gltf"]

MAGIC, VERSION = b"glTF", 2
JSON_CHUNK, BINARY_CHUNK = 0x4E4F534A, 0x004E4942
REFUSED = {
    "EXT_meshopt_compression": "meshopt",
    "KHR_meshopt_compression": "meshopt",
}
"""Extensions whose geometry cannot be read here."""
DEEPEST = 128
"""Arrays and objects within each other; no exporter nests a tenth of that, and readers recurse."""
ASKED_AT_ALL, ASKED_FOR_EACH_BYTE = 1 << 24, 32
"""Bytes of numbers that accessors may ask for: a byte becomes eight as float64, and some are shared."""


@dataclass
class GltfFile:
    """A file as it came.

    Attributes
    ----------
    path
        Where it came from.
    document
        Its JSON; what is added goes here.
    binary
        The chunk that a GLB carries, or None.
    chunks
        What else a GLB carries: type and content.
    """

    path: Path
    document: dict[str, Any]
    binary: bytes | None = None
    chunks: list[tuple[int, bytes]] = field(default_factory=list)
    _buffers: dict[int, bytes] = field(default_factory=dict)
    _items: dict[str, list[Any]] = field(default_factory=dict)
    _asked: int = 0

    def items(self, key: str) -> list[Any]:
        """Return a top-level array; empty without it.

        Raises
        ------
        MeshFileError
            If it is no array of objects.
        """
        if key not in self._items:
            found = self.document.get(key, [])
            if not isinstance(found, list) or not all(isinstance(each, dict) for each in found):
                raise MeshFileError(f"{self.path}: {key} is not an array of objects")
            self._items[key] = found
        return self._items[key]

    def item(self, key: str, index: Any, where: str) -> dict[str, Any]:
        """Return one entry of a top-level array.

        Raises
        ------
        MeshFileError
            If the index points nowhere.
        """
        found = self.items(key)
        if not isinstance(index, int) or isinstance(index, bool) or not 0 <= index < len(found):
            raise MeshFileError(
                f"{self.path}: {where} refers to {key} {index!r}; there are {len(found)}"
            )
        result: dict[str, Any] = found[index]
        return result

    def buffer(self, index: Any, where: str) -> bytes:
        """Return a buffer's bytes: the chunk, a data URI, or a file beside the document.

        Raises
        ------
        MeshFileError
            If it is missing, shorter than it says, or would leave the asset's folder.
        """
        described = self.item("buffers", index, where)
        if index not in self._buffers:
            self._buffers[index] = self._loaded(index, described)
        return self._buffers[index]

    def ask(self, count: int, here: str) -> None:
        """Count numbers that are about to be made of the file's bytes.

        Raises
        ------
        MeshFileError
            If there are far more of them than its bytes can mean: a few bytes read over and over.
        """
        self._asked += 8 * count
        held = sum(map(len, self._buffers.values()))
        if self._asked > ASKED_AT_ALL + ASKED_FOR_EACH_BYTE * held:
            raise MeshFileError(
                f"{here} asks for {count} numbers too many: the file has {held} bytes"
            )

    def external_files(self) -> list[Path]:
        """Return the files that the document refers to, relative to its folder.

        Raises
        ------
        MeshFileError
            If one would leave the folder.
        """
        uris = [each.get("uri") for key in ("buffers", "images") for each in self.items(key)]
        return [
            self._beside(uri).relative_to(self.path.parent.resolve())
            for uri in uris
            if isinstance(uri, str) and not uri.startswith("data:") and "://" not in uri
        ]

    def _loaded(self, index: int, described: dict[str, Any]) -> bytes:
        uri = described.get("uri")
        if uri is None:
            data = self.binary if index == 0 and self.binary is not None else None
            if data is None:
                raise MeshFileError(f"{self.path}: buffer {index} has neither a uri nor a chunk")
        elif not isinstance(uri, str):
            raise MeshFileError(f"{self.path}: buffer {index}: uri is {uri!r}, not text")
        elif uri.startswith("data:"):
            data = self._from_data_uri(uri, index)
        else:
            data = existing_file(self._beside(uri), MeshFileError).read_bytes()
        length = described.get("byteLength")
        if not isinstance(length, int) or isinstance(length, bool) or not 1 <= length <= len(data):
            raise MeshFileError(
                f"{self.path}: buffer {index} says it has {length!r} bytes; it has {len(data)}"
            )
        return data

    def _from_data_uri(self, uri: str, index: int) -> bytes:
        head, comma, text = uri.partition(",")
        if not comma or not head.endswith(";base64"):
            raise MeshFileError(f"{self.path}: buffer {index}: its data URI is not base64")
        try:
            return base64.b64decode(unquote(text) if "%" in text else text, validate=True)
        except (binascii.Error, ValueError) as error:
            raise MeshFileError(f"{self.path}: buffer {index}: {error}") from None

    def _beside(self, uri: str) -> Path:
        folder = self.path.parent.resolve()
        if "://" in uri:
            raise MeshFileError(f"{self.path}: {uri!r} is not a file beside it; fetch it first")
        try:
            place = (folder / unquote(uri)).resolve()
            place.exists()
        except (OSError, ValueError, RuntimeError) as error:  # too long, a NUL, links in a circle
            raise MeshFileError(f"{self.path}: {uri[:80]!r} is no file's name ({error})") from None
        if not place.is_relative_to(folder):
            raise MeshFileError(f"{self.path}: {uri!r} leaves the asset's folder")
        return place


def read_gltf(path: Path) -> GltfFile:
    """Read ``.glb`` or ``.gltf``; buffers are read when they are asked for.

    Raises
    ------
    MeshFileError
        If the file is missing, truncated or no glTF 2.0, or holds geometry that is compressed.
    """
    file = existing_file(path, MeshFileError)
    data = file.read_bytes()
    text, binary, chunks = _chunks(file, data) if data[:4] == MAGIC else (data, None, [])
    try:
        document = json.loads(
            text.decode("utf-8-sig"),
            parse_constant=_refuse_constant,
            parse_float=_finite,
            object_pairs_hook=_object,
        )
        _refuse_depth(document)
    except (ValueError, RecursionError) as error:
        raise MeshFileError(f"{file}: its JSON cannot be read ({error})") from None
    if not isinstance(document, dict):
        raise MeshFileError(f"{file}: its JSON is no object")
    asset = document.get("asset")
    version = asset.get("version") if isinstance(asset, dict) else None
    if not isinstance(version, str) or not version.startswith("2."):
        raise MeshFileError(f"{file}: is glTF {version!r}; glTF 2 is read")
    found = GltfFile(file, document, binary, chunks)
    used = document.get("extensionsRequired", [])
    for name, called in REFUSED.items():
        if isinstance(used, list) and name in used:
            raise MeshFileError(
                f"{file}: its geometry is compressed by {called} ({name}), which is not decoded here;"
                " export it uncompressed"
            )
    return found


def _refuse_constant(name: str) -> float:
    raise ArgumentError(f"{name} is no JSON number")


def _finite(text: str) -> float:
    value = float(text)
    if not math.isfinite(value):
        raise ArgumentError(f"{text[:40]} is larger than any number that can be kept")
    return value


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) < len(pairs):
        twice, _ = Counter(key for key, _ in pairs).most_common(1)[0]
        raise ArgumentError(f"an object has the key {twice[:40]!r} twice")
    return found


def _refuse_depth(document: Any) -> None:
    level = [document] if isinstance(document, (dict, list)) else []
    for _ in range(DEEPEST):
        inner = [each.values() if isinstance(each, dict) else each for each in level]
        level = [part for each in inner for part in each if isinstance(part, (dict, list))]
        if not level:
            return
    raise ArgumentError(f"it nests deeper than {DEEPEST} levels")


def _chunks(file: Path, data: bytes) -> tuple[bytes, bytes | None, list[tuple[int, bytes]]]:
    if len(data) < 20:
        raise MeshFileError(f"{file}: ends within its header")
    _, version, length = struct.unpack_from("<4sII", data)
    if version != VERSION:
        raise MeshFileError(f"{file}: is a GLB of version {version}; 2 is read")
    if length > len(data):
        raise MeshFileError(f"{file}: is truncated: {len(data)} of {length} bytes")
    found = list(_split(file, data[:length]))
    if not found or found[0][0] != JSON_CHUNK:
        raise MeshFileError(f"{file}: does not begin with a JSON chunk")
    text, *others = found
    binary = next((content for kind, content in others if kind == BINARY_CHUNK), None)
    return text[1], binary, [each for each in others if each[0] != BINARY_CHUNK]


def _split(file: Path, data: bytes) -> Iterator[tuple[int, bytes]]:
    at = 12
    while at + 8 <= len(data):
        length, kind = struct.unpack_from("<II", data, at)
        if at + 8 + length > len(data):
            raise MeshFileError(f"{file}: a chunk of {length} bytes at {at} runs past the end")
        yield kind, data[at + 8 : at + 8 + length]
        at += 8 + length


def glb_bytes(
    document: dict[str, Any], binary: bytes, chunks: Iterable[tuple[int, bytes]] = ()
) -> bytes:
    """Return a GLB of a document, its buffer, and chunks of other types."""
    text = json_bytes(document)
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    parts = [struct.pack("<II", len(text), JSON_CHUNK), text]
    if binary:
        parts += [struct.pack("<II", len(binary), BINARY_CHUNK), binary]
    for kind, content in chunks:
        parts += [struct.pack("<II", len(content), kind), content]
    body = b"".join(parts)
    return struct.pack("<4sII", MAGIC, VERSION, 12 + len(body)) + body


def json_bytes(document: dict[str, Any]) -> bytes:
    """Return a document as compact JSON."""
    compact = (",", ":")
    try:
        text = json.dumps(document, ensure_ascii=False, separators=compact, allow_nan=False)
        return text.encode("utf-8")
    except UnicodeEncodeError:  # half a surrogate pair, which JSON can escape and UTF-8 cannot hold
        return json.dumps(document, separators=compact, allow_nan=False).encode("ascii")
