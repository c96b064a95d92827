"""Baked attributes in glTF files: names, units, and reading them back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from .._core.arrays import FloatArray
from ..gltf import scale_of
from .tensors import SYMMETRIC_ROWS

__all__ = ["GLTF_NAMES", "baked_attributes", "baked_unit_mm"]

GLTF_NAMES = {
    "curvature": (("_CURVATURE", slice(0, 1)),),
    "tensor": (("_CURVATURE_TENSOR_0", slice(0, 3)), ("_CURVATURE_TENSOR_1", slice(3, 6))),
    "thickness": (("_THICKNESS", slice(0, 1)),),
}
"""Attributes of a primitive that store each baked quantity, with the columns that each stores."""


def baked_unit_mm(extras: Any, matrix: FloatArray) -> float | None:
    """Return the length of the file's unit, mm, that a bake noted for a mesh, or None.

    Parameters
    ----------
    extras
        Entry ``skinshade`` of the mesh's extras, or None.
    matrix
        (4, 4) from the mesh's axes to the scene's.
    """
    unit = extras.get("unit_mm") if isinstance(extras, dict) else None
    scale, _ = scale_of(matrix)
    if not isinstance(unit, (int, float)) or not np.isfinite(unit) or unit <= 0.0 or scale <= 0.0:
        return None
    return float(unit) / scale


def baked_attributes(
    attributes: Mapping[str, FloatArray], matrix: FloatArray
) -> dict[str, FloatArray]:
    """Return ``curvature`` (V, 1) 1/mm, ``tensor`` (V, 6) 1/mm in the scene's axes, ``thickness`` (V, 1) mm.

    Quantities that are missing or not finite are left out.

    Parameters
    ----------
    attributes
        (V, n) by their names in the file.
    matrix
        (4, 4) from the mesh's axes to the scene's.
    """
    quantities = {}
    for key, parts in GLTF_NAMES.items():
        columns = [
            _columns(attributes.get(name), numbers.stop - numbers.start) for name, numbers in parts
        ]
        present = [column for column in columns if column is not None]
        if len(present) == len(parts):
            values = np.concatenate(present, axis=1)
            quantities[key] = _turned(values, matrix) if key == "tensor" else values
    return quantities


def _columns(values: FloatArray | None, width: int) -> FloatArray | None:
    """Return an attribute as (V, width), or None if it has another shape or is not finite."""
    if values is None or values.ndim > 2 or values.size != width * len(values):
        return None
    return values.reshape(len(values), width) if np.isfinite(values).all() else None


def _turned(six: FloatArray, matrix: FloatArray) -> FloatArray:
    """Return symmetric tensors (V, 6) turned by the rotation of a matrix."""
    left, _, right = np.linalg.svd(matrix[:3, :3])
    turn = left @ right
    full = six[:, np.array(SYMMETRIC_ROWS)]
    turned = np.einsum("ia,vab,jb->vij", turn, full, turn)
    rows, columns = np.triu_indices(3)
    return turned[:, rows, columns]
