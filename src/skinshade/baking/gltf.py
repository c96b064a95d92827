"""Baking of glTF: every primitive with triangles gets attributes, and nothing else changes."""

from __future__ import annotations

import copy
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from .._core.arrays import FloatArray
from .._core.errors import MeshFileError
from .._core.progress import Progress, silent
from .._core.units import GLTF_UNIT_MM
from .._core.version import __version__
from ..gltf import (
    GltfDocument,
    Part,
    TriangleSet,
    mesh_placements,
    read_mesh,
    scale_of,
)
from ..gltf.primitives import geometry_key
from ..gltf.write import AccessorWriter
from ..mesh import Mesh
from ..mesh.baked import GLTF_NAMES
from .analysis import Analysis, BakedMesh, analyse
from .settings import BakeSettings

__all__ = ["GltfBake", "bake_gltf", "bake_note"]

UNITS = {"curvature": "1/mm", "tensor": "1/mm", "thickness": "mm"}


@dataclass(frozen=True)
class GltfBake:
    """Result of baking a document.

    Attributes
    ----------
    json
        JSON with the new attributes. Its last bufferViews describe `data`; their offsets start at `data`.
    data
        Bytes of the new attributes.
    meshes
        Meshes that were baked.
    """

    json: dict[str, Any]
    data: bytes
    meshes: list[BakedMesh]


def bake_gltf(gltf: GltfDocument, settings: BakeSettings, progress: Progress = silent) -> GltfBake:
    """Analyse every mesh of a document and add the attributes.

    Parameters
    ----------
    gltf
        Document to bake.
    settings
        Attributes to bake.
    progress
        Called with the name of the work and the fraction that is done.

    Raises
    ------
    MeshFileError, MeshError
        If the document is malformed, or contains no triangles.
    """
    placements = mesh_placements(gltf)
    meshes = gltf.items("meshes")
    # Meshes that differ only in their materials are analysed once.
    results: dict[str, tuple[list[Part], BakedMesh] | None] = {}
    baked = []
    writer = _Writer(gltf)
    for index, entry in enumerate(meshes):
        progress("baking", index / len(meshes))
        name = str(entry.get("name") or index)
        unit, notes = _unit_mm(gltf, index, placements.get(index, []), settings)
        key = f"{unit} {geometry_key(gltf, index)}"
        if key not in results:
            triangles = read_mesh(gltf, index)
            location = f"{gltf.path}: mesh {name}"
            results[key] = triangles and (
                triangles[0],
                _analysed(triangles[1], unit, location, settings, progress),
            )
        if (analysed := results[key]) is not None:
            parts, result = analysed
            result = BakedMesh(name, result.mesh, result.analysis, {**notes, **result.notes})
            writer.add(index, parts, result, settings)
            baked.append(result)
    if not baked:
        raise MeshFileError(f"{gltf.path}: holds no triangles")
    return GltfBake(writer.json, bytes(writer.accessors.data), baked)


def bake_note(analysis: Analysis, unit_mm: float, settings: BakeSettings) -> dict[str, Any]:
    """Return the entry ``skinshade`` of a mesh's extras: version, unit, profile, scale and attributes."""
    return {
        "version": __version__,
        "unit_mm": unit_mm,
        "profile": settings.profile,
        "uv_scale_mm": analysis.uv_scale_mm,
        "attributes": {
            name: UNITS[key] for key in analysis.attributes for name, _ in GLTF_NAMES[key]
        },
    }


def _analysed(
    triangles: TriangleSet, unit_mm: float, name: str, settings: BakeSettings, progress: Progress
) -> BakedMesh:
    uvs, notes = triangles.uvs, {}
    if uvs is not None and not np.isfinite(uvs).all():
        uvs, notes["meshes whose UVs are not finite"] = None, 1
    mesh = Mesh.checked(
        triangles.positions,
        triangles.faces,
        unit_mm=unit_mm,
        normals=triangles.normals,
        uvs=uvs,
        keep_vertices=True,
        name=name,
    )
    return BakedMesh("", mesh, analyse(mesh, settings, name, progress), notes)


def _unit_mm(
    gltf: GltfDocument, index: int, matrices: Sequence[FloatArray], settings: BakeSettings
) -> tuple[float, dict[str, int]]:
    """Return the length of a mesh's unit at its first node, mm, and notes about its scale."""
    notes: dict[str, int] = {}
    unit = settings.unit_mm or GLTF_UNIT_MM
    if matrices:
        scale, even = scale_of(matrices[0])
        if not 1e-9 < scale < 1e9:
            raise MeshFileError(f"{gltf.path}: mesh {index}: its node scales it by {scale:g}")
        ratios = {round(scale_of(matrix)[0] / scale, 3) for matrix in matrices}
        if not even:
            notes["meshes of uneven scale"] = 1
        if ratios != {1.0}:
            notes["meshes with nodes of several scales"] = 1
        unit *= scale
    elif "nodes" in gltf.json:
        notes["meshes without a node"] = 1
    return unit, notes


class _Writer:
    """Writer of attributes into a copy of the document."""

    def __init__(self, gltf: GltfDocument) -> None:
        self.json = copy.deepcopy(gltf.json)
        self.accessors = AccessorWriter(self.json)
        self._known: dict[tuple[int, str, int], tuple[Analysis, int]] = {}

    def add(
        self, index: int, parts: Sequence[Part], baked: BakedMesh, settings: BakeSettings
    ) -> None:
        """Add the attributes of a mesh, and the note in its extras."""
        mesh, analysis = self.json["meshes"][index], baked.analysis
        for key, values in analysis.attributes.items():
            for name, columns in GLTF_NAMES[key]:
                for part in parts:
                    attributes = mesh["primitives"][part.number]["attributes"]
                    shared = (id(analysis), name, part.vertices.start)
                    if shared not in self._known:
                        accessor = self.accessors.add_vertices(values[part.vertices, columns])
                        self._known[shared] = analysis, accessor
                    attributes[name] = self._known[shared][1]
        extras = mesh.setdefault("extras", {})
        if isinstance(extras, dict):
            extras["skinshade"] = bake_note(analysis, baked.mesh.unit_mm, settings)
