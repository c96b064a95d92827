"""Table of the vertex attributes that shading interpolates."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from ..._core.arrays import FloatArray, IntArray
from ...mesh import Mesh, vertex_attributes
from ...mesh.ambient_transfer import diffused_by_channel
from ...mesh.attributes import plain_attributes
from ...params.vertex import VERTEX_COLUMNS, column_slices
from ...shading.direct import directional_curvature, relief_length
from ...shading.skin import Skin
from . import compiled_fetches as compiled
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

    def mixed(self, name: str, face: IntArray, weights: FloatArray) -> FloatArray:
        """Return a column (N, k) by its `name`, mixed with weights (N, 3) of the corners of faces (N,)."""
        values = self.column(name)
        if compiled.serves():
            return compiled.interpolated(values, self.faces, face, weights)
        result: FloatArray = np.einsum("ni,nik->nk", weights, values[self.faces[face]])
        return result

    def interpolated(self, face: IntArray, barycentric: FloatArray) -> dict[str, FloatArray]:
        """Return every column (N, k) at points given by face (N,) and barycentric weights (N, 3)."""
        if compiled.serves():
            mixed = compiled.interpolated(self.values, self.faces, face, barycentric)
        else:
            corners = self.faces[face]
            mixed = self.values[corners[:, 0]] * barycentric[:, :1]
            mixed += self.values[corners[:, 1]] * barycentric[:, 1:2]
            mixed += self.values[corners[:, 2]] * barycentric[:, 2:]
        return {name: mixed[:, floats] for name, floats in column_slices().items()}


def build_vertex_table(
    mesh: Mesh,
    skin: Skin,
    ambient: AmbientLight | None,
    faces: IntArray | None = None,
    skin_faces: int | None = None,
) -> VertexTable:
    """Return the vertex table of a mesh; the columns of ambient light are 0 if `ambient` is None.

    Parameters
    ----------
    mesh
        Body.
    skin
        Material of its skin.
    ambient
        Ambient light at the vertices.
    faces
        Faces of the mesh in the order of the table; those of the mesh if None.
    skin_faces
        Number of faces at the beginning that are skin; all if None.
    """
    faces = mesh.faces if faces is None else faces
    if skin_faces is None or skin_faces == len(faces):
        columns = vertex_attributes(mesh, skin.profile)
        columns["mesh_relief"] = _mesh_relief(skin, columns)
    else:
        columns = plain_attributes(mesh)
        if skin_faces:
            vertices, body = _submesh(mesh, faces[:skin_faces])
            diffused = vertex_attributes(body, skin.profile)
            diffused["mesh_relief"] = _mesh_relief(skin, diffused)
            for name, values in diffused.items():
                column = columns.setdefault(name, np.zeros((len(mesh.positions), values.shape[1])))
                column[vertices] = values
    if ambient is not None:
        skin_faces = len(faces) if skin_faces is None else skin_faces
        columns |= _ambient_columns(mesh, faces[:skin_faces], skin, ambient)
    count = len(mesh.positions)
    parts = [
        columns.get(name, np.zeros((count, column.width)))
        for name, column in VERTEX_COLUMNS.items()
    ]
    return VertexTable(np.concatenate(parts, axis=1), faces)


def _ambient_columns(
    mesh: Mesh, skin_faces: IntArray, skin: Skin, ambient: AmbientLight
) -> dict[str, FloatArray]:
    """Return the columns of ambient light, which skin diffuses."""
    light = np.stack([ambient.arriving, ambient.bounced], axis=2)
    if len(skin_faces):
        vertices, body = _submesh(mesh, skin_faces)
        own = light[vertices]
        light[vertices] = diffused_by_channel(body.positions_mm, body.faces, own, skin.profile)
    return {
        "visibility": light[:, :, 0] / ambient.unoccluded,
        "bounced": light[:, :, 1],
        "through": ambient.through,
        "sky_harmonics": ambient.sky_harmonics,
    }


def _submesh(mesh: Mesh, faces: IntArray) -> tuple[IntArray, Mesh]:
    """Return the indices of the vertices that some faces use, and the mesh of these faces."""
    vertices, corners = np.unique(faces, return_inverse=True)
    return vertices, replace(
        mesh,
        positions=mesh.positions[vertices],
        normals=mesh.normals[vertices],
        faces=corners.reshape(-1, 3).astype(np.int64),
        uvs=None if mesh.uvs is None else mesh.uvs[vertices],
        attributes={name: values[vertices] for name, values in mesh.attributes.items()},
        repairs={},
        materials=None,
    )


def _mesh_relief(skin: Skin, columns: Mapping[str, FloatArray]) -> FloatArray:
    """Return the length (V, 3) of diffused normals at folds of the mesh, without a normal map."""
    normals = columns["normal"]
    _, total = directional_curvature(columns["tensor"], normals, normals)
    flat = np.repeat(normals[:, None], 3, axis=1)
    diffused = columns["diffused_normals"].reshape(-1, 3, 3)
    return relief_length(skin.transfer, flat, diffused, total)
