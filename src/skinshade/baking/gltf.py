"""Baking of glTF: every primitive with triangles gets attributes, and nothing else changes."""

from __future__ import annotations

import copy
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
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
from ..gltf.placement import Placement, SkippedNode
from ..gltf.primitives import geometry_key, no_mesh_reason
from ..gltf.write import AccessorWriter
from ..mesh import Mesh
from ..mesh.baked import GLTF_NAMES
from ..mesh.topology import used_vertices
from .analysis import Analysis, BakedMesh, analyse
from .settings import BakeSettings

__all__ = ["GltfBake", "bake_gltf", "bake_note"]

UNITS = {"curvature": "1/mm", "tensor": "1/mm", "thickness": "mm", "ambient_transfer": "1"}


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
    extent_mm
        (3,) size of all placed meshes along the axes of the scene, mm; 0 if none is placed. A turned mesh
        counts as the box that turns with it.
    """

    json: dict[str, Any]
    data: bytes
    meshes: list[BakedMesh]
    extent_mm: FloatArray


def bake_gltf(gltf: GltfDocument, settings: BakeSettings, progress: Progress = silent) -> GltfBake:
    """Analyse every mesh of a document and add the attributes.

    Meshes that their nodes scale by 0, or by a number that is not finite, are skipped. Their count is
    among the notes of the first mesh.

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
        If the document is malformed, contains no triangles, or every mesh is skipped.
    """
    placements = mesh_placements(gltf)
    unplaced = Placement([] if "nodes" in gltf.json else [np.eye(4)])
    boxes: list[FloatArray] = []
    meshes = gltf.items("meshes")
    skipped: list[tuple[int, SkippedNode]] = []
    # Meshes that differ only in their materials are analysed once.
    results: dict[str, tuple[list[Part], BakedMesh] | None] = {}
    baked = []
    writer = _Writer(gltf)
    for index, entry in enumerate(meshes):
        progress("baking", index / len(meshes))
        name = str(entry.get("name") or index)
        placement = placements.get(index, unplaced)
        if placement.skipped and not placement.matrices:
            skipped.append((index, placement.skipped[0]))
            continue
        unit, notes = _unit_mm(gltf, placement.matrices, settings)
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
            boxes += _placed_boxes(result.mesh, placement.matrices)
    if not baked:
        raise MeshFileError(f"{gltf.path}: {no_mesh_reason(skipped)}")
    document_notes = Counter(node.note for _, node in skipped)
    baked[0] = replace(baked[0], notes={**baked[0].notes, **document_notes})
    with np.errstate(over="ignore"):  # an infinite extent is implausible
        extent = np.ptp(np.concatenate(boxes), axis=0) if boxes else np.zeros(3)
        extent_mm = extent * (settings.unit_mm or GLTF_UNIT_MM)
    return GltfBake(writer.json, bytes(writer.accessors.data), baked, extent_mm)


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


def _placed_boxes(mesh: Mesh, matrices: Sequence[FloatArray]) -> list[FloatArray]:
    """Return the corners (8, 3) of the box of a mesh at every node, in the axes and unit of the scene."""
    points = mesh.positions[used_vertices(mesh.faces, len(mesh.positions))]
    ends = np.stack([points.min(axis=0), points.max(axis=0)])
    corners = np.stack(np.meshgrid(*ends.T, indexing="ij"), axis=-1).reshape(8, 3)
    return [corners @ matrix[:3, :3].T + matrix[:3, 3] for matrix in matrices]


def _unit_mm(
    gltf: GltfDocument, matrices: Sequence[FloatArray], settings: BakeSettings
) -> tuple[float, dict[str, int]]:
    """Return the length of a mesh's unit at its first node, mm, and notes about its scale."""
    notes: dict[str, int] = {}
    unit = settings.unit_mm or GLTF_UNIT_MM
    if matrices:
        scale, even = scale_of(matrices[0])
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
