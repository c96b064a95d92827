"""Textures that a frame is drawn into, for one size of picture; each is made when it is first asked for."""

from __future__ import annotations

from functools import cached_property

import wgpu

from ..renderer import MULTISAMPLES

__all__ = ["LIGHT", "RESOLVED", "SHOWN", "Targets"]

LIGHT, RESOLVED, SHOWN = "rgba32float", "rgba16float", "rgba8unorm"
"""Of samples and linear pictures; of what is multisampled, which no wider format is; of a screen."""

DRAWN = wgpu.TextureUsage.RENDER_ATTACHMENT | wgpu.TextureUsage.TEXTURE_BINDING


class Targets:
    """Textures of one size.

    Parameters
    ----------
    device
        They live on.
    size
        Columns and rows.
    """

    def __init__(self, device: wgpu.GPUDevice, size: tuple[int, int]) -> None:
        self.device = device
        self.size = size

    @cached_property
    def sample(self) -> wgpu.GPUTexture:
        """One sample's light and coverage."""
        return self._made(LIGHT)

    @cached_property
    def sums(self) -> tuple[wgpu.GPUTexture, wgpu.GPUTexture]:
        """Sums over samples: one is read while the other is written."""
        return self._made(LIGHT), self._made(LIGHT)

    @cached_property
    def multisampled(self) -> wgpu.GPUTexture:
        """Light of the samples of each pixel."""
        return self._made(RESOLVED, MULTISAMPLES)

    @cached_property
    def resolved(self) -> wgpu.GPUTexture:
        """The mean over them."""
        return self._made(RESOLVED)

    @cached_property
    def linear(self) -> wgpu.GPUTexture:
        """The picture, in linear light."""
        return self._made(LIGHT)

    @cached_property
    def shown(self) -> wgpu.GPUTexture:
        """The picture as a screen shows it."""
        return self._made(SHOWN)

    def depth(self, samples: int) -> wgpu.GPUTexture:
        """Return the depth of 1 or several samples a pixel."""
        return self._depth_of_many if samples > 1 else self._depth_of_one

    @cached_property
    def _depth_of_one(self) -> wgpu.GPUTexture:
        return self._made("depth32float")

    @cached_property
    def _depth_of_many(self) -> wgpu.GPUTexture:
        return self._made("depth32float", MULTISAMPLES)

    def _made(self, kind: str, samples: int = 1) -> wgpu.GPUTexture:
        usage = DRAWN if samples > 1 else DRAWN | wgpu.TextureUsage.COPY_SRC
        return self.device.create_texture(
            size=(*self.size, 1), format=kind, usage=usage, sample_count=samples
        )
