"""Skin in your own wgpu renderer: your shader wgpu_skin.wgsl, your pipeline, skinshade's resources.

``python examples/wgpu_skin.py FOLDER`` writes wgpu_skin.png.
"""

import sys
from pathlib import Path

import numpy as np
import wgpu

import skinshade as sk

SHADER = Path(__file__).with_suffix(".wgsl")
COLUMNS = {"position": 3, "normal": 3, "uv": 2, "tensor": 6, "diffused_curvature": 3}
FORMATS = {0: 3, 12: 3, 24: 2, 32: 3, 44: 3, 56: 3}  # offset in bytes: floats
TARGET = "rgba32float"


def draw(scene: sk.Scene, size: tuple[int, int]) -> np.ndarray:
    """Return linear light and coverage (H, W, 4) of a scene's body under its first light."""
    device = wgpu.gpu.request_adapter_sync().request_device_sync(
        required_features=["float32-filterable"]
    )
    skin = sk.Skin.of(scene.material.profile, scene.material.params)
    context = sk.gpu.SkinContext(device, skin)
    code = sk.gpu.wgsl_library() + SHADER.read_text(encoding="utf-8")
    module = device.create_shader_module(code=code)

    def buffer(data: np.ndarray, usage: str) -> wgpu.GPUBuffer:
        return device.create_buffer_with_data(data=data, usage=usage)

    def texture(kind: str, extent: tuple[int, int], usage: str) -> wgpu.GPUTexture:
        return device.create_texture(size=extent, format=kind, usage=usage)

    attributes = sk.vertex_attributes(scene.mesh, skin.profile)
    vertices = np.concatenate([attributes[name] for name in COLUMNS], axis=1).astype(np.float32)
    faces = np.ascontiguousarray(scene.mesh.faces, dtype=np.uint32)
    light = scene.lights[0]
    frame = np.zeros((7, 4), dtype=np.float32)
    frame[:4] = scene.camera.view_projection(size[0] / size[1]).T
    frame[4:, :3] = scene.camera.position_mm, light.to_light, light.irradiance / np.pi
    picture = np.dstack([scene.material.albedo, np.ones(scene.material.albedo.shape[:2])])
    extent = picture.shape[1::-1]
    albedo = texture(TARGET, extent, "TEXTURE_BINDING|COPY_DST")
    rows = {"bytes_per_row": 16 * extent[0]}
    device.queue.write_texture({"texture": albedo}, picture.astype(np.float32), rows, (*extent, 1))
    target = texture(TARGET, size, "RENDER_ATTACHMENT|COPY_SRC")
    depth = texture("depth32float", size, "RENDER_ATTACHMENT").create_view()

    pairs = enumerate(FORMATS.items())
    inputs = [
        {"shader_location": i, "offset": offset, "format": f"float32x{n}"}
        for i, (offset, n) in pairs
    ]
    pipeline = device.create_render_pipeline(
        layout="auto",
        vertex={"module": module, "buffers": [{"array_stride": 68, "attributes": inputs}]},
        fragment={"module": module, "targets": [{"format": TARGET}]},
        depth_stencil={
            "format": "depth32float",
            "depth_write_enabled": True,
            "depth_compare": "less",
        },
    )
    own = ({"buffer": buffer(frame, "UNIFORM")}, albedo.create_view())
    own = [{"binding": binding, "resource": resource} for binding, resource in enumerate(own)]
    encoder = device.create_command_encoder()
    colours = [{"view": target.create_view(), "load_op": "clear", "store_op": "store"}]
    depths = {
        "view": depth,
        "depth_load_op": "clear",
        "depth_store_op": "store",
        "depth_clear_value": 1,
    }
    work = encoder.begin_render_pass(color_attachments=colours, depth_stencil_attachment=depths)
    work.set_pipeline(pipeline)
    for group, entries in enumerate((own, context.entries(code, group=1))):
        layout = pipeline.get_bind_group_layout(group)
        work.set_bind_group(group, device.create_bind_group(layout=layout, entries=entries))
    work.set_vertex_buffer(0, buffer(vertices, "VERTEX"))
    work.set_index_buffer(buffer(faces, "INDEX"), "uint32")
    work.draw_indexed(faces.size)
    work.end()
    device.queue.submit([encoder.finish()])
    rows = {"bytes_per_row": 16 * size[0]}
    data = device.queue.read_texture({"texture": target}, rows, (*size, 1))
    return np.frombuffer(data, dtype=np.float32).reshape(size[1], size[0], 4)


if __name__ == "__main__":
    image = draw(sk.head_scene(sk.builtin_head(), yaw_deg=28.0), (480, 480))
    sk.save_image(Path(sys.argv[1]) / "wgpu_skin.png", image)
