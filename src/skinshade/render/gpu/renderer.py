"""Frames on a GPU: depth, skin, the sum over samples, and what a screen shows."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeVar

import numpy as np
import wgpu
from numpy.typing import NDArray

from ..._core.arrays import ImageArray
from ..._core.errors import BackendError
from ..._core.progress import Progress, silent
from ...gpu.device import open_device
from ...gpu.timing import Stopwatch
from ...scene import Camera, Scene
from ..prepared import PreparedScene
from ..renderer import MULTISAMPLES, Renderer, RenderSettings, sample_offsets, tone_of
from .programs import open_program
from .records import frame_params
from .resources import Resources
from .shadows import Shadows
from .skin_pass import SkinPass
from .targets import LIGHT, RESOLVED, SHOWN, Targets

__all__ = ["GpuRenderer"]

Result = TypeVar("Result")
STAGES = {"sum": 0, "linear": 1, "srgb": 2, "filmic": 3}
TEXEL_BYTES = {LIGHT: 16, SHOWN: 4}


class GpuRenderer(Renderer):
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
        self.scene = scene
        self.device = open_device(adapter, software=software)
        self.prepared = PreparedScene(scene, progress)
        self._progress = progress
        self._stopwatch = Stopwatch(self.device)
        self._timings_ms: dict[str, list[float]] = {}
        self._resources = Resources(self.device, self.prepared)
        self._skin = SkinPass(self._resources, Shadows(self._resources, self._stopwatch))
        self._present = open_program(self.device, "present_pass")
        self._targets = Targets(self.device, (1, 1))
        self._groups: dict[str, wgpu.GPUBindGroup] = {}

    @property
    def place(self) -> str:
        """The adapter's name."""
        return str(self.device.adapter.info["device"])

    @property
    def timings_ms(self) -> dict[str, list[float]]:
        """Time of every pass so far, ms, by its name."""
        return self._timings_ms

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

        def pictures() -> list[ImageArray]:
            found = []
            for way in ways:
                self._draw(camera, size, samples, way, "linear")
                found.append(np.frombuffer(self._read(self._targets.linear), dtype=np.float32))
            return [each.reshape(size[1], size[0], 4) for each in found]

        return self._guarded(pictures)

    def draw_shown(
        self, camera: Camera, size: tuple[int, int], samples: int, way: RenderSettings
    ) -> NDArray[np.uint8]:
        """Return display values in eight bits, through the tone curve on the device.

        Raises
        ------
        BackendError
            If the device is lost or out of memory.
        """

        def picture() -> NDArray[np.uint8]:
            self._draw(camera, size, samples, way, tone_of(self.scene, way)[0])
            shown = np.frombuffer(self._read(self._targets.shown), dtype=np.uint8)
            return np.ascontiguousarray(shown.reshape(size[1], size[0], 4)[..., :3])

        return self._guarded(picture)

    def _guarded(self, work: Callable[[], Result]) -> Result:
        self.prepared.prepare()
        try:
            return work()
        except (wgpu.GPUError, MemoryError) as error:
            reason = str(error).strip().splitlines()[0] if str(error).strip() else "out of memory"
            raise BackendError(f"backend gpu: {self.place} failed ({reason}); use cpu") from None

    def _draw(
        self,
        camera: Camera,
        size: tuple[int, int],
        samples: int,
        way: RenderSettings,
        tone: str,
    ) -> None:
        """Draw a picture into the target of linear light, or of what is shown."""
        if self._targets.size != size:
            self._targets, self._groups = Targets(self.device, size), {}
        targets = self._targets
        multisampled = way.antialiasing == "multisampling"
        offsets = [(0.5, 0.5)] if multisampled else sample_offsets(samples, way.seed)
        exposure = tone_of(self.scene, way)[1]
        light = targets.resolved if multisampled else targets.sample
        for index, offset in enumerate(offsets):
            self._progress("shading", index / len(offsets))
            record = frame_params(
                self.prepared,
                camera,
                size,
                samples=len(offsets),
                offset=offset,
                exposure=exposure,
            )
            self._resources.write_frame(record)
            self._sample(way, MULTISAMPLES if multisampled else 1)
            if len(offsets) > 1:
                light = self._sum(index)
                self._keep_time()  # where passes are timed it waits: one sample is under way
        self._progress("shading", 1.0)
        linear = tone == "linear"
        target, kind = (targets.linear, LIGHT) if linear else (targets.shown, SHOWN)
        environment = self.scene.environment
        behind = int(environment is not None and environment.visible)
        encoder = self.device.create_command_encoder()
        self._present_pass(encoder, light, light, target, kind, tone, behind)
        self.device.queue.submit([encoder.finish()])
        self._keep_time()

    def _sample(self, way: RenderSettings, samples: int) -> None:
        """Draw depth, then skin where it is seen."""
        targets = self._targets
        encoder = self.device.create_command_encoder()
        depth = {
            "view": targets.depth(samples).create_view(),
            "depth_load_op": "clear",
            "depth_store_op": "store",
            "depth_clear_value": 1.0,
        }
        group = self._skin.group(way)
        work = encoder.begin_render_pass(
            color_attachments=[], depth_stencil_attachment=depth, **self._stopwatch.around("depth")
        )
        self._draw_body(work, self._skin.depth_pipeline(samples), group)
        colour: dict[str, Any] = {
            "view": (targets.multisampled if samples > 1 else targets.sample).create_view(),
            "load_op": "clear",
            "store_op": "discard" if samples > 1 else "store",
            "clear_value": (0.0, 0.0, 0.0, 0.0),
        }
        if samples > 1:
            colour["resolve_target"] = targets.resolved.create_view()
        work = encoder.begin_render_pass(
            color_attachments=[colour],
            depth_stencil_attachment={**depth, "depth_load_op": "load"},
            **self._stopwatch.around("skin"),
        )
        kind = RESOLVED if samples > 1 else LIGHT
        self._draw_body(work, self._skin.pipeline(way, kind, samples), group)
        self.device.queue.submit([encoder.finish()])

    def _draw_body(
        self,
        work: wgpu.GPURenderPassEncoder,
        pipeline: wgpu.GPURenderPipeline,
        group: wgpu.GPUBindGroup,
    ) -> None:
        work.set_pipeline(pipeline)
        work.set_bind_group(0, group)
        work.set_vertex_buffer(0, self._resources.vertices)
        work.set_index_buffer(self._resources.indices, "uint32")
        work.draw_indexed(self._resources.corner_count)
        work.end()

    def _sum(self, index: int) -> wgpu.GPUTexture:
        """Add a sample to the sum of those before it, and return the sum."""
        targets = self._targets
        before, after = targets.sums[index % 2], targets.sums[1 - index % 2]
        encoder = self.device.create_command_encoder()
        if index == 0:  # the sum of none
            self._cleared(encoder, before)
        self._present_pass(encoder, targets.sample, before, after, LIGHT, "sum", 0)
        self.device.queue.submit([encoder.finish()])
        return after

    @staticmethod
    def _cleared(encoder: wgpu.GPUCommandEncoder, target: wgpu.GPUTexture) -> None:
        colour = {"view": target.create_view(), "load_op": "clear", "store_op": "store"}
        encoder.begin_render_pass(color_attachments=[colour]).end()

    def _present_pass(
        self,
        encoder: wgpu.GPUCommandEncoder,
        light: wgpu.GPUTexture,
        before: wgpu.GPUTexture,
        target: wgpu.GPUTexture,
        kind: str,
        stage: str,
        behind: int,
    ) -> None:
        colour = {"view": target.create_view(), "load_op": "clear", "store_op": "store"}
        name = "sum" if stage == "sum" else "background and tone"
        work = encoder.begin_render_pass(color_attachments=[colour], **self._stopwatch.around(name))
        constants = {"STAGE": STAGES[stage], "ENVIRONMENT": behind}
        work.set_pipeline(self._present.pipeline(constants, targets=[kind]))
        work.set_bind_group(0, self._present_group(light, before))
        work.draw(3)
        work.end()

    def _present_group(self, light: wgpu.GPUTexture, before: wgpu.GPUTexture) -> wgpu.GPUBindGroup:
        key = f"{id(light)} {id(before)}"
        if key not in self._groups:
            self._groups[key] = self._present.bind(
                {
                    "frame_block": {"buffer": self._resources.frame_block},
                    "light_texels": light.create_view(),
                    "sum_texels": before.create_view(),
                    "sky_texels": self._resources.sky.create_view(),
                }
            )
        return self._groups[key]

    def _keep_time(self) -> None:
        for name, times in self._stopwatch.read_ms().items():
            self._timings_ms.setdefault(name, []).extend(times)

    def _read(self, texture: wgpu.GPUTexture) -> bytes:
        width, height = self._targets.size
        row = TEXEL_BYTES[texture.format] * width
        return bytes(
            self.device.queue.read_texture(
                {"texture": texture},
                {"bytes_per_row": row, "rows_per_image": height},
                (width, height, 1),
            )
        )
