"""Image files as arrays, through OpenImageIO, which no other file imports."""

from __future__ import annotations

import os
import re
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import OpenImageIO as oiio  # noqa: N813 — the name in its manual
from numpy.typing import NDArray

from .arrays import ImageArray
from .errors import ArgumentError, FileError, OutputError
from .files import FileSet, atomic_write, existing_file
from .limits import check_file_size, check_limit, limit_advice, limits
from .png import PngPixels, check_png

__all__ = [
    "ImageFile",
    "open_image",
    "read_description",
    "read_pixels",
    "unit_values",
    "write_pixels",
]

DESCRIPTION = "ImageDescription"
"""Text field that OpenImageIO stores in both EXR and PNG."""
AS_STORED = "oiio:UnassociatedAlpha"
"""Without this attribute, OpenImageIO multiplies colours by alpha on reading and divides on writing."""
STORED_AS = {
    np.dtype(np.uint8): "uint8",
    np.dtype(np.uint16): "uint16",
    np.dtype(np.float32): "float",
}
TYPES_HELD = {".png": ("uint8", "uint16"), ".exr": ("float32",)}
"""Types that the formats store without conversion."""
READ_AS_STORED = ("uint8", "uint16", "half")
"""Types that are smaller than float32; OpenImageIO converts every other type to float32."""
ROWS = 256
"""Rows that are decoded at once: no format compresses more of them together."""
MANY_CHANNELS = (b"v/1\x01", b"II*\0", b"MM\0*", b"II+\0", b"MM\0+")
"""Beginning of EXR and TIFF files, which may have any number of channels."""
JPEG = b"\xff\xd8"
"""Beginning of JPEG files, in which 64 pixels take at least one bit."""
DECODED_WHEN_OPENED = (JPEG, b"GIF8")
"""Beginning of JPEG and GIF files, which OpenImageIO may decode when it opens them; 4 bytes a pixel."""
UNLIMITED = 2**31 - 1
SIZE = re.compile(r"\b([1-9]\d*)x([1-9]\d*)\b")
"""A size in a message of OpenImageIO; 0x69206e6f is none."""
_OPENING = threading.Lock()
"""OpenImageIO has one set of limits for the whole process."""

Decode = Callable[[NDArray[Any]], NDArray[Any]]
"""Function from stored values (h, W, C) of some rows, in the type of the file, to values of one shape."""


@dataclass(frozen=True)
class ImageFile:
    """An open image, whose header has been checked against the limits.

    Attributes
    ----------
    path
        Its file.
    width, height, channels
        Size of the image, pixels, and number of stored channels.
    description
        Its description; empty if it has none.
    """

    path: Path
    width: int
    height: int
    channels: int
    description: str
    _source: Any
    _error: type[FileError]
    _png: PngPixels | None

    def read(self, channels: int, decode: Decode | None = None) -> ImageArray:
        """Return the first channels (H, W, channels) of the image in float32.

        Rows are decoded in groups, so that little more memory is needed than for the result.

        Parameters
        ----------
        channels
            Number of channels, up to those that the image has; more than one for an image with one gives
            equal channels.
        decode
            Function that converts stored values; `unit_values` if None.

        Raises
        ------
        FileError
            If the file is corrupt.
        """
        if self._png is not None:
            self._png.check(self._error)
        decode = decode or unit_values
        result = np.empty((self.height, self.width, channels), dtype=np.float32)
        for start, rows in self._rows(min(channels, self.channels)):
            result[start : start + len(rows)] = decode(rows)
        reason, error = _reason(self._source), self._error
        if reason:  # the missing part of a truncated JPEG is grey
            raise error(f"{self.path}: corrupt ({reason})")
        return result

    def _rows(self, channels: int) -> Iterator[tuple[int, NDArray[Any]]]:
        """Yield groups of rows (h, W, channels), as stored, with the index of their first row."""
        source, spec = self._source, self._source.spec()
        kind = str(spec.format)
        form = kind if kind in READ_AS_STORED else "float"
        step = spec.tile_height * -(-ROWS // spec.tile_height) if spec.tile_width else ROWS
        for start in range(0, self.height, step):
            top, bottom = spec.y + start, spec.y + min(start + step, self.height)
            if spec.tile_width:
                rows = source.read_tiles(
                    spec.x, spec.x + spec.width, top, bottom, spec.z, spec.z + 1, 0, channels, form
                )
            else:
                rows = source.read_scanlines(top, bottom, spec.z, 0, channels, form)
            if rows is None:
                error = self._error
                raise error(f"{self.path}: corrupt ({_reason(source)})")
            yield start, rows.reshape(bottom - top, self.width, channels)


@contextmanager
def open_image(path: str | os.PathLike[str], error: type[FileError]) -> Iterator[ImageFile]:
    """Open an image, and close it after the body of the ``with`` statement.

    Raises
    ------
    FileError
        Of the type `error`, if the file is missing, not an image, corrupt, or beyond a limit.
    """
    file = existing_file(path, error)
    check_file_size(file, error)
    png = check_png(file, error)
    if png is not None:
        _check_size(file, png.width, png.height, error)
    source = _opened(file, error)
    try:
        spec = source.spec()
        _check_size(file, spec.width, spec.height, error)
        check_limit("image_channels", spec.nchannels, str(file), error)
        if spec.tile_width:  # a tile may be larger than the image
            _check_size(file, spec.tile_width, spec.tile_height, error)
        if min(spec.width, spec.height, spec.nchannels) < 1:
            raise error(f"{file}: has no pixels")
        if spec.deep or spec.depth > 1:
            raise error(f"{file}: holds several depths in a pixel; a flat image is needed")
        yield ImageFile(
            file,
            spec.width,
            spec.height,
            spec.nchannels,
            _description(file, spec, error),
            source,
            error,
            png,
        )
    finally:
        source.close()


def read_pixels(path: str | os.PathLike[str], error: type[FileError]) -> tuple[ImageArray, str]:
    """Return the values (H, W, C) of an image, integers scaled to 0..1, and its description.

    Raises
    ------
    FileError
        Of the type `error`, if the file is missing, not an image, corrupt, or beyond a limit.
    """
    with open_image(path, error) as image:
        return image.read(image.channels), image.description


def unit_values(stored: NDArray[Any]) -> NDArray[Any]:
    """Return stored integers scaled to 0..1 in float32; floats as they are."""
    if stored.dtype.kind != "u":
        return stored
    result: NDArray[Any] = stored / np.float32(np.iinfo(stored.dtype).max)
    return result


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
        reason = _reason(out or oiio).partition("; ")[0]  # the others are of later blocks
        if not written or (reason and Path(path).suffix.lower() in TYPES_HELD):
            raise OutputError(f"{Path(path)}: cannot write it ({reason or 'unknown error'})")


def _opened(file: Path, error: type[FileError]) -> Any:
    """Return the image of a file; OpenImageIO has the limits of `limits` while it opens the file."""
    config = oiio.ImageSpec()
    config.attribute(AS_STORED, 1)
    allowed = {
        "limits:resolution": min(limits().image_side, UNLIMITED),
        "limits:channels": UNLIMITED,
        "limits:imagesize_MB": min(_opening_bytes(file) // 2**20 + 1, UNLIMITED),
    }
    with _OPENING:
        # An attribute that this version of OpenImageIO does not have reads as the default, −1.
        values = {name: oiio.get_int_attribute(name, -1) for name in allowed}
        before = {name: value for name, value in values.items() if value >= 0}
        try:
            for name in before:
                oiio.attribute(name, allowed[name])
            source = oiio.ImageInput.open(str(file), config)
        finally:
            for name, value in before.items():
                oiio.attribute(name, value)
    if source is None:
        reason = _reason(oiio)
        _check_stated_size(file, reason, error)
        raise error(f"{file}: not an image ({reason})")
    return source


def _check_stated_size(file: Path, reason: str, error: type[FileError]) -> None:
    """Raise if a size in a message of OpenImageIO, such as ``65500x65500``, is beyond a limit."""
    text = reason.replace(str(file), "")
    sizes = [(int(width), int(height)) for width, height in SIZE.findall(text)]
    if sizes:  # a message also states its own limit, which is less
        _check_size(file, *max(sizes), error)


def _opening_bytes(file: Path) -> int:
    """Return the bytes that an image may take when it is opened."""
    start = _beginning(file)
    if start.startswith(DECODED_WHEN_OPENED):
        return 4 * _allowed_pixels(file)
    return 4 * _allowed_pixels(file) * (limits().image_channels if start in MANY_CHANNELS else 4)


def _allowed_pixels(file: Path) -> int:
    """Return the number of pixels that an image with the size of this file may have."""
    most = limits()
    free = 0 if _beginning(file).startswith(JPEG) else most.image_free_pixels
    by_size = free + most.image_pixels_per_byte * file.stat().st_size
    return min(most.image_pixels, by_size)


def _beginning(file: Path) -> bytes:
    """Return the first four bytes, which tell the formats apart."""
    with file.open("rb") as stream:
        return stream.read(4)


def _check_size(file: Path, width: int, height: int, error: type[FileError]) -> None:
    """Raise if the header of an image claims a size that is beyond a limit."""
    claim, most = f"{file}: claims {width}×{height} pixels", limits()
    if max(width, height) > most.image_side:
        raise error(f"{claim}; {limit_advice('image_side', max(width, height))}")
    if width * height > most.image_pixels:
        raise error(f"{claim}; {limit_advice('image_pixels', width * height)}")
    if width * height > _allowed_pixels(file):
        size = file.stat().st_size
        if _beginning(file).startswith(JPEG):
            advice = limit_advice("image_pixels_per_byte", -(-width * height // size))
        else:
            needed = width * height - most.image_pixels_per_byte * size
            advice = limit_advice("image_free_pixels", needed)
        raise error(f"{claim} in {size} bytes; {advice}")


def _description(file: Path, spec: Any, error: type[FileError]) -> str:
    try:
        value = spec.getattribute(DESCRIPTION)  # an EXR file may have it in any type
        text = value if isinstance(value, str) else ""
        text.encode()  # invalid bytes are read as lone surrogates
    except UnicodeError:
        raise error(f"{file}: corrupt (its text is not UTF-8)") from None
    return text


def _reason(source: Any) -> str:
    """Return the errors of an OpenImageIO object in one line, each once; empty without an error."""
    try:
        return "; ".join(dict.fromkeys(str(source.geterror()).strip().splitlines()))
    except UnicodeDecodeError:  # the message quotes bytes of a corrupt file
        return "its header is corrupt"
