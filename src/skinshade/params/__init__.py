"""Constant blocks and enumerations that Python and shaders share: fields with unit, range and source."""

from .frame import FrameParams, LightParams
from .scatter import ScatterParams
from .skin import SkinParams

__all__ = ["BLOCKS", "FrameParams", "LightParams", "ScatterParams", "SkinParams"]

BLOCKS: dict[str, type] = {
    "SkinBlock": SkinParams,
    "ScatterBlock": ScatterParams,
    "FrameBlock": FrameParams,
    "LightBlock": LightParams,
}
"""Constant blocks, by name in shaders. The first two belong to the shader library."""
