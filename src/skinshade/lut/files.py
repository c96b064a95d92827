"""Files of tables: EXR, 16-bit PNG and npz, with the description of the axes as metadata."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import numpy as np

from .._core.arrays import ImageArray, as_floats
from .._core.errors import ArgumentError, LutFileError
from .._core.files import atomic_write, existing_file
from .._core.pixels import read_pixels, write_pixels

__all__ = ["read_table", "write_table"]

PNG_STEPS = 65535.0


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
        values = (low + values * span).astype(np.float32)
    return values, description


def _text(description: dict[str, Any]) -> str:
    return json.dumps(description, sort_keys=True)


def _read_image(file: Path) -> tuple[ImageArray, Any]:
    pixels, text = read_pixels(file, LutFileError)
    if pixels.shape[2] != 3:
        raise LutFileError(f"{file}: has {pixels.shape[2]} channels; a table has 3")
    try:
        return pixels, json.loads(text)
    except ValueError:
        raise LutFileError(
            f"{file}: has no description of its axes; it is not a table of skinshade"
        ) from None


def _read_npz(file: Path) -> tuple[ImageArray, Any]:
    try:
        with file.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
            values = np.asarray(archive["values"], dtype=np.float32)
            return values, json.loads(str(archive["description"]))
    except Exception as error:  # zip, zlib, json and NumPy raise many types
        raise LutFileError(f"{file}: not a table of skinshade ({error})") from None
