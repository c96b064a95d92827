"""Files of tables: EXR, 16-bit PNG and npz, with the description of the axes as metadata."""

from __future__ import annotations

import json
import os
import struct
import sys
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import ImageArray, as_floats
from .._core.errors import ArgumentError, LutFileError
from .._core.files import atomic_write, existing_file
from .._core.json import parse_json
from .._core.limits import check_file_size, check_limit
from .._core.pixels import open_image, write_pixels

__all__ = ["read_table", "write_table"]

PNG_STEPS = 65535.0
ZIP_END = struct.Struct("<4s4H2IH")
"""Last record of a zip file without a comment; the sixth field is the size of the directory, bytes."""
ZIP64_LOCATOR = 20
"""Size of the record before it in large zip files, bytes."""
LARGEST_DIRECTORY = 1 << 16
"""Greatest size of the directory of a zip file, bytes; the two arrays of a table take about 120."""
LONGEST_DESCRIPTION = 1 << 20
"""Greatest number of characters of the description in an npz file, which takes 4 bytes for each; tables have
about a thousand."""


def write_table(
    path: str | os.PathLike[str], values: ImageArray, description: dict[str, Any]
) -> None:
    """Write values (H, W, 3) and a description of JSON types in the format of the suffix.

    Raises
    ------
    ArgumentError, OutputError
        If the suffix is not ``.exr``, ``.png`` or ``.npz``, or the file cannot be written.
    """
    suffix = Path(path).suffix.lower()
    if suffix not in (".exr", ".png", ".npz"):
        raise ArgumentError(f"{path}: suffix {suffix!r}; it must be .exr, .png or .npz")
    if suffix == ".npz":
        with atomic_write(path) as temporary, temporary.open("wb") as stream:
            np.savez_compressed(stream, values=values, description=np.array(_text(description)))
    elif suffix == ".exr":
        write_pixels(path, values, _text(description))
    else:
        low, high = values.min(axis=(0, 1)), values.max(axis=(0, 1))
        span = np.where(high > low, high - low, 1.0)
        steps = np.rint((values - low) / span * PNG_STEPS).astype(np.uint16)
        scale = {"value_low": low.tolist(), "value_span": span.tolist()}
        write_pixels(path, steps, _text(description | scale))


def read_table(path: str | os.PathLike[str]) -> tuple[ImageArray, dict[str, Any]]:
    """Return the values (H, W, 3) and the description of a file of `write_table`.

    Raises
    ------
    LutFileError
        If the file is missing or corrupt, or has no description.
    """
    file = existing_file(path, LutFileError)
    values, description = _read_npz(file) if file.suffix.lower() == ".npz" else _read_image(file)
    if not isinstance(description, dict):
        raise LutFileError(f"{file}: the description of its axes is not a JSON object")
    if "value_low" in description:
        try:
            low = as_floats("value_low", description["value_low"], (3,))
            span = as_floats("value_span", description.get("value_span", ()), (3,))
        except ArgumentError as error:
            raise LutFileError(f"{file}: the range of its values is wrong: {error}") from None
        with np.errstate(over="ignore", invalid="ignore"):  # the table is checked
            values = (low + values * span).astype(np.float32)
    return values, description


def _text(description: dict[str, Any]) -> str:
    return json.dumps(description, sort_keys=True)


def _read_image(file: Path) -> tuple[ImageArray, Any]:
    with open_image(file, LutFileError) as image:
        if image.channels != 3:
            raise LutFileError(f"{file}: has {image.channels} channels; a table has 3")
        _check_size(file, image.height, image.width)
        description = _parse(file, image.description)
        return image.read(3), description


def _parse(file: Path, text: str) -> Any:
    try:
        return parse_json(text)
    except ArgumentError as error:
        raise LutFileError(
            f"{file}: has no description of its axes; it is not a table of skinshade ({error})"
        ) from None


def _check_size(file: Path, height: int, width: int) -> None:
    check_limit("table_side", max(height, width), f"{file}: a side", LutFileError)
    check_limit("table_texels", height * width, str(file), LutFileError)


def _read_npz(file: Path) -> tuple[ImageArray, Any]:
    check_file_size(file, LutFileError)
    try:
        _check_directory(file)
        with zipfile.ZipFile(file) as archive:
            shape, kind = _array_header(archive, "values.npy")
            text_shape, text_kind = _array_header(archive, "description.npy")
        if len(shape) != 3 or shape[2] != 3 or kind.kind not in "fiu":
            raise ArgumentError(
                f"values have shape {shape} and type {kind}; they must be numbers (H, W, 3)"
            )
        if text_shape or text_kind.kind != "U" or text_kind.itemsize > 4 * LONGEST_DESCRIPTION:
            raise ArgumentError(
                f"description has shape {text_shape} and type {text_kind}; it must be one text of"
                f" {LONGEST_DESCRIPTION} characters at most"
            )
        _check_size(file, *shape[:2])
        with (
            file.open("rb") as stream,
            np.load(stream, allow_pickle=False) as arrays,
            np.errstate(over="ignore"),  # the table is checked
        ):
            return np.asarray(arrays["values"], np.float32), _parse(
                file, _array_text(arrays["description"])
            )
    except LutFileError:
        raise
    except Exception as error:  # zip, zlib and NumPy raise many types
        raise LutFileError(f"{file}: not a table of skinshade ({error})") from None


def _check_directory(file: Path) -> None:
    """Raise if the directory of a zip file is larger than that of a few files, or has another form."""
    with file.open("rb") as stream:
        stream.seek(-min(file.stat().st_size, ZIP_END.size + ZIP64_LOCATOR), os.SEEK_END)
        end = stream.read()
    if len(end) < ZIP_END.size or end[-ZIP_END.size :][:4] != b"PK\5\6":
        raise ArgumentError("it does not end as a zip file")
    size = ZIP_END.unpack(end[-ZIP_END.size :])[5]
    if size > LARGEST_DIRECTORY or end.startswith(b"PK\6\7"):
        raise ArgumentError(f"the directory of its files has more than {LARGEST_DIRECTORY} bytes")


def _array_header(archive: zipfile.ZipFile, name: str) -> tuple[tuple[int, ...], np.dtype[Any]]:
    """Return the shape and type of an array, without its values."""
    if archive.getinfo(name).compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise ArgumentError(f"{name} is neither stored nor deflated")
    with archive.open(name) as stream:
        version = np.lib.format.read_magic(stream)
        readers = {
            (1, 0): np.lib.format.read_array_header_1_0,
            (2, 0): np.lib.format.read_array_header_2_0,
        }
        shape, _, kind = readers[version](stream)
    return shape, kind


def _array_text(array: NDArray[Any]) -> str:
    """Return the text of an array (), whose code points NumPy does not check.

    Raises
    ------
    ArgumentError
        If the array does not hold one text, or a code point is beyond Unicode.
    """
    if array.dtype.kind != "U" or array.shape != ():
        raise ArgumentError(f"its description has type {array.dtype} and shape {array.shape}")
    codes = np.frombuffer(array.tobytes(), dtype=np.uint32)
    if codes.size and codes.max() > sys.maxunicode:
        raise ArgumentError(
            f"its description has the code point {codes.max()}, which is no character"
        )
    return str(array)
