"""Tables in files: EXR, 16-bit PNG and npz, each with the description of its axes."""

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
from .table import Axis, Lut

__all__ = ["load_lut", "save_lut"]

PNG_STEPS = 65535.0


def save_lut(lut: Lut, path: str | os.PathLike[str]) -> None:
    """Write a table; see `Lut.save`."""
    suffix = Path(path).suffix.lower()
    if suffix not in (".exr", ".png", ".npz"):
        raise ArgumentError(f"{path}: suffix {suffix!r}; a table is saved as .exr, .png or .npz")
    record = lut.description()
    if suffix == ".npz":
        with atomic_write(path) as temporary, temporary.open("wb") as stream:
            np.savez_compressed(stream, values=lut.values, description=np.array(_text(record)))
    elif suffix == ".exr":
        write_pixels(path, lut.values, _text(record))
    else:
        low, high = lut.values.min(axis=(0, 1)), lut.values.max(axis=(0, 1))
        span = np.where(high > low, high - low, 1.0)
        steps = np.rint((lut.values - low) / span * PNG_STEPS).astype(np.uint16)
        scale = {"value_low": low.tolist(), "value_span": span.tolist()}
        write_pixels(path, steps, _text(record | scale))


def load_lut(path: str | os.PathLike[str]) -> Lut:
    """Read a table; see `Lut.load`."""
    file = existing_file(path, LutFileError)
    values, record = _read_npz(file) if file.suffix.lower() == ".npz" else _read_image(file)
    try:
        if "value_low" in record:
            low = as_floats("value_low", record["value_low"], (3,))
            span = as_floats("value_span", record["value_span"], (3,))
            values = (low + values * span).astype(np.float32)
        axes = Axis(**record["columns"]), Axis(**record["rows"])
        return Lut(values, record["kind"], *axes, record["provenance"])
    except (KeyError, TypeError, ValueError) as error:
        raise LutFileError(
            f"{file}: its description lacks or misstates something: {error}"
        ) from None


def _text(record: dict[str, Any]) -> str:
    return json.dumps(record, sort_keys=True)


def _read_image(file: Path) -> tuple[ImageArray, dict[str, Any]]:
    pixels, text = read_pixels(file, LutFileError)
    if pixels.shape[2] != 3:
        raise LutFileError(f"{file}: has {pixels.shape[2]} channels; a table has three")
    try:
        return pixels, json.loads(text)
    except ValueError:
        raise LutFileError(
            f"{file}: carries no description of its axes; not a skinshade table"
        ) from None


def _read_npz(file: Path) -> tuple[ImageArray, dict[str, Any]]:
    try:
        with file.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
            values = np.asarray(archive["values"], dtype=np.float32)
            return values, json.loads(str(archive["description"]))
    except Exception as error:  # zip, zlib, json and NumPy each raise their own on a wrong byte
        raise LutFileError(f"{file}: not a table saved by skinshade ({error})") from None
