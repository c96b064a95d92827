"""What skin shading wants at every vertex, in one call."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray
from ..profile import Profile
from .curvature import mesh_curvature, mesh_curvature_tensor, tensor_to_world
from .diffusion import diffuse_on_mesh
from .model import Mesh
from .normals import tangent_frame, vertex_tangents

__all__ = ["vertex_attributes"]

DIFFUSION_TOLERANCE = 1e-4
"""Of diffused normals: a tenth of what eight bits of a picture resolve."""


def vertex_attributes(mesh: Mesh, profile: Profile) -> dict[str, FloatArray]:
    """Analyse a mesh for a profile; what was baked into its file is taken as it is.

    Parameters
    ----------
    mesh
        With its unit.
    profile
        Of the skin; already scaled.

    Returns
    -------
    dict
        ``position`` (V, 3) mm; ``normal`` (V, 3) unit; ``tangent`` (V, 4), the last number the side of
        the bitangent; ``uv`` (V, 2), 0 without them; ``curvature`` (V, 1) mean, 1/mm; ``tensor`` (V, 6)
        shape operator in world axes, xx xy xz yy yz zz, 1/mm; ``diffused`` (V, 9) normals diffused by the
        profile, a row a channel; ``diffused_curvature`` (V, 3), 1/mm.
    """
    points = mesh.positions_mm
    tensor, curvature = mesh.attributes.get("tensor"), mesh.attributes.get("curvature")
    if tensor is None:
        flat = mesh_curvature_tensor(points, mesh.faces, mesh.normals)
        tensor = tensor_to_world(flat, mesh.normals)
    if curvature is None:
        curvature = mesh_curvature(points, mesh.faces, mesh.normals)
    both = np.concatenate([mesh.normals, curvature[:, None]], axis=1)
    diffused = diffuse_on_mesh(points, mesh.faces, both, profile, tolerance=DIFFUSION_TOLERANCE)
    if mesh.uvs is None:
        uv = np.zeros((len(points), 2))
        tangent = np.concatenate(
            [tangent_frame(mesh.normals)[0], np.ones((len(points), 1))], axis=1
        )
    else:
        uv = mesh.uvs
        tangent = vertex_tangents(points, mesh.normals, mesh.uvs, mesh.faces)
    return {
        "position": points,
        "normal": mesh.normals,
        "tangent": tangent,
        "uv": uv,
        "curvature": curvature[:, None],
        "tensor": tensor,
        "diffused": diffused[:, :3].swapaxes(1, 2).reshape(-1, 9),
        "diffused_curvature": diffused[:, 3],
    }
