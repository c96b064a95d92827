"""skin.vulkan.glsl, which the reference compiler makes SPIR-V of, on wgpu."""

from __future__ import annotations

import subprocess
import tempfile
from pathlib import Path

import numpy as np
from glsl_text import compute_text
from on_wgpu import WgpuRunner
from rows import Texture, generated, places, texture_names

from gpu_device import tool_or_skip
from skinshade.codegen.signatures import signatures

UNUSED = Texture(np.zeros((1, 1, 4), dtype=np.float32), {})


class VulkanGlsl(WgpuRunner):
    """One module for all functions: a start of the compiler takes longer than its work.

    A constant that is known when the pipeline is made chooses between them.
    """

    def __init__(self, device):
        super().__init__(device, places())
        functions = signatures()
        self.numbers = {each.name: number for number, each in enumerate(functions)}
        self.names = texture_names(functions)
        self.module = device.create_shader_module(code=spirv(self._text(functions)))

    def _text(self, functions):
        declared = ["layout(constant_id = 0) const int chosen = -1;"]
        for name in self.names:
            sampler = f"{name}_sampler"
            declared += [
                f"layout(binding = {self.places[name]}) uniform texture2D {name};",
                f"layout(binding = {self.places[sampler]}) uniform sampler {sampler};",
            ]
        cases = [
            f"case {self.numbers[each.name]}: run_{each.name}(row); break;" for each in functions
        ]
        return compute_text(
            functions,
            generated("skin.vulkan.glsl"),
            version=450,
            declared="\n".join(declared),
            main=" ".join(["switch (chosen) {", *cases, "}"]),
            combined=False,
        )

    def stage(self, signature):
        chosen = {"0": self.numbers[signature.name]}
        return {"module": self.module, "entry_point": "main", "constants": chosen}

    def run(self, signature, rows, textures):
        # The module names every texture, so every pipeline wants all of them bound.
        return super().run(signature, rows, {**dict.fromkeys(self.names, UNUSED), **textures})


def spirv(text):
    """What glslangValidator makes of a compute shader for Vulkan."""
    program = tool_or_skip("glslangValidator")
    with tempfile.TemporaryDirectory() as folder:
        source, binary = Path(folder, "kernels.comp"), Path(folder, "kernels.spv")
        source.write_text(text, encoding="utf-8")
        command = [program, "-V", str(source), "-o", str(binary)]
        done = subprocess.run(command, capture_output=True, text=True)
        assert done.returncode == 0, done.stdout
        return binary.read_bytes()
