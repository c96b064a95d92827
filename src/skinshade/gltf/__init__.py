"""glTF 2.0 documents: `load_mesh` reads with this model, and `bake` edits with it."""

from .document import GLTF_SUFFIXES, GltfDocument, read_gltf
from .placement import mesh_placements, scale_of
from .primitives import Part, TriangleSet, read_mesh, read_scene

__all__ = [
    "GLTF_SUFFIXES",
    "GltfDocument",
    "Part",
    "TriangleSet",
    "mesh_placements",
    "read_gltf",
    "read_mesh",
    "read_scene",
    "scale_of",
]
