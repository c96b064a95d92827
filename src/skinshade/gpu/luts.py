"""Lookup tables as textures."""

from __future__ import annotations

from typing import Protocol

import wgpu

from ..lut import Lut
from .textures import filtered_texture

__all__ = ["HasLuts", "LutTextures"]


class HasLuts(Protocol):
    """What makes tables: `skinshade.shading.skin.Skin`."""

    def lut(self, name: str) -> Lut:
        """Return a table by its name in shaders."""


class LutTextures:
    """Tables by their names in shaders, each uploaded when it is first asked for.

    Parameters
    ----------
    device
        They live on.
    source
        Makes them.
    """

    def __init__(self, device: wgpu.GPUDevice, source: HasLuts) -> None:
        self._device, self._source = device, source
        self._textures: dict[str, wgpu.GPUTexture] = {}

    def __getitem__(self, name: str) -> wgpu.GPUTexture:
        """Return one table's texture."""
        if name not in self._textures:
            self._textures[name] = filtered_texture(self._device, [self._source.lut(name).values])
        return self._textures[name]
