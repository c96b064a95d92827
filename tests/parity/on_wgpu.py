"""Kernels on wgpu: the generated WGSL, and the dispatch that runners of SPIR-V share."""

from __future__ import annotations

import re

import numpy as np
import wgpu
from rows import Runner, generated

from codegen.kernels import WORKGROUP
from codegen.signatures import FLOATS


class WgpuRunner(Runner):
    """Dispatches kernels whose resources have the given binding numbers, by name."""

    def __init__(self, device, bindings):
        self.device, self.bindings, self.pipelines = device, bindings, {}

    def stage(self, signature):
        """Return module and entry point of a function as wgpu's description of a compute stage."""
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
            resources[f"{name}_sampler"] = self.device.create_sampler(**texture.sampler)
        pipeline = self._pipeline(signature)
        group = self.device.create_bind_group(
            layout=pipeline.get_bind_group_layout(0),
            entries=[
                {"binding": self.bindings[name], "resource": resource}
                for name, resource in resources.items()
            ],
        )
        encoder = self.device.create_command_encoder()
        work = encoder.begin_compute_pass()
        work.set_pipeline(pipeline)
        work.set_bind_group(0, group)
        work.dispatch_workgroups(len(rows) // WORKGROUP)
        work.end()
        self.device.queue.submit([encoder.finish()])
        data = self.device.queue.read_buffer(outputs)
        return np.frombuffer(data, dtype=np.float32).reshape(len(rows), width)

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
    """Return the name of a function's generated kernel."""
    return signature.name.replace("skin_", "run_", 1)


class Wgsl(WgpuRunner):
    """The generated kernels, all in one module."""

    def __init__(self, device):
        text = generated("kernels.wgsl")
        variables = re.findall(r"@binding\((\d+)\) @group\(0\) var(?:<[^>]*>)? (\w+?)_0 :", text)
        super().__init__(device, {name: int(binding) for binding, name in variables})
        self.module = device.create_shader_module(code=text)

    def stage(self, signature):
        return {"module": self.module, "entry_point": entry_point(signature)}
