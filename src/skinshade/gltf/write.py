"""Writing glTF: accessors appended to a document, and the bytes of a file."""

from __future__ import annotations

import json
import struct
from collections.abc import Iterable
from typing import Any

import numpy as np

from .._core.arrays import FloatArray, IntArray
from .document import BINARY_CHUNK, JSON_CHUNK, MAGIC, VERSION

__all__ = ["AccessorWriter", "glb_bytes", "json_bytes"]

TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}
FLOAT, UNSIGNED_INT = 5126, 5125
ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER = 34962, 34963


class AccessorWriter:
    """Appends accessors to a document and collects their bytes.

    Parameters
    ----------
    document
        JSON of the document, which is changed.

    Attributes
    ----------
    data
        Bytes of the added accessors. Their bufferViews have offsets from the start of these bytes; the
        writer of the file sets their buffer and adds its own offset.
    """

    def __init__(self, document: dict[str, Any]) -> None:
        self.data = bytearray()
        self._views: list[dict[str, Any]] = document.setdefault("bufferViews", [])
        self._accessors: list[dict[str, Any]] = document.setdefault("accessors", [])

    def add_vertices(self, values: FloatArray) -> int:
        """Add numbers (V, 1 to 4) as floats; return the index of the accessor."""
        return self._add(values.astype("<f4"), FLOAT, ARRAY_BUFFER)

    def add_corners(self, faces: IntArray) -> int:
        """Add triangles (F, 3) as indices; return the index of the accessor."""
        return self._add(faces.reshape(-1, 1).astype("<u4"), UNSIGNED_INT, ELEMENT_ARRAY_BUFFER)

    def _add(self, stored: np.ndarray[Any, Any], component: int, target: int) -> int:
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": stored.nbytes}
        accessor = {
            "bufferView": len(self._views),
            "componentType": component,
            "count": len(stored),
            "type": TYPES[stored.shape[1]],
        }
        if component == FLOAT:
            accessor["min"] = [float(value) for value in stored.min(axis=0)]
            accessor["max"] = [float(value) for value in stored.max(axis=0)]
        self._views.append({**view, "target": target})
        self._accessors.append(accessor)
        self.data += stored.tobytes()
        return len(self._accessors) - 1


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
    except UnicodeEncodeError:  # half a surrogate pair: JSON can escape it, UTF-8 cannot encode it
        return json.dumps(document, separators=compact, allow_nan=False).encode("ascii")
