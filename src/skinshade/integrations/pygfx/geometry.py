"""A mesh with all that skin shading interpolates, as a pygfx geometry."""

from __future__ import annotations

import numpy as np
import pygfx

from ...mesh import Mesh, mesh_uv_scale, vertex_attributes
from ...profile import Profile
from ...scene import Material

__all__ = ["ATTRIBUTES", "NUMBERS", "skin_geometry"]

ATTRIBUTES = {"curvature": 1, "diffused_curvature": 3, "tensor": 6}
"""Numbers of each attribute, in their order in ``geometry.skin_attributes``."""
NUMBERS = sum(ATTRIBUTES.values())


def skin_geometry(mesh: Mesh, profile: Profile | None = None) -> pygfx.Geometry:
    """Return what `SkinMaterial` draws.

    Parameters
    ----------
    mesh
        With its unit; `skinshade.load_mesh`.
    profile
        Of the material, already scaled: ``material.skin.profile``. The default material's if None.

    Returns
    -------
    pygfx.Geometry
        ``positions`` (V, 3) mm, ``normals``, ``indices`` and ``tangents``, for any of pygfx's materials;
        ``texcoords`` (V, 2), v down, and ``uv_scale_mm`` if the mesh has UVs; ``skin_attributes``, in one
        buffer as a vertex shader may have few: per vertex the mean curvature, that curvature diffused by
        the profile in R, G, B, and the shape operator xx xy xz yy yz zz in the mesh's axes, all 1/mm.
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
