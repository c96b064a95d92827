"""First steps: a table for an engine, the curvature of a mesh, a picture."""

import sys
from pathlib import Path

import skinshade as sk

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")

profile = sk.Profile.preset("skin-deon2007")
lut = sk.build_curvature_lut(profile)
lut.save(folder / "curvature.exr")

head = sk.builtin_head()
mesh = head.mesh
curvature = sk.mesh_curvature(mesh.positions_mm, mesh.faces, mesh.normals)
print(f"{curvature.size} vertices, curvature {curvature.min():.2f} to {curvature.max():.2f} per mm")

scene = sk.head_scene(head, yaw_deg=30.0)
image = sk.render(scene, size=(320, 180), samples=1)
sk.save_image(folder / "portrait.png", image)
