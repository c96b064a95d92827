"""Pixels in and out of files, through OpenImageIO: the one file that knows it."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
import OpenImageIO as oiio  # noqa: N813 — the name its own manual gives it
from numpy.typing import NDArray

from .arrays import ImageArray
from .errors import FileError, OutputError
from .files import atomic_write, existing_file

__all__ = ["read_pixels", "write_pixels"]

DESCRIPTION = "ImageDescription"
"""The one text field that EXR and PNG share under OpenImageIO."""
LARGEST_SIDE = 32768
"""A header that claims more is taken for corrupt before memory is asked for it."""
STORED_AS = {
    np.dtype(np.uint8): "uint8",
    np.dtype(np.uint16): "uint16",
    np.dtype(np.float32): "float",
}


def read_pixels(path: str | os.PathLike[str], error: type[FileError]) -> tuple[ImageArray, str]:
    """Return the values (H, W, C) of an image, integers scaled to 0..1, and its description.

    Raises
    ------
    FileError
        Of the type given, if the file is missing, not an image, corrupt, or implausibly large.
    """
    file = existing_file(path, error)
    source = oiio.ImageInput.open(str(file))
    if source is None:
        raise error(f"{file}: not an image ({_reason(oiio)})")
    try:
        spec = source.spec()
        if max(spec.width, spec.height) > LARGEST_SIDE:
            raise error(f"{file}: claims {spec.width}×{spec.height} pixels; too large")
        pixels = source.read_image("float")
        reason = _reason(source)
        text = str(spec.getattribute(DESCRIPTION) or "")
    except UnicodeDecodeError:
        raise error(f"{file}: corrupt (its text is not UTF-8)") from None
    finally:
        source.close()
    if pixels is None:
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
    OutputError
        If the place cannot be written.
    """
    height, width, channels = pixels.shape
    spec = oiio.ImageSpec(width, height, channels, STORED_AS[pixels.dtype])
    if channels == 4:
        spec.alpha_channel = 3
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
    try:
        return str(of.geterror()).strip()
    except UnicodeDecodeError:  # it quotes a corrupt file's own bytes
        return "its header is corrupt"
