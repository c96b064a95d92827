"""Pixels in and out of files, through OpenImageIO: the one file that knows it."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
import OpenImageIO as oiio  # noqa: N813 — the name its own manual gives it
from numpy.typing import NDArray

from .arrays import ImageArray
from .errors import ArgumentError, FileError, OutputError
from .files import atomic_write, existing_file

__all__ = ["read_pixels", "write_pixels"]

DESCRIPTION = "ImageDescription"
"""The one text field that EXR and PNG share under OpenImageIO."""
LARGEST_SIDE = 32768
MOST_PIXELS = 2**28
"""A header that claims more is taken for corrupt before memory is asked for it."""
AS_STORED = "oiio:UnassociatedAlpha"
"""Unless it is set, colours are multiplied by alpha on reading and divided by it on writing."""
STORED_AS = {
    np.dtype(np.uint8): "uint8",
    np.dtype(np.uint16): "uint16",
    np.dtype(np.float32): "float",
}
TYPES_HELD = {".png": ("uint8", "uint16"), ".exr": ("float32",)}
"""Any other type would be converted on the way, and not come back as it was."""


def read_pixels(path: str | os.PathLike[str], error: type[FileError]) -> tuple[ImageArray, str]:
    """Return the values (H, W, C) of an image, integers scaled to 0..1, and its description.

    Raises
    ------
    FileError
        Of the type given, if the file is missing, not an image, corrupt, or implausibly large.
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
        text = str(spec.getattribute(DESCRIPTION) or "")
        text.encode()  # bytes that are no text come as lone surrogates
    except UnicodeError:
        raise error(f"{file}: corrupt (its text is not UTF-8)") from None
    finally:
        source.close()
    if pixels is None or reason:  # a JPEG that was cut off is filled up with grey
        raise error(f"{file}: corrupt ({reason})")
    if pixels.ndim == 2:
        pixels = pixels[..., None]
    return np.ascontiguousarray(pixels, dtype=np.float32), text


def write_pixels(
    path: str | os.PathLike[str],
    pixels: NDArray[np.uint8] | NDArray[np.uint16] | ImageArray,
    description: str = "",
) -> None:
    """Write (H, W, C) as the suffix says, in the type of the array; all or nothing.

    Raises
    ------
    ArgumentError, OutputError
        If the type is not one that the format holds, or the place cannot be written.
    """
    if pixels.dtype not in STORED_AS:
        raise ArgumentError(
            f"{path}: pixels are {pixels.dtype}; uint8, uint16 or float32 is stored"
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
    with atomic_write(path) as temporary:
        name = str(temporary)
        out = oiio.ImageOutput.create(name)
        written = (
            out is not None
            and out.open(name, spec)
            and out.write_image(np.ascontiguousarray(pixels))
            and out.close()
        )
        if not written:
            raise OutputError(f"{Path(path)}: cannot write it ({_reason(out or oiio)})")


def _reason(of: Any) -> str:
    """What went wrong, in one line; nothing if nothing did."""
    try:
        return "; ".join(dict.fromkeys(str(of.geterror()).strip().splitlines()))
    except UnicodeDecodeError:  # it quotes a corrupt file's own bytes
        return "its header is corrupt"
