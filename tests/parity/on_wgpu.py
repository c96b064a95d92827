"""Kernels on wgpu: those that are generated in WGSL, and the dispatch that SPIR-V shares with them."""

from __future__ import annotations

import re

import numpy as np
import wgpu
from rows import Runner, generated

from skinshade.codegen.kernels import WORKGROUP
from skinshade.codegen.signatures import FLOATS


class WgpuRunner(Runner):
    """Kernels that bind ``places`` by name."""

    def __init__(self, device, places):
        self.device, self.places, self.pipelines = device, places, {}

    def stage(self, signature):
        """Return module and entry point of a function, as wgpu describes a compute stage."""
        raise NotImplementedError

    def run(self, signature, rows, textures):
        width, usage = FLOATS[signature.returns], wgpu.BufferUsage
        inputs = self.device.create_buffer_with_data(data=rows, usage=usage.STORAGE)
        outputs = self.device.create_buffer(
            size=4 * len(rows) * width, usage=usage.STORAGE | usage.COPY_SRC
        )
        resources = {"inputs": {"buffer": inputs}, "outputs": {"buffer": outputs}}
        for name, texture in textures.items():
            resources[name] = self._view(texture.rgba)
            resources[f"{name}_sampler"] = self.device.create_sampler(**texture.sampled)
        pipeline = self._pipeline(signature)
        group = self.device.create_bind_group(
            layout=pipeline.get_bind_group_layout(0),
            entries=[
                {"binding": self.places[name], "resource": each} for name, each in resources.items()
            ],
        )
        encoder = self.device.create_command_encoder()
        work = encoder.begin_compute_pass()
        work.set_pipeline(pipeline)
        work.set_bind_group(0, group)
        work.dispatch_workgroups(len(rows) // WORKGROUP)
        work.end()
        self.device.queue.submit([encoder.finish()])
        read = self.device.queue.read_buffer(outputs)
        return np.frombuffer(read, dtype=np.float32).reshape(len(rows), width)

    def _pipeline(self, signature):
        if signature.name not in self.pipelines:
            self.pipelines[signature.name] = self.device.create_compute_pipeline(
                layout="auto", compute=self.stage(signature)
            )
        return self.pipelines[signature.name]

    def _view(self, rgba):
        height, width, _ = rgba.shape
        texture = self.device.create_texture(
            size=(width, height, 1),
            format="rgba32float",
            usage=wgpu.TextureUsage.TEXTURE_BINDING | wgpu.TextureUsage.COPY_DST,
        )
        layout = {"bytes_per_row": 16 * width, "rows_per_image": height}
        self.device.queue.write_texture({"texture": texture}, rgba, layout, (width, height, 1))
        return texture.create_view()


def entry_point(signature):
    """Name of a function's generated kernel."""
    return signature.name.replace("skin_", "run_", 1)


class Wgsl(WgpuRunner):
    """The generated kernels, all in one module."""

    def __init__(self, device):
        text = generated("kernels.wgsl")
        found = re.findall(r"@binding\((\d+)\) @group\(0\) var(?:<[^>]*>)? (\w+?)_0 :", text)
        super().__init__(device, {name: int(binding) for binding, name in found})
        self.module = device.create_shader_module(code=text)

    def stage(self, signature):
        return {"module": self.module, "entry_point": entry_point(signature)}
