"""Meshes and their analysis: curvature, thickness, UV scale, tangent frames, diffusion over the surface."""

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
