"""Geometry compressed by Draco, in the order in which it comes out: additions go uncompressed beside it."""

from __future__ import annotations

from importlib.util import find_spec
from typing import Any

import numpy as np

from .._core.arrays import FloatArray, IntArray
from .._core.errors import MeshFileError
from .accessors import as_floats_of, view_bytes
from .gltf import GltfFile

__all__ = ["DRACO", "read_draco"]

DRACO = "KHR_draco_mesh_compression"


def read_draco(
    gltf: GltfFile, primitive: dict[str, Any], wanted: dict[str, int], where: str
) -> tuple[dict[str, FloatArray], IntArray]:
    """Return attributes (V, n) by name and triangles (F, 3) of a compressed primitive.

    Parameters
    ----------
    gltf
        The file.
    primitive
        With the extension.
    wanted
        Numbers of each attribute that is asked for, by its name.
    where
        What messages call the primitive.

    Raises
    ------
    MeshFileError
        If the decoder is not installed, or refuses the data, or the data is not what the file says.
    """
    here = f"{gltf.path}: {where}"
    if find_spec("DracoPy") is None:
        raise MeshFileError(
            f'{here} is compressed by Draco: pip install "skinshade[draco]", or export it uncompressed'
        )
    import DracoPy

    described = primitive["extensions"][DRACO]
    names = described.get("attributes") if isinstance(described, dict) else None
    if not isinstance(names, dict):
        raise MeshFileError(f"{here}: {DRACO} has no attributes")
    data = view_bytes(gltf, described.get("bufferView"), f"{where}: {DRACO}")
    try:
        decoded: Any = DracoPy.decode(data)
        held = {each["unique_id"]: each["data"] for each in decoded.attributes}
        faces = np.asarray(decoded.faces, dtype=np.int64)
    except Exception as error:  # the decoder's own, and what its wrapper makes of odd data
        raise MeshFileError(f"{here}: Draco cannot decode it ({error})") from None
    table: dict[str, FloatArray] = {}
    for name, width in wanted.items():
        if name not in primitive["attributes"] or name not in names:
            continue
        values = np.asarray(held.get(names[name], np.zeros((0, 0))))
        if values.ndim != 2 or values.shape[1] != width or not len(values):
            raise MeshFileError(f"{here}: {name} is {values.shape} after decoding")
        accessor = gltf.item("accessors", primitive["attributes"][name], f"{where}: {name}")
        if accessor.get("count") != len(values):
            raise MeshFileError(
                f"{here}: {name} has {len(values)} elements, not {accessor.get('count')!r}"
            )
        table[name] = as_floats_of(values, bool(accessor.get("normalized", False)))
    if "POSITION" not in table:
        raise MeshFileError(f"{here}: {DRACO} holds no POSITION")
    if (
        faces.ndim != 2
        or faces.shape[1] != 3
        or (faces.size and faces.max() >= len(table["POSITION"]))
    ):
        raise MeshFileError(f"{here}: Draco gives faces that are none")
    return table, faces
