"""Compute kernels for the tests: one for each function of the library, run on rows of numbers."""

from __future__ import annotations

from .signatures import FLOATS, NUMBERS, Parameter, Signature

__all__ = ["WIDTHS", "WORKGROUP", "kernel_source", "row_length"]

WIDTHS = {**NUMBERS, "lut": 4, "tex2d": 0}
"""Floats in a row for each kind of parameter: four axes for a table, none for a plain texture."""

WORKGROUP = 64


def row_length(signature: Signature) -> int:
    """Return the number of floats of one call: its values and the axes of its tables."""
    return sum(WIDTHS[parameter.kind] for parameter in signature.parameters)


def kernel_source(signatures: list[Signature]) -> str:
    """Return Slang that reads ``inputs`` row by row, calls each function, and writes ``outputs``."""
    parameters = [p for signature in signatures for p in signature.parameters]
    textures = sorted({p.name for p in parameters if p.kind in ("lut", "tex2d")})
    lines = ['#include "skin.slang"', ""]
    lines += ["StructuredBuffer<float> inputs;", "RWStructuredBuffer<float> outputs;"]
    for name in textures:
        lines += [f"Texture2D<float4> {name};", f"SamplerState {name}_sampler;"]
    for signature in signatures:
        lines += ["", *_kernel(signature)]
    return "\n".join(lines) + "\n"


def _kernel(signature: Signature) -> list[str]:
    lines = [
        '[shader("compute")]',
        f"[numthreads({WORKGROUP}, 1, 1)]",
        f"void {signature.name.replace('skin_', 'run_', 1)}(uint3 thread : SV_DispatchThreadID)",
        "{",
        f"    uint start = thread.x * {row_length(signature)};",
    ]
    arguments, start = [], 0
    for parameter in signature.parameters:
        arguments.append(_argument(parameter, start))
        start += WIDTHS[parameter.kind]
    width = FLOATS[signature.returns]
    lines.append(f"    {signature.returns} result = {signature.name}({', '.join(arguments)});")
    lines += [
        f"    outputs[thread.x * {width} + {index}] = {_part(signature.returns, index)};"
        for index in range(width)
    ]
    return [*lines, "}"]


def _argument(parameter: Parameter, start: int) -> str:
    if parameter.kind == "tex2d":
        return f"{parameter.name}, {parameter.name}_sampler"
    if parameter.kind == "lut":
        axes = _numbers("float4", start, 4)
        return f"{parameter.name}, {parameter.name}_sampler, {axes}"
    return _numbers(parameter.kind, start, NUMBERS[parameter.kind])


def _numbers(kind: str, start: int, count: int) -> str:
    floats = ", ".join(f"inputs[start + {start + index}]" for index in range(count))
    return floats if kind == "float" else f"{kind}({floats})"


def _part(kind: str, index: int) -> str:
    if kind == "float":
        return "result"
    if kind == "float3x3":
        return f"result[{index // 3}][{index % 3}]"
    return f"result[{index}]"
