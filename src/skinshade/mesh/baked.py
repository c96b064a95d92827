"""Baked attributes in files: names, units, and reading them back."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from .._core.arrays import FloatArray
from .._core.errors import UnitError
from ..gltf import scale_of
from .tensors import SYMMETRIC_ROWS

__all__ = [
    "COLUMNS",
    "GLTF_NAMES",
    "UNIT_COMMENT",
    "baked_attributes",
    "baked_unit_mm",
    "commented_unit_mm",
    "gathered_columns",
    "turned_tensors",
]

GLTF_NAMES = {
    "curvature": (("_CURVATURE", slice(0, 1)),),
    "tensor": (("_CURVATURE_TENSOR_0", slice(0, 3)), ("_CURVATURE_TENSOR_1", slice(3, 6))),
    "thickness": (("_THICKNESS", slice(0, 1)),),
    "ambient_transfer": tuple(
        (f"_AMBIENT_TRANSFER_{number}", slice(3 * number, 3 * number + 3)) for number in range(9)
    ),
}
"""Attributes of a primitive that store each baked quantity, with the columns that each stores."""
COLUMNS = {
    "curvature": ("curvature",),
    "tensor": ("tensor_xx", "tensor_xy", "tensor_xz", "tensor_yy", "tensor_yz", "tensor_zz"),
    "thickness": ("thickness",),
    "ambient_transfer": tuple(
        f"ambient_transfer_{number}_{channel}" for number in range(9) for channel in "rgb"
    ),
}
"""Vertex properties of PLY and primvars of USD, by the name of the attribute."""
LOADED = ("curvature", "tensor", "thickness")
"""Quantities that `load_mesh` reads. Ambient transfer is for engines; this package computes it."""
UNIT_COMMENT = "unit_mm"
"""First word of the comment of PLY and OBJ files that states the length of their unit, mm."""


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
    for key in LOADED:
        parts = GLTF_NAMES[key]
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
    return turned_tensors(six, left @ right)


def turned_tensors(six: FloatArray, turn: FloatArray) -> FloatArray:
    """Return symmetric tensors (V, 6), xx xy xz yy yz zz, turned by a rotation (3, 3)."""
    full = six[:, np.array(SYMMETRIC_ROWS)]
    turned = np.einsum("ia,vab,jb->vij", turn, full, turn)
    rows, columns = np.triu_indices(3)
    return turned[:, rows, columns]


def gathered_columns(attributes: Mapping[str, FloatArray]) -> dict[str, FloatArray]:
    """Return attributes of a PLY file with the baked columns of each quantity as one attribute.

    Attributes with the name of a quantity, and parts of a quantity that is not complete, are left out.

    Parameters
    ----------
    attributes
        (V, n) by the names of the file; numbers of vertices are (V, 1).
    """
    names = {name for parts in COLUMNS.values() for name in parts} | COLUMNS.keys()
    gathered = {name: values for name, values in attributes.items() if name not in names}
    for quantity, parts in COLUMNS.items():
        if all(name in attributes for name in parts):
            gathered[quantity] = np.concatenate([attributes[name] for name in parts], axis=1)
    return gathered


def commented_unit_mm(comments: Sequence[str], name: str) -> float | None:
    """Return the unit that comments state, mm, or None if no comment states one.

    Parameters
    ----------
    comments
        Comments of a file; ``unit_mm 10.0`` states that one unit is 10 mm.
    name
        Name of the file, for error messages.

    Raises
    ------
    UnitError
        If a unit is not a number of mm in range, or comments state different ones.
    """
    units: list[float] = []
    for comment in comments:
        keyword, *rest = comment.split(maxsplit=1)[:2] or [""]
        if keyword != UNIT_COMMENT:
            continue
        try:
            unit = float(rest[0] if rest else "")
        except ValueError:
            unit = 0.0
        if not 0.0 < unit < np.inf:  # false for NaN
            raise UnitError(
                f"{name}: the comment {comment.strip()[:60]!r} states no positive number of mm;"
                " correct it, or give unit_mm"
            )
        units.append(unit)
    if len(set(units)) > 1:
        raise UnitError(
            f"{name}: comments state units of {units[0]:g} and {units[1]:g} mm; give unit_mm"
        )
    return units[0] if units else None
