"""Image files as arrays, through OpenImageIO, which no other file imports."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
import OpenImageIO as oiio  # noqa: N813 — the name in its manual
from numpy.typing import NDArray

from .arrays import ImageArray
from .errors import ArgumentError, FileError, OutputError
from .files import FileSet, atomic_write, existing_file

__all__ = ["read_description", "read_pixels", "write_pixels"]

DESCRIPTION = "ImageDescription"
"""Text field that OpenImageIO stores in both EXR and PNG."""
LARGEST_SIDE = 32768
MOST_PIXELS = 2**28
"""Larger sizes in a header count as corrupt, before memory is allocated."""
AS_STORED = "oiio:UnassociatedAlpha"
"""Without this attribute, OpenImageIO multiplies colours by alpha on reading and divides on writing."""
STORED_AS = {
    np.dtype(np.uint8): "uint8",
    np.dtype(np.uint16): "uint16",
    np.dtype(np.float32): "float",
}
TYPES_HELD = {".png": ("uint8", "uint16"), ".exr": ("float32",)}
"""Types that the formats store without conversion."""


def read_pixels(path: str | os.PathLike[str], error: type[FileError]) -> tuple[ImageArray, str]:
    """Return the values (H, W, C) of an image, integers scaled to 0..1, and its description.

    Raises
    ------
    FileError
        Of the type `error`, if the file is missing, not an image, corrupt, or implausibly large.
    """
    file = existing_file(path, error)
    config = oiio.ImageSpec()
    config.attribute(AS_STORED, 1)
    source = oiio.ImageInput.open(str(file), config)
    if source is None:
        raise error(f"{file}: not an image ({_reason(oiio)})")
    try:
        spec = source.spec()
        size = spec.width * spec.height
        if max(spec.width, spec.height) > LARGEST_SIDE or size > MOST_PIXELS:
            raise error(f"{file}: claims {spec.width}×{spec.height} pixels; too large")
        pixels = source.read_image("float")
        reason = _reason(source)
        description = spec.getattribute(DESCRIPTION)
        text = description if isinstance(description, str) else ""
        text.encode()  # invalid bytes are read as lone surrogates
    except UnicodeError:
        raise error(f"{file}: corrupt (its text is not UTF-8)") from None
    finally:
        source.close()
    if pixels is None or reason:  # the missing part of a truncated JPEG is grey
        raise error(f"{file}: corrupt ({reason})")
    if pixels.ndim == 2:
        pixels = pixels[..., None]
    return np.ascontiguousarray(pixels, dtype=np.float32), text


def read_description(path: str | os.PathLike[str]) -> str:
    """Return the text that `write_pixels` stored in an image; empty if there is none.

    Raises
    ------
    FileError
        If the file is not an image.
    """
    file = existing_file(path)
    source = oiio.ImageInput.open(str(file))
    if source is None:
        raise FileError(f"{file}: not an image ({_reason(oiio)})")
    try:
        description = source.spec().getattribute(DESCRIPTION)
    finally:
        source.close()
    return description if isinstance(description, str) else ""


def write_pixels(
    path: str | os.PathLike[str],
    pixels: NDArray[np.uint8] | NDArray[np.uint16] | ImageArray,
    description: str = "",
    files: FileSet | None = None,
) -> None:
    """Write an image (H, W, C) in the format of the suffix and the type of the array, atomically.

    Parameters
    ----------
    path
        Target.
    pixels
        Values of the pixels.
    description
        Text that is stored in the file.
    files
        Set of files that is written together; None for this file alone.

    Raises
    ------
    ArgumentError, OutputError
        If the format does not hold the type, or the file cannot be written.
    """
    if pixels.dtype not in STORED_AS:
        raise ArgumentError(
            f"{path}: pixels are {pixels.dtype}; they must be uint8, uint16 or float32"
        )
    held = TYPES_HELD.get(Path(path).suffix.lower(), (pixels.dtype.name,))
    if pixels.dtype.name not in held:
        raise ArgumentError(
            f"{path}: pixels are {pixels.dtype}; the format holds {' or '.join(held)}"
        )
    height, width, channels = pixels.shape
    spec = oiio.ImageSpec(width, height, channels, STORED_AS[pixels.dtype])
    if channels == 4:
        spec.alpha_channel = 3
    spec.attribute(AS_STORED, 1)
    if description:
        spec.attribute(DESCRIPTION, description)
        spec.attribute("oiio:ColorSpace", "Linear")
    with atomic_write(path, files) as temporary:
        name = str(temporary)
        out = oiio.ImageOutput.create(name)
        written = (
            out is not None
            and out.open(name, spec)
            and out.write_image(np.ascontiguousarray(pixels))
            and out.close()
        )
        # A full disk is reported only as an error text: every call returns True. TIFF has such texts
        # also for complete files.
        reason = _reason(out or oiio)
        if not written or (reason and Path(path).suffix.lower() in TYPES_HELD):
            raise OutputError(f"{Path(path)}: cannot write it ({reason or 'unknown error'})")


def _reason(source: Any) -> str:
    """Return the first error of an OpenImageIO object; empty without an error."""
    try:
        return str(source.geterror()).strip().partition("\n")[0].strip()
    except UnicodeDecodeError:  # the message quotes bytes of a corrupt file
        return "its header is corrupt"
