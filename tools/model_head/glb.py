"""Writing the head as a binary glTF 2.0 file with one primitive."""

from __future__ import annotations

import json
import struct
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

_FLOAT, _UNSIGNED_BYTE, _UNSIGNED_SHORT, _UNSIGNED_INT = 5126, 5121, 5123, 5125
_VERTICES, _INDICES = 34962, 34963


def write_glb(
    path: Path,
    positions_m: NDArray[np.float32],
    normals: NDArray[np.float32],
    uv: NDArray[np.float32],
    regions: NDArray[np.uint8],
    faces: NDArray[np.int64],
) -> int:
    """Write ``path`` in one move and give its size in bytes."""
    short = len(positions_m) <= 65535
    index = faces.astype("<u2" if short else "<u4").ravel()
    low, high = positions_m.min(axis=0).tolist(), positions_m.max(axis=0).tolist()
    arrays = [
        (positions_m.astype("<f4"), _FLOAT, "VEC3", {"min": low, "max": high}),
        (normals.astype("<f4"), _FLOAT, "VEC3", {}),
        (uv.astype("<f4"), _FLOAT, "VEC2", {}),
        (regions.astype("u1"), _UNSIGNED_BYTE, "VEC4", {"normalized": True}),
        (index, _UNSIGNED_SHORT if short else _UNSIGNED_INT, "SCALAR", {}),
    ]
    blob = b""
    views, accessors = [], []
    for number, (data, component, kind, more) in enumerate(arrays):
        raw = data.tobytes()
        target = _INDICES if number == 4 else _VERTICES
        views.append(
            {"buffer": 0, "byteOffset": len(blob), "byteLength": len(raw), "target": target}
        )
        accessors.append(
            {"bufferView": number, "componentType": component, "count": len(data), "type": kind}
            | more
        )
        blob += raw + b"\0" * (-len(raw) % 4)
    attributes = {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2, "_REGION": 3}
    primitive = {"attributes": attributes, "indices": 4, "material": 0}
    tree = {
        "asset": {"version": "2.0", "generator": "skinshade tools/model_head"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "head"}],
        "meshes": [{"name": "head", "primitives": [primitive]}],
        "materials": [
            {
                "name": "skin",
                "pbrMetallicRoughness": {
                    "baseColorFactor": [0.48, 0.29, 0.21, 1.0],
                    "metallicFactor": 0.0,
                    "roughnessFactor": 0.5,
                },
            }
        ],
        "buffers": [{"byteLength": len(blob)}],
        "bufferViews": views,
        "accessors": accessors,
    }
    text = json.dumps(tree, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    total = 12 + 8 + len(text) + 8 + len(blob)
    out = struct.pack("<4sII", b"glTF", 2, total)
    out += struct.pack("<I4s", len(text), b"JSON") + text
    out += struct.pack("<I4s", len(blob), b"BIN\0") + blob
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_name(path.name + ".partial")
    partial.write_bytes(out)
    partial.replace(path)
    return total
