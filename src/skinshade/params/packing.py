"""Packing of parameters into constant blocks, in the generated layout."""

from __future__ import annotations

import json
import re
from functools import cache
from typing import Any

import numpy as np

from .._core.generated import generated_text

__all__ = ["TYPE_NAMES", "float_count", "kind_of", "layout", "pack"]

KINDS = {1: "float", 2: "float2", 3: "float4", 4: "float4"}
"""Type of a field by its number of floats. A field of three floats is padded to four, because the offset of a
float3 differs between languages."""
TYPE_NAMES = {
    "glsl": {"float2": "vec2", "float3": "vec3", "float4": "vec4", "float3x3": "mat3"},
    "wgsl": {
        "float": "f32",
        "float2": "vec2<f32>",
        "float3": "vec3<f32>",
        "float4": "vec4<f32>",
        "float3x3": "mat3x3<f32>",
    },
}
"""Names of the types in languages whose names differ from those of Slang."""


def kind_of(value: Any) -> str:
    """Return the shader type of a field from its value: a number, a vector, or an array of vectors.

    Examples
    --------
    >>> from skinshade.params.packing import kind_of
    >>> kind_of(0.35), kind_of((1.0, 0.5, 0.2)), kind_of(((0.0, 0.0, 0.0),) * 9)
    ('float', 'float4', 'float4[9]')
    """
    shape = np.shape(value)
    kind = KINDS[shape[-1] if shape else 1]
    return f"{kind}[{shape[0]}]" if len(shape) == 2 else kind


def float_count(kind: str) -> int:
    """Return the number of floats in a shader type."""
    match = re.fullmatch(r"float(\d?)(?:\[(\d+)\])?", kind)
    assert match is not None, kind
    return int(match.group(1) or 1) * int(match.group(2) or 1)


@cache
def layout() -> dict[str, Any]:
    """Return the layout of every block, by name: size, and type and offset of each field; in bytes."""
    result: dict[str, Any] = json.loads(generated_text("layout.json"))["blocks"]
    return result


def pack(block: str, instance: Any) -> bytes:
    """Return the bytes of a block as little-endian float32, with zeros in the gaps between fields.

    Parameters
    ----------
    block
        Name of the block in the layout.
    instance
        Object with an attribute for every field of the block.
    """
    entry = layout()[block]
    data = np.zeros(entry["size"] // 4, dtype="<f4")
    for name, field in entry["fields"].items():
        rows = np.atleast_2d(np.asarray(getattr(instance, name), dtype="<f4"))
        padded = np.zeros((rows.shape[0], float_count(field["kind"]) // rows.shape[0]), dtype="<f4")
        padded[:, : rows.shape[1]] = rows
        start = field["offset"] // 4
        data[start : start + padded.size] = padded.ravel()
    return data.tobytes()
