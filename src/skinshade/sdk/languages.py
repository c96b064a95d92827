"""Shading languages: which files an engine includes, and how the same calls are written in each."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from ..params.packing import TYPE_NAMES
from ..shading.skin import ENGINE_LUTS

__all__ = ["LANGUAGES", "ShadingLanguage"]


@dataclass(frozen=True)
class ShadingLanguage:
    """One form of the package.

    Attributes
    ----------
    title
        For a person to read.
    library
        Generated file, or empty for the commented source itself.
    suffix
        Of the files that are written.
    structs
        Generated file of the constant blocks.
    types
        Its names of ``float``, ``float2``, ``float3``, ``float4`` and ``float3x3``, where they are others.
    combined
        Whether a texture holds its sampler.
    prologue
        Lines that must stand before the library.
    checked
        What has run it.
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
        """Return its name of a type."""
        return self.types.get(neutral, neutral)

    def defined(self, kind: str, name: str, value: str) -> str:
        """Return the definition of a local value."""
        if self.suffix == "wgsl":
            return f"let {name} = {value};"
        return f"{self.type_of(kind)} {name} = {value};"

    def lut(self, name: str) -> str:
        """Return the arguments that hand a table on."""
        sampler = "" if self.combined else "lut_sampler, "
        return f"{name}_lut, {sampler}scatter_block.{name}_axes"

    def declared(self) -> list[str]:
        """Return the global declarations of what the library's calls are given."""
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
            lines = [f"layout(std140) uniform {name} {{ {what}; }};" for name, what in blocks]
            return lines + [f"uniform sampler2D {name}_lut;" for name in ENGINE_LUTS]
        lines = [
            f"layout(std140, set = 1, binding = {i}) uniform {name} {{ {what}; }};"
            for i, (name, what) in enumerate(blocks)
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
"""OpenGL ES reads float textures at low precision unless told otherwise."""

LANGUAGES = {
    "slang": ShadingLanguage(
        "Slang", "", "slang", "blocks.hlsl", checked="executed as WGSL, compiled as all others"
    ),
    "hlsl": ShadingLanguage(
        "HLSL (Direct3D 11 and 12)",
        "",
        "hlsl",
        "blocks.hlsl",
        checked="executed through DXC and SPIR-V, compiled to DXIL",
    ),
    "glsl-vulkan": ShadingLanguage(
        "GLSL for Vulkan",
        "skin.vulkan.glsl",
        "glsl",
        "blocks.glsl",
        TYPE_NAMES["glsl"],
        checked="executed through glslang and SPIR-V",
    ),
    "glsl-gl": ShadingLanguage(
        "GLSL 3.30 and later for OpenGL",
        "skin.gl.glsl",
        "glsl",
        "blocks.glsl",
        TYPE_NAMES["glsl"],
        combined=True,
        checked="executed on OpenGL 3.3 and 4.3",
    ),
    "glsl-es": ShadingLanguage(
        "GLSL ES 3.00 for WebGL 2 and OpenGL ES 3",
        "skin.gl.glsl",
        "glsl",
        "blocks.glsl",
        TYPE_NAMES["glsl"],
        combined=True,
        prologue=HIGHEST,
        checked="executed in Chromium's WebGL 2",
    ),
    "wgsl": ShadingLanguage(
        "WGSL for WebGPU",
        "skin.wgsl",
        "wgsl",
        "blocks.wgsl",
        TYPE_NAMES["wgsl"],
        checked="executed by naga (wgpu) and Tint (Chromium)",
    ),
    "metal": ShadingLanguage(
        "Metal",
        "skin.metal",
        "metal",
        "blocks.metal",
        checked="emitted; no compiler for it has seen it",
    ),
}
"""By the names that ``skinshade shaders export`` takes."""
