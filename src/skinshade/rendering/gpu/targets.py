"""Render targets of a frame, for one size; each is created at its first use."""

from __future__ import annotations

from functools import cached_property

from ...gpu.device import GPUDevice, GPUTexture, TextureUsage
from ..settings import MULTISAMPLES

__all__ = ["DISPLAY", "LIGHT", "RESOLVED", "Targets"]

LIGHT, RESOLVED, DISPLAY = "rgba32float", "rgba16float", "rgba8unorm"
"""Formats of linear light, of multisampled light (wider formats cannot be multisampled), and of display
values."""

DRAWN = TextureUsage.RENDER_ATTACHMENT | TextureUsage.TEXTURE_BINDING


class Targets:
    """Render targets of one size.

    Parameters
    ----------
    device
        Device of the textures.
    size
        (width, height).
    """

    def __init__(self, device: GPUDevice, size: tuple[int, int]) -> None:
        self.device, self.size = device, size

    @cached_property
    def sample(self) -> GPUTexture:
        """Light and coverage of one sample."""
        return self._create(LIGHT)

    @cached_property
    def sums(self) -> tuple[GPUTexture, GPUTexture]:
        """Sums over samples: one is read while the other is written."""
        return self._create(LIGHT), self._create(LIGHT)

    @cached_property
    def multisampled(self) -> GPUTexture:
        """Light of all samples of each pixel."""
        return self._create(RESOLVED, MULTISAMPLES)

    @cached_property
    def resolved(self) -> GPUTexture:
        """Mean over the samples of `multisampled`."""
        return self._create(RESOLVED)

    @cached_property
    def linear(self) -> GPUTexture:
        """Picture as linear light."""
        return self._create(LIGHT)

    @cached_property
    def display(self) -> GPUTexture:
        """Picture as display values."""
        return self._create(DISPLAY)

    def depth(self, samples: int) -> GPUTexture:
        """Return the depth buffer for 1 or 4 `samples` per pixel."""
        return self._multisampled_depth if samples > 1 else self._single_depth

    @cached_property
    def _single_depth(self) -> GPUTexture:
        return self._create("depth32float")

    @cached_property
    def _multisampled_depth(self) -> GPUTexture:
        return self._create("depth32float", MULTISAMPLES)

    def _create(self, kind: str, samples: int = 1) -> GPUTexture:
        usage = DRAWN if samples > 1 else DRAWN | TextureUsage.COPY_SRC
        return self.device.create_texture(
            size=(*self.size, 1), format=kind, usage=usage, sample_count=samples
        )
