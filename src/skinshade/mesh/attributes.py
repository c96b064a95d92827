"""Vertex attributes of skin shading, in one call."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray
from .._core.errors import MeshError
from ..profile import Profile
from .diffusion import diffuse_on_mesh
from .model import Mesh
from .normals import tangent_frame, vertex_tangents
from .shape_operator import ShapeOperator
from .tensors import tensor_to_world

__all__ = ["plain_attributes", "vertex_attributes"]

DIFFUSION_TOLERANCE = 1e-4
"""Tolerance of diffused normals: a tenth of a step of eight bits in the picture."""


def vertex_attributes(mesh: Mesh, profile: Profile) -> dict[str, FloatArray]:
    """Return the vertex attributes of a mesh for a profile; baked ones are not computed again.

    Parameters
    ----------
    mesh
        Mesh with its unit.
    profile
        Profile of the skin, already scaled.

    Returns
    -------
    dict
        ``position`` (V, 3) mm; ``normal`` (V, 3) unit; ``tangent`` (V, 4) unit, and sign of the
        bitangent; ``uv`` (V, 2), 0 where the mesh has none; ``curvature`` (V, 1) mean, 1/mm; ``tensor``
        (V, 6) shape operator in world axes, xx xy xz yy yz zz, 1/mm; ``diffused_normals`` (V, 9) normals
        diffused by the profile, a row for each channel; ``diffused_curvature`` (V, 3), 1/mm.

    Raises
    ------
    MeshError
        If the mesh has an attribute ``curvature`` that is not (V,), or ``tensor`` that is not (V, 6).

    Examples
    --------
    >>> import skinshade as sk
    >>> mesh = sk.builtin_head().mesh
    >>> attributes = sk.vertex_attributes(mesh, sk.Profile.preset("skin-deon2007"))
    >>> attributes["tensor"].shape
    (20560, 6)
    """
    points = mesh.positions_mm
    tensor, curvature = _stored(mesh, "tensor", (6,)), _stored(mesh, "curvature", ())
    if tensor is None or curvature is None:
        operator = ShapeOperator.fit(points, mesh.faces, mesh.normals)
        if tensor is None:
            tensor = tensor_to_world(operator.tensor(), mesh.normals)
        if curvature is None:
            curvature = operator.mean()
    fields = np.concatenate([mesh.normals, curvature[:, None]], axis=1)
    diffused = diffuse_on_mesh(points, mesh.faces, fields, profile, tolerance=DIFFUSION_TOLERANCE)
    return {
        **plain_attributes(mesh),
        "curvature": curvature[:, None],
        "tensor": tensor,
        "diffused_normals": diffused[:, :3].swapaxes(1, 2).reshape(-1, 9),
        "diffused_curvature": diffused[:, 3],
    }


def plain_attributes(mesh: Mesh) -> dict[str, FloatArray]:
    """Return the attributes that shading without scattering needs: the first four of `vertex_attributes`."""
    points = mesh.positions_mm
    if mesh.uvs is None:
        uv = np.zeros((len(points), 2))
        tangent = np.concatenate(
            [tangent_frame(mesh.normals)[0], np.ones((len(points), 1))], axis=1
        )
    else:
        uv = mesh.uvs
        tangent = vertex_tangents(points, mesh.normals, mesh.uvs, mesh.faces)
    return {"position": points, "normal": mesh.normals, "tangent": tangent, "uv": uv}


def _stored(mesh: Mesh, name: str, shape: tuple[int, ...]) -> FloatArray | None:
    """Return an attribute of the mesh after a check of its shape for one vertex, or None."""
    values = mesh.attributes.get(name)
    if values is not None and values.shape[1:] != shape:
        expected = ", ".join(map(str, ("V", *shape)))
        raise MeshError(f"mesh: attribute {name} has shape {values.shape}; it must be ({expected})")
    return values
