"""Assets in, assets out: what skin shading needs, written into a studio's own files."""

from .asset import BakedAsset, bake
from .settings import BakeSettings

__all__ = ["BakeSettings", "BakedAsset", "bake"]
