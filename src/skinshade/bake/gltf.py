"""glTF 2.0 without loss: the document stays a document, so that what nobody here knows stays too."""

from __future__ import annotations

import base64
import binascii
import json
import struct
from collections.abc import Iterator
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
    "KHR_draco_mesh_compression": "Draco",
    "EXT_meshopt_compression": "meshopt",
    "KHR_meshopt_compression": "meshopt",
}
"""Extensions whose geometry cannot be read here."""


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
    """

    path: Path
    document: dict[str, Any]
    binary: bytes | None = None
    _buffers: dict[int, bytes] = field(default_factory=dict)

    @property
    def is_binary(self) -> bool:
        """Whether it is a GLB."""
        return self.path.suffix.lower() == ".glb"

    def items(self, key: str) -> list[Any]:
        """Return a top-level array; empty without it.

        Raises
        ------
        MeshFileError
            If it is no array of objects.
        """
        found = self.document.get(key, [])
        if not isinstance(found, list) or not all(isinstance(each, dict) for each in found):
            raise MeshFileError(f"{self.path}: {key} is not an array of objects")
        return found

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
        place = (folder / unquote(uri)).resolve()
        if "\0" in uri or not place.is_relative_to(folder):
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
    text, binary = _chunks(file, data) if data[:4] == MAGIC else (data, None)
    try:
        document = json.loads(text.decode("utf-8-sig"), parse_constant=_refuse_constant)
    except (ValueError, RecursionError) as error:
        raise MeshFileError(f"{file}: its JSON cannot be read ({error})") from None
    if not isinstance(document, dict):
        raise MeshFileError(f"{file}: its JSON is no object")
    asset = document.get("asset")
    version = asset.get("version") if isinstance(asset, dict) else None
    if not isinstance(version, str) or not version.startswith("2."):
        raise MeshFileError(f"{file}: is glTF {version!r}; glTF 2 is read")
    found = GltfFile(file, document, binary)
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


def _chunks(file: Path, data: bytes) -> tuple[bytes, bytes | None]:
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
    binary = next((content for kind, content in found[1:] if kind == BINARY_CHUNK), None)
    return found[0][1], binary


def _split(file: Path, data: bytes) -> Iterator[tuple[int, bytes]]:
    at = 12
    while at + 8 <= len(data):
        length, kind = struct.unpack_from("<II", data, at)
        if at + 8 + length > len(data):
            raise MeshFileError(f"{file}: a chunk of {length} bytes at {at} runs past the end")
        yield kind, data[at + 8 : at + 8 + length]
        at += 8 + length


def glb_bytes(document: dict[str, Any], binary: bytes) -> bytes:
    """Return a GLB of a document and its chunk."""
    text = json_bytes(document)
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    parts = [struct.pack("<II", len(text), JSON_CHUNK), text]
    if binary:
        parts += [struct.pack("<II", len(binary), BINARY_CHUNK), binary]
    body = b"".join(parts)
    return struct.pack("<4sII", MAGIC, VERSION, 12 + len(body)) + body


def json_bytes(document: dict[str, Any]) -> bytes:
    """Return a document as compact JSON."""
    return json.dumps(document, ensure_ascii=False, separators=(",", ":")).encode("utf-8")
