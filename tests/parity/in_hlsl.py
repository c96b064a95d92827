"""HLSL by the DirectX shader compiler: kernels as SPIR-V on wgpu, and pixel shaders as DXIL."""

from __future__ import annotations

import re

import dxc
from on_wgpu import WgpuRunner, entry_point
from rows import HLSL, binding_numbers, call, components, texture_names

from codegen.build import GENERATED
from codegen.compiler import LIBRARY
from codegen.kernels import kernel_source
from codegen.signatures import signatures
from gpu_device import absent

SOURCES = {"commented": ("skin.slang", LIBRARY), "generated": ("skin.hlsl", GENERATED)}
"""Files that a user of HLSL may include, with their folders."""
GLOBAL = re.compile(r"^(?:RW)?(?:StructuredBuffer|Texture2D|SamplerState)\S* (\w+);", re.MULTILINE)
PIXEL = """#include "{include}"
{globals}
float4 main(float4 position : SV_Position, nointerpolation float4 values[16] : VALUES) : SV_Target
{{
    {type} result = {call};
    return {first};
}}
"""


class Hlsl(WgpuRunner):
    """The Slang text of the kernels, compiled as HLSL with either source of the library."""

    def __init__(self, device, source):
        super().__init__(device, binding_numbers())
        include, folder = SOURCES[source]
        text = kernel_source(signatures()).replace("skin.slang", include)
        text = GLOBAL.sub(lambda m: f"[[vk::binding({self.bindings[m[1]]}, 0)]] {m[0]}", text)
        entries = [entry_point(signature) for signature in signatures()]
        flags = ["-spirv", "-T", "cs_6_0", "-E"]
        results = compiled([(text, folder, [*flags, entry]) for entry in entries])
        self.results = dict(zip(entries, results, strict=True))

    def stage(self, signature):
        entry = entry_point(signature)
        code, messages = self.results[entry]
        assert code, messages
        return {"module": self.device.create_shader_module(code=code), "entry_point": entry}


def compiled(jobs):
    """Return the results of `dxc.compiled`; call `absent` if the compiler does not run here."""
    if not dxc.LIBRARY.is_file():
        absent("the DirectX shader compiler is not installed; see tools/language_tools.py")
    try:
        return dxc.compiled(jobs)
    except OSError as error:
        absent(f"the DirectX shader compiler does not run: {error}")


def pixel_text(signature, source):
    """Return a pixel shader that calls one function, as a game's shader would."""
    include, _ = SOURCES[source]
    names = texture_names([signature])
    return PIXEL.format(
        include=include,
        globals="\n".join(f"Texture2D<float4> {n}; SamplerState {n}_sampler;" for n in names),
        type=signature.returns,
        call=call(signature, HLSL, lambda index: f"values[{index // 4}][{index % 4}]"),
        first=components(signature)[0],
    )
