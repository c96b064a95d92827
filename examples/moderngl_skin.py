"""Skin in your own moderngl renderer: OpenGL 3.3, offscreen on EGL, with the shader moderngl_skin.frag.

``python examples/moderngl_skin.py FOLDER`` writes moderngl_skin.png.
"""

import sys
from pathlib import Path

import moderngl
import numpy as np

import skinshade as sk
from skinshade.integrations.moderngl import SkinProgram

FRAGMENT = Path(__file__).with_suffix(".frag")
VERTEX = """#version 330
uniform mat4 view_projection;
in vec3 in_position, in_normal;
in vec4 in_tangent;
in vec2 in_uv;
in vec3 in_xx_xy_xz, in_yy_yz_zz, in_curvature;
out vec3 position, normal;
out vec4 tangent;
out vec2 uv;
out vec3 xx_xy_xz, yy_yz_zz, curvature;

void main()
{
    position = in_position; normal = in_normal; tangent = in_tangent; uv = in_uv;
    xx_xy_xz = in_xx_xy_xz; yy_yz_zz = in_yy_yz_zz; curvature = in_curvature;
    gl_Position = view_projection * vec4(in_position, 1.0);
}
"""
COLUMNS = ("position", "normal", "tangent", "uv", "tensor", "diffused_curvature")
INPUTS = ("position", "normal", "tangent", "uv", "xx_xy_xz", "yy_yz_zz", "curvature")


def draw(scene: sk.Scene, size: tuple[int, int]) -> np.ndarray:
    """Return linear light and coverage (H, W, 4) of a scene's body under its first light."""
    context = moderngl.create_context(standalone=True, backend="egl", require=330)
    skin = sk.Skin.of(scene.material.profile, scene.material.params)
    skin_program = SkinProgram(
        context, skin, vertex_shader=VERTEX, fragment_shader=FRAGMENT.read_text(encoding="utf-8")
    )
    program, mesh = skin_program.program, scene.mesh
    matrix = scene.camera.view_projection(size[0] / size[1])
    matrix[2] = 2.0 * matrix[2] - matrix[3]  # OpenGL's depth is -1..1
    program["view_projection"].write(np.ascontiguousarray(matrix.T, dtype="f4").tobytes())
    program["eye_mm"].value = tuple(scene.camera.position_mm)
    program["to_light"].value = tuple(scene.lights[0].to_light)
    program["light_radiance"].value = tuple(scene.lights[0].irradiance / np.pi)
    program["uv_scale_mm"].value = sk.mesh_uv_scale(mesh.positions_mm, mesh.uvs, mesh.faces)
    for unit, name in enumerate(("albedo", "normal")):
        image = np.ascontiguousarray(getattr(scene.material, name), dtype="f4")
        texture = context.texture(image.shape[1::-1], 3, image.tobytes(), dtype="f4", alignment=4)
        texture.build_mipmaps()  # averages, which the blurred normals need
        texture.filter = (moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR)
        texture.use(unit)
        program[f"{name}_map"].value = unit

    attributes = sk.vertex_attributes(mesh, skin.profile)
    vertices = np.concatenate([attributes[name] for name in COLUMNS], axis=1)
    body = context.vertex_array(
        program,
        [
            (
                context.buffer(vertices.astype("f4").tobytes()),
                "3f 3f 4f 2f 3f 3f 3f",
                *(f"in_{name}" for name in INPUTS),
            )
        ],
        context.buffer(mesh.faces.astype("i4").tobytes()),
    )
    target = context.framebuffer(
        [context.texture(size, 4, dtype="f4")], context.depth_renderbuffer(size)
    )
    target.use()
    target.clear()
    context.enable(moderngl.DEPTH_TEST)
    skin_program.use()
    body.render()
    data = np.frombuffer(target.read(components=4, dtype="f4"), dtype="f4")
    context.release()
    return data.reshape(size[1], size[0], 4)[::-1]  # the first row of OpenGL is the lowest


if __name__ == "__main__":
    image = draw(sk.head_scene(sk.builtin_head(), yaw_deg=28.0), (480, 480))
    sk.save_image(Path(sys.argv[1]) / "moderngl_skin.png", image)
