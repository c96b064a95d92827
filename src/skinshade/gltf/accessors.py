"""Accessors of glTF documents: packed, strided, sparse and normalized numbers, with range checks."""

from __future__ import annotations

from typing import Any

import numpy as np

from .._core.arrays import FloatArray, IntArray
from .._core.errors import MeshFileError
from .document import GltfDocument

__all__ = [
    "FAN",
    "STRIP",
    "TRIANGLES",
    "accessor_width",
    "normalised",
    "read_accessor",
    "read_matrices",
    "read_triangles",
    "view_bytes",
]

COMPONENTS = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
"""Components of the types that are read. No attribute of the format has the types MAT2 and MAT3."""
TRIANGLES, STRIP, FAN = 4, 5, 6
"""Modes of primitives with triangles."""
GREATEST = 2**53
"""Greatest whole number of a field: JSON readers agree on all numbers up to it, and sums fit in 64 bits."""


def accessor_width(gltf: GltfDocument, index: Any, where: str) -> int | None:
    """Return the components of the elements of an accessor, or None if its type is not read."""
    kind = gltf.item("accessors", index, where).get("type")
    return WIDTHS.get(kind) if isinstance(kind, str) else None


def read_accessor(gltf: GltfDocument, index: Any, where: str, *, width: int) -> FloatArray:
    """Return the numbers (count, width) of an accessor as float64, normalised where it is marked so.

    Parameters
    ----------
    gltf, index
        Document, and index of the accessor.
    where
        Place of the reference in the document, for error messages.
    width
        Numbers that each element must have.

    Raises
    ------
    MeshFileError
        If the accessor is malformed, has another width, or reaches past a buffer.
    """
    accessor = gltf.item("accessors", index, where)
    here = f"{gltf.path}: {where}: accessor {index}"
    kind, components = accessor.get("type"), accessor.get("componentType")
    if not isinstance(kind, str) or WIDTHS.get(kind) != width:
        raise MeshFileError(f"{here}: type is {kind!r}; it must have {width} numbers")
    dtype = _component(components, here)
    count = _whole(accessor.get("count"), here, "count", least=1)
    normalized = accessor.get("normalized", False)
    if not isinstance(normalized, bool):
        raise MeshFileError(f"{here}: normalized is {normalized!r}; it must be true or false")
    if "bufferView" in accessor:
        offset = _whole(accessor.get("byteOffset", 0), here, "byteOffset")
        view = accessor["bufferView"]
        values = _strided(gltf, view, offset, count, width, dtype, here)
    else:
        gltf.count_numbers(count * width, here)
        values = np.zeros((count, width), dtype=dtype)
    if "sparse" in accessor:
        values = _with_sparse(gltf, accessor["sparse"], values, here)
    return normalised(values, normalized)


def read_matrices(gltf: GltfDocument, index: Any, where: str) -> FloatArray:
    """Return matrices (count, 4, 4) for column vectors.

    Raises
    ------
    MeshFileError
        If the accessor is at fault, as in `read_accessor`.
    """
    return read_accessor(gltf, index, where, width=16).reshape(-1, 4, 4).swapaxes(1, 2)


def read_triangles(
    gltf: GltfDocument, primitive: dict[str, Any], vertex_count: int, where: str
) -> IntArray:
    """Return the triangles (F, 3) of a primitive: a list, a strip or a fan, indexed or not.

    Raises
    ------
    MeshFileError
        If an index is out of range, or the indices are malformed.
    """
    if "indices" in primitive:
        accessor = gltf.item("accessors", primitive["indices"], f"{where}: indices")
        if accessor.get("componentType") not in (5121, 5123, 5125):
            raise MeshFileError(f"{gltf.path}: {where}: indices must be unsigned integers")
        if accessor.get("normalized"):
            raise MeshFileError(f"{gltf.path}: {where}: indices must not be normalized")
        values = read_accessor(gltf, primitive["indices"], f"{where}: indices", width=1)
        corners = values[:, 0].astype(np.int64)
    else:
        corners = np.arange(vertex_count, dtype=np.int64)
    if corners.size and corners.max() >= vertex_count:
        raise MeshFileError(
            f"{gltf.path}: {where}: index {int(corners.max())} is out of range;"
            f" there are {vertex_count} vertices"
        )
    mode = primitive.get("mode", TRIANGLES)
    if mode == TRIANGLES:
        if corners.size % 3:
            raise MeshFileError(
                f"{gltf.path}: {where}: {corners.size} corners are not a multiple of 3"
            )
        return corners.reshape(-1, 3)
    return _unrolled(corners, mode)


def _unrolled(corners: IntArray, mode: int) -> IntArray:
    """Return the triangles (F, 3) of a strip or fan, without degenerate ones."""
    if corners.size < 3:
        return np.zeros((0, 3), dtype=np.int64)
    first = corners[:-2].copy() if mode == STRIP else np.full(corners.size - 2, corners[0])
    second, third = corners[1:-1].copy(), corners[2:].copy()
    if mode == STRIP:  # every second triangle of a strip is reversed
        second[1::2], third[1::2] = corners[2:][1::2], corners[1:-1][1::2]
    faces = np.stack([first, second, third], axis=1)
    a, b, c = faces.T
    return faces[(a != b) & (b != c) & (c != a)]


def view_bytes(gltf: GltfDocument, index: Any, where: str) -> bytes:
    """Return the bytes of a buffer view.

    Raises
    ------
    MeshFileError
        If the view is malformed, or reaches past its buffer.
    """
    here = f"{gltf.path}: {where}"
    view = gltf.item("bufferViews", index, where)
    data = gltf.buffer(view.get("buffer"), f"{where}: bufferView {index}")
    start = _whole(view.get("byteOffset", 0), here, "bufferView.byteOffset")
    length = _whole(view.get("byteLength"), here, "bufferView.byteLength", least=1)
    if start + length > len(data):
        raise MeshFileError(f"{here}: bufferView {index} ends past its buffer of {len(data)} bytes")
    return data[start : start + length]


def _strided(
    gltf: GltfDocument,
    view_index: Any,
    offset: int,
    count: int,
    width: int,
    dtype: np.dtype[Any],
    here: str,
) -> np.ndarray[Any, Any]:
    view = gltf.item("bufferViews", view_index, here)
    data = gltf.buffer(view.get("buffer"), f"{here}: bufferView {view_index}")
    start = _whole(view.get("byteOffset", 0), here, "bufferView.byteOffset")
    length = _whole(view.get("byteLength"), here, "bufferView.byteLength", least=1)
    element = width * dtype.itemsize
    stride = _whole(view.get("byteStride", element), here, "byteStride", least=1)
    if stride < element:
        raise MeshFileError(f"{here}: byteStride is {stride}; an element has {element} bytes")
    needed = offset + stride * (count - 1) + element
    if needed > length or start + length > len(data):
        raise MeshFileError(
            f"{here} needs {needed} bytes of bufferView {view_index}, which has {length} bytes from"
            f" {start} in a buffer of {len(data)}"
        )
    gltf.count_numbers(count * width, here)
    table = np.ndarray((count, width), dtype, data, start + offset, (stride, dtype.itemsize))
    return table.copy()


def _with_sparse(
    gltf: GltfDocument, sparse: Any, values: np.ndarray[Any, Any], here: str
) -> np.ndarray[Any, Any]:
    if not isinstance(sparse, dict):
        raise MeshFileError(f"{here}: sparse is not an object")
    count = _whole(sparse.get("count"), here, "sparse.count", least=1)
    parts = []
    for name, width in (("indices", 1), ("values", values.shape[1])):
        part = sparse.get(name)
        if not isinstance(part, dict):
            raise MeshFileError(f"{here}: sparse.{name} is not an object")
        dtype = _component(part.get("componentType"), here) if name == "indices" else values.dtype
        offset = _whole(part.get("byteOffset", 0), here, f"sparse.{name}.byteOffset")
        parts.append(_strided(gltf, part.get("bufferView"), offset, count, width, dtype, here))
    indices = parts[0][:, 0].astype(np.int64)
    if indices.min() < 0 or indices.max() >= len(values):
        raise MeshFileError(f"{here}: sparse index {int(indices.max())} is out of range")
    values[indices] = parts[1]
    return values


def _component(code: Any, here: str) -> np.dtype[Any]:
    if not isinstance(code, int) or code not in COMPONENTS:
        raise MeshFileError(f"{here}: componentType is {code!r}")
    return np.dtype(COMPONENTS[code])


def normalised(values: np.ndarray[Any, Any], normalized: bool) -> FloatArray:
    """Return stored numbers as float64; integers in −1..1 or 0..1 if they are marked as normalized."""
    with np.errstate(invalid="ignore"):  # a signalling NaN is refused later, as any NaN
        result: FloatArray = values.astype(np.float64)
    if normalized and values.dtype.kind in "iu":
        result = np.maximum(result / np.iinfo(values.dtype).max, -1.0)
    return result


def _whole(value: Any, here: str, name: str, least: int = 0) -> int:
    if not isinstance(value, int) or isinstance(value, bool) or not least <= value <= GREATEST:
        raise MeshFileError(
            f"{here}: {name} is {value!r:.80}; it must be a whole number, {least} or more"
        )
    return value
