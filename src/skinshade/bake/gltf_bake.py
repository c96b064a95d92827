"""A glTF file baked: attributes for every triangle of it, and nothing else changed."""

from __future__ import annotations

import copy
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .._core.arrays import FloatArray, IntArray
from .._core.errors import MeshFileError
from .._core.progress import Progress, silent
from .._core.version import __version__
from .accessors import FAN, STRIP, TRIANGLES, read_accessor, read_triangles
from .analysis import Analysed, Body, analyse
from .gltf import REFUSED, GltfFile
from .placement import placements, scale_of
from .settings import BakeSettings

__all__ = ["NEW_BUFFER", "BakedMesh", "GltfBake", "bake_gltf"]

METRE_MM = 1000.0
FLOAT, ARRAY_BUFFER = 5126, 34962
NAMES = {
    "curvature": (("_CURVATURE", slice(0, 1)),),
    "tensor": (("_CURVATURE_TENSOR_0", slice(0, 3)), ("_CURVATURE_TENSOR_1", slice(3, 6))),
    "thickness": (("_THICKNESS", slice(0, 1)),),
}
"""Attributes of a primitive, and which numbers of the analysis they hold: xx xy xz, then yy yz zz."""
UNITS = {"curvature": "1/mm", "tensor": "1/mm", "thickness": "mm"}
TYPES = {1: "SCALAR", 3: "VEC3"}


@dataclass(frozen=True)
class BakedMesh:
    """One mesh of the file.

    Attributes
    ----------
    name
        Its own, or its number.
    unit_mm
        Length of its unit, the scale of its node included.
    body, analysed
        Triangles in mm, and what came of them.
    notes
        What was noticed beside the analysis, and how often.
    """

    name: str
    unit_mm: float
    body: Body
    analysed: Analysed
    notes: dict[str, int] = field(default_factory=dict)


@dataclass(frozen=True)
class GltfBake:
    """What came of a file.

    Attributes
    ----------
    document
        The new JSON, but for the buffer that ``added`` goes to.
    added
        Bytes of the new attributes; their views count from 0 in buffer −1.
    meshes
        Those that were baked.
    """

    document: dict[str, Any]
    added: bytes
    meshes: list[BakedMesh]


@dataclass(frozen=True)
class _Part:
    """One primitive: its number in the mesh, and its vertices in the body."""

    number: int
    vertices: slice


def bake_gltf(gltf: GltfFile, settings: BakeSettings, progress: Progress = silent) -> GltfBake:
    """Analyse every mesh of a file and add the attributes.

    Parameters
    ----------
    gltf
        As read.
    settings
        What is wanted.
    progress
        Called with what is being done and how far it is.

    Raises
    ------
    MeshFileError, MeshError
        If the file is malformed, or holds no triangles.
    """
    standing = placements(gltf)
    meshes = gltf.items("meshes")
    baked, analysed = [], {}
    for index, mesh in enumerate(meshes):
        progress("baking", index / len(meshes))
        found = _read_mesh(gltf, mesh, index, standing.get(index, []), settings)
        if found is not None:
            unit, parts, body, notes = found
            name = str(mesh.get("name") or index)
            result = analyse(body, settings, f"{gltf.path}: mesh {name}", progress)
            analysed[index] = (parts, result)
            baked.append(BakedMesh(name, unit, body, result, notes))
    if not baked:
        raise MeshFileError(f"{gltf.path}: holds no triangles")
    writer = _Writer(gltf)
    for (index, (parts, result)), each in zip(analysed.items(), baked, strict=True):
        writer.add(index, parts, result, each.unit_mm, settings)
    return GltfBake(writer.document, bytes(writer.added), baked)


def _read_mesh(
    gltf: GltfFile,
    mesh: dict[str, Any],
    index: int,
    placed: list[FloatArray],
    settings: BakeSettings,
) -> tuple[float, list[_Part], Body, dict[str, int]] | None:
    notes: dict[str, int] = {}
    unit = settings.unit_mm or METRE_MM
    if placed:
        scale, even = scale_of(placed[0])
        others = {round(scale_of(each)[0] / max(scale, 1e-300), 3) for each in placed}
        if not even:
            notes["meshes of uneven scale"] = 1
        if others != {1.0}:
            notes["meshes shown at several scales"] = 1
        if not 1e-9 < scale < 1e9:
            raise MeshFileError(f"{gltf.path}: mesh {index}: its node scales it by {scale:g}")
        unit *= scale
    elif "nodes" in gltf.document:
        notes["meshes that no node shows"] = 1
    parts, columns, faces, start = [], [], [], 0
    for number, primitive in _triangle_primitives(gltf, mesh, index):
        where = f"mesh {index}: primitive {number}"
        table = _columns(gltf, primitive, where)
        count = len(table["POSITION"])
        faces.append(read_triangles(gltf, primitive, count, where) + start)
        columns.append(table)
        parts.append(_Part(number, slice(start, start + count)))
        start += count
    if not parts or not sum(map(len, faces)):
        return None
    return unit, parts, _joined(columns, np.concatenate(faces), unit), notes


def _triangle_primitives(
    gltf: GltfFile, mesh: dict[str, Any], index: int
) -> Iterator[tuple[int, dict[str, Any]]]:
    primitives = mesh.get("primitives")
    if not isinstance(primitives, list) or not all(isinstance(p, dict) for p in primitives):
        raise MeshFileError(f"{gltf.path}: mesh {index}: primitives is not an array of objects")
    for number, primitive in enumerate(primitives):
        attributes = primitive.get("attributes")
        if not isinstance(attributes, dict):
            raise MeshFileError(f"{gltf.path}: mesh {index}: primitive {number} has no attributes")
        for name, called in REFUSED.items():
            if name in (primitive.get("extensions") or {}):
                raise MeshFileError(
                    f"{gltf.path}: mesh {index}: primitive {number} is compressed by {called}, which is"
                    " not decoded here; export it uncompressed"
                )
        mode = primitive.get("mode", TRIANGLES)
        if mode in (TRIANGLES, STRIP, FAN) and "POSITION" in attributes:
            yield number, primitive
        elif mode not in range(7):
            raise MeshFileError(f"{gltf.path}: mesh {index}: primitive {number}: mode is {mode!r}")


def _columns(gltf: GltfFile, primitive: dict[str, Any], where: str) -> dict[str, FloatArray]:
    attributes = primitive["attributes"]
    wanted = {"POSITION": 3, "NORMAL": 3, "TEXCOORD_0": 2}
    table = {
        name: read_accessor(gltf, attributes[name], f"{where}: {name}", width=width)
        for name, width in wanted.items()
        if name in attributes
    }
    count = len(table["POSITION"])
    for name, values in table.items():
        if len(values) != count:
            raise MeshFileError(
                f"{gltf.path}: {where}: {name} has {len(values)} elements for {count} vertices"
            )
    return table


def _joined(columns: list[dict[str, FloatArray]], faces: IntArray, unit: float) -> Body:
    """One body of all primitives; what not all of them have is left out."""

    def all_of(name: str) -> FloatArray | None:
        if not all(name in table for table in columns):
            return None
        return np.concatenate([table[name] for table in columns])

    positions = all_of("POSITION")
    assert positions is not None
    return Body(positions * unit, faces, all_of("NORMAL"), all_of("TEXCOORD_0"))


NEW_BUFFER = -1
"""Stands for the buffer that whoever writes the file decides on."""


class _Writer:
    """Adds accessors to a copy of the document."""

    def __init__(self, gltf: GltfFile) -> None:
        self.document = copy.deepcopy(gltf.document)
        self.added = bytearray()

    def add(
        self,
        index: int,
        parts: list[_Part],
        result: Analysed,
        unit_mm: float,
        settings: BakeSettings,
    ) -> None:
        """Add what was baked of one mesh, and say so in its extras."""
        mesh, told = self.document["meshes"][index], {}
        for key, values in result.attributes.items():
            for name, numbers in NAMES[key]:
                told[name] = UNITS[key]
                for part in parts:
                    attributes = mesh["primitives"][part.number]["attributes"]
                    attributes[name] = self._accessor(values[part.vertices, numbers])
        extras = mesh.setdefault("extras", {})
        if isinstance(extras, dict):
            extras["skinshade"] = {
                "version": __version__,
                "unit_mm": unit_mm,
                "profile": settings.profile,
                "uv_scale_mm": result.uv_scale_mm,
                "attributes": told,
            }

    def _accessor(self, values: FloatArray) -> int:
        data = np.ascontiguousarray(values, dtype="<f4")
        views = self.document.setdefault("bufferViews", [])
        views.append(
            {
                "buffer": NEW_BUFFER,
                "byteOffset": len(self.added),
                "byteLength": data.nbytes,
                "target": ARRAY_BUFFER,
            }
        )
        self.added += data.tobytes()
        accessors = self.document.setdefault("accessors", [])
        accessors.append(
            {
                "bufferView": len(views) - 1,
                "componentType": FLOAT,
                "count": len(data),
                "type": TYPES[data.shape[1]],
                "min": [float(value) for value in data.min(axis=0)],
                "max": [float(value) for value in data.max(axis=0)],
            }
        )
        return len(accessors) - 1
