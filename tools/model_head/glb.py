"""Writing the head as a binary glTF 2.0 file with one primitive."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from skinshade._core.files import atomic_write
from skinshade.gltf.write import glb_bytes

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
    """Write a file, which is replaced when the new one is complete; return its size in bytes."""
    short = len(positions_m) <= 65535
    indices = faces.astype("<u2" if short else "<u4").ravel()
    low, high = positions_m.min(axis=0).tolist(), positions_m.max(axis=0).tolist()
    arrays = [
        (positions_m.astype("<f4"), _FLOAT, "VEC3", {"min": low, "max": high}),
        (normals.astype("<f4"), _FLOAT, "VEC3", {}),
        (uv.astype("<f4"), _FLOAT, "VEC2", {}),
        (regions.astype("u1"), _UNSIGNED_BYTE, "VEC4", {"normalized": True}),
        (indices, _UNSIGNED_SHORT if short else _UNSIGNED_INT, "SCALAR", {}),
    ]
    blob = b""
    views, accessors = [], []
    for number, (values, component, kind, more) in enumerate(arrays):
        raw = values.tobytes()
        target = _INDICES if kind == "SCALAR" else _VERTICES
        views.append(
            {"buffer": 0, "byteOffset": len(blob), "byteLength": len(raw), "target": target}
        )
        accessors.append(
            {"bufferView": number, "componentType": component, "count": len(values), "type": kind}
            | more
        )
        blob += raw + b"\0" * (-len(raw) % 4)
    attributes = {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2, "_REGION": 3}
    primitive = {"attributes": attributes, "indices": 4, "material": 0}
    document = {
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
    data = glb_bytes(document, blob)
    path.parent.mkdir(parents=True, exist_ok=True)
    with atomic_write(path) as temporary:
        temporary.write_bytes(data)
    return len(data)
