"""HLSL by the DirectX shader compiler: kernels as SPIR-V on wgpu, and pixel shaders as DXIL."""

from __future__ import annotations

import re

import dxc
from on_wgpu import WgpuRunner, entry_point
from rows import HLSL, call, parts, places, texture_names

from gpu_device import absent
from skinshade.codegen.build import GENERATED
from skinshade.codegen.compiler import LIBRARY
from skinshade.codegen.kernels import kernel_source
from skinshade.codegen.signatures import signatures

SOURCES = {"commented": ("skin.slang", LIBRARY), "generated": ("skin.hlsl", GENERATED)}
"""What a user of HLSL may include, and its folder."""
GLOBAL = re.compile(r"^(?:RW)?(?:StructuredBuffer|Texture2D|SamplerState)\S* (\w+);", re.MULTILINE)
PIXEL = """#include "{include}"
{globals}
float4 main(float4 position : SV_Position, nointerpolation float4 given[16] : GIVEN) : SV_Target
{{
    {type} result = {call};
    return {first};
}}
"""


class Hlsl(WgpuRunner):
    """The kernels as they are written before their translation, around either source."""

    def __init__(self, device, source):
        super().__init__(device, places())
        include, folder = SOURCES[source]
        text = kernel_source(signatures()).replace("skin.slang", include)
        text = GLOBAL.sub(lambda f: f"[[vk::binding({self.places[f[1]]}, 0)]] {f[0]}", text)
        entries = [entry_point(each) for each in signatures()]
        flags = ["-spirv", "-T", "cs_6_0", "-E"]
        found = compiled([(text, folder, [*flags, entry]) for entry in entries])
        self.compiled = dict(zip(entries, found, strict=True))

    def stage(self, signature):
        entry = entry_point(signature)
        code, said = self.compiled[entry]
        assert code, said
        return {"module": self.device.create_shader_module(code=code), "entry_point": entry}


def compiled(jobs):
    """Return what `dxc.compiled` does where the compiler is there."""
    if not dxc.LIBRARY.is_file():
        absent("no DirectX shader compiler; see tools/language_tools.py")
    try:
        return dxc.compiled(jobs)
    except OSError as error:
        absent(f"the DirectX shader compiler does not run: {error}")


def pixel_text(signature, source):
    """A pixel shader that calls one function, as a game's would."""
    include, _ = SOURCES[source]
    names = texture_names([signature])
    return PIXEL.format(
        include=include,
        globals="\n".join(f"Texture2D<float4> {n}; SamplerState {n}_sampler;" for n in names),
        type=signature.returns,
        call=call(signature, HLSL, lambda index: f"given[{index // 4}][{index % 4}]"),
        first=parts(signature)[0],
    )
