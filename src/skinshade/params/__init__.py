"""Parameters of shading: frozen, with unit, range, source and meaning in each field's metadata."""

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
"""Every constant block by its name in a shader; the first two are the library's."""
