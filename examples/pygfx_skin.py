"""Skin in a pygfx scene: the built-in head under a key light, a rim light and ambient light.

``python examples/pygfx_skin.py FOLDER`` writes pygfx_skin.png; a path of a PNG writes that file.
"""

import sys
from pathlib import Path

import numpy as np
import pygfx
from rendercanvas.offscreen import OffscreenRenderCanvas

import skinshade as sk
from skinshade.integrations.pygfx import SkinMaterial, skin_geometry, skin_light


def draw(size: tuple[int, int]) -> np.ndarray:
    """Return display values (H, W, 3), uint8."""
    head = sk.builtin_head()
    mesh, maps = head.mesh, head.material
    material = SkinMaterial(maps.profile, map=maps.albedo, normal_map=maps.normal)
    body = pygfx.Mesh(
        skin_geometry(mesh, material.skin.profile),
        material,
        cast_shadow=True,
        receive_shadow=True,
    )
    scene = pygfx.Scene()
    scene.add(
        pygfx.Background.from_color("#383a3c"),
        body,
        skin_light(sk.DirectionalLight.from_angles(-38.0, 26.0, 0.8), mesh),
        skin_light(sk.DirectionalLight.from_angles(150.0, 5.0, 1.6), mesh),
        pygfx.AmbientLight("#fff", 0.5),
    )
    framed = sk.head_scene(head).camera
    camera = pygfx.PerspectiveCamera(framed.vertical_fov_deg, depth_range=(100.0, 5000.0))
    camera.local.position = framed.position_mm
    camera.look_at(framed.target_mm)
    canvas = OffscreenRenderCanvas(size=size, pixel_ratio=1)
    renderer = pygfx.renderers.WgpuRenderer(canvas)
    canvas.request_draw(lambda: renderer.render(scene, camera))
    return np.asarray(canvas.draw())[..., :3]


if __name__ == "__main__":
    target = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    sk.save_image(target / "pygfx_skin.png" if target.is_dir() else target, draw((480, 480)))
