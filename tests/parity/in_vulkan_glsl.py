"""skin.vulkan.glsl on wgpu: the reference compiler translates it to SPIR-V."""

from __future__ import annotations

import subprocess
import tempfile
from pathlib import Path

import numpy as np
from glsl_text import compute_text
from on_wgpu import WgpuRunner
from rows import Texture, binding_numbers, generated, texture_names

from codegen.signatures import signatures
from gpu_device import tool_or_skip

UNUSED = Texture(np.zeros((1, 1, 4), dtype=np.float32), {})


class VulkanGlsl(WgpuRunner):
    """One module for all functions, because the compiler takes longer to start than to compile.

    A specialization constant selects the function when the pipeline is created.
    """

    def __init__(self, device):
        super().__init__(device, binding_numbers())
        functions = signatures()
        self.numbers = {function.name: number for number, function in enumerate(functions)}
        self.names = texture_names(functions)
        self.module = device.create_shader_module(code=spirv(self._text(functions)))

    def _text(self, functions):
        declarations = ["layout(constant_id = 0) const int selected = -1;"]
        for name in self.names:
            sampler = f"{name}_sampler"
            declarations += [
                f"layout(binding = {self.bindings[name]}) uniform texture2D {name};",
                f"layout(binding = {self.bindings[sampler]}) uniform sampler {sampler};",
            ]
        cases = [f"case {n}: run_{name}(row); break;" for name, n in self.numbers.items()]
        return compute_text(
            functions,
            generated("skin.vulkan.glsl"),
            version=450,
            declarations="\n".join(declarations),
            main=" ".join(["switch (selected) {", *cases, "}"]),
            combined=False,
        )

    def stage(self, signature):
        constants = {"0": self.numbers[signature.name]}
        return {"module": self.module, "entry_point": "main", "constants": constants}

    def run(self, signature, rows, textures):
        # The module declares every texture, so every pipeline needs all of them bound.
        return super().run(signature, rows, {**dict.fromkeys(self.names, UNUSED), **textures})


def spirv(text):
    """Return the SPIR-V that glslangValidator makes of a compute shader for Vulkan."""
    program = tool_or_skip("glslangValidator")
    with tempfile.TemporaryDirectory() as folder:
        source, binary = Path(folder, "kernels.comp"), Path(folder, "kernels.spv")
        source.write_text(text, encoding="utf-8")
        command = [program, "-V", str(source), "-o", str(binary)]
        done = subprocess.run(command, capture_output=True, text=True)
        assert done.returncode == 0, done.stdout
        return binary.read_bytes()
