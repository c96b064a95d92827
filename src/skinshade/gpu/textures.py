"""Pictures, mips and tables as textures."""

from __future__ import annotations

from typing import Any

import numpy as np
import wgpu
from numpy.typing import NDArray

from .._core.arrays import ImageArray

__all__ = ["buffer", "filtered_texture", "loaded_texture", "rgba"]

USAGE = wgpu.TextureUsage.TEXTURE_BINDING | wgpu.TextureUsage.COPY_DST


def buffer(device: wgpu.GPUDevice, data: bytes, usage: int) -> wgpu.GPUBuffer:
    """Return a buffer with bytes in it that can be written again."""
    return device.create_buffer_with_data(data=data, usage=usage | wgpu.BufferUsage.COPY_DST)


def filtered_texture(device: wgpu.GPUDevice, levels: list[ImageArray]) -> wgpu.GPUTexture:
    """Return mip levels (h, w, C), or the one of a table, as half floats, which every device filters.

    Tables in them change a head by .03 of 255 at most.
    """
    return _texture(device, [rgba(level) for level in levels], "rgba16float")


def loaded_texture(device: wgpu.GPUDevice, values: ImageArray) -> wgpu.GPUTexture:
    """Return a picture (H, W, 3) as float32, for programs that load its texels."""
    return _texture(device, [rgba(values)], "rgba32float")


def rgba(values: ImageArray, kind: type[np.floating[Any]] = np.float32) -> NDArray[Any]:
    """Return (..., C) with as many channels as textures have, 4; what is not there is 1."""
    full = np.ones((*values.shape[:-1], 4), dtype=kind)
    full[..., : values.shape[-1]] = values
    return full


def _texture(device: wgpu.GPUDevice, levels: list[ImageArray], kind: str) -> wgpu.GPUTexture:
    height, width = levels[0].shape[:2]
    texture = device.create_texture(
        size=(width, height, 1), format=kind, usage=USAGE, mip_level_count=len(levels)
    )
    for number, level in enumerate(levels):
        data = np.ascontiguousarray(level, dtype=np.float16 if "16" in kind else np.float32)
        rows, columns = data.shape[:2]
        device.queue.write_texture(
            {"texture": texture, "mip_level": number},
            data,
            {"bytes_per_row": data.strides[0], "rows_per_image": rows},
            (columns, rows, 1),
        )
    return texture
