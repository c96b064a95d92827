"""Geometry compressed by Draco."""

from __future__ import annotations

from importlib.util import find_spec
from typing import Any

import numpy as np

from .._core.arrays import FloatArray, IntArray
from .._core.errors import MeshFileError
from .accessors import normalised, view_bytes
from .document import GltfDocument

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
        values = np.asarray(arrays.get(names[name], np.zeros((0, 0))))
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
