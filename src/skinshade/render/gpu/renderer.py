"""One pass over the body for each sample of a pixel, on a GPU."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from importlib.resources import files
from typing import Any

import numpy as np
import wgpu

from ..._core.arrays import ImageArray
from ..._core.errors import BackendError
from ..._core.progress import Progress, silent
from ...gpu.bindings import bind_points, override_ids
from ...gpu.device import open_device
from ...gpu.textures import buffer
from ...gpu.timing import Stopwatch
from ...scene import Camera, Scene
from ..prepared import PreparedScene
from ..renderer import DEBUG_VIEWS, SHADINGS, TIERS, RenderSettings, sample_offsets
from .resources import ATTRIBUTES, Resources

__all__ = ["GpuRenderer"]

COLOUR, DEPTH = "rgba32float", "depth32float"


class GpuRenderer:
    """A scene made ready on a device.

    Parameters
    ----------
    scene
        What is drawn.
    progress
        Called with what is being done and how far it is.
    adapter
        Part of an adapter's name; the best one if None.
    software
        Whether an adapter that is no hardware will do.

    Raises
    ------
    BackendError
        If there is no adapter, or it gives no device.
    """

    def __init__(
        self,
        scene: Scene,
        progress: Progress = silent,
        adapter: str | None = None,
        software: bool = True,
    ) -> None:
        self.device = open_device(adapter, software=software)
        self.place = str(self.device.adapter.info["device"])
        self.scene = scene
        self.prepared = PreparedScene(scene, progress)
        self.resources = Resources(self.device, self.prepared)
        self._progress = progress
        self.timings_ms: dict[str, list[float]] = {}
        self._pipelines: dict[tuple[int, ...], wgpu.GPURenderPipeline] = {}
        self._targets: dict[tuple[int, int], list[wgpu.GPUTexture]] = {}

    def draw(
        self, camera: Camera, size: tuple[int, int], samples: int, settings: RenderSettings
    ) -> ImageArray:
        """Return (H, W, 4) linear light and coverage."""
        return self.draw_each(camera, size, samples, [settings])[0]

    def draw_each(
        self,
        camera: Camera,
        size: tuple[int, int],
        samples: int,
        ways: Sequence[RenderSettings],
    ) -> list[ImageArray]:
        """Return a picture for each way to shade.

        Raises
        ------
        BackendError
            If the device is lost or out of memory.
        """
        self.prepared.prepare()
        try:
            return self._drawn(camera, size, samples, ways)
        except (wgpu.GPUError, MemoryError) as error:
            reason = str(error).strip().splitlines()[0] if str(error).strip() else "out of memory"
            raise BackendError(f"backend gpu: {self.place} failed ({reason}); use cpu") from None

    def _drawn(
        self,
        camera: Camera,
        size: tuple[int, int],
        samples: int,
        ways: Sequence[RenderSettings],
    ) -> list[ImageArray]:
        background = self.prepared.background(camera, size)
        offsets = sample_offsets(samples, ways[0].seed)
        pictures = []
        for number, way in enumerate(ways):
            total = np.zeros((size[1] * size[0], 4))
            for index, offset in enumerate(offsets):
                done = (number * samples + index) / (samples * len(ways))
                self._progress("shading", done)
                total += self._sample(camera, size, samples, offset, way)
            total /= samples
            total[:, :3] += (1.0 - total[:, 3:]) * background
            pictures.append(total.reshape(size[1], size[0], 4).astype(np.float32))
        self._progress("shading", 1.0)
        return pictures

    def _sample(
        self,
        camera: Camera,
        size: tuple[int, int],
        samples: int,
        offset: tuple[float, float],
        way: RenderSettings,
    ) -> ImageArray:
        width, height = size
        frame = self._frame(camera, size, samples, offset)
        self.device.queue.write_buffer(self._frame_buffer, 0, frame.tobytes())
        colour, depth = self._target(size)
        encoder = self.device.create_command_encoder()
        work = encoder.begin_render_pass(
            color_attachments=[
                {
                    "view": colour.create_view(),
                    "load_op": "clear",
                    "store_op": "store",
                    "clear_value": (0.0, 0.0, 0.0, 0.0),
                }
            ],
            depth_stencil_attachment={
                "view": depth.create_view(),
                "depth_load_op": "clear",
                "depth_store_op": "discard",
                "depth_clear_value": 1.0,
            },
            **self._stopwatch.around(),
        )
        pipeline = self._pipeline(way)
        work.set_pipeline(pipeline)
        work.set_bind_group(0, self._bind_group(way.thickness_taps))
        work.set_vertex_buffer(0, self.resources.vertices)
        work.set_index_buffer(self.resources.indices, "uint32")
        work.draw_indexed(self.resources.corner_count)
        work.end()
        self._stopwatch.resolve(encoder)
        self.device.queue.submit([encoder.finish()])
        self.timings_ms.setdefault("skin", []).extend(self._stopwatch.read_ms())
        data = self.device.queue.read_texture(
            {"texture": colour},
            {"bytes_per_row": 16 * width, "rows_per_image": height},
            (width, height, 1),
        )
        return np.frombuffer(data, dtype=np.float32).reshape(-1, 4)

    def _frame(
        self, camera: Camera, size: tuple[int, int], samples: int, offset: tuple[float, float]
    ) -> ImageArray:
        """The record of the pass: the matrix whose pixel centres are the samples, the eye, the sky."""
        matrix = camera.view_projection(size[0] / size[1])
        matrix[0] += matrix[3] * (1.0 - 2.0 * offset[0]) / size[0]
        matrix[1] -= matrix[3] * (1.0 - 2.0 * offset[1]) / size[1]
        record = np.zeros((16, 4), dtype=np.float32)
        record[:4] = matrix
        record[4] = [*camera.position_mm, 1.0 / np.sqrt(samples)]
        if self.scene.environment is not None:
            record[5:14, :3] = self.scene.environment.radiance_sh
        if "normal" in self.prepared.textures:
            record[14, 0] = self.prepared.uv_scale_mm
            record[15, 0] = 1.0
        return record

    @cached_property
    def _stopwatch(self) -> Stopwatch:
        return Stopwatch(self.device)

    @cached_property
    def _frame_buffer(self) -> wgpu.GPUBuffer:
        return buffer(self.device, bytes(16 * 16), wgpu.BufferUsage.STORAGE)

    def _target(self, size: tuple[int, int]) -> list[wgpu.GPUTexture]:
        if size not in self._targets:
            usage = wgpu.TextureUsage.RENDER_ATTACHMENT
            self._targets[size] = [
                self.device.create_texture(
                    size=(*size, 1), format=COLOUR, usage=usage | wgpu.TextureUsage.COPY_SRC
                ),
                self.device.create_texture(size=(*size, 1), format=DEPTH, usage=usage),
            ]
        return self._targets[size]

    @cached_property
    def _text(self) -> str:
        place = files("skinshade.shaders").joinpath("generated/skin_pass.wgsl")
        return place.read_text(encoding="utf-8")

    @cached_property
    def _module(self) -> wgpu.GPUShaderModule:
        return self.device.create_shader_module(code=self._text)

    @cached_property
    def _layout(self) -> wgpu.GPUBindGroupLayout:
        """Every bind point of the text, whether a variant uses it or not."""
        entries = []
        stages = wgpu.ShaderStage.FRAGMENT | wgpu.ShaderStage.VERTEX
        for name, point in bind_points(self._text).items():
            entry: dict[str, Any] = {"binding": point.binding, "visibility": stages}
            if name.endswith("_block"):
                entry["buffer"] = {"type": "uniform"}
            elif point.kind.startswith("array"):
                entry["buffer"] = {"type": "read-only-storage"}
            elif point.kind == "sampler":
                entry["sampler"] = {"type": "filtering"}
            else:
                entry["texture"] = {
                    "sample_type": "unfilterable-float" if name == "depths" else "float",
                    "view_dimension": "2d-array" if "array" in point.kind else "2d",
                }
            entries.append(entry)
        return self.device.create_bind_group_layout(entries=entries)

    def _pipeline(self, way: RenderSettings) -> wgpu.GPURenderPipeline:
        values = {
            "SHADING": SHADINGS.index(way.shading),
            "TIER": TIERS.index(way.tier),
            "VIEW": 0 if way.debug_view is None else 1 + DEBUG_VIEWS.index(way.debug_view),
            "TAPS": way.thickness_taps,
            "LIGHTS": len(self.scene.lights),
            "ENVIRONMENT": int(self.scene.environment is not None),
        }
        if tuple(values.values()) not in self._pipelines:
            self._pipelines[tuple(values.values())] = self._made_pipeline(values)
        return self._pipelines[tuple(values.values())]

    def _made_pipeline(self, values: dict[str, int]) -> wgpu.GPURenderPipeline:
        constants = {number: values[name] for name, number in override_ids(self._text).items()}
        attributes = [
            {"shader_location": index, "offset": 16 * index, "format": "float32x4"}
            for index in range(ATTRIBUTES)
        ]
        return self.device.create_render_pipeline(
            layout=self.device.create_pipeline_layout(bind_group_layouts=[self._layout]),
            vertex={
                "module": self._module,
                "entry_point": "vertex_main",
                "buffers": [{"array_stride": 16 * ATTRIBUTES, "attributes": attributes}],
                "constants": constants,
            },
            fragment={
                "module": self._module,
                "entry_point": "fragment_main",
                "targets": [{"format": COLOUR}],
                "constants": constants,
            },
            primitive={"topology": "triangle-list", "cull_mode": "none"},
            depth_stencil={
                "format": DEPTH,
                "depth_write_enabled": True,
                "depth_compare": "less",
            },
        )

    def _bind_group(self, taps: int) -> wgpu.GPUBindGroup:
        if taps not in self._bind_groups:
            found = self._bound(taps)
            entries = [
                {"binding": point.binding, "resource": found[name]}
                for name, point in bind_points(self._text).items()
            ]
            self._bind_groups[taps] = self.device.create_bind_group(
                layout=self._layout, entries=entries
            )
        return self._bind_groups[taps]

    @cached_property
    def _bind_groups(self) -> dict[int, wgpu.GPUBindGroup]:
        return {}

    def _bound(self, taps: int) -> dict[str, Any]:
        made = self.resources
        linear = {"mag_filter": "linear", "min_filter": "linear", "mipmap_filter": "linear"}
        repeat = {"address_mode_u": "repeat", "address_mode_v": "repeat"}
        buffers = {
            "skin_block": made.skin_block,
            "scatter_block": made.scatter_block,
            "frames": self._frame_buffer,
            "lights": made.lights,
            "taps": made.taps(taps),
        }
        layers = {"preconvolved": made.preconvolved, "depths": made.depths}
        return {
            **{name: {"buffer": each} for name, each in buffers.items()},
            **{name: each.create_view() for name, each in (made.tables | made.maps).items()},
            **{name: each.create_view(dimension="2d-array") for name, each in layers.items()},
            "table_sampler": self.device.create_sampler(mag_filter="linear", min_filter="linear"),
            "map_sampler": self.device.create_sampler(**linear, **repeat),
            "sky_sampler": self.device.create_sampler(
                mag_filter="linear", min_filter="linear", address_mode_u="repeat"
            ),
        }
