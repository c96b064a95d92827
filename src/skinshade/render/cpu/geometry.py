"""Everything that shading interpolates, as one table of per-vertex columns."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..._core.arrays import FloatArray, IntArray
from ...mesh import Mesh, vertex_attributes
from ...shading.direct import directional_curvature, unexplained_length
from ...shading.skin import Skin
from .sky import SkyLight

__all__ = ["Columns", "Geometry", "build_geometry"]

Columns = dict[str, FloatArray]


@dataclass(frozen=True)
class Geometry:
    """Per-vertex values side by side.

    Attributes
    ----------
    table
        (V, K).
    slices
        Where each column stands, by name.
    faces
        (F, 3).
    """

    table: FloatArray
    slices: dict[str, slice]
    faces: IntArray

    def interpolated(self, face: IntArray, barycentric: FloatArray) -> Columns:
        """Return every column (N, k) at points given by face and barycentric coordinates."""
        at = self.faces[face]
        mixed = self.table[at[:, 0]] * barycentric[:, :1]
        mixed += self.table[at[:, 1]] * barycentric[:, 1:2]
        mixed += self.table[at[:, 2]] * barycentric[:, 2:]
        return {name: mixed[:, where] for name, where in self.slices.items()}


def build_geometry(mesh: Mesh, skin: Skin, sky: SkyLight | None) -> Geometry:
    """Analyse a mesh for a skin."""
    columns = vertex_attributes(mesh, skin.profile)
    columns["unexplained"] = _unexplained(skin, columns)
    if sky is not None:
        columns["visibility"] = sky.visibility
        columns["through"] = sky.through
        columns["bounced"] = sky.bounced
    ends = np.cumsum([column.shape[1] for column in columns.values()])
    starts = np.concatenate([[0], ends[:-1]])
    slices = {
        name: slice(int(start), int(end))
        for name, start, end in zip(columns, starts, ends, strict=True)
    }
    return Geometry(np.concatenate(list(columns.values()), axis=1), slices, mesh.faces)


def _unexplained(skin: Skin, columns: Columns) -> FloatArray:
    """Length (V, 3) that the mesh's normals lost to folds, where the map is flat."""
    normals = columns["normal"]
    _, total = directional_curvature(columns["tensor"], normals, normals)
    flat = np.repeat(normals[:, None], 3, axis=1)
    return unexplained_length(skin.transfer, flat, columns["diffused"].reshape(-1, 3, 3), total)
