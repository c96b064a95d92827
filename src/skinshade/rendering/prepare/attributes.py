"""Table of the vertex attributes that shading interpolates."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..._core.arrays import FloatArray, IntArray
from ...mesh import Mesh, vertex_attributes
from ...params.vertex import VERTEX_COLUMNS, column_slices
from ...shading.direct import directional_curvature, relief_length
from ...shading.skin import Skin
from .ambient_light import AmbientLight

__all__ = ["VertexTable", "build_vertex_table"]


@dataclass(frozen=True)
class VertexTable:
    """Values at the vertices, in the columns of `skinshade.params.vertex.VERTEX_COLUMNS`.

    Attributes
    ----------
    values
        (V, K) all columns side by side.
    faces
        (F, 3) indices of vertices.
    """

    values: FloatArray
    faces: IntArray

    def column(self, name: str) -> FloatArray:
        """Return a column (V, k) by its `name`."""
        return self.values[:, column_slices()[name]]

    def interpolated(self, face: IntArray, barycentric: FloatArray) -> dict[str, FloatArray]:
        """Return every column (N, k) at points given by face (N,) and barycentric weights (N, 3)."""
        corners = self.faces[face]
        mixed = self.values[corners[:, 0]] * barycentric[:, :1]
        mixed += self.values[corners[:, 1]] * barycentric[:, 1:2]
        mixed += self.values[corners[:, 2]] * barycentric[:, 2:]
        return {name: mixed[:, floats] for name, floats in column_slices().items()}


def build_vertex_table(mesh: Mesh, skin: Skin, ambient: AmbientLight | None) -> VertexTable:
    """Return the vertex table of a mesh; the columns of ambient light are 0 if `ambient` is None."""
    columns = vertex_attributes(mesh, skin.profile)
    columns["mesh_relief"] = _mesh_relief(skin, columns)
    if ambient is not None:
        columns["visibility"] = ambient.visibility
        columns["through"] = ambient.through
        columns["bounced"] = ambient.bounced
    count = len(mesh.positions)
    parts = [
        columns.get(name, np.zeros((count, column.width)))
        for name, column in VERTEX_COLUMNS.items()
    ]
    return VertexTable(np.concatenate(parts, axis=1), mesh.faces)


def _mesh_relief(skin: Skin, columns: Mapping[str, FloatArray]) -> FloatArray:
    """Return the length (V, 3) of diffused normals at folds of the mesh, without a normal map."""
    normals = columns["normal"]
    _, total = directional_curvature(columns["tensor"], normals, normals)
    flat = np.repeat(normals[:, None], 3, axis=1)
    diffused = columns["diffused_normals"].reshape(-1, 3, 3)
    return relief_length(skin.transfer, flat, diffused, total)
