"""Meshes from files, through trimesh: glTF, OBJ, PLY, STL."""

from __future__ import annotations

import os
import warnings
from pathlib import Path
from typing import Any

import numpy as np

from .._core.arrays import FloatArray
from .._core.errors import MeshFileError, SkinshadeError, UnitError, UnitWarning
from .._core.files import existing_file
from .._core.units import GLTF_UNIT_MM, checked_unit_mm
from .baked import GLTF_NAMES, baked_attributes, baked_unit_mm
from .model import Mesh

__all__ = ["GLTF_SUFFIXES", "SUFFIXES", "load_mesh"]

GLTF_SUFFIXES = (".glb", ".gltf")
SUFFIXES = (*GLTF_SUFFIXES, ".obj", ".ply", ".stl")
SAME_UNIT = 1e-4
"""Relative; node scales are single precision."""
PLAUSIBLE_MM = (20.0, 3000.0)
"""Diagonals between a fingertip and a tall person's; outside it metres are rarely what was meant."""


def load_mesh(path: str | os.PathLike[str], *, unit_mm: float | None = None) -> Mesh:
    """Read a mesh, all its parts as one, placed as the file's scene places them.

    Parameters
    ----------
    path
        ``.glb``, ``.gltf``, ``.obj``, ``.ply`` or ``.stl``.
    unit_mm
        Length of one unit of the file, mm. Only glTF states one (metres), or what `skinshade bake` noted;
        any other file needs it.

    Returns
    -------
    Mesh
        UVs with v down, as in glTF, whatever the file's own convention. Attributes ``curvature``,
        ``tensor`` and ``thickness`` if the file was baked for this unit.

    Raises
    ------
    MeshFileError, MeshError, UnitError
        If the file is missing, corrupt or of another kind, holds no usable triangle, or its unit is
        unknown.

    Warns
    -----
    UnitWarning
        If glTF's metres make the object smaller than a fingertip or larger than a person.
    """
    file = existing_file(path, MeshFileError)
    suffix = file.suffix.lower()
    if suffix not in SUFFIXES:
        raise MeshFileError(
            f"{file}: {suffix or 'no suffix'}; a mesh is one of {' '.join(SUFFIXES)}"
        )
    stated = suffix in GLTF_SUFFIXES
    if unit_mm is None and not stated:
        raise UnitError(
            f"{file}: {suffix} files do not say their unit; give unit_mm (1 mm, 10 cm, 1000 m)"
        )
    parts = _parts(file)
    baked = _common_unit([part.pop("baked_unit_mm") for part in parts])
    given = None if unit_mm is None else checked_unit_mm(unit_mm, str(file))
    unit = given or baked or GLTF_UNIT_MM
    if baked is None or abs(unit / baked - 1.0) > SAME_UNIT:
        # Baked for another size, or for none that is known: curvature is not what it says.
        for part in parts:
            part["attributes"] = {
                key: value for key, value in part["attributes"].items() if key not in GLTF_NAMES
            }
    try:
        mesh = Mesh.checked(**_joined(parts, file), unit_mm=unit, name=str(file))
    except SkinshadeError as error:
        raise type(error)(str(error)) from None
    if unit_mm is None and baked is None:
        _warn_of_size(mesh, file)
    return mesh


def _common_unit(units: list[float | None]) -> float | None:
    """The unit that baking noted, if it noted the same one for every part."""
    known = [unit for unit in units if unit is not None]
    if len(known) < len(units) or max(known) > min(known) * (1.0 + SAME_UNIT):
        return None
    return known[0]


def _warn_of_size(mesh: Mesh, file: Path) -> None:
    diagonal = float(np.linalg.norm(np.ptp(mesh.positions_mm, axis=0)))
    if not PLAUSIBLE_MM[0] <= diagonal <= PLAUSIBLE_MM[1]:
        warnings.warn(
            f"{file}: in metres, as glTF prescribes, it is {diagonal / GLTF_UNIT_MM:.3g} m across; "
            "give unit_mm if another unit was meant",
            UnitWarning,
            stacklevel=3,
        )


def _parts(file: Path) -> list[dict[str, Any]]:
    import trimesh  # a third of a second to import

    options: dict[str, Any] = {"process": False}
    if file.suffix.lower() == ".obj":
        options["skip_materials"] = True
        _refuse_index_zero(file)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of its own arithmetic on files without materials
            scene = trimesh.load_scene(file, **options)
        parts = []
        for node in scene.graph.nodes_geometry:
            matrix, name = scene.graph[node]
            geometry = scene.geometry[name]
            if isinstance(geometry, trimesh.Trimesh):
                part = _part(geometry, np.asarray(matrix, dtype=np.float64))
                parts.append(_merged(part) if file.suffix.lower() == ".obj" else part)
    except Exception as error:
        raise MeshFileError(f"{file}: cannot be read as {file.suffix}: {error!r:.300}") from None
    if not parts:
        raise MeshFileError(f"{file}: holds no triangles")
    return parts


def _refuse_index_zero(file: Path) -> None:
    """OBJ counts from 1; readers take 0 for the vertex before the first, which is the last."""
    with file.open("rb") as lines:
        for number, line in enumerate(lines, 1):
            if line.startswith(b"f ") and any(
                corner.split(b"/")[0] == b"0" for corner in line.split()[1:]
            ):
                raise MeshFileError(f"{file}: line {number} has vertex index 0; OBJ counts from 1")


def _part(geometry: Any, matrix: FloatArray) -> dict[str, Any]:
    linear = matrix[:3, :3]
    positions = np.asarray(geometry.vertices, dtype=np.float64)
    faces = np.asarray(geometry.faces, dtype=np.int64)
    # trimesh computes normals on request; only those that came with the file are in its cache.
    given = geometry._cache.cache.get("vertex_normals")
    normals = None if given is None else np.asarray(given, dtype=np.float64)
    if not np.array_equal(matrix, np.eye(4)):
        positions = positions @ linear.T + matrix[:3, 3]
        if normals is not None:
            normals = normals @ np.linalg.inv(linear)
        if np.linalg.det(linear) < 0.0:
            faces = faces[:, ::-1]
    uv = getattr(geometry.visual, "uv", None)
    uvs = None if uv is None else np.asarray(uv, dtype=np.float64)[:, :2] * (1.0, -1.0) + (0.0, 1.0)
    attributes = {
        key: np.asarray(value, dtype=np.float64)
        for key, value in geometry.vertex_attributes.items()
        if np.asarray(value).dtype.kind in "fiu" and np.asarray(value).ndim in (1, 2)
    }
    unit = baked_unit_mm(geometry.metadata.get("skinshade"), matrix)
    if unit is not None:
        attributes |= baked_attributes(attributes, matrix)
    return {
        "positions": positions,
        "faces": faces,
        "normals": normals,
        "uvs": uvs,
        "attributes": attributes,
        "baked_unit_mm": unit,
    }


def _merged(part: dict[str, Any]) -> dict[str, Any]:
    """One vertex for all corners of equal position, UV and normal: OBJ counts them one by one."""
    columns = [part[key] for key in ("positions", "uvs", "normals") if part[key] is not None]
    _, first, group = np.unique(
        np.concatenate(columns, axis=1), axis=0, return_index=True, return_inverse=True
    )
    order = np.argsort(first)  # as they came
    rank = np.empty_like(order)
    rank[order] = np.arange(order.size)
    kept = first[order]
    merged = {
        key: None if part[key] is None else part[key][kept]
        for key in ("positions", "uvs", "normals")
    }
    attributes = {key: value[kept] for key, value in part["attributes"].items()}
    merged["baked_unit_mm"] = part["baked_unit_mm"]
    return merged | {"faces": rank[group.ravel()][part["faces"]], "attributes": attributes}


def _joined(parts: list[dict[str, Any]], file: Path) -> dict[str, Any]:
    """One mesh of all parts; what not every part has is left out."""
    if len(parts) == 1:
        return parts[0]
    offsets = np.cumsum([0] + [part["positions"].shape[0] for part in parts])
    joined: dict[str, Any] = {
        "positions": np.concatenate([part["positions"] for part in parts]),
        "faces": np.concatenate(
            [part["faces"] + offset for part, offset in zip(parts, offsets[:-1], strict=True)]
        ),
    }
    for key in ("normals", "uvs"):
        if all(part[key] is not None for part in parts):
            joined[key] = np.concatenate([part[key] for part in parts])
    shared = set.intersection(
        *({(key, value.shape[1:]) for key, value in part["attributes"].items()} for part in parts)
    )
    joined["attributes"] = {
        key: np.concatenate([part["attributes"][key] for part in parts])
        for key, _ in sorted(shared)
    }
    return joined
