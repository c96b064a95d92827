"""Constant blocks by name."""

from __future__ import annotations

from .eye import EyeParams, EyePlaceParams
from .frame import FrameParams, LightParams
from .scatter import ScatterParams
from .skin import SkinParams

__all__ = ["BLOCKS"]

BLOCKS: dict[str, type] = {
    "SkinBlock": SkinParams,
    "ScatterBlock": ScatterParams,
    "EyeBlock": EyeParams,
    "EyePlaceBlock": EyePlaceParams,
    "FrameBlock": FrameParams,
    "LightBlock": LightParams,
}
"""Constant blocks, by name in shaders. The first four belong to the shader library."""
