"""What a file that was baked says of itself: its unit, and attributes that need not be computed again."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from .._core.arrays import FloatArray

__all__ = ["BAKED_NAMES", "baked_attributes", "baked_unit_mm"]

BAKED_NAMES = ("curvature", "tensor", "thickness")
"""What `skinshade.mesh.vertex_attributes` takes of a mesh instead of computing it."""
SCALARS = {"_CURVATURE": "curvature", "_THICKNESS": "thickness"}
TENSOR = ("_CURVATURE_TENSOR_0", "_CURVATURE_TENSOR_1")
ROWS = ((0, 1, 2), (1, 3, 4), (2, 4, 5))
"""Where the entries of a symmetric matrix stand among xx xy xz yy yz zz."""


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
    for stored, name in SCALARS.items():
        values = attributes.get(stored)
        if values is not None and values.size == len(values) and np.isfinite(values).all():
            found[name] = values.reshape(-1)
    halves = [attributes.get(name) for name in TENSOR]
    if all(half is not None and half.ndim == 2 and half.shape[1] == 3 for half in halves):
        six = np.concatenate([half for half in halves if half is not None], axis=1)
        if np.isfinite(six).all():
            found["tensor"] = _turned(six, matrix)
    return found


def _turned(six: FloatArray, matrix: FloatArray) -> FloatArray:
    """Symmetric tensors (V, 6) in the axes that a matrix turns theirs into."""
    left, _, right = np.linalg.svd(matrix[:3, :3])
    turn = left @ right
    full = six[:, np.array(ROWS)]
    turned = np.einsum("ia,vab,jb->vij", turn, full, turn)
    rows, columns = np.triu_indices(3)
    return turned[:, rows, columns]
