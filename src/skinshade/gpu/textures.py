"""Textures of images, mips and tables, and buffers of arrays."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import ImageArray
from .device import BufferUsage, GPUBuffer, GPUDevice, GPUTexture, TextureUsage

__all__ = ["buffer", "filtered_texture", "loaded_texture", "rgba"]

LARGEST_HALF = float(np.finfo(np.float16).max)
"""Greatest half float, 65504."""
USAGE = TextureUsage.TEXTURE_BINDING | TextureUsage.COPY_DST


def buffer(device: GPUDevice, data: bytes, usage: int) -> GPUBuffer:
    """Return a buffer with data; the buffer can be written again."""
    return device.create_buffer_with_data(data=data, usage=usage | BufferUsage.COPY_DST)


def filtered_texture(device: GPUDevice, levels: list[ImageArray]) -> GPUTexture:
    """Return a texture of mip levels (h, w, C) in half floats, which every device can filter.

    Tables in half floats change the picture of a head by at most .03 of 255. Greater values than those of
    half floats, as in the reflection of a very bright sun, become the greatest half float.
    """
    bounded = [np.clip(rgba(level), -LARGEST_HALF, LARGEST_HALF) for level in levels]
    return _texture(device, bounded, "rgba16float")


def loaded_texture(device: GPUDevice, values: ImageArray) -> GPUTexture:
    """Return a texture of an image (H, W, 3) in float32, for programs that load single texels."""
    return _texture(device, [rgba(values)], "rgba32float")


def rgba(values: ImageArray, kind: type[np.floating[Any]] = np.float32) -> NDArray[Any]:
    """Return values (..., C) with four channels; added channels are 1."""
    full = np.ones((*values.shape[:-1], 4), dtype=kind)
    full[..., : values.shape[-1]] = values
    return full


def _texture(device: GPUDevice, levels: list[ImageArray], kind: str) -> GPUTexture:
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
