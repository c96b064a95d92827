"""pygfx geometries with the vertex attributes of skin shading."""

from __future__ import annotations

import numpy as np
import pygfx

from ...mesh import Mesh, mesh_uv_scale, vertex_attributes
from ...profile import Profile
from ...scene import Material

__all__ = ["ATTRIBUTES", "NUMBERS", "skin_geometry"]

ATTRIBUTES = {"curvature": 1, "diffused_curvature": 3, "tensor": 6}
"""Numbers per vertex of each attribute, in the order of ``geometry.skin_attributes``."""
NUMBERS = sum(ATTRIBUTES.values())
"""Numbers per vertex of all attributes."""


def skin_geometry(mesh: Mesh, profile: Profile | None = None) -> pygfx.Geometry:
    """Return the geometry of a mesh for `SkinMaterial`.

    Parameters
    ----------
    mesh
        Mesh with its unit, for instance from `skinshade.load_mesh`.
    profile
        Profile of the material, already scaled: ``material.skin.profile``. If None, the profile of the
        default material.

    Returns
    -------
    pygfx.Geometry
        ``positions`` (V, 3) mm, ``normals``, ``indices`` and ``tangents``, for any material of pygfx;
        ``texcoords`` (V, 2), v down, and ``uv_scale_mm`` if the mesh has UVs; and ``skin_attributes``.
        Per vertex these are the mean curvature, the mean curvature diffused by the profile in R, G, B, and
        the shape operator xx xy xz yy yz zz in the mesh's axes, all in 1/mm. They share one buffer, because
        devices limit the number of buffers of a vertex shader.

    Examples
    --------
    >>> import skinshade as sk
    >>> from skinshade.integrations.pygfx import skin_geometry
    >>> geometry = skin_geometry(sk.builtin_head().mesh)
    >>> geometry.positions.data.shape[1]
    3
    """
    columns = vertex_attributes(mesh, Material().profile if profile is None else profile)
    arrays = {name: np.ascontiguousarray(c, dtype=np.float32) for name, c in columns.items()}
    skin = np.concatenate([arrays[name] for name in ATTRIBUTES], axis=1)
    geometry = pygfx.Geometry(
        positions=arrays["position"],
        indices=np.ascontiguousarray(mesh.faces, dtype=np.uint32),
        normals=arrays["normal"],
        tangents=arrays["tangent"],
        skin_attributes=skin.ravel(),
    )
    if mesh.uvs is not None:
        geometry.texcoords = pygfx.Buffer(arrays["uv"])
        geometry.uv_scale_mm = mesh_uv_scale(mesh.positions_mm, mesh.uvs, mesh.faces)
    return geometry
