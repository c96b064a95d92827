"""What a file that was baked says of itself: its unit, and attributes that need not be computed again."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from .._core.arrays import FloatArray
from .curvature import SYMMETRIC_ROWS

__all__ = ["GLTF_NAMES", "baked_attributes", "baked_unit_mm"]

GLTF_NAMES = {
    "curvature": (("_CURVATURE", slice(0, 1)),),
    "tensor": (("_CURVATURE_TENSOR_0", slice(0, 3)), ("_CURVATURE_TENSOR_1", slice(3, 6))),
    "thickness": (("_THICKNESS", slice(0, 1)),),
}
"""What is baked, by the attributes of a primitive that hold it, and which of its numbers each holds."""


def baked_unit_mm(extras: Any, matrix: FloatArray) -> float | None:
    """Return the length of the file's unit, mm, by what baking noted for a mesh that stands so.

    Parameters
    ----------
    extras
        What the mesh carries under ``skinshade``, if anything.
    matrix
        (4, 4) from the mesh's axes to the scene's.
    """
    unit = extras.get("unit_mm") if isinstance(extras, dict) else None
    scale = float(np.cbrt(abs(np.linalg.det(matrix[:3, :3]))))
    if not isinstance(unit, (int, float)) or not np.isfinite(unit) or unit <= 0.0 or scale <= 0.0:
        return None
    return float(unit) / scale


def baked_attributes(
    attributes: Mapping[str, FloatArray], matrix: FloatArray
) -> dict[str, FloatArray]:
    """Return ``curvature`` (V,) 1/mm, ``tensor`` (V, 6) 1/mm in the scene's axes, ``thickness`` (V,) mm.

    Only what is there and finite.

    Parameters
    ----------
    attributes
        (V, n) by the file's names.
    matrix
        (4, 4) from the mesh's axes to the scene's.
    """
    found = {}
    for key, parts in GLTF_NAMES.items():
        columns = [
            _columns(attributes.get(name), numbers.stop - numbers.start) for name, numbers in parts
        ]
        there = [each for each in columns if each is not None]
        if len(there) == len(parts):
            values = np.concatenate(there, axis=1)
            found[key] = _turned(values, matrix) if key == "tensor" else values[:, 0]
    return found


def _columns(values: FloatArray | None, width: int) -> FloatArray | None:
    """An attribute as (V, width), if it is that and finite."""
    if values is None or values.ndim > 2 or values.size != width * len(values):
        return None
    return values.reshape(len(values), width) if np.isfinite(values).all() else None


def _turned(six: FloatArray, matrix: FloatArray) -> FloatArray:
    """Symmetric tensors (V, 6) in the axes that a matrix turns theirs into."""
    left, _, right = np.linalg.svd(matrix[:3, :3])
    turn = left @ right
    full = six[:, np.array(SYMMETRIC_ROWS)]
    turned = np.einsum("ia,vab,jb->vij", turn, full, turn)
    rows, columns = np.triu_indices(3)
    return turned[:, rows, columns]
