"""A compute kernel for every function of the library, which runs it on rows of numbers."""

from __future__ import annotations

from .signatures import FLOATS, Parameter, Signature

__all__ = ["WORKGROUP", "kernel_source", "row_length"]

WORKGROUP = 64


def row_length(signature: Signature) -> int:
    """Return how many floats one call takes: its values, and the axes of its tables."""
    return sum(FLOATS.get(each.kind, 4) for each in signature.parameters)


def kernel_source(signatures: list[Signature]) -> str:
    """Return Slang that reads ``inputs`` row by row, calls each function, and writes ``outputs``."""
    tables = sorted({p.name for each in signatures for p in each.parameters if p.kind == "lut"})
    lines = ['#include "skin.slang"', ""]
    lines += ["StructuredBuffer<float> inputs;", "RWStructuredBuffer<float> outputs;"]
    for name in tables:
        lines += [f"Texture2D<float4> {name};", f"SamplerState {name}_sampler;"]
    for each in signatures:
        lines += ["", *_kernel(each)]
    return "\n".join(lines) + "\n"


def _kernel(signature: Signature) -> list[str]:
    lines = [
        '[shader("compute")]',
        f"[numthreads({WORKGROUP}, 1, 1)]",
        f"void {signature.name.replace('skin_', 'run_', 1)}(uint3 thread : SV_DispatchThreadID)",
        "{",
        f"    uint at = thread.x * {row_length(signature)};",
    ]
    arguments, start = [], 0
    for parameter in signature.parameters:
        arguments.append(_argument(parameter, start))
        start += FLOATS.get(parameter.kind, 4)
    width = FLOATS[signature.returns]
    lines.append(f"    {signature.returns} result = {signature.name}({', '.join(arguments)});")
    lines += [
        f"    outputs[thread.x * {width} + {index}] = {_part(signature.returns, index)};"
        for index in range(width)
    ]
    return [*lines, "}"]


def _argument(parameter: Parameter, start: int) -> str:
    if parameter.kind == "lut":
        axes = _numbers("float4", start, 4)
        return f"{parameter.name}, {parameter.name}_sampler, {axes}"
    return _numbers(parameter.kind, start, FLOATS[parameter.kind])


def _numbers(kind: str, start: int, count: int) -> str:
    read = ", ".join(f"inputs[at + {start + index}]" for index in range(count))
    return read if kind == "float" else f"{kind}({read})"


def _part(kind: str, index: int) -> str:
    if kind == "float":
        return "result"
    if kind == "float3x3":
        return f"result[{index // 3}][{index % 3}]"
    return f"result[{index}]"
