"""Baking of assets: the attributes of skin shading, written into files and libraries of files."""

from .asset import BakedAsset, bake
from .settings import BakeSettings

__all__ = ["BakeSettings", "BakedAsset", "bake"]
