"""GPU renderer: passes for depth, skin, the sum over samples, background and tone."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from ..._core.arrays import ImageArray
from ..._core.errors import BackendError
from ..._core.progress import Progress, silent
from ...gpu.device import (
    GPUBindGroup,
    GPUCommandEncoder,
    GPUError,
    GPURenderPassEncoder,
    GPURenderPipeline,
    GPUTexture,
    open_device,
)
from ...gpu.timing import Stopwatch
from ...params.choices import AmbientForm, Antialiasing, PresentStage
from ...scene import Camera, Scene
from ..backend import Renderer
from ..prepare.samples import sample_offsets
from ..prepare.scene import prepare_scene
from ..settings import MULTISAMPLES, RenderSettings
from ..tone import tone_of
from .programs import open_program
from .records import frame_params
from .resources import PartResources, SceneResources
from .shadow_maps import DeviceShadowMaps
from .skin_pass import SkinPass
from .targets import DISPLAY, LIGHT, RESOLVED, Targets

__all__ = ["GpuRenderer"]

Result = TypeVar("Result")
TEXEL_BYTES = {LIGHT: 16, DISPLAY: 4}
PASS_NAMES = {PresentStage.SUM: "sum"}
"""Names of stages of the present pass in timings; other stages are called ``background and tone``."""


class GpuRenderer(Renderer):
    """A scene prepared on a device.

    Parameters
    ----------
    scene
        The scene to draw.
    progress
        Called with the name of the work and the fraction that is done.
    adapter
        Part of an adapter's name; the best adapter if None.
    software
        Accept software adapters.
    ambient
        Form of the ambient light at the vertices.

    Raises
    ------
    BackendError
        If there is no adapter, or it cannot open a device.
    """

    def __init__(
        self,
        scene: Scene,
        progress: Progress = silent,
        adapter: str | None = None,
        software: bool = True,
        ambient: AmbientForm = AmbientForm.STATIC,
    ) -> None:
        self.scene = scene
        self.device = open_device(adapter, software=software)
        self._progress = progress
        self._stopwatch = Stopwatch(self.device)
        self._timings_ms: dict[str, list[float]] = {}
        shadow_maps = DeviceShadowMaps(
            self.device, scene.material.params.shadow_filter_width_mm, self._stopwatch
        )
        self.prepared = self._guarded(
            lambda: prepare_scene(scene, progress, shadow_maps.rasterize, ambient)
        )
        self._shared = SceneResources(self.device, self.prepared)
        self._parts = [PartResources(self._shared, part) for part in self.prepared.parts]
        self._passes = [SkinPass(resources, shadow_maps) for resources in self._parts]
        self._present = open_program(self.device, "present_pass")
        self._targets = Targets(self.device, (1, 1))
        self._groups: dict[tuple[int, int], GPUBindGroup] = {}

    @property
    def device_name(self) -> str:
        """Name of the adapter."""
        return str(self.device.adapter.info["device"])

    @property
    def timings_ms(self) -> dict[str, list[float]]:
        """Times of all passes so far, ms, by the name of the pass."""
        return self._timings_ms

    def draw_many(
        self,
        camera: Camera,
        size: tuple[int, int],
        samples: int,
        settings: Sequence[RenderSettings],
    ) -> list[ImageArray]:
        """Draw one view with several settings.

        Raises
        ------
        BackendError
            If the device is lost or out of memory.
        """

        def images() -> list[ImageArray]:
            drawn = []
            for setting in settings:
                self._draw(camera, size, samples, setting, PresentStage.LINEAR)
                drawn.append(np.frombuffer(self._read(self._targets.linear), dtype=np.float32))
            return [image.reshape(size[1], size[0], 4) for image in drawn]

        return self._guarded(images)

    def draw_display(
        self,
        camera: Camera,
        size: tuple[int, int],
        samples: int,
        settings: RenderSettings,
    ) -> NDArray[np.uint8]:
        """Return display values in eight bits; the tone curve runs on the device.

        Raises
        ------
        BackendError
            If the device is lost or out of memory.
        """

        def image() -> NDArray[np.uint8]:
            stage = PresentStage(tone_of(self.scene, settings)[0])
            self._draw(camera, size, samples, settings, stage)
            data = np.frombuffer(self._read(self._targets.display), dtype=np.uint8)
            return np.ascontiguousarray(data.reshape(size[1], size[0], 4)[..., :3])

        return self._guarded(image)

    def _guarded(self, work: Callable[[], Result]) -> Result:
        """Return the result of `work`; an error of the device becomes a BackendError."""
        try:
            return work()
        except (GPUError, MemoryError) as error:
            lines = str(error).strip().splitlines() or ["out of memory"]
            raise BackendError(
                f"backend gpu: {self.device_name} failed ({lines[0]}); use cpu"
            ) from None

    def _draw(
        self,
        camera: Camera,
        size: tuple[int, int],
        samples: int,
        settings: RenderSettings,
        stage: PresentStage,
    ) -> None:
        """Draw a picture into the target of its stage: linear light or display values."""
        if self._targets.size != size:
            self._targets, self._groups = Targets(self.device, size), {}
        targets = self._targets
        multisampled = settings.antialiasing == Antialiasing.MULTISAMPLING
        offsets = [(0.5, 0.5)] if multisampled else sample_offsets(samples, settings.seed)
        exposure = tone_of(self.scene, settings)[1]
        light = targets.resolved if multisampled else targets.sample
        for index, offset in enumerate(offsets):
            self._progress("shading", index / len(offsets))
            for resources in self._parts:
                frame = frame_params(
                    self.prepared,
                    resources.part,
                    camera,
                    size,
                    samples=len(offsets),
                    offset=offset,
                    exposure=exposure,
                )
                resources.write_frame(frame)
            self._draw_sample(settings, MULTISAMPLES if multisampled else 1)
            if len(offsets) > 1:
                light = self._add_sample(index)
                # Where passes are timed, this call waits until the device has drawn the sample.
                self._read_times()
        self._progress("shading", 1.0)
        linear = stage == PresentStage.LINEAR
        target, kind = (targets.linear, LIGHT) if linear else (targets.display, DISPLAY)
        environment = self.scene.environment
        visible = int(environment is not None and environment.visible)
        encoder = self.device.create_command_encoder()
        self._present_pass(encoder, light, light, target, kind, stage, visible)
        self.device.queue.submit([encoder.finish()])
        self._read_times()

    def _draw_sample(self, settings: RenderSettings, samples: int) -> None:
        """Draw the depth of opaque parts, then all parts where they are visible."""
        targets = self._targets
        encoder = self.device.create_command_encoder()
        depth = {
            "view": targets.depth(samples).create_view(),
            "depth_load_op": "clear",
            "depth_store_op": "store",
            "depth_clear_value": 1.0,
        }
        render_pass = encoder.begin_render_pass(
            color_attachments=[], depth_stencil_attachment=depth, **self._stopwatch.around("depth")
        )
        for index, part in enumerate(self.prepared.parts):
            if part.opacity is None:
                pipeline = self._passes[index].depth_pipeline(samples)
                self._draw_part(render_pass, index, pipeline, settings)
        render_pass.end()
        colour: dict[str, Any] = {
            "view": (targets.multisampled if samples > 1 else targets.sample).create_view(),
            "load_op": "clear",
            "store_op": "discard" if samples > 1 else "store",
            "clear_value": (0.0, 0.0, 0.0, 0.0),
        }
        if samples > 1:
            colour["resolve_target"] = targets.resolved.create_view()
        render_pass = encoder.begin_render_pass(
            color_attachments=[colour],
            depth_stencil_attachment={**depth, "depth_load_op": "load"},
            **self._stopwatch.around("skin"),
        )
        kind = RESOLVED if samples > 1 else LIGHT
        for index, part in enumerate(self.prepared.parts):
            pipeline = self._passes[index].pipeline(part.settings(settings), kind, samples)
            self._draw_part(render_pass, index, pipeline, settings)
        render_pass.end()
        self.device.queue.submit([encoder.finish()])

    def _draw_part(
        self,
        render_pass: GPURenderPassEncoder,
        index: int,
        pipeline: GPURenderPipeline,
        settings: RenderSettings,
    ) -> None:
        part = self.prepared.parts[index]
        render_pass.set_pipeline(pipeline)
        render_pass.set_bind_group(0, self._passes[index].group(part.settings(settings)))
        render_pass.set_vertex_buffer(0, self._shared.vertices)
        render_pass.set_index_buffer(self._shared.indices, "uint32")
        render_pass.draw_indexed(3 * part.face_count, 1, 3 * part.first_face)

    def _add_sample(self, index: int) -> GPUTexture:
        """Add a sample to the sum of the previous samples, and return the new sum."""
        targets = self._targets
        previous, total = targets.sums[index % 2], targets.sums[1 - index % 2]
        encoder = self.device.create_command_encoder()
        if index == 0:
            colour = {"view": previous.create_view(), "load_op": "clear", "store_op": "store"}
            encoder.begin_render_pass(color_attachments=[colour]).end()
        self._present_pass(encoder, targets.sample, previous, total, LIGHT, PresentStage.SUM, 0)
        self.device.queue.submit([encoder.finish()])
        return total

    def _present_pass(
        self,
        encoder: GPUCommandEncoder,
        light: GPUTexture,
        previous: GPUTexture,
        target: GPUTexture,
        kind: str,
        stage: PresentStage,
        environment: int,
    ) -> None:
        colour = {"view": target.create_view(), "load_op": "clear", "store_op": "store"}
        name = PASS_NAMES.get(stage, "background and tone")
        render_pass = encoder.begin_render_pass(
            color_attachments=[colour], **self._stopwatch.around(name)
        )
        constants = {"STAGE": stage.number, "ENVIRONMENT": environment}
        render_pass.set_pipeline(self._present.pipeline(constants, targets=[kind]))
        render_pass.set_bind_group(0, self._present_group(light, previous))
        render_pass.draw(3)
        render_pass.end()

    def _present_group(self, light: GPUTexture, previous: GPUTexture) -> GPUBindGroup:
        key = id(light), id(previous)  # the textures live as long as the targets
        if key not in self._groups:
            self._groups[key] = self._present.bind(
                {
                    "frame_block": {"buffer": self._parts[0].frame_block},
                    "light_texels": light.create_view(),
                    "sum_texels": previous.create_view(),
                    "sky_texels": self._shared.sky.create_view(),
                }
            )
        return self._groups[key]

    def _read_times(self) -> None:
        for name, times in self._stopwatch.read_ms().items():
            self._timings_ms.setdefault(name, []).extend(times)

    def _read(self, texture: GPUTexture) -> bytes:
        width, height = self._targets.size
        row = TEXEL_BYTES[texture.format] * width
        return bytes(
            self.device.queue.read_texture(
                {"texture": texture},
                {"bytes_per_row": row, "rows_per_image": height},
                (width, height, 1),
            )
        )
