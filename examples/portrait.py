"""The ten lines of the README: a table for an engine, curvature of a mesh, a picture."""

import sys
from pathlib import Path

import skinshade as sk
from skinshade.render.renderer import display
from skinshade.scene.images import write_png

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")

profile = sk.Profile.preset("skin-deon2007")
lut = sk.build_curvature_lut(profile)
lut.save(folder / "curvature.exr")

mesh, skin = sk.builtin_head()
curvature = sk.mesh_curvature(mesh.positions_mm, mesh.faces, mesh.normals)
print(f"{curvature.size} vertices, curvature {curvature.min():.2f} to {curvature.max():.2f} per mm")

scene = sk.head_scene(mesh, skin, yaw_deg=30.0)
image = sk.render(scene, size=(320, 180), samples=1)
write_png(folder / "portrait.png", display(image, scene, sk.RenderSettings()))
