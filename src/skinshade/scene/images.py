"""Image files, linear Rec.709 inside."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import FloatArray, ImageArray
from .._core.errors import ImageFileError
from .._core.pixels import read_pixels, write_pixels
from .._core.srgb import linear_from_srgb

__all__ = ["read_image", "read_linear", "write_exr", "write_png"]


def read_image(path: str | os.PathLike[str], channels: int = 3) -> ImageArray:
    """Return the stored values of an image, (H, W, channels) float32, integers scaled to 0..1.

    Raises
    ------
    ImageFileError
        If the file is missing, corrupt, too large, or holds NaN or infinite values.
    """
    pixels, _ = read_pixels(path, ImageFileError)
    if pixels.shape[2] in (1, 2):  # grey, with or without alpha
        pixels = np.repeat(pixels[..., :1], channels, axis=2)
    if pixels.shape[2] < channels:
        raise ImageFileError(f"{path}: has {pixels.shape[2]} channels; {channels} are needed")
    pixels = np.ascontiguousarray(pixels[..., :channels], dtype=np.float32)
    if not np.isfinite(pixels).all():
        raise ImageFileError(f"{path}: holds NaN or infinite pixels")
    return pixels


def read_linear(path: str | os.PathLike[str]) -> ImageArray:
    """Return an image as linear light (H, W, 3): HDR and EXR as stored, others through the sRGB curve."""
    pixels = read_image(path)
    if Path(path).suffix.lower() in (".hdr", ".exr", ".rgbe"):
        return pixels
    # A table of 16 bits is exact for 8 and 16 bits, and much faster than a power per pixel.
    table = linear_from_srgb(np.arange(65536) / 65535.0).astype(np.float32)
    result: ImageArray = table[np.rint(np.clip(pixels, 0.0, 1.0) * 65535.0).astype(np.int64)]
    return result


def write_png(path: str | os.PathLike[str], display: FloatArray | NDArray[np.uint8]) -> None:
    """Write display values (H, W, 3 or 4), 0..1 or uint8, as 8-bit PNG."""
    unit = 1.0 if display.dtype == np.uint8 else 255.0
    write_pixels(path, np.rint(np.clip(display * unit, 0.0, 255.0)).astype(np.uint8))


def write_exr(path: str | os.PathLike[str], linear: ImageArray) -> None:
    """Write linear values (H, W, 3 or 4) as float32 EXR."""
    write_pixels(path, np.asarray(linear, dtype=np.float32))
