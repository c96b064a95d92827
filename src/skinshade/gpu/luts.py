"""Lookup tables as textures."""

from __future__ import annotations

from typing import Protocol

from ..lut import Lut
from .device import GPUDevice, GPUTexture
from .textures import filtered_texture

__all__ = ["LutSource", "LutTextures"]


class LutSource(Protocol):
    """Source of lookup tables, such as `skinshade.Skin`."""

    def lut(self, name: str) -> Lut:
        """Return a table by its `name` in shaders without ``_lut``."""


class LutTextures:
    """Textures of tables by name; each is uploaded at its first use.

    Parameters
    ----------
    device
        Device of the textures.
    """

    def __init__(self, device: GPUDevice) -> None:
        self._device = device
        self._textures: dict[str, GPUTexture] = {}

    def texture(self, name: str, source: LutSource) -> GPUTexture:
        """Return the texture of the table `name` of a `source`."""
        if name not in self._textures:
            self._textures[name] = filtered_texture(self._device, [source.lut(name).values])
        return self._textures[name]
