"""Parameters as the bytes of a constant block, by the generated layout alone: no offset is written here."""

from __future__ import annotations

import json
from functools import cache
from importlib.resources import files
from typing import Any

import numpy as np

__all__ = ["layout", "pack"]


@cache
def layout() -> dict[str, Any]:
    """Return the layout of every block: size, and kind and offset of each field, bytes."""
    text = files("skinshade.shaders").joinpath("generated/layout.json").read_text(encoding="utf-8")
    result: dict[str, Any] = json.loads(text)["blocks"]
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
        value = np.atleast_1d(np.asarray(getattr(instance, name), dtype="<f4"))
        start = field["offset"] // 4
        data[start : start + value.size] = value
    return data.tobytes()
