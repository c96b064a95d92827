"""Records of baked assets, which decide whether an asset is current. A record is untrusted input."""

from __future__ import annotations

import hashlib
import json
import re
import sys
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from .._core.arrays import FloatArray
from .._core.errors import FileError
from .._core.files import atomic_write, existing_file
from .._core.json import parse_json
from ..mesh.baked import GLTF_NAMES
from .analysis import BakedMesh
from .names import is_local_name

__all__ = [
    "MeshRecord",
    "Record",
    "are_unchanged",
    "file_hash",
    "mesh_record",
    "read_record",
    "write_record",
]

LARGEST_RECORD = 8 << 20
"""Largest size of a record in bytes: about 6,000 meshes. Hostile JSON of this size takes at most 0.5 GiB and
some seconds. An asset with a larger record is baked again every time."""
HISTOGRAM_BINS = 48
LONGEST_LABEL = 200
"""Most characters of the name of a mesh or of a note; longer names only widen the page."""
LONGEST_WARNING = 1000
"""Most characters of a warning."""
MOST_NOTES = 64
"""Most notes of a mesh, several times the number of different notes."""


@dataclass(frozen=True)
class MeshRecord:
    """Description of a baked mesh.

    Attributes
    ----------
    name
        Name of the mesh, at most 200 characters.
    unit_mm
        Length of one unit of the mesh, mm.
    vertices, triangles
        Counts.
    size_mm
        Extent along each axis, mm.
    uv_scale_mm
        Length of one unit of UV on the surface, mm; None without usable UVs.
    ranges
        Least and greatest value of each attribute.
    histograms
        Counts of the values of each attribute in 48 bins of equal width.
    notes
        Counts of faults and repairs, by their description.
    """

    name: str
    unit_mm: float
    vertices: int
    triangles: int
    size_mm: list[float]
    uv_scale_mm: float | None
    ranges: dict[str, list[float]]
    histograms: dict[str, list[int]]
    notes: dict[str, int]


@dataclass(frozen=True)
class Record:
    """Record of a baked asset. All names are relative, so that a library can be moved.

    Attributes
    ----------
    source
        Source, relative to the common folder of the sources.
    output
        Output, relative to the output folder.
    key
        Hash of the source, the files that it refers to, the settings and the version.
    files
        Hash of each file that was written, by its name relative to the folder of the output.
    thumbnail
        Hash of the thumbnails; None without thumbnails.
    meshes
        Description of each mesh.
    warnings
        Texts of the warnings.
    """

    source: str
    output: str
    key: str
    files: dict[str, str]
    thumbnail: str | None
    meshes: list[MeshRecord]
    warnings: list[str]


def mesh_record(baked: BakedMesh) -> MeshRecord:
    """Return the description of a baked mesh."""
    attributes, scale = baked.analysis.attributes, baked.analysis.uv_scale_mm
    # Names may hold lone surrogates, which are not text; they are written as escapes.
    name = baked.name.encode("utf-8", "backslashreplace").decode("utf-8")
    return MeshRecord(
        name=name[:LONGEST_LABEL],
        unit_mm=float(baked.mesh.unit_mm),
        vertices=len(baked.mesh.positions),
        triangles=len(baked.mesh.faces),
        size_mm=[float(side) for side in np.ptp(baked.mesh.positions_mm, axis=0)],
        uv_scale_mm=None if scale is None else float(scale),
        ranges={key: [float(v.min()), float(v.max())] for key, v in attributes.items()},
        histograms={key: _histogram(values) for key, values in attributes.items()},
        notes={note: int(count) for note, count in baked.all_notes.items()},
    )


def file_hash(path: Path) -> str:
    """Return the SHA-256 of a file as hexadecimal digits."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def write_record(record: Record, path: Path) -> None:
    """Write a record as JSON in ASCII, in which any name of a file has a form.

    Raises
    ------
    OutputError
        If the file cannot be written.
    """
    text = json.dumps(asdict(record), separators=(",", ":"))
    with atomic_write(path) as temporary:
        temporary.write_text(text + "\n", encoding="ascii")


def read_record(path: Path) -> Record | None:
    """Return the record in a file, or None if the file is missing, too large or not a valid record."""
    try:
        with existing_file(path).open("rb") as file:
            data = file.read(LARGEST_RECORD + 1)
        if len(data) > LARGEST_RECORD:
            return None
        content = parse_json(data.decode("utf-8"))
    except (FileError, OSError, ValueError):  # the errors of UTF-8 and JSON are ValueErrors
        return None
    if not _matches(content, RECORD):
        return None
    meshes = [MeshRecord(**mesh) for mesh in content["meshes"]]
    return Record(**{**content, "meshes": meshes})


def are_unchanged(files: Mapping[str, str], folder: Path) -> bool:
    """Return whether all files, given by name and hash, exist unchanged inside a folder.

    Parameters
    ----------
    files
        Hashes by names relative to the folder.
    folder
        Folder that no name may leave, also not through a symbolic link.
    """
    try:
        root = folder.resolve()
        for name, value in files.items():
            file = (root / name).resolve()
            if not (file.is_relative_to(root) and file.is_file() and file_hash(file) == value):
                return False
    except (OSError, ValueError, RuntimeError):  # a name with NUL, a loop of symbolic links
        return False
    return True


def _histogram(values: FloatArray) -> list[int]:
    """Return the counts of values in bins of equal width."""
    low, high = float(values.min()), float(values.max())
    # The margin keeps the width of bins above 0 if all values are equal up to rounding.
    margin = 1e-6 * max(abs(low), abs(high)) or 0.5
    counts, _ = np.histogram(values, HISTOGRAM_BINS, (low - margin, high + margin))
    result: list[int] = counts.tolist()
    return result


# -- schema ----------------------------------------------------------------------------------------
# A check stops at the first fault: a validator that collects millions of them needs gigabytes.

Check = Callable[[Any], bool]
LARGEST_COUNT = 2**53
"""Largest integer up to which JSON readers with float64 are exact."""
HASH = re.compile("[0-9a-f]{64}")


def _matches(value: Any, schema: Mapping[str, Check]) -> bool:
    """Return whether a value is an object that has exactly the keys of a schema and passes its checks."""
    return (
        isinstance(value, dict)
        and value.keys() == schema.keys()
        and all(check(value[key]) for key, check in schema.items())
    )


def _is_number(value: Any) -> bool:
    return type(value) in (int, float) and abs(value) <= sys.float_info.max


def _is_length(value: Any) -> bool:
    return _is_number(value) and value >= 0.0


def _is_count(value: Any) -> bool:
    return type(value) is int and 0 <= value <= LARGEST_COUNT


def _is_label(value: Any) -> bool:
    return isinstance(value, str) and len(value) <= LONGEST_LABEL


def _is_warning(value: Any) -> bool:
    return isinstance(value, str) and len(value) <= LONGEST_WARNING


def _is_attribute(value: Any) -> bool:
    return value in GLTF_NAMES


def _is_hash(value: Any) -> bool:
    return isinstance(value, str) and HASH.fullmatch(value) is not None


def _is_name(value: Any) -> bool:
    return isinstance(value, str) and is_local_name(value)


def _list_of(check: Check, length: int) -> Check:
    return lambda value: isinstance(value, list) and len(value) == length and all(map(check, value))


def _dict_of(key: Check, check: Check, most: int) -> Check:
    return lambda value: (
        isinstance(value, dict)
        and len(value) <= most
        and all(map(key, value))
        and all(map(check, value.values()))
    )


def _is_mesh(value: Any) -> bool:
    return _matches(value, MESH) and value["ranges"].keys() == value["histograms"].keys()


MESH: dict[str, Check] = {
    "name": _is_label,
    "unit_mm": lambda value: _is_number(value) and value > 0.0,
    "vertices": _is_count,
    "triangles": _is_count,
    "size_mm": _list_of(_is_length, 3),
    "uv_scale_mm": lambda value: value is None or _is_length(value),
    "ranges": _dict_of(_is_attribute, _list_of(_is_number, 2), 3),
    "histograms": _dict_of(_is_attribute, _list_of(_is_count, HISTOGRAM_BINS), 3),
    "notes": _dict_of(_is_label, _is_count, MOST_NOTES),
}
RECORD: dict[str, Check] = {
    "source": _is_name,
    "output": _is_name,
    "key": _is_hash,
    "files": _dict_of(
        _is_name, _is_hash, LARGEST_RECORD
    ),  # the size of the record limits their number
    "thumbnail": lambda value: value is None or _is_hash(value),
    "meshes": lambda value: isinstance(value, list) and all(map(_is_mesh, value)),
    "warnings": lambda value: isinstance(value, list) and all(map(_is_warning, value)),
}
