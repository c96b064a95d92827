"""Triangles of glTF meshes: primitives of every mode, joined and placed."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from .._core.arrays import FloatArray, IntArray, as_positions, dot
from .._core.errors import MeshFileError
from .._core.limits import check_limit
from .accessors import FAN, STRIP, TRIANGLES, accessor_width, read_accessor, read_triangles
from .document import COMPRESSED, GltfDocument
from .draco import DRACO, read_draco
from .placement import Placement, SkippedNode, mesh_placements

__all__ = [
    "Part",
    "Placed",
    "TriangleSet",
    "geometry_key",
    "joined",
    "no_mesh_reason",
    "read_mesh",
    "read_scene",
]

WIDTHS = {"POSITION": 3, "NORMAL": 3, "TEXCOORD_0": 2}
"""Numbers of the attributes that are always read."""


@dataclass(frozen=True)
class TriangleSet:
    """Triangles with their vertices.

    Attributes
    ----------
    positions
        (V, 3).
    faces
        (F, 3) indices of vertices.
    normals
        (V, 3) as stored, or None.
    uvs
        (V, 2), v down, or None.
    attributes
        Custom attributes (V, n) by their names in the document.
    materials
        (F,) number of every face's material, −1 for none; None if the format has no materials.
    """

    positions: FloatArray
    faces: IntArray
    normals: FloatArray | None
    uvs: FloatArray | None
    attributes: Mapping[str, FloatArray] = field(default_factory=dict)
    materials: IntArray | None = None


@dataclass(frozen=True)
class Part:
    """A primitive of a mesh.

    Attributes
    ----------
    number
        Index of the primitive in the mesh.
    vertices
        Its vertices in the mesh's `TriangleSet`; primitives can share them.
    """

    number: int
    vertices: slice


@dataclass(frozen=True)
class Placed:
    """A mesh as the scene shows it.

    Attributes
    ----------
    mesh
        Index of the mesh.
    matrix
        (4, 4) from the mesh's axes to the scene's.
    triangles
        Its triangles in the scene's axes.
    """

    mesh: int
    matrix: FloatArray
    triangles: TriangleSet


def read_mesh(
    gltf: GltfDocument, index: int, *, custom: bool = False
) -> tuple[list[Part], TriangleSet] | None:
    """Return the primitives of a mesh and their joined triangles, or None if it has no triangles.

    Attributes that not every primitive has are left out.

    Parameters
    ----------
    gltf
        Document.
    index
        Index of the mesh.
    custom
        Read custom attributes, whose names begin with an underscore.

    Raises
    ------
    MeshFileError
        If the mesh is malformed.
    """
    parts: list[Part] = []
    tables: list[dict[str, FloatArray]] = []
    faces: list[IntArray] = []
    materials: list[IntArray] = []
    known: dict[str, slice] = {}
    start = 0
    for number, primitive in _triangle_primitives(gltf, index):
        where = f"mesh {index}: primitive {number}"
        widths = WIDTHS | (_custom_widths(gltf, primitive, where) if custom else {})
        key = _vertex_key(primitive, widths)
        table, corners = None, None
        if DRACO in (primitive.get("extensions") or {}):
            table, corners = read_draco(gltf, primitive, widths, where)
        elif key not in known:  # primitives often share vertices and differ in their indices
            table = _read_attributes(gltf, primitive, widths, where)
        if table is not None:
            known[key] = slice(start, start + len(table["POSITION"]))
            tables.append(table)
            start = known[key].stop
        vertices = known[key]
        if corners is None:
            corners = read_triangles(gltf, primitive, vertices.stop - vertices.start, where)
        faces.append(corners + vertices.start)
        materials.append(np.full(len(corners), _material(gltf, primitive, where), dtype=np.int64))
        parts.append(Part(number, vertices))
    triangles = sum(map(len, faces))
    if not triangles:
        return None
    check_limit("vertices", start, f"{gltf.path}: mesh {index}", MeshFileError)
    check_limit("triangles", triangles, f"{gltf.path}: mesh {index}", MeshFileError)
    return parts, _triangle_set(tables, np.concatenate(faces), np.concatenate(materials))


def read_scene(gltf: GltfDocument, *, custom: bool = False) -> tuple[list[Placed], dict[str, int]]:
    """Return the meshes of the default scene, placed, and counts of those that are skipped.

    Skinned meshes are in their bind pose. Meshes that their nodes scale by 0, or by a number that is not
    finite, are skipped.

    Parameters
    ----------
    gltf
        Document.
    custom
        Read custom attributes, whose names begin with an underscore.

    Raises
    ------
    MeshFileError, ArgumentError
        If the document is malformed, holds no triangles, a position is out of range, or every mesh is
        skipped.
    """
    placements = mesh_placements(gltf, visible_only=True)
    unplaced = Placement([] if "nodes" in gltf.json else [np.eye(4)])
    placed: list[Placed] = []
    skipped: list[tuple[int, SkippedNode]] = []
    vertices = triangles = 0
    for index in range(len(gltf.items("meshes"))):
        placement = placements.get(index, unplaced)
        skipped += [(index, node) for node in placement.skipped]
        matrices = placement.matrices
        mesh = read_mesh(gltf, index, custom=custom) if matrices else None
        if mesh is None:
            continue
        where = f"{gltf.path}: mesh {index}"
        as_positions(f"{where}: positions", mesh[1].positions)
        vertices += len(matrices) * len(mesh[1].positions)
        triangles += len(matrices) * len(mesh[1].faces)
        check_limit("vertices", vertices, f"{where}: all instances", MeshFileError)
        check_limit("triangles", triangles, f"{where}: all instances", MeshFileError)
        for matrix in matrices:
            gltf.count_numbers(mesh[1].positions.size + mesh[1].faces.size, where)
            placed.append(Placed(index, matrix, _placed(mesh[1], matrix)))
    if not placed:
        raise MeshFileError(f"{gltf.path}: {no_mesh_reason(skipped)}")
    return placed, dict(Counter(node.note for _, node in skipped))


def no_mesh_reason(skipped: Sequence[tuple[int, SkippedNode]]) -> str:
    """Return why a document shows no triangles, for an error message.

    Parameters
    ----------
    skipped
        Index of the mesh, and the node, of everything that is skipped.
    """
    if not skipped:
        return "holds no triangles"
    index, node = skipped[0]
    return f"mesh {index}: {node.reason}"


def geometry_key(gltf: GltfDocument, index: int) -> str:
    """Return a key that is equal for meshes of a document with equal geometry."""
    return repr(
        [
            (
                number,
                primitive.get("indices"),
                primitive.get("mode"),
                _vertex_key(primitive, WIDTHS),
                primitive.get("extensions"),
            )
            for number, primitive in _triangle_primitives(gltf, index)
        ]
    )


def joined(sets: Sequence[TriangleSet]) -> TriangleSet:
    """Return one set of all triangles.

    Normals and UVs that a part of the sets lacks are 0 there. Attributes that one set lacks, and materials
    that one set lacks, are left out.
    """
    if len(sets) == 1:
        return sets[0]
    counts = [len(part.positions) for part in sets]
    materials = [part.materials for part in sets if part.materials is not None]
    starts = np.cumsum([0, *(len(part.positions) for part in sets[:-1])])
    shared = set.intersection(
        *({(name, v.shape[1]) for name, v in part.attributes.items()} for part in sets)
    )
    return TriangleSet(
        np.concatenate([part.positions for part in sets]),
        np.concatenate([part.faces + start for part, start in zip(sets, starts, strict=True)]),
        _any_or_none([part.normals for part in sets], counts),
        _any_or_none([part.uvs for part in sets], counts),
        {
            name: np.concatenate([part.attributes[name] for part in sets])
            for name, _ in sorted(shared)
        },
        np.concatenate(materials) if len(materials) == len(sets) else None,
    )


def _placed(triangles: TriangleSet, matrix: FloatArray) -> TriangleSet:
    rows, normals = matrix[:3, :3], triangles.normals
    # Normals are transformed by the cofactors, which stay finite where a scale is 0. Values that are not
    # finite are refused later.
    with np.errstate(over="ignore", invalid="ignore"):
        cofactors = np.cross(np.roll(rows, -1, axis=0), np.roll(rows, -2, axis=0))
        mirrored = float(dot(rows[0], cofactors[0])) < 0.0
        if normals is not None:
            normals = normals @ (-cofactors if mirrored else cofactors).T
        positions = triangles.positions @ rows.T + matrix[:3, 3]
    faces = triangles.faces[:, ::-1] if mirrored else triangles.faces
    return replace(triangles, positions=positions, faces=faces, normals=normals)


def _vertex_key(primitive: dict[str, Any], names: Iterable[str]) -> str:
    """Return a key that is equal for primitives with the same accessors of these attributes."""
    return repr([primitive["attributes"].get(name) for name in sorted(names)])


def _triangle_primitives(gltf: GltfDocument, index: int) -> Iterator[tuple[int, dict[str, Any]]]:
    """Yield number and JSON of every primitive with triangles, checked."""
    primitives = gltf.items("meshes")[index].get("primitives")
    if not isinstance(primitives, list) or not all(isinstance(p, dict) for p in primitives):
        raise MeshFileError(f"{gltf.path}: mesh {index}: primitives is not an array of objects")
    for number, primitive in enumerate(primitives):
        here = f"{gltf.path}: mesh {index}: primitive {number}"
        attributes = primitive.get("attributes")
        if not isinstance(attributes, dict):
            raise MeshFileError(f"{here} has no attributes")
        extensions = primitive.get("extensions", {})
        if not isinstance(extensions, dict):
            raise MeshFileError(f"{here}: extensions is not an object")
        for name, compression in COMPRESSED.items():
            if name in extensions:
                raise MeshFileError(
                    f"{here} is compressed by {compression}, which cannot be decoded; export it"
                    " uncompressed"
                )
        mode = primitive.get("mode", TRIANGLES)
        if mode in (TRIANGLES, STRIP, FAN) and "POSITION" in attributes:
            yield number, primitive
        elif mode not in range(7):
            raise MeshFileError(f"{here}: mode is {mode!r}; it must be 0..6")


def _custom_widths(gltf: GltfDocument, primitive: dict[str, Any], where: str) -> dict[str, int]:
    widths = {
        name: accessor_width(gltf, accessor, f"{where}: {name}")
        for name, accessor in primitive["attributes"].items()
        if name.startswith("_")
    }
    return {name: width for name, width in widths.items() if width is not None}


def _read_attributes(
    gltf: GltfDocument, primitive: dict[str, Any], widths: Mapping[str, int], where: str
) -> dict[str, FloatArray]:
    attributes = primitive["attributes"]
    table = {
        name: read_accessor(gltf, attributes[name], f"{where}: {name}", width=width)
        for name, width in widths.items()
        if name in attributes
    }
    count = len(table["POSITION"])
    for name, values in table.items():
        if len(values) != count:
            raise MeshFileError(
                f"{gltf.path}: {where}: {name} has {len(values)} elements for {count} vertices"
            )
    return table


def _material(gltf: GltfDocument, primitive: dict[str, Any], where: str) -> int:
    """Return the index of a primitive's material, or −1."""
    index: int = primitive.get("material", -1)
    if index != -1:
        gltf.item("materials", index, where)
    return index


def _triangle_set(
    tables: Sequence[Mapping[str, FloatArray]], faces: IntArray, materials: IntArray
) -> TriangleSet:
    positions = np.concatenate([table["POSITION"] for table in tables])
    counts = [len(table["POSITION"]) for table in tables]
    normals, uvs = (
        _any_or_none([table.get(name) for table in tables], counts)
        for name in ("NORMAL", "TEXCOORD_0")
    )
    names = [name for name in tables[0] if name not in WIDTHS]
    columns = {name: _all_or_none([table.get(name) for table in tables]) for name in names}
    attributes = {name: values for name, values in columns.items() if values is not None}
    return TriangleSet(positions, faces, normals, uvs, attributes, materials)


def _any_or_none(arrays: Sequence[FloatArray | None], counts: Sequence[int]) -> FloatArray | None:
    """Return the arrays (n, width) in one, with 0 for those that are missing; None if all are missing."""
    widths = {array.shape[1] for array in arrays if array is not None}
    if len(widths) != 1:
        return None
    width = widths.pop()
    return np.concatenate(
        [
            np.zeros((count, width)) if array is None else array
            for array, count in zip(arrays, counts, strict=True)
        ]
    )


def _all_or_none(arrays: Sequence[FloatArray | None]) -> FloatArray | None:
    present = [array for array in arrays if array is not None]
    shapes = {array.shape[1:] for array in present}
    return np.concatenate(present) if len(present) == len(arrays) and len(shapes) == 1 else None
