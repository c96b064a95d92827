"""PLY, the Polygon File Format: polygons or triangle strips, with properties of vertices."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

import numpy as np

from .._core.arrays import FloatArray, IntArray, as_faces
from .._core.errors import MeshFileError
from ..gltf import TriangleSet
from .corners import fan_triangles, first_of_equal_rows, merged_corners, strip_triangles
from .decimals import as_float64
from .ply_binary import read_binary_tables
from .ply_header import Column, Header, Lists, read_header
from .ply_text import read_text_tables
from .text import PlainText

__all__ = ["read_ply"]

POSITION, NORMAL = ("x", "y", "z"), ("nx", "ny", "nz")
UVS = (("texture_u", "texture_v"), ("u", "v"), ("s", "t"))
"""Names of texture coordinates: those of MeshLab, then those of other programs."""
COLOURS = (("red", "green", "blue", "alpha"), ("red", "green", "blue"))
INDICES = ("vertex_indices", "vertex_index")

Table = Mapping[str, Column]


def read_ply(file: Path) -> tuple[TriangleSet, list[str]]:
    """Return the triangles of a PLY file, and its comments.

    Polygons become fans. UVs come from the corners of faces (``texcoord``), or else from vertices; they are
    left out if a corner lacks one. Colours become the attribute ``color`` (V, 3) or (V, 4), as stored; all
    other numbers of vertices become attributes (V, 1) by their names, except those that are not finite.

    Raises
    ------
    MeshFileError, ArgumentError
        If the file is malformed, has no vertices or triangles, or an index is out of range.
    """
    content = file.read_bytes()
    header = read_header(file, content)
    _refuse_impossible_counts(file, header, len(content) - header.size)
    if header.byte_order:
        tables = read_binary_tables(file, content, header)
    else:
        tables = read_text_tables(PlainText.of(file, content), header)
    return _triangle_set(file, tables), list(header.comments)


def _refuse_impossible_counts(file: Path, header: Header, size: int) -> None:
    """Raise if the data are shorter than the rows that the header states. Lists can be empty."""
    least = 0
    for element in header.elements:
        row = 2 * len(element.properties)  # a digit and a space
        if header.byte_order:
            row = sum(np.dtype(p.count_type or p.type).itemsize for p in element.properties)
        least += row * element.rows
        if least > size + 1:  # the last line can have no end
            raise MeshFileError(
                f"{file}: ends early; the header states {element.rows} rows of element {element.name},"
                f" but only {size} bytes of data follow"
            )


def _triangle_set(file: Path, tables: Mapping[str, Table]) -> TriangleSet:
    vertices = tables.get("vertex")
    if vertices is None:
        raise MeshFileError(f"{file}: has no element vertex")
    numbers = {
        name: as_float64(column)
        for name, column in vertices.items()
        if not isinstance(column, Lists)
    }
    positions = _taken(numbers, POSITION)
    if positions is None:
        raise MeshFileError(f"{file}: element vertex has no numbers x, y and z")
    normals = _taken(numbers, NORMAL)
    uvs = next((uv for uv in (_taken(numbers, names) for names in UVS) if uv is not None), None)
    colours = (_taken(numbers, names) for names in COLOURS)
    colour = next((values for values in colours if values is not None), None)
    attributes = {name: values[:, None] for name, values in numbers.items()}
    attributes |= {} if colour is None else {"color": colour}
    attributes = {name: v for name, v in attributes.items() if np.isfinite(v).all()}
    faces, corner_uvs = _faces(file, tables, len(positions))
    if corner_uvs is not None:
        kept, vertex = merged_corners([faces.ravel(), first_of_equal_rows(corner_uvs)])
        used = faces.ravel()[kept]
        faces, positions, uvs = vertex.reshape(-1, 3), positions[used], corner_uvs[kept]
        normals = None if normals is None else normals[used]
        attributes = {name: values[used] for name, values in attributes.items()}
    v_down = None if uvs is None else uvs * (1.0, -1.0) + (0.0, 1.0)
    return TriangleSet(positions, faces, normals, v_down, attributes)


def _taken(numbers: dict[str, FloatArray], names: Iterable[str]) -> FloatArray | None:
    """Remove columns (V,) from a table and return them as (V, n), or None if one is missing."""
    if not all(name in numbers for name in names):
        return None
    return np.stack([numbers.pop(name) for name in names], axis=1)


def _faces(
    file: Path, tables: Mapping[str, Table], vertex_count: int
) -> tuple[IntArray, FloatArray | None]:
    """Return the triangles (F, 3), and the UVs (3F, 2) of their corners if all corners have one."""
    parts, uvs = [], []
    polygons = _indices(file, tables, "face")
    if polygons is not None and polygons[0].size:
        sizes, indices = polygons
        empty = np.flatnonzero(sizes == 0)
        if empty.size:
            raise MeshFileError(f"{file}: element face, row {empty[0]}, has no corners")
        triangles = fan_triangles(sizes)
        parts.append(indices[triangles])
        uvs.append(_corner_uvs(file, tables["face"].get("texcoord"), sizes, triangles))
    strips = _indices(file, tables, "tristrips")
    if strips is not None and strips[1].size:
        parts.append(strip_triangles(*strips))
        uvs.append(None)
    if not sum(map(len, parts)):
        raise MeshFileError(f"{file}: holds no triangles")
    faces = as_faces(f"{file}: faces", np.concatenate(parts), vertex_count)
    present = [uv for uv in uvs if uv is not None]
    return faces, np.concatenate(present) if len(present) == len(uvs) else None


def _indices(
    file: Path, tables: Mapping[str, Table], element: str
) -> tuple[IntArray, IntArray] | None:
    """Return sizes (R,) and values of the lists of vertices of an element, or None if it is missing."""
    if element not in tables:
        return None
    table = tables[element]
    lists = {name: column for name, column in table.items() if isinstance(column, Lists)}
    names = [name for name in INDICES if name in lists]
    names = names or (list(lists) if len(table) == 1 else [])  # some programs use another name
    if not names:
        raise MeshFileError(f"{file}: element {element} has no list {' or '.join(INDICES)}")
    indices = lists[names[0]]
    if indices.values.dtype.kind == "f":
        raise MeshFileError(f"{file}: element {element}: the type of {names[0]} is not whole")
    return indices.sizes, indices.values.astype(np.int64)


def _corner_uvs(
    file: Path, column: Column | None, sizes: IntArray, triangles: IntArray
) -> FloatArray | None:
    """Return the UVs (3F, 2) of the corners of triangles, or None if a face has none.

    Parameters
    ----------
    file
        Name of the file, for error messages.
    column
        Lists of u v of the corners of the polygons, or None.
    sizes
        (P,) number of corners of the polygons.
    triangles
        (F, 3) corners of the triangles, counted through all polygons.
    """
    if not isinstance(column, Lists):
        return None
    wrong = np.flatnonzero((column.sizes != 2 * sizes) & (column.sizes != 0))
    if wrong.size:
        row = wrong[0]
        raise MeshFileError(
            f"{file}: element face, row {row}, has {column.sizes[row]} numbers in the list texcoord;"
            f" {sizes[row]} corners have {2 * sizes[row]}"
        )
    if not column.sizes.all():
        return None
    return as_float64(column.values).reshape(-1, 2)[triangles.ravel()]
