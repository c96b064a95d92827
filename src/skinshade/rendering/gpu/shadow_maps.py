"""Shadow maps of all lights, drawn on the device once for a scene."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

import numpy as np

from ..._core.arrays import FloatArray
from ...gpu.device import BufferUsage, GPUBuffer, GPUCommandEncoder, GPUDevice, GPUTexture
from ...gpu.device import TextureUsage as Usage
from ...gpu.program import Program
from ...gpu.textures import buffer
from ...gpu.timing import Stopwatch
from ...mesh import Mesh
from ...params import LightParams
from ...scene import Light
from ..prepare.light_view import MAP_SIZE, LightView
from ..prepare.shadow_map import FAR_MM, ShadowMap
from .programs import open_program
from .records import light_params

__all__ = ["DeviceShadowMaps"]

DEPTHS, MOMENTS = "r32float", "rg32float"
USAGE = Usage.RENDER_ATTACHMENT | Usage.TEXTURE_BINDING | Usage.COPY_SRC


class DeviceShadowMaps:
    """Depth maps of all lights as textures for the skin pass.

    Parameters
    ----------
    device
        Device of the textures.
    filter_width_mm
        Width of the wide filter, mm.
    stopwatch
        Stopwatch that times the passes.
    """

    def __init__(self, device: GPUDevice, filter_width_mm: float, stopwatch: Stopwatch) -> None:
        self._device, self._width_mm, self._stopwatch = device, filter_width_mm, stopwatch
        self._lights: Sequence[Light] = ()
        self._views: Sequence[LightView] = ()

    def rasterize(self, mesh: Mesh, lights: Sequence[Light]) -> list[ShadowMap]:
        """Draw the shadow maps of a mesh, one for each light, and read them back."""
        views = [LightView.of(light, mesh) for light in lights]
        self._lights, self._views = lights, views
        self._draw(mesh)
        layers = [self._read(layer) for layer in range(2 * len(views))]
        return [
            ShadowMap(view, nearest_mm=layers[2 * i + 1], occluder_mm=layers[2 * i])
            for i, view in enumerate(views)
        ]

    @cached_property
    def lights(self) -> GPUBuffer:
        """Storage buffer with one block for each light; one unused block if there is no light."""
        pairs = zip(self._lights, self._views, strict=True)
        data = b"".join(light_params(light, view, self._width_mm).pack() for light, view in pairs)
        return buffer(self._device, data or LightParams().pack(), BufferUsage.STORAGE)

    @cached_property
    def depths(self) -> GPUTexture:
        """Two layers for each light: depths of occluders, and depths of the nearest surface; mm."""
        return self._layers(DEPTHS, 2 * max(len(self._lights), 1))

    @cached_property
    def moments(self) -> GPUTexture:
        """One layer for each light: blurred depth from the body's middle, and its square; mm, mm²."""
        count = len(self._lights)
        layers = self._layers(MOMENTS, max(count, 1))
        if not count:
            return layers
        program = open_program(self._device, "blur_pass")
        half_blurred = self._layers(MOMENTS, 1)
        encoder = self._device.create_command_encoder()
        for light in range(count):
            steps = ((self.depths, half_blurred, 0), (half_blurred, layers, light))
            for vertical, (source, target, layer) in enumerate(steps):
                self._blur(encoder, program, vertical, source, _target(target, layer), light)
        self._device.queue.submit([encoder.finish()])
        return layers

    def _draw(self, mesh: Mesh) -> None:
        if not self._views:
            return
        positions = np.ones((len(mesh.positions), 4), dtype=np.float32)
        positions[:, :3] = mesh.positions_mm
        vertices = buffer(self._device, positions.tobytes(), BufferUsage.VERTEX)
        faces = np.ascontiguousarray(mesh.faces, dtype=np.uint32)
        indices = buffer(self._device, faces.tobytes(), BufferUsage.INDEX)
        program = open_program(self._device, "shadow_pass")
        group = program.bind({"lights": {"buffer": self.lights}})
        depth_buffer = self._device.create_texture(
            size=(MAP_SIZE, MAP_SIZE, 1), format="depth32float", usage=USAGE
        )
        encoder = self._device.create_command_encoder()
        for layer in range(2 * len(self._views)):
            pipeline = program.pipeline(
                {"OCCLUDERS": 1 - layer % 2}, targets=[DEPTHS], vertex_floats=4, depth="less"
            )
            render_pass = encoder.begin_render_pass(
                color_attachments=[_target(self.depths, layer, FAR_MM)],
                depth_stencil_attachment={
                    "view": depth_buffer.create_view(),
                    "depth_load_op": "clear",
                    "depth_store_op": "discard",
                    "depth_clear_value": 1.0,
                },
                **self._stopwatch.around("shadow map"),
            )
            render_pass.set_pipeline(pipeline)
            render_pass.set_bind_group(0, group)
            render_pass.set_vertex_buffer(0, vertices)
            render_pass.set_index_buffer(indices, "uint32")
            render_pass.draw_indexed(faces.size, 1, 0, 0, layer // 2)
            render_pass.end()
        self._device.queue.submit([encoder.finish()])

    def _read(self, layer: int) -> FloatArray:
        """Return the depths of a layer, infinite in empty texels."""
        data = self._device.queue.read_texture(
            {"texture": self.depths, "origin": (0, 0, layer)},
            {"bytes_per_row": 4 * MAP_SIZE, "rows_per_image": MAP_SIZE},
            (MAP_SIZE, MAP_SIZE, 1),
        )
        depths = np.frombuffer(data, dtype=np.float32).reshape(MAP_SIZE, MAP_SIZE)
        return np.where(depths < 0.5 * FAR_MM, depths.astype(np.float64), np.inf)

    def _blur(
        self,
        encoder: GPUCommandEncoder,
        program: Program,
        vertical: int,
        source: GPUTexture,
        target: dict[str, Any],
        light: int,
    ) -> None:
        render_pass = encoder.begin_render_pass(
            color_attachments=[target], **self._stopwatch.around("shadow blur")
        )
        render_pass.set_pipeline(program.pipeline({"VERTICAL": vertical}, targets=[MOMENTS]))
        resources = {
            "lights": {"buffer": self.lights},
            "source": source.create_view(dimension="2d-array"),
        }
        render_pass.set_bind_group(0, program.bind(resources))
        render_pass.draw(3, 1, 0, light)
        render_pass.end()

    def _layers(self, kind: str, count: int) -> GPUTexture:
        return self._device.create_texture(
            size=(MAP_SIZE, MAP_SIZE, count), format=kind, usage=USAGE
        )


def _target(texture: GPUTexture, layer: int, clear: float = 0.0) -> dict[str, Any]:
    view = texture.create_view(dimension="2d", base_array_layer=layer, array_layer_count=1)
    return {
        "view": view,
        "load_op": "clear",
        "store_op": "store",
        "clear_value": (clear, clear, clear, clear),
    }
