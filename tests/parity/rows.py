"""Running one function of the shader library on rows of numbers, on a real driver."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from importlib.resources import files

import numpy as np
import wgpu

from skinshade.codegen.kernels import WIDTHS, WORKGROUP, row_length
from skinshade.codegen.signatures import FLOATS


@dataclass
class Runner:
    """A device with the kernels of every function."""

    device: object
    module: object
    pipelines: dict = field(default_factory=dict)

    @classmethod
    def on(cls, device):
        text = files("skinshade.shaders").joinpath("generated/kernels.wgsl").read_text("utf-8")
        return cls(device, device.create_shader_module(code=text))

    def __call__(self, signature, values, tables=None):
        """Return (N, ...) of a function, given (N, ...) by parameter name and tables by theirs.

        A table is its texels (H, W, 3), its four axes where it has them, and how it is sampled.
        """
        count = len(next(iter(values.values())))
        padded = -(-count // WORKGROUP) * WORKGROUP
        rows, columns = [], {}
        for parameter in signature.parameters:
            if parameter.kind in ("lut", "tex2d"):
                texels, axes, sampled = tables[parameter.name]
                columns[parameter.name] = texels, sampled
            if parameter.kind == "lut":
                rows.append(np.tile(np.asarray(axes, dtype=np.float64), (count, 1)))
            elif parameter.kind != "tex2d":
                flat = np.asarray(values[parameter.name], dtype=np.float64).reshape(count, -1)
                assert flat.shape[1] == WIDTHS[parameter.kind], parameter
                rows.append(flat)
        data = np.zeros((padded, row_length(signature)), dtype=np.float32)
        data[:count] = np.concatenate(rows, axis=1)
        width = FLOATS[signature.returns]
        usage = wgpu.BufferUsage
        inputs = self.device.create_buffer_with_data(data=data, usage=usage.STORAGE)
        outputs = self.device.create_buffer(
            size=4 * padded * width, usage=usage.STORAGE | usage.COPY_SRC
        )
        pipeline = self._pipeline(signature.name)
        entries = self._entries(signature.name, columns, inputs, outputs)
        encoder = self.device.create_command_encoder()
        run = encoder.begin_compute_pass()
        run.set_pipeline(pipeline)
        run.set_bind_group(
            0,
            self.device.create_bind_group(
                layout=pipeline.get_bind_group_layout(0), entries=entries
            ),
        )
        run.dispatch_workgroups(padded // WORKGROUP)
        run.end()
        self.device.queue.submit([encoder.finish()])
        read = np.frombuffer(self.device.queue.read_buffer(outputs), dtype=np.float32)
        result = read.reshape(padded, width)[:count]
        if signature.returns == "float3x3":
            return result.reshape(count, 3, 3)
        return result[:, 0] if width == 1 else result

    def _pipeline(self, name):
        entry = name.replace("skin_", "run_", 1)
        if name not in self.pipelines:
            self.pipelines[name] = self.device.create_compute_pipeline(
                layout="auto", compute={"module": self.module, "entry_point": entry}
            )
        return self.pipelines[name]

    def _entries(self, name, tables, inputs, outputs):
        places = bindings()
        entries = [
            {"binding": places["inputs"], "resource": {"buffer": inputs}},
            {"binding": places["outputs"], "resource": {"buffer": outputs}},
        ]
        for table, (texels, sampled) in tables.items():
            entries.append({"binding": places[table], "resource": self._texture(texels)})
            sampler = self.device.create_sampler(**sampled)
            entries.append({"binding": places[f"{table}_sampler"], "resource": sampler})
        return entries

    def _texture(self, texels):
        height, width, _ = texels.shape
        rgba = np.ones((height, width, 4), dtype=np.float32)
        rgba[..., :3] = texels
        texture = self.device.create_texture(
            size=(width, height, 1),
            format="rgba32float",
            usage=wgpu.TextureUsage.TEXTURE_BINDING | wgpu.TextureUsage.COPY_DST,
        )
        self.device.queue.write_texture(
            {"texture": texture},
            rgba,
            {"bytes_per_row": 16 * width, "rows_per_image": height},
            (width, height, 1),
        )
        return texture.create_view()


def bindings():
    """Binding of every global of the kernels, by name."""
    text = files("skinshade.shaders").joinpath("generated/kernels.wgsl").read_text("utf-8")
    found = re.findall(r"@binding\((\d+)\) @group\(0\) var(?:<[^>]*>)? (\w+?)_0 :", text)
    return {name: int(binding) for binding, name in found}
