"""Geometry compressed by Draco."""

from __future__ import annotations

from importlib.util import find_spec
from typing import Any

import numpy as np

from .._core.arrays import FloatArray, IntArray
from .._core.errors import ArgumentError, MeshFileError
from .._core.limits import check_limit
from .accessors import normalised, view_bytes
from .document import GltfDocument
from .draco_header import draco_counts

__all__ = ["DRACO", "read_draco"]

DRACO = "KHR_draco_mesh_compression"


def read_draco(
    gltf: GltfDocument, primitive: dict[str, Any], wanted: dict[str, int], where: str
) -> tuple[dict[str, FloatArray], IntArray]:
    """Return attributes (V, n) by name, and triangles (F, 3), of a compressed primitive.

    Parameters
    ----------
    gltf
        Document.
    primitive
        Primitive with the extension.
    wanted
        Numbers of components of the attributes to read, by name.
    where
        Name of the primitive in error messages.

    Raises
    ------
    MeshFileError
        If the decoder is not installed, or the data contradict the document.
    """
    here = f"{gltf.path}: {where}"
    if find_spec("DracoPy") is None:
        raise MeshFileError(
            f'{here} is compressed by Draco: pip install "skinshade[draco]", or export it uncompressed'
        )
    import DracoPy

    extension = primitive["extensions"][DRACO]
    names = extension.get("attributes") if isinstance(extension, dict) else None
    if not isinstance(names, dict):
        raise MeshFileError(f"{here}: {DRACO} has no attributes")
    data = view_bytes(gltf, extension.get("bufferView"), f"{where}: {DRACO}")
    _check_counts(data, here)
    try:
        decoded: Any = DracoPy.decode(data)
        arrays = {attribute["unique_id"]: attribute["data"] for attribute in decoded.attributes}
        faces = np.asarray(decoded.faces, dtype=np.int64)
    except Exception as error:  # the decoder and its wrapper raise many types
        raise MeshFileError(f"{here}: Draco cannot decode it ({error})") from None
    table: dict[str, FloatArray] = {}
    for name, width in wanted.items():
        if name not in primitive["attributes"] or name not in names:
            continue
        attribute = names[name]
        if not isinstance(attribute, int) or attribute not in arrays:
            raise MeshFileError(f"{here}: Draco has no attribute {attribute!r:.80} for {name}")
        values = np.asarray(arrays[attribute])
        if values.ndim != 2 or values.shape[1] != width or not len(values):
            raise MeshFileError(f"{here}: {name} has shape {values.shape} after decoding")
        accessor = gltf.item("accessors", primitive["attributes"][name], f"{where}: {name}")
        if accessor.get("count") != len(values):
            raise MeshFileError(
                f"{here}: {name} has {len(values)} elements, not {accessor.get('count')!r}"
            )
        table[name] = normalised(values, bool(accessor.get("normalized", False)))
    if "POSITION" not in table:
        raise MeshFileError(f"{here}: {DRACO} has no POSITION")
    shaped = faces.ndim == 2 and faces.shape[1] == 3
    if not shaped or (faces.size and faces.max() >= len(table["POSITION"])):
        raise MeshFileError(f"{here}: Draco returns faces with indices out of range")
    return table, faces


def _check_counts(data: bytes, here: str) -> None:
    """Raise if the header states more triangles or vertices than the limits allow."""
    try:
        counts = draco_counts(data)
    except (IndexError, ArgumentError):
        raise MeshFileError(f"{here}: Draco cannot decode it (its header is corrupt)") from None
    if counts is not None:
        check_limit("triangles", counts[0], here, MeshFileError)
        check_limit("vertices", counts[1], here, MeshFileError)
