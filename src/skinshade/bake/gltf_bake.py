"""A glTF file baked: attributes for every triangle of it, and nothing else changed."""

from __future__ import annotations

import copy
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .._core.arrays import FloatArray, IntArray, as_positions, dot
from .._core.errors import MeshFileError
from .._core.progress import Progress, silent
from .._core.units import GLTF_UNIT_MM
from ..mesh.baked import GLTF_NAMES
from .accessors import FAN, STRIP, TRIANGLES, read_accessor, read_triangles
from .analysis import Analysed, Body, analyse
from .draco import DRACO, read_draco
from .gltf import REFUSED, GltfFile
from .gltf_attributes import AccessorWriter, baked_note
from .placement import placements, scale_of
from .settings import BakeSettings

__all__ = ["BakedMesh", "GltfBake", "bake_gltf", "read_scene"]

WIDTHS = {"POSITION": 3, "NORMAL": 3, "TEXCOORD_0": 2}
"""Attributes that are read, and how many numbers each has."""


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
        The new JSON, but for the place of ``added``.
    added
        Bytes of the new attributes, whose views are the last, and count from the first of these.
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
    # Meshes that differ in their materials alone are analysed once.
    known: dict[str, tuple[list[_Part], Body, Analysed] | None] = {}
    baked = []
    writer = _Writer(gltf)
    for index, mesh in enumerate(meshes):
        progress("baking", index / len(meshes))
        name = str(mesh.get("name") or index)
        unit, notes = _unit_mm(gltf, index, standing.get(index, []), settings)
        key = f"{unit} {_geometry_of(gltf, mesh, index)}"
        if key not in known:
            found = _read_mesh(gltf, mesh, index, unit)
            known[key] = found and (
                *found,
                analyse(found[1], settings, f"{gltf.path}: mesh {name}", progress),
            )
        if (there := known[key]) is not None:
            parts, body, result = there
            writer.add(index, parts, result, unit, settings)
            baked.append(BakedMesh(name, unit, body, result, notes))
    if not baked:
        raise MeshFileError(f"{gltf.path}: holds no triangles")
    return GltfBake(writer.document, bytes(writer.accessors.data), baked)


def read_scene(gltf: GltfFile, settings: BakeSettings) -> Body:
    """Return all meshes as the scene shows them, skinned ones in their bind pose, as one body.

    Raises
    ------
    MeshFileError
        If the file is malformed, or holds no triangles.
    """
    unit = settings.unit_mm or GLTF_UNIT_MM
    standing = placements(gltf)
    bodies = []
    for index, mesh in enumerate(gltf.items("meshes")):
        placed = standing.get(index, [] if "nodes" in gltf.document else [np.eye(4)])
        found = _read_mesh(gltf, mesh, index, unit) if placed else None
        if found is not None:
            as_positions(f"{gltf.path}: mesh {index}: positions", found[1].positions_mm / unit)
            for matrix in placed:
                gltf.ask(
                    found[1].positions_mm.size + found[1].faces.size, f"{gltf.path}: mesh {index}"
                )
                bodies.append(_placed(found[1], matrix, unit))
    if not bodies:
        raise MeshFileError(f"{gltf.path}: holds no triangles")
    starts = np.cumsum([0, *(len(each.positions_mm) for each in bodies[:-1])])
    faces = [each.faces + start for each, start in zip(bodies, starts, strict=True)]
    return Body(
        np.concatenate([each.positions_mm for each in bodies]),
        np.concatenate(faces),
        _all_of([each.normals for each in bodies]),
        _all_of([each.uvs for each in bodies]),
    )


def _placed(body: Body, matrix: FloatArray, unit: float) -> Body:
    rows, normals = matrix[:3, :3], body.normals
    # Normals turn by the cofactors, which a scale of zero along an axis leaves finite.
    with np.errstate(over="ignore", invalid="ignore"):  # what is not finite is refused later
        cofactors = np.cross(np.roll(rows, -1, axis=0), np.roll(rows, -2, axis=0))
        mirrored = float(dot(rows[0], cofactors[0])) < 0.0
        if normals is not None:
            normals = normals @ (-cofactors if mirrored else cofactors).T
        positions = body.positions_mm @ rows.T + unit * matrix[:3, 3]
    return Body(positions, body.faces[:, ::-1] if mirrored else body.faces, normals, body.uvs)


def _unit_mm(
    gltf: GltfFile, index: int, placed: list[FloatArray], settings: BakeSettings
) -> tuple[float, dict[str, int]]:
    """Length of a mesh's unit where it stands first, and what is to be said of it."""
    notes: dict[str, int] = {}
    unit = settings.unit_mm or GLTF_UNIT_MM
    if placed:
        scale, even = scale_of(placed[0])
        if not 1e-9 < scale < 1e9:
            raise MeshFileError(f"{gltf.path}: mesh {index}: its node scales it by {scale:g}")
        others = {round(scale_of(each)[0] / scale, 3) for each in placed}
        if not even:
            notes["meshes of uneven scale"] = 1
        if others != {1.0}:
            notes["meshes shown at several scales"] = 1
        unit *= scale
    elif "nodes" in gltf.document:
        notes["meshes that no node shows"] = 1
    return unit, notes


def _geometry_of(gltf: GltfFile, mesh: dict[str, Any], index: int) -> str:
    """What the triangles of a mesh are made of: the same for meshes of the same."""
    return repr(
        [
            (
                number,
                each.get("indices"),
                each.get("mode"),
                _vertices_of(each),
                each.get("extensions"),
            )
            for number, each in _triangle_primitives(gltf, mesh, index)
        ]
    )


def _vertices_of(primitive: dict[str, Any]) -> str:
    return repr([primitive["attributes"].get(name) for name in WIDTHS])


def _read_mesh(
    gltf: GltfFile, mesh: dict[str, Any], index: int, unit: float
) -> tuple[list[_Part], Body] | None:
    parts, columns, faces, start = [], [], [], 0
    known: dict[str, slice] = {}
    for number, primitive in _triangle_primitives(gltf, mesh, index):
        where = f"mesh {index}: primitive {number}"
        key = _vertices_of(primitive)
        table, corners = None, None
        if DRACO in (primitive.get("extensions") or {}):
            table, corners = read_draco(gltf, primitive, WIDTHS, where)
        elif key not in known:  # primitives often share their vertices, and differ in indices
            table = _columns(gltf, primitive, where)
        if table is not None:
            known[key] = slice(start, start + len(table["POSITION"]))
            columns.append(table)
            start = known[key].stop
        vertices = known[key]
        if corners is None:
            corners = read_triangles(gltf, primitive, vertices.stop - vertices.start, where)
        faces.append(corners + vertices.start)
        parts.append(_Part(number, vertices))
    if not parts or not sum(map(len, faces)):
        return None
    return parts, _joined(columns, np.concatenate(faces), unit)


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
        extensions = primitive.get("extensions", {})
        if not isinstance(extensions, dict):
            raise MeshFileError(
                f"{gltf.path}: mesh {index}: primitive {number}: extensions is no object"
            )
        for name, called in REFUSED.items():
            if name in extensions:
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
    table = {
        name: read_accessor(gltf, attributes[name], f"{where}: {name}", width=width)
        for name, width in WIDTHS.items()
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
    positions = np.concatenate([table["POSITION"] for table in columns])
    normals, uvs = (
        _all_of([table.get(name) for table in columns]) for name in ("NORMAL", "TEXCOORD_0")
    )
    return Body(positions * unit, faces, normals, uvs)


def _all_of(parts: list[FloatArray | None]) -> FloatArray | None:
    found = [each for each in parts if each is not None]
    return np.concatenate(found) if len(found) == len(parts) else None


class _Writer:
    """Adds attributes to a copy of the document."""

    def __init__(self, gltf: GltfFile) -> None:
        self.document = copy.deepcopy(gltf.document)
        self.accessors = AccessorWriter(self.document)
        self._known: dict[tuple[int, str, int], tuple[Analysed, int]] = {}

    def add(
        self,
        index: int,
        parts: list[_Part],
        result: Analysed,
        unit_mm: float,
        settings: BakeSettings,
    ) -> None:
        """Add what was baked of one mesh, and say so in its extras."""
        mesh = self.document["meshes"][index]
        for key, values in result.attributes.items():
            for name, numbers in GLTF_NAMES[key]:
                for part in parts:
                    attributes = mesh["primitives"][part.number]["attributes"]
                    place = (id(result), name, part.vertices.start)
                    if place not in self._known:
                        added = self.accessors.vertices(values[part.vertices, numbers])
                        self._known[place] = result, added
                    attributes[name] = self._known[place][1]
        extras = mesh.setdefault("extras", {})
        if isinstance(extras, dict):
            extras["skinshade"] = baked_note(result, unit_mm, settings)
