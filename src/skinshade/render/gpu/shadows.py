"""Depth maps of every light, drawn on the device once for a scene."""

from __future__ import annotations

from functools import cached_property

import wgpu

from ...gpu.program import Program
from ...gpu.timing import Stopwatch
from ..cpu.shadow_map import NOWHERE_MM
from ..light_view import MAP_SIZE
from .programs import open_program
from .resources import ATTRIBUTES, Resources

__all__ = ["Shadows"]

DEPTHS, MOMENTS = "r32float", "rg32float"
USAGE = wgpu.TextureUsage.RENDER_ATTACHMENT | wgpu.TextureUsage.TEXTURE_BINDING


class Shadows:
    """What lights see, as textures for the skin pass; each is drawn when it is first asked for.

    Parameters
    ----------
    resources
        The scene's body and lights.
    stopwatch
        Times the passes.
    """

    def __init__(self, resources: Resources, stopwatch: Stopwatch) -> None:
        self.resources = resources
        self._stopwatch = stopwatch
        self._device = resources.device

    @cached_property
    def depths(self) -> wgpu.GPUTexture:
        """Two layers a light: what shadows, and the nearest surface; mm."""
        count = self.resources.light_count
        layers = self._layers(DEPTHS, 2 * max(count, 1))
        if not count:
            return layers
        program = open_program(self._device, "shadow_pass")
        group = program.bind({"lights": {"buffer": self.resources.lights}})
        scratch = self._device.create_texture(
            size=(MAP_SIZE, MAP_SIZE, 1), format="depth32float", usage=USAGE
        )
        encoder = self._device.create_command_encoder()
        for layer in range(2 * count):
            pipeline = program.pipeline(
                {"OCCLUDERS": 1 - layer % 2},
                targets=[DEPTHS],
                vertex_floats=4 * ATTRIBUTES,
                depth="less",
            )
            work = encoder.begin_render_pass(
                color_attachments=[self._target(layers, layer, NOWHERE_MM)],
                depth_stencil_attachment={
                    "view": scratch.create_view(),
                    "depth_load_op": "clear",
                    "depth_store_op": "discard",
                    "depth_clear_value": 1.0,
                },
                **self._stopwatch.around("shadow map"),
            )
            work.set_pipeline(pipeline)
            work.set_bind_group(0, group)
            work.set_vertex_buffer(0, self.resources.vertices)
            work.set_index_buffer(self.resources.indices, "uint32")
            work.draw_indexed(self.resources.corner_count, 1, 0, 0, layer // 2)
            work.end()
        self._device.queue.submit([encoder.finish()])
        return layers

    @cached_property
    def moments(self) -> wgpu.GPUTexture:
        """A layer a light: depth and its square from the body's middle, blurred; mm, mm²."""
        count = self.resources.light_count
        layers = self._layers(MOMENTS, max(count, 1))
        if not count:
            return layers
        program = open_program(self._device, "blur_pass")
        half_blurred = self._layers(MOMENTS, 1)
        encoder = self._device.create_command_encoder()
        for light in range(count):
            steps = ((self.depths, half_blurred, 0), (half_blurred, layers, light))
            for vertical, (source, target, layer) in enumerate(steps):
                self._blur(encoder, program, vertical, source, self._target(target, layer), light)
        self._device.queue.submit([encoder.finish()])
        return layers

    def _blur(
        self,
        encoder: wgpu.GPUCommandEncoder,
        program: Program,
        vertical: int,
        source: wgpu.GPUTexture,
        target: dict[str, object],
        light: int,
    ) -> None:
        work = encoder.begin_render_pass(
            color_attachments=[target], **self._stopwatch.around("shadow blur")
        )
        work.set_pipeline(program.pipeline({"VERTICAL": vertical}, targets=[MOMENTS]))
        resources = {
            "lights": {"buffer": self.resources.lights},
            "source": source.create_view(dimension="2d-array"),
        }
        work.set_bind_group(0, program.bind(resources))
        work.draw(3, 1, 0, light)
        work.end()

    def _layers(self, kind: str, count: int) -> wgpu.GPUTexture:
        return self._device.create_texture(
            size=(MAP_SIZE, MAP_SIZE, count), format=kind, usage=USAGE
        )

    @staticmethod
    def _target(texture: wgpu.GPUTexture, layer: int, clear: float = 0.0) -> dict[str, object]:
        view = texture.create_view(dimension="2d", base_array_layer=layer, array_layer_count=1)
        return {
            "view": view,
            "load_op": "clear",
            "store_op": "store",
            "clear_value": (clear, clear, clear, clear),
        }
