"""Common part of the runners of all languages: rows of numbers in, rows of numbers out.

A row holds the arguments of one call, float by float; tables and textures are passed beside the rows.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from codegen.build import GENERATED
from codegen.kernels import WIDTHS, WORKGROUP, row_length
from codegen.signatures import FLOATS, NUMBERS, signatures


@dataclass(frozen=True)
class Texture:
    """Texels (H, W, 4) float32, and the properties of their sampler by WebGPU's names."""

    rgba: np.ndarray
    sampler: dict[str, str]

    @property
    def linear(self):
        return self.sampler.get("mag_filter") == "linear"

    @property
    def repeats_u(self):
        """Whether u repeats; otherwise it clamps to the edge, as v always does."""
        return self.sampler.get("address_mode_u") == "repeat"


class Runner:
    """Runs one function at a time in one language."""

    def __call__(self, signature, values, tables):
        """Return the results (N, ...) of a function.

        `values` are (N, ...) by parameter name. `tables` are, by parameter name, texels (H, W, 3), four
        axes or None, and the properties of the sampler.
        """
        count = len(next(iter(values.values())))
        rows, textures = packed(signature, values, tables, count)
        result = self.run(signature, rows, textures)[:count]
        if signature.returns == "float3x3":
            return result.reshape(count, 3, 3)
        return result[:, 0] if FLOATS[signature.returns] == 1 else result

    def run(self, signature, rows, textures):
        """Return (rows, floats of a result)."""
        raise NotImplementedError

    def close(self):
        """Release resources outside this process."""


def packed(signature, values, tables, count):
    """Return float32 rows, padded to whole work groups, and textures by name."""
    columns, textures = [np.zeros((count, 0))], {}
    for parameter in signature.parameters:
        if parameter.kind in ("lut", "tex2d"):
            texels, axes, sampler = tables[parameter.name]
            rgba = np.ones((*texels.shape[:2], 4), dtype=np.float32)
            rgba[..., :3] = texels
            textures[parameter.name] = Texture(rgba, sampler)
            numbers = np.asarray([] if axes is None else axes, dtype=np.float64)
            columns.append(np.tile(numbers, (count, 1)))
        else:
            columns.append(np.asarray(values[parameter.name], dtype=np.float64).reshape(count, -1))
        assert columns[-1].shape[1] == WIDTHS[parameter.kind], parameter
    rows = np.zeros((-(-count // WORKGROUP) * WORKGROUP, row_length(signature)), dtype=np.float32)
    rows[:count] = np.concatenate(columns, axis=1)
    return rows, textures


def generated(name):
    """Return the text of a generated file."""
    return (GENERATED / name).read_text("utf-8")


def texture_names(functions):
    """Return the names of all textures that functions sample."""
    parameters = [parameter for function in functions for parameter in function.parameters]
    return sorted({p.name for p in parameters if p.kind in ("lut", "tex2d")})


def binding_numbers():
    """Return a binding for everything that some kernel reads or writes, by name."""
    pairs = [(name, f"{name}_sampler") for name in texture_names(signatures())]
    order = ["inputs", "outputs", *(name for pair in pairs for name in pair)]
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
    """Return the text of a call, where ``read(i)`` is the text of float i of the row.

    A matrix takes its floats row by row in every language. A row of the library's float3x3 is a column
    of the mat3 of its translations; both are constructed and indexed in the same order.
    """
    arguments, start = [], 0
    for parameter in signature.parameters:
        name = parameter.name
        if parameter.kind in ("lut", "tex2d"):
            arguments += [name] if combined else [name, f"{name}_sampler"]
        if parameter.kind != "tex2d":
            kind = "float4" if parameter.kind == "lut" else parameter.kind
            numbers = ", ".join(read(start + index) for index in range(NUMBERS[kind]))
            arguments.append(f"{types[kind]}({numbers})")
        start += WIDTHS[parameter.kind]
    return f"{signature.name}({', '.join(arguments)})"


def components(signature):
    """Return the text of every float of ``result``."""
    width = FLOATS[signature.returns]
    if signature.returns == "float3x3":
        return [f"result[{index // 3}][{index % 3}]" for index in range(width)]
    return ["result"] if width == 1 else [f"result[{index}]" for index in range(width)]


def statements(signature, types, *, index_type, result_type, combined=False):
    """Return the body of a kernel in GLSL or WGSL: read ``inputs``, call, write ``outputs``."""
    text = call(signature, types, lambda index: f"inputs[start + {index}u]", combined=combined)
    width = FLOATS[signature.returns]
    lines = [
        f"{index_type} start = row * {row_length(signature)}u;",
        f"{result_type} result = {text};",
    ]
    for index, component in enumerate(components(signature)):
        lines.append(f"outputs[row * {width}u + {index}u] = {component};")
    return "\n".join(f"    {line}" for line in lines)
