"""Meshes from files: glTF through the document model, OBJ, PLY and STL through trimesh."""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from .._core.arrays import FloatArray
from .._core.errors import MeshFileError, SkinshadeError, UnitError
from .._core.files import existing_file
from .._core.units import GLTF_UNIT_MM, checked_unit_mm
from ..gltf import GLTF_SUFFIXES, TriangleSet, read_gltf, read_scene
from ..gltf.primitives import joined
from .baked import GLTF_NAMES, baked_attributes, baked_unit_mm
from .model import Mesh
from .size import UnitSource, warn_of_size

__all__ = ["SUFFIXES", "load_mesh"]

SUFFIXES = (*GLTF_SUFFIXES, ".obj", ".ply", ".stl")
SAME_UNIT = 1e-4
"""Relative difference of units that count as equal: node scales are single precision."""


@dataclass(frozen=True)
class _Part:
    """Triangles of a part of the file, and the unit that a bake noted for it, mm."""

    triangles: TriangleSet
    baked_unit_mm: float | None


def load_mesh(path: str | os.PathLike[str], *, unit_mm: float | None = None) -> Mesh:
    """Read a mesh: all parts of the file as one, placed as the file's scene places them.

    Parameters
    ----------
    path
        ``.glb``, ``.gltf``, ``.obj``, ``.ply`` or ``.stl``.
    unit_mm
        Length of one unit of the file, mm. It can be left out for glTF, whose unit is the metre, and
        for files of `skinshade bake`, which state theirs.

    Returns
    -------
    Mesh
        UVs have v down, as in glTF, whatever the file's convention. Its attributes are the file's custom
        ones, and ``curvature``, ``tensor`` and ``thickness`` if the file was baked for this unit.

    Raises
    ------
    MeshFileError, MeshError, UnitError
        If the file is missing, corrupt or of another kind, holds no usable triangle, or its unit is
        unknown.

    Warns
    -----
    UnitWarning
        If the unit makes the object smaller than an ear or larger than a person
        (`skinshade.mesh.size.PLAUSIBLE_MM`).

    Examples
    --------
    >>> import skinshade as sk
    >>> from importlib.resources import files
    >>> mesh = sk.load_mesh(files("skinshade") / "heads/assets/head.glb")
    >>> mesh
    Mesh(20560 vertices, 40034 faces, 174.2 × 322 × 213.1 mm, UVs, attributes: _REGION)
    """
    file = existing_file(path, MeshFileError)
    suffix = file.suffix.lower()
    if suffix not in SUFFIXES:
        raise MeshFileError(
            f"{file}: {suffix or 'no suffix'}; a mesh is one of {' '.join(SUFFIXES)}"
        )
    is_gltf = suffix in GLTF_SUFFIXES
    if unit_mm is None and not is_gltf:
        raise UnitError(
            f"{file}: {suffix} files do not state their unit; give unit_mm (1 mm, 10 cm, 1000 m)"
        )
    parts, notes = _gltf_parts(file) if is_gltf else (_trimesh_parts(file), {})
    triangles = joined([part.triangles for part in parts])
    baked = _common_unit([part.baked_unit_mm for part in parts])
    given = None if unit_mm is None else checked_unit_mm(unit_mm, str(file))
    unit = given or baked or GLTF_UNIT_MM
    if baked is None or abs(unit / baked - 1.0) > SAME_UNIT:
        # Values that were baked for another unit, or for none that is known, do not hold.
        kept = {k: v for k, v in triangles.attributes.items() if k not in GLTF_NAMES}
        triangles = replace(triangles, attributes=kept)
    try:
        mesh = Mesh.checked(
            triangles.positions,
            triangles.faces,
            unit_mm=unit,
            normals=triangles.normals,
            uvs=triangles.uvs,
            attributes={name: _narrow(v) for name, v in triangles.attributes.items()},
            materials=triangles.materials,
            name=str(file),
        )
    except SkinshadeError as error:
        raise type(error)(str(error)) from None
    mesh = replace(mesh, repairs={**notes, **mesh.repairs})
    source: UnitSource = "given" if given else "baked" if baked else "format"
    warn_of_size(np.ptp(mesh.positions_mm, axis=0), file, unit, source)
    return mesh


def _narrow(values: FloatArray) -> FloatArray:
    """Return a column (V, 1) as (V,)."""
    return values[:, 0] if values.ndim == 2 and values.shape[1] == 1 else values


def _common_unit(units: Sequence[float | None]) -> float | None:
    """Return the unit that a bake noted for every part, or None if they differ or one is missing."""
    known = [unit for unit in units if unit is not None]
    if len(known) < len(units) or max(known) > min(known) * (1.0 + SAME_UNIT):
        return None
    return known[0]


def _gltf_parts(file: Path) -> tuple[list[_Part], dict[str, int]]:
    """Return the parts of a file, and counts of meshes that are skipped."""
    gltf = read_gltf(file)
    parts = []
    scene, notes = read_scene(gltf, custom=True)
    for placed in scene:
        extras = gltf.items("meshes")[placed.mesh].get("extras")
        note = extras.get("skinshade") if isinstance(extras, dict) else None
        unit = baked_unit_mm(note, placed.matrix)
        triangles = placed.triangles
        if unit is not None:
            baked = baked_attributes(triangles.attributes, placed.matrix)
            triangles = replace(triangles, attributes={**triangles.attributes, **baked})
        parts.append(_Part(triangles, unit))
    return parts, notes


def _trimesh_parts(file: Path) -> list[_Part]:
    import trimesh

    is_obj = file.suffix.lower() == ".obj"
    options: dict[str, Any] = {"process": False}
    if is_obj:
        options["skip_materials"] = True
        _refuse_index_zero(file)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # trimesh's arithmetic on files without materials
            scene = trimesh.load_scene(file, **options)
        sets = [
            _trimesh_triangles(scene.geometry[name], np.asarray(matrix, dtype=np.float64))
            for matrix, name in (scene.graph[node] for node in scene.graph.nodes_geometry)
            if isinstance(scene.geometry[name], trimesh.Trimesh)
        ]
    except Exception as error:  # trimesh raises many types
        raise MeshFileError(f"{file}: cannot be read as {file.suffix}: {error!r:.300}") from None
    if not sets:
        raise MeshFileError(f"{file}: holds no triangles")
    return [_Part(_merged(triangles) if is_obj else triangles, None) for triangles in sets]


def _refuse_index_zero(file: Path) -> None:
    """Raise if a face has vertex index 0: OBJ counts from 1, and readers take 0 for the last vertex."""
    with file.open("rb") as lines:
        for number, line in enumerate(lines, 1):
            if line.startswith(b"f ") and any(
                corner.split(b"/")[0] == b"0" for corner in line.split()[1:]
            ):
                raise MeshFileError(f"{file}: line {number} has vertex index 0; OBJ counts from 1")


def _trimesh_triangles(geometry: Any, matrix: FloatArray) -> TriangleSet:
    linear = matrix[:3, :3]
    positions = np.asarray(geometry.vertices, dtype=np.float64)
    faces = np.asarray(geometry.faces, dtype=np.int64)
    # trimesh computes normals on request; its cache holds only those of the file.
    stored = geometry._cache.cache.get("vertex_normals")
    normals = None if stored is None else np.asarray(stored, dtype=np.float64)
    if not np.array_equal(matrix, np.eye(4)):
        positions = positions @ linear.T + matrix[:3, 3]
        if normals is not None:
            normals = normals @ np.linalg.inv(linear)
        if np.linalg.det(linear) < 0.0:
            faces = faces[:, ::-1]
    uv = getattr(geometry.visual, "uv", None)
    uvs = None if uv is None else np.asarray(uv, dtype=np.float64)[:, :2] * (1.0, -1.0) + (0.0, 1.0)
    columns = {key: np.asarray(value) for key, value in geometry.vertex_attributes.items()}
    attributes = {
        key: value.astype(np.float64).reshape(len(value), -1)
        for key, value in columns.items()
        if value.dtype.kind in "fiu" and value.ndim in (1, 2)
    }
    return TriangleSet(positions, faces, normals, uvs, attributes)


def _merged(triangles: TriangleSet) -> TriangleSet:
    """Merge vertices of equal position, UV and normal: OBJ has one for every corner of a face."""
    arrays = (triangles.positions, triangles.uvs, triangles.normals)
    columns = [array for array in arrays if array is not None]
    _, first, group = np.unique(
        np.concatenate(columns, axis=1), axis=0, return_index=True, return_inverse=True
    )
    order = np.argsort(first)  # in the order of the file
    rank = np.empty_like(order)
    rank[order] = np.arange(order.size)
    kept = first[order]
    return TriangleSet(
        triangles.positions[kept],
        rank[group.ravel()][triangles.faces],
        None if triangles.normals is None else triangles.normals[kept],
        None if triangles.uvs is None else triangles.uvs[kept],
        {name: value[kept] for name, value in triangles.attributes.items()},
    )
