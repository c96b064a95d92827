"""What a baked primitive carries: accessors of its attributes, and the note in ``extras``."""

from __future__ import annotations

from typing import Any

import numpy as np

from .._core.arrays import FloatArray, IntArray
from .._core.version import __version__
from ..mesh.baked import GLTF_NAMES
from .analysis import Analysed
from .settings import BakeSettings

__all__ = ["AccessorWriter", "baked_note"]

UNITS = {"curvature": "1/mm", "tensor": "1/mm", "thickness": "mm"}
TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3"}
FLOAT, UNSIGNED_INT = 5126, 5125
ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER = 34962, 34963


class AccessorWriter:
    """Appends accessors to a document, and gathers their bytes.

    Attributes
    ----------
    data
        Bytes so far. The views of them count from 0 in buffer 0, until whoever writes the file
        places them elsewhere.
    """

    def __init__(self, document: dict[str, Any]) -> None:
        self.data = bytearray()
        self._views: list[dict[str, Any]] = document.setdefault("bufferViews", [])
        self._accessors: list[dict[str, Any]] = document.setdefault("accessors", [])

    def vertices(self, values: FloatArray) -> int:
        """Add numbers (V, 1 to 3) as floats, and return the accessor's number."""
        return self._added(values.astype("<f4"), FLOAT, ARRAY_BUFFER)

    def corners(self, faces: IntArray) -> int:
        """Add triangles (F, 3) as indices, and return the accessor's number."""
        return self._added(faces.reshape(-1, 1).astype("<u4"), UNSIGNED_INT, ELEMENT_ARRAY_BUFFER)

    def _added(self, stored: np.ndarray[Any, Any], component: int, target: int) -> int:
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


def baked_note(analysed: Analysed, unit_mm: float, settings: BakeSettings) -> dict[str, Any]:
    """Return what ``extras.skinshade`` of a mesh says: by what, for which unit, and each attribute's."""
    return {
        "version": __version__,
        "unit_mm": unit_mm,
        "profile": settings.profile,
        "uv_scale_mm": analysed.uv_scale_mm,
        "attributes": {
            name: UNITS[key] for key in analysed.attributes for name, _ in GLTF_NAMES[key]
        },
    }
