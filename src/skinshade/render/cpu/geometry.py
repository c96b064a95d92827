"""Everything that shading interpolates, as one table of per-vertex columns."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..._core.arrays import FloatArray, IntArray
from ...mesh import Mesh, diffuse_on_mesh, mesh_curvature, mesh_curvature_tensor
from ...mesh.curvature import tensor_to_world
from ...mesh.normals import tangent_frame, vertex_tangents
from ...profile import Profile
from .sky import SkyLight

__all__ = ["Columns", "Geometry", "build_geometry"]

DIFFUSION_TOLERANCE = 1e-4
"""Of diffused normals: a tenth of what eight bits of a picture resolve."""

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


def build_geometry(mesh: Mesh, profile: Profile, sky: SkyLight | None) -> Geometry:
    """Analyse a mesh for a profile."""
    points = mesh.positions_mm
    tensor = mesh_curvature_tensor(points, mesh.faces, mesh.normals)
    curvature = mesh_curvature(points, mesh.faces, mesh.normals)
    both = np.concatenate([mesh.normals, curvature[:, None]], axis=1)
    diffused = diffuse_on_mesh(points, mesh.faces, both, profile, tolerance=DIFFUSION_TOLERANCE)
    if mesh.uvs is None:
        tangent = np.concatenate(
            [tangent_frame(mesh.normals)[0], np.ones((len(points), 1))], axis=1
        )
    else:
        tangent = vertex_tangents(points, mesh.normals, mesh.uvs, mesh.faces)
    columns: Columns = {
        "position": points,
        "normal": mesh.normals,
        "tangent": tangent,
        "uv": np.zeros((len(points), 2)) if mesh.uvs is None else mesh.uvs,
        "curvature": curvature[:, None],
        "tensor": tensor_to_world(tensor, mesh.normals),
        "diffused": diffused[:, :3].swapaxes(1, 2).reshape(-1, 9),
        "diffused_curvature": diffused[:, 3],
    }
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
