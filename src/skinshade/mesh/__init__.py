"""Meshes and their analysis: curvature, thickness, UV scale, tangent frames, diffusion over the surface."""

from typing import TYPE_CHECKING

from .._core.lazy import names_on_demand

if TYPE_CHECKING:
    from .ambient_transfer import AmbientTransfer, mesh_ambient_transfer
    from .attributes import vertex_attributes
    from .curvature import mesh_curvature, mesh_curvature_tensor
    from .diffusion import diffuse_on_mesh, mesh_diffused_normals
    from .model import Mesh
    from .readers import load_mesh
    from .thickness import mesh_thickness
    from .uv_scale import mesh_uv_scale

__all__ = [
    "AmbientTransfer",
    "Mesh",
    "diffuse_on_mesh",
    "load_mesh",
    "mesh_ambient_transfer",
    "mesh_curvature",
    "mesh_curvature_tensor",
    "mesh_diffused_normals",
    "mesh_thickness",
    "mesh_uv_scale",
    "vertex_attributes",
]

__getattr__ = names_on_demand(
    __name__,
    {
        ".ambient_transfer": ("AmbientTransfer", "mesh_ambient_transfer"),
        ".attributes": ("vertex_attributes",),
        ".curvature": (
            "mesh_curvature",
            "mesh_curvature_tensor",
        ),
        ".diffusion": (
            "diffuse_on_mesh",
            "mesh_diffused_normals",
        ),
        ".model": ("Mesh",),
        ".readers": ("load_mesh",),
        ".thickness": ("mesh_thickness",),
        ".uv_scale": ("mesh_uv_scale",),
    },
)
