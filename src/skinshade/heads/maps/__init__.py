"""Texture maps of the built-in head, generated at run time."""

from .head_maps import HeadMaps, head_maps

__all__ = ["HeadMaps", "head_maps"]
