"""Up axis of files that do not state theirs."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from .._core.arrays import FloatArray
from .._core.errors import ArgumentError
from ..gltf import GLTF_SUFFIXES, TriangleSet
from .baked import turned_tensors
from .up_axis import UpAxis

__all__ = ["UpAxis", "checked_up", "turned_to_y_up"]

Z_UP_TO_Y_UP = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
"""Quarter turn around x: (x, y, z) becomes (x, z, −y)."""


def checked_up(up: str, file: Path) -> UpAxis:
    """Return an up axis after a check.

    Raises
    ------
    ArgumentError
        If it is none, or it is z for glTF, which prescribes y.
    """
    axis = UpAxis.of(up, "up")
    if axis == UpAxis.Z and file.suffix.lower() in GLTF_SUFFIXES:
        raise ArgumentError(f"{file}: up is 'z'; glTF prescribes y, so leave up out for this file")
    return axis


def turned_to_y_up(triangles: TriangleSet) -> TriangleSet:
    """Return triangles of a file with z up with y up; normals and the attribute ``tensor`` are turned too."""
    attributes = {
        name: turned_tensors(values, Z_UP_TO_Y_UP) if name == "tensor" else values
        for name, values in triangles.attributes.items()
    }
    return replace(
        triangles,
        positions=_turned(triangles.positions),
        normals=None if triangles.normals is None else _turned(triangles.normals),
        attributes=attributes,
    )


def _turned(vectors: FloatArray) -> FloatArray:
    """Return vectors (V, 3) after the quarter turn, without products, which infinity does not survive."""
    x, y, z = vectors.T
    return np.stack([x, z, -y], axis=1)
