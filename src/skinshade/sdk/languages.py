"""Shading languages: files in the package, and syntax of declarations and calls."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from .._core.choice import Choice
from ..params.packing import TYPE_NAMES
from ..shading.tables import ENGINE_LUTS

__all__ = ["LANGUAGES", "Language", "ShadingLanguage"]


class Language(Choice):
    """Languages of the shader package."""

    SLANG = "slang"
    HLSL = "hlsl"
    GLSL_VULKAN = "glsl-vulkan"
    GLSL_GL = "glsl-gl"
    GLSL_ES = "glsl-es"
    WGSL = "wgsl"
    METAL = "metal"


@dataclass(frozen=True)
class ShadingLanguage:
    """A language of the shader package.

    Attributes
    ----------
    title
        Name of the language in texts.
    library
        Name of the generated file with all functions; empty where the commented sources are exported.
    suffix
        Suffix of the exported files.
    structs
        Name of the generated file with the constant blocks.
    types
        Names of ``float``, ``float2``, ``float3``, ``float4`` and ``float3x3`` that differ in the language.
    combined
        Whether a texture and its sampler are one object.
    prologue
        Lines that must precede the library.
    checked
        Drivers and compilers with which the tests check the exported files.
    """

    title: str
    library: str
    suffix: str
    structs: str
    types: Mapping[str, str] = field(default_factory=dict)
    combined: bool = False
    prologue: str = ""
    checked: str = ""

    def type_of(self, neutral: str) -> str:
        """Return the name of a `neutral` type, such as ``float3``, in the language."""
        return self.types.get(neutral, neutral)

    def defined(self, kind: str, name: str, value: str) -> str:
        """Return the definition of a local value."""
        if self.suffix == "wgsl":
            return f"let {name} = {value};"
        return f"{self.type_of(kind)} {name} = {value};"

    def lut(self, name: str) -> str:
        """Return the arguments that pass the table `name` to a function."""
        sampler = "" if self.combined else "lut_sampler, "
        return f"{name}_lut, {sampler}scatter_block.{name}_axes"

    def declared(self) -> list[str]:
        """Return the global declarations of the textures, the sampler and the blocks."""
        if self.suffix == "wgsl":
            blocks = ("skin_block : SkinBlock", "scatter_block : ScatterBlock")
            lines = [
                f"@group(1) @binding({i}) var<uniform> {name};" for i, name in enumerate(blocks)
            ]
            lines += [
                f"@group(1) @binding({2 + i}) var {name}_lut : texture_2d<f32>;"
                for i, name in enumerate(ENGINE_LUTS)
            ]
            return [
                *lines,
                f"@group(1) @binding({2 + len(ENGINE_LUTS)}) var lut_sampler : sampler;",
            ]
        if self.suffix == "glsl":
            return self._declared_in_glsl()
        if self.suffix == "metal":
            return []
        lines = [
            "cbuffer SkinUniforms { SkinBlock skin_block; };",
            "cbuffer ScatterUniforms { ScatterBlock scatter_block; };",
        ]
        lines += [f"Texture2D<float4> {name}_lut;" for name in ENGINE_LUTS]
        return [*lines, "SamplerState lut_sampler;"]

    def _declared_in_glsl(self) -> list[str]:
        blocks = (
            ("SkinUniforms", "SkinBlock skin_block"),
            ("ScatterUniforms", "ScatterBlock scatter_block"),
        )
        if self.combined:
            lines = [f"layout(std140) uniform {name} {{ {member}; }};" for name, member in blocks]
            return lines + [f"uniform sampler2D {name}_lut;" for name in ENGINE_LUTS]
        lines = [
            f"layout(std140, set = 1, binding = {i}) uniform {name} {{ {member}; }};"
            for i, (name, member) in enumerate(blocks)
        ]
        lines += [
            f"layout(set = 1, binding = {2 + i}) uniform texture2D {name}_lut;"
            for i, name in enumerate(ENGINE_LUTS)
        ]
        return [
            *lines,
            f"layout(set = 1, binding = {2 + len(ENGINE_LUTS)}) uniform sampler lut_sampler;",
        ]


HIGHEST = "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
"""Precision qualifiers; by default, OpenGL ES reads float textures at low precision."""

LANGUAGES: dict[str, ShadingLanguage] = {
    Language.SLANG: ShadingLanguage(
        "Slang", "", "slang", "blocks.hlsl", checked="executed as WGSL, compiled as all others"
    ),
    Language.HLSL: ShadingLanguage(
        "HLSL (Direct3D 11 and 12)",
        "",
        "hlsl",
        "blocks.hlsl",
        checked="executed through DXC and SPIR-V, compiled to DXIL",
    ),
    Language.GLSL_VULKAN: ShadingLanguage(
        "GLSL for Vulkan",
        "skin.vulkan.glsl",
        "glsl",
        "blocks.glsl",
        TYPE_NAMES["glsl"],
        checked="executed through glslang and SPIR-V",
    ),
    Language.GLSL_GL: ShadingLanguage(
        "GLSL 3.30 and later for OpenGL",
        "skin.gl.glsl",
        "glsl",
        "blocks.glsl",
        TYPE_NAMES["glsl"],
        combined=True,
        checked="executed on OpenGL 3.3 and 4.3",
    ),
    Language.GLSL_ES: ShadingLanguage(
        "GLSL ES 3.00 for WebGL 2 and OpenGL ES 3",
        "skin.gl.glsl",
        "glsl",
        "blocks.glsl",
        TYPE_NAMES["glsl"],
        combined=True,
        prologue=HIGHEST,
        checked="executed in Chromium's WebGL 2",
    ),
    Language.WGSL: ShadingLanguage(
        "WGSL for WebGPU",
        "skin.wgsl",
        "wgsl",
        "blocks.wgsl",
        TYPE_NAMES["wgsl"],
        checked="executed by naga (wgpu) and Tint (Chromium)",
    ),
    Language.METAL: ShadingLanguage(
        "Metal",
        "skin.metal",
        "metal",
        "blocks.metal",
        checked="not compiled by the tests, which have no Metal compiler",
    ),
}
"""Description of each `Language`."""
