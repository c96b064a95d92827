"""Image files, linear Rec.709 inside."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import FloatArray, ImageArray
from .._core.errors import ImageFileError
from .._core.pixels import open_image, unit_values, write_pixels
from .._core.srgb import linear_from_srgb

__all__ = ["read_image", "read_linear", "write_exr", "write_png"]

LINEAR_SUFFIXES = (".hdr", ".exr", ".rgbe")


def read_image(path: str | os.PathLike[str], channels: int = 3) -> ImageArray:
    """Return the stored values of an image, (H, W, channels) float32, integers scaled to 0..1.

    Raises
    ------
    ImageFileError
        If the file is missing, corrupt, beyond a limit, or holds NaN or infinite values.
    """
    return _read(path, channels, unit_values)


def read_linear(path: str | os.PathLike[str]) -> ImageArray:
    """Return an image as linear light (H, W, 3): HDR and EXR as stored, others through the sRGB curve.

    Raises
    ------
    ImageFileError
        As for `read_image`.
    """
    is_linear = Path(path).suffix.lower() in LINEAR_SUFFIXES
    return _read(path, 3, unit_values if is_linear else _linear_values)


def _read(
    path: str | os.PathLike[str], channels: int, decode: Callable[[NDArray[Any]], NDArray[Any]]
) -> ImageArray:
    """Return the first channels (H, W, channels) of an image; those of a grey image are equal."""

    def finite(stored: NDArray[Any]) -> NDArray[Any]:
        if stored.dtype.kind == "f" and not np.isfinite(stored).all():
            raise ImageFileError(f"{path}: holds NaN or infinite pixels")
        return decode(stored[..., :1] if is_grey else stored)

    with open_image(path, ImageFileError) as image:
        is_grey = image.channels <= 2
        if not is_grey and image.channels < channels:
            raise ImageFileError(f"{path}: has {image.channels} channels; {channels} are needed")
        return image.read(channels, finite)


def _linear_values(stored: NDArray[Any]) -> NDArray[Any]:
    """Return linear light of stored sRGB values, by a table for every step of 16 bits."""
    table = _linear_table()
    if stored.dtype == np.uint8:
        return table[::257][stored]
    if stored.dtype == np.uint16:
        return table[stored]
    return table[np.rint(np.clip(stored, 0.0, 1.0) * np.float32(65535.0)).astype(np.uint16)]


@cache
def _linear_table() -> NDArray[np.float32]:
    """Return linear light (65536,) of sRGB values in 16 bits; a table is faster than a power per pixel."""
    return linear_from_srgb(np.arange(65536) / 65535.0).astype(np.float32)


def write_png(path: str | os.PathLike[str], display: FloatArray | NDArray[np.uint8]) -> None:
    """Write display values (H, W, 3 or 4), 0..1 or uint8, as 8-bit PNG."""
    unit = 1.0 if display.dtype == np.uint8 else 255.0
    write_pixels(path, np.rint(np.clip(display * unit, 0.0, 255.0)).astype(np.uint8))


def write_exr(path: str | os.PathLike[str], linear: ImageArray) -> None:
    """Write linear values (H, W, 3 or 4) as float32 EXR."""
    write_pixels(path, np.asarray(linear, dtype=np.float32))
