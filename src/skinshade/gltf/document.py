"""glTF 2.0 documents: the JSON, its binary chunk, and the files beside it.

The document stays plain JSON, so that parts that skinshade does not know survive a bake.
"""

from __future__ import annotations

import base64
import binascii
import os
import struct
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from .._core.errors import ArgumentError, MeshFileError
from .._core.files import existing_file
from .._core.json import parse_json
from .._core.limits import check_file_size, check_limit, limit_advice, limits

__all__ = [
    "BINARY_CHUNK",
    "COMPRESSED",
    "GLTF_SUFFIXES",
    "JSON_CHUNK",
    "MAGIC",
    "VERSION",
    "GltfDocument",
    "read_gltf",
]

GLTF_SUFFIXES = (".glb", ".gltf")
MAGIC, VERSION = b"glTF", 2
JSON_CHUNK, BINARY_CHUNK = 0x4E4F534A, 0x004E4942
COMPRESSED = {
    "EXT_meshopt_compression": "meshopt",
    "KHR_meshopt_compression": "meshopt",
}
"""Extensions whose compressed geometry cannot be decoded, with the name of the compression."""
LIMITED = ("nodes", "meshes")
"""Arrays whose length has a limit of the same name."""


@dataclass
class GltfDocument:
    """A document as it was read.

    Attributes
    ----------
    path
        File that it was read from.
    json
        JSON of the document.
    binary
        Binary chunk of a GLB, or None.
    chunks
        Other chunks of a GLB: type and content.
    """

    path: Path
    json: dict[str, Any]
    binary: bytes | None = None
    chunks: list[tuple[int, bytes]] = field(default_factory=list)
    _buffers: dict[int, bytes] = field(default_factory=dict)
    _files: dict[Path, bytes] = field(default_factory=dict)
    _arrays: dict[str, list[Any]] = field(default_factory=dict)
    _produced: int = 0

    def items(self, key: str) -> list[Any]:
        """Return a top-level array; empty if it is missing.

        Raises
        ------
        MeshFileError
            If it is not an array of objects, or has more entries than its limit.
        """
        if key not in self._arrays:
            value = self.json.get(key, [])
            if not isinstance(value, list) or not all(isinstance(item, dict) for item in value):
                raise MeshFileError(f"{self.path}: {key} is not an array of objects")
            if key in LIMITED:
                check_limit(key, len(value), str(self.path), MeshFileError)
            if key == "meshes":
                parts = (mesh.get("primitives") for mesh in value)
                count = sum(len(part) for part in parts if isinstance(part, list))
                check_limit("primitives", count, str(self.path), MeshFileError)
            self._arrays[key] = value
        return self._arrays[key]

    def item(self, key: str, index: Any, where: str) -> dict[str, Any]:
        """Return one entry of a top-level array.

        Parameters
        ----------
        key, index
            Name of the array, and index of the entry.
        where
            Place of the reference in the document, for the error message.

        Raises
        ------
        MeshFileError
            If there is no such entry.
        """
        array = self.items(key)
        if not isinstance(index, int) or isinstance(index, bool) or not 0 <= index < len(array):
            raise MeshFileError(
                f"{self.path}: {where} refers to {key} {index!r}; there are {len(array)}"
            )
        entry: dict[str, Any] = array[index]
        return entry

    def buffer(self, index: Any, where: str) -> bytes:
        """Return the bytes of a buffer: the binary chunk, a data URI, or a file beside the document.

        Raises
        ------
        MeshFileError
            If the buffer is missing, shorter than stated, or outside the asset's folder.
        """
        entry = self.item("buffers", index, where)
        if index not in self._buffers:
            self._buffers[index] = self._load_buffer(index, entry)
        return self._buffers[index]

    def count_numbers(self, count: int, where: str) -> None:
        """Count numbers that are about to be decoded.

        Raises
        ------
        MeshFileError
            If the accessors decode to more numbers than the limits allow for the bytes of the buffers:
            some read the same bytes repeatedly.
        """
        self._produced += 8 * count
        available, most = self._buffer_bytes(), limits()
        free = self._produced - most.accessor_bytes_per_byte * available
        if free > most.accessor_free_bytes:
            raise MeshFileError(
                f"{where} needs {count} more numbers; that is too many for {available} bytes of buffers:"
                f" {limit_advice('accessor_free_bytes', free)}"
            )

    def external_files(self) -> dict[Path, Path]:
        """Return the files that the document refers to, by their names relative to its folder.

        Raises
        ------
        MeshFileError
            If one of them is outside the folder.
        """
        uris = [entry.get("uri") for key in ("buffers", "images") for entry in self.items(key)]
        return {
            self._name_of(uri): self._file_of(uri)
            for uri in uris
            if isinstance(uri, str) and not uri.startswith("data:") and "://" not in uri
        }

    def _load_buffer(self, index: int, entry: dict[str, Any]) -> bytes:
        uri = entry.get("uri")
        if uri is None:
            data = self.binary if index == 0 and self.binary is not None else None
            if data is None:
                raise MeshFileError(f"{self.path}: buffer {index} has neither a uri nor a chunk")
        elif not isinstance(uri, str):
            raise MeshFileError(f"{self.path}: buffer {index}: uri is {uri!r}; it must be text")
        else:
            data = self.resource(uri, f"buffer {index}")
        length = entry.get("byteLength")
        if not isinstance(length, int) or isinstance(length, bool) or not 1 <= length <= len(data):
            raise MeshFileError(
                f"{self.path}: buffer {index}: byteLength is {length!r}; there are {len(data)} bytes"
            )
        return data

    def resource(self, uri: str, name: str) -> bytes:
        """Return the bytes of a data URI, or of a file beside the document; `name` is for error messages.

        Raises
        ------
        MeshFileError
            If the data are malformed, or the file is missing or outside the asset's folder.
        """
        if uri.startswith("data:"):
            return self._data_uri(uri, name)
        try:
            file = existing_file(self._file_of(uri), MeshFileError)
            if file not in self._files:
                size = self._buffer_bytes() + file.stat().st_size
                check_limit("file_bytes", size, "all buffers", MeshFileError)
                self._files[file] = file.read_bytes()
            return self._files[file]
        except MeshFileError as error:
            text = str(error).removeprefix(f"{self.path}: ")
            raise MeshFileError(f"{self.path}: {name}: {text}") from None

    def _buffer_bytes(self) -> int:
        """Return the bytes of all buffers that have been read; buffers of one file count once."""
        return sum({id(data): len(data) for data in self._buffers.values()}.values())

    def _data_uri(self, uri: str, name: str) -> bytes:
        head, comma, text = uri.partition(",")
        if not comma or not head.endswith(";base64"):
            raise MeshFileError(f"{self.path}: {name}: its data URI is not base64")
        try:
            return base64.b64decode(unquote(text) if "%" in text else text, validate=True)
        except (binascii.Error, ValueError) as error:
            raise MeshFileError(f"{self.path}: {name}: {error}") from None

    def _name_of(self, uri: str) -> Path:
        """Return the name of a relative URI, which must not lead out of the document's folder on the way."""
        name = Path(os.path.normpath(unquote(uri)))
        if name.is_absolute() or name.drive or ".." in name.parts:
            raise MeshFileError(f"{self.path}: {uri!r} leaves the asset's folder")
        return name

    def _file_of(self, uri: str) -> Path:
        """Return the file of a relative URI, which must be inside the document's folder."""
        folder = self.path.parent.resolve()
        if "://" in uri:
            raise MeshFileError(f"{self.path}: {uri!r} is not a file beside it; fetch it first")
        try:
            file = (folder / unquote(uri)).resolve()
            file.exists()
        except (OSError, ValueError, RuntimeError) as error:  # too long, a NUL, circular links
            raise MeshFileError(f"{self.path}: {uri[:80]!r} is not a file name ({error})") from None
        if not file.is_relative_to(folder):
            raise MeshFileError(f"{self.path}: {uri!r} leaves the asset's folder")
        return file


def read_gltf(path: Path) -> GltfDocument:
    """Read a GLB or glTF file, whatever its suffix; buffers are read when they are needed.

    Raises
    ------
    MeshFileError
        If the file is missing, truncated or not glTF 2, or needs a decoder that skinshade does not have.
    """
    file = existing_file(path, MeshFileError)
    check_file_size(file, MeshFileError)
    data = file.read_bytes()
    text, binary, chunks = _chunks(file, data) if data[:4] == MAGIC else (data, None, [])
    check_limit("json_bytes", len(text), f"{file}: its JSON", MeshFileError)
    try:
        document = parse_json(text.decode("utf-8-sig"))
    except (UnicodeDecodeError, ArgumentError) as error:
        raise MeshFileError(f"{file}: its JSON cannot be read: {error}") from None
    if not isinstance(document, dict):
        raise MeshFileError(f"{file}: its JSON is not an object")
    asset = document.get("asset")
    version = asset.get("version") if isinstance(asset, dict) else None
    if not isinstance(version, str) or not version.startswith("2."):
        raise MeshFileError(f"{file}: glTF version {version!r}; it must be 2")
    required = document.get("extensionsRequired", [])
    for name, compression in COMPRESSED.items():
        if isinstance(required, list) and name in required:
            raise MeshFileError(
                f"{file}: its geometry is compressed by {compression} ({name}), which cannot be"
                " decoded; export it uncompressed"
            )
    return GltfDocument(file, document, binary, chunks)


def _chunks(file: Path, data: bytes) -> tuple[bytes, bytes | None, list[tuple[int, bytes]]]:
    """Return the JSON chunk, the binary chunk, and the other chunks of a GLB."""
    if len(data) < 20:
        raise MeshFileError(f"{file}: ends within its header")
    _, version, length = struct.unpack_from("<4sII", data)
    if version != VERSION:
        raise MeshFileError(f"{file}: GLB version {version}; it must be 2")
    if length > len(data):
        raise MeshFileError(f"{file}: truncated: {len(data)} of {length} bytes")
    chunks = list(_split(file, data[:length]))
    if not chunks or chunks[0][0] != JSON_CHUNK:
        raise MeshFileError(f"{file}: does not begin with a JSON chunk")
    text, *others = chunks
    binary = next((content for kind, content in others if kind == BINARY_CHUNK), None)
    return text[1], binary, [chunk for chunk in others if chunk[0] != BINARY_CHUNK]


def _split(file: Path, data: bytes) -> Iterator[tuple[int, bytes]]:
    at = 12
    while at + 8 <= len(data):
        length, kind = struct.unpack_from("<II", data, at)
        if at + 8 + length > len(data):
            raise MeshFileError(f"{file}: a chunk of {length} bytes at {at} runs past the end")
        yield kind, data[at + 8 : at + 8 + length]
        at += 8 + length
