"""Rows of numbers in, rows out: what the runners of all languages share.

A row is the arguments of one call, float by float; tables and textures come beside the rows.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from skinshade.codegen.build import GENERATED
from skinshade.codegen.kernels import WIDTHS, WORKGROUP, row_length
from skinshade.codegen.signatures import FLOATS, NUMBERS, signatures


@dataclass(frozen=True)
class Texture:
    """Texels (H, W, 4), and how they are sampled, in WebGPU's words."""

    rgba: np.ndarray
    sampled: dict[str, str]

    @property
    def linear(self):
        return self.sampled.get("mag_filter") == "linear"

    @property
    def around(self):
        """Whether u goes on at the other edge; else, as v, it stops at its own."""
        return self.sampled.get("address_mode_u") == "repeat"


class Runner:
    """One function at a time in one language; call it as the test does."""

    def __call__(self, signature, values, tables):
        """Return (N, ...) of a function, given (N, ...) by parameter name and tables by theirs.

        A table is its texels (H, W, 3), its four axes where it has them, and how it is sampled.
        """
        count = len(next(iter(values.values())))
        rows, textures = packed(signature, values, tables, count)
        found = self.run(signature, rows, textures)[:count]
        if signature.returns == "float3x3":
            return found.reshape(count, 3, 3)
        return found[:, 0] if FLOATS[signature.returns] == 1 else found

    def run(self, signature, rows, textures):
        """Return (rows, floats of a result)."""
        raise NotImplementedError

    def close(self):
        """Give back what is held outside this process."""


def packed(signature, values, tables, count):
    """Return float32 rows, filled up to whole work groups, and textures by name."""
    columns, textures = [np.zeros((count, 0))], {}
    for parameter in signature.parameters:
        if parameter.kind in ("lut", "tex2d"):
            texels, axes, sampled = tables[parameter.name]
            rgba = np.ones((*texels.shape[:2], 4), dtype=np.float32)
            rgba[..., :3] = texels
            textures[parameter.name] = Texture(rgba, sampled)
            given = [] if axes is None else axes
            columns.append(np.tile(np.asarray(given, dtype=np.float64), (count, 1)))
        else:
            columns.append(np.asarray(values[parameter.name], dtype=np.float64).reshape(count, -1))
        assert columns[-1].shape[1] == WIDTHS[parameter.kind], parameter
    rows = np.zeros((-(-count // WORKGROUP) * WORKGROUP, row_length(signature)), dtype=np.float32)
    rows[:count] = np.concatenate(columns, axis=1)
    return rows, textures


def generated(name):
    """Text of a generated file."""
    return (GENERATED / name).read_text("utf-8")


def texture_names(functions):
    """Of all that these functions sample."""
    parameters = [each for function in functions for each in function.parameters]
    return sorted({each.name for each in parameters if each.kind in ("lut", "tex2d")})


def places():
    """A binding for everything that some kernel of ours reads or writes, by name."""
    pairs = [(name, f"{name}_sampler") for name in texture_names(signatures())]
    order = ["inputs", "outputs", *(each for pair in pairs for each in pair)]
    return {name: number for number, name in enumerate(order)}


# -- the text of a call ----------------------------------------------------------------------------

GLSL = {
    "float": "float", "float2": "vec2", "float3": "vec3", "float4": "vec4",
    "float3x3": "mat3", "float4x4": "mat4", "int": "int",
}  # fmt: skip
WGSL = {
    "float": "f32", "float2": "vec2<f32>", "float3": "vec3<f32>", "float4": "vec4<f32>",
    "float3x3": "mat3x3<f32>", "float4x4": "mat4x4<f32>", "int": "i32",
}  # fmt: skip
HLSL = {name: name for name in NUMBERS}


def call(signature, types, read, *, combined=False):
    """Text of a call, where ``read(i)`` is float i of the row.

    A matrix takes its floats row by row in every language: what is a row of a float3x3 to the
    library is a column of a mat3 to its translations, and is built and read with the same index.
    """
    arguments, start = [], 0
    for each in signature.parameters:
        if each.kind in ("lut", "tex2d"):
            arguments += [each.name] if combined else [each.name, f"{each.name}_sampler"]
        if each.kind != "tex2d":
            kind = "float4" if each.kind == "lut" else each.kind
            numbers = ", ".join(read(start + index) for index in range(NUMBERS[kind]))
            arguments.append(f"{types[kind]}({numbers})")
        start += WIDTHS[each.kind]
    return f"{signature.name}({', '.join(arguments)})"


def parts(signature):
    """Text of every float of ``result``."""
    width = FLOATS[signature.returns]
    if signature.returns == "float3x3":
        return [f"result[{index // 3}][{index % 3}]" for index in range(width)]
    return ["result"] if width == 1 else [f"result[{index}]" for index in range(width)]


def statements(signature, types, *, index_type, result_type, combined=False):
    """A kernel's inside: from ``inputs`` by a call to ``outputs``, in GLSL's and WGSL's words."""
    text = call(signature, types, lambda index: f"inputs[at + {index}u]", combined=combined)
    width = FLOATS[signature.returns]
    lines = [
        f"{index_type} at = row * {row_length(signature)}u;",
        f"{result_type} result = {text};",
    ]
    each_part = enumerate(parts(signature))
    lines += [f"outputs[row * {width}u + {index}u] = {part};" for index, part in each_part]
    return "\n".join(f"    {line}" for line in lines)
