"""Tables in files: EXR, 16-bit PNG and npz, each with the description of its axes."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import numpy as np
import OpenImageIO as oiio  # noqa: N813 — the name its own manual gives it

from .._core.arrays import ImageArray
from .._core.errors import ArgumentError, LutFileError, OutputError
from .._core.files import atomic_write, existing_file
from .table import Axis, Lut

__all__ = ["load_lut", "save_lut"]

DESCRIPTION = "ImageDescription"
"""The one text field that EXR and PNG share under OpenImageIO."""
PNG_STEPS = 65535.0


def save_lut(lut: Lut, path: str | os.PathLike[str]) -> None:
    """Write a table; see `Lut.save`."""
    suffix = Path(path).suffix.lower()
    if suffix not in (".exr", ".png", ".npz"):
        raise ArgumentError(f"{path}: suffix {suffix!r}; a table is saved as .exr, .png or .npz")
    with atomic_write(path) as temporary:
        if suffix == ".npz":
            text = np.array(json.dumps(lut.description(), sort_keys=True))
            with temporary.open("wb") as stream:
                np.savez_compressed(stream, values=lut.values, description=text)
        elif suffix == ".exr":
            _write(temporary, lut.values, "float", lut.description())
        else:
            low, high = lut.values.min(axis=(0, 1)), lut.values.max(axis=(0, 1))
            span = np.where(high > low, high - low, 1.0)
            steps = np.rint((lut.values - low) / span * PNG_STEPS).astype(np.uint16)
            scale = {"value_low": low.tolist(), "value_span": span.tolist()}
            _write(temporary, steps, "uint16", lut.description() | scale)


def load_lut(path: str | os.PathLike[str]) -> Lut:
    """Read a table; see `Lut.load`."""
    file = existing_file(path, LutFileError)
    values, record = _read_npz(file) if file.suffix.lower() == ".npz" else _read_image(file)
    try:
        if "value_low" in record:
            low = np.asarray(record["value_low"], dtype=np.float64)
            values = (low + values * np.asarray(record["value_span"])).astype(np.float32)
        axes = Axis(**record["columns"]), Axis(**record["rows"])
        return Lut(values, record["kind"], *axes, record["provenance"])
    except (KeyError, TypeError, ValueError) as error:
        raise LutFileError(
            f"{file}: its description lacks or misstates something: {error}"
        ) from None


def _write(path: Path, pixels: np.ndarray[Any, Any], kind: str, record: dict[str, Any]) -> None:
    spec = oiio.ImageSpec(pixels.shape[1], pixels.shape[0], 3, kind)
    spec.attribute(DESCRIPTION, json.dumps(record, sort_keys=True))
    spec.attribute("oiio:ColorSpace", "Linear")
    out = oiio.ImageOutput.create(str(path))
    if (
        out is None
        or not out.open(str(path), spec)
        or not out.write_image(pixels)
        or not out.close()
    ):
        raise OutputError(f"{path}: {out.geterror() if out else oiio.geterror()}")


def _read_image(file: Path) -> tuple[ImageArray, dict[str, Any]]:
    source = oiio.ImageInput.open(str(file))
    if source is None:
        raise LutFileError(f"{file}: not an image ({oiio.geterror().strip()})")
    try:
        try:
            text = source.spec().getattribute(DESCRIPTION)
        except UnicodeDecodeError:
            text = None
        pixels = source.read_image("float")
    finally:
        source.close()
    if pixels is None or pixels.ndim != 3 or pixels.shape[2] != 3:
        raise LutFileError(f"{file}: cannot be read as three channels")
    try:
        return pixels, json.loads(text)
    except (TypeError, ValueError):
        raise LutFileError(
            f"{file}: carries no description of its axes; not a skinshade table"
        ) from None


def _read_npz(file: Path) -> tuple[ImageArray, dict[str, Any]]:
    try:
        with file.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
            return archive["values"], json.loads(str(archive["description"]))
    except Exception as error:  # zip, zlib, json and NumPy each raise their own on a wrong byte
        raise LutFileError(f"{file}: not a table saved by skinshade ({error})") from None
