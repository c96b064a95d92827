"""Parameters as the bytes of a constant block, by the generated layout alone: no offset is written here."""

from __future__ import annotations

import json
import re
from functools import cache
from typing import Any

import numpy as np

from ..shaders import generated_text

__all__ = ["TYPE_NAMES", "float_count", "kind_of", "layout", "pack"]

KINDS = {1: "float", 2: "float2", 3: "float4", 4: "float4"}
"""Three numbers take the room of four: a float3 stands elsewhere in every language."""
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
"""What languages call types where it is another name."""


def kind_of(value: Any) -> str:
    """Return the shader's type of a field with this value: a number, a vector, or rows of vectors."""
    shape = np.shape(value)
    kind = KINDS[shape[-1] if shape else 1]
    return f"{kind}[{shape[0]}]" if len(shape) == 2 else kind


def float_count(kind: str) -> int:
    """Return how many floats a type takes."""
    found = re.fullmatch(r"float(\d?)(?:\[(\d+)\])?", kind)
    assert found is not None, kind
    return int(found.group(1) or 1) * int(found.group(2) or 1)


@cache
def layout() -> dict[str, Any]:
    """Return the layout of every block: size, and kind and offset of each field, bytes."""
    result: dict[str, Any] = json.loads(generated_text("layout.json"))["blocks"]
    return result


def pack(block: str, instance: Any) -> bytes:
    """Return an instance's fields as the bytes of a block, float32 little-endian; gaps are 0.

    Parameters
    ----------
    block
        Its name in the layout.
    instance
        Anything with an attribute for every field of the block.
    """
    described = layout()[block]
    data = np.zeros(described["size"] // 4, dtype="<f4")
    for name, field in described["fields"].items():
        rows = np.atleast_2d(np.asarray(getattr(instance, name), dtype="<f4"))
        room = np.zeros((rows.shape[0], float_count(field["kind"]) // rows.shape[0]), dtype="<f4")
        room[:, : rows.shape[1]] = rows
        start = field["offset"] // 4
        data[start : start + room.size] = room.ravel()
    return data.tobytes()
