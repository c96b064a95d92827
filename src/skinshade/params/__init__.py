"""Constant blocks and enumerations that Python and shaders share: fields with unit, range and source."""

from typing import TYPE_CHECKING

from .._core.lazy import names_on_demand

if TYPE_CHECKING:
    from .blocks import BLOCKS
    from .eye import EyeParams, EyePlaceParams
    from .frame import FrameParams, LightParams
    from .scatter import ScatterParams
    from .skin import SkinParams

__all__ = [
    "BLOCKS",
    "EyeParams",
    "EyePlaceParams",
    "FrameParams",
    "LightParams",
    "ScatterParams",
    "SkinParams",
]

__getattr__ = names_on_demand(
    __name__,
    {
        ".blocks": ("BLOCKS",),
        ".eye": (
            "EyeParams",
            "EyePlaceParams",
        ),
        ".frame": (
            "FrameParams",
            "LightParams",
        ),
        ".scatter": ("ScatterParams",),
        ".skin": ("SkinParams",),
    },
)
