"""One body's attributes, from its triangles in mm."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from .._core.arrays import FloatArray, IntArray, as_positions
from .._core.errors import MeshError
from .._core.progress import Progress, silent
from ..mesh import mesh_curvature, mesh_curvature_tensor, mesh_thickness, mesh_uv_scale
from ..mesh.curvature import tensor_to_world
from ..mesh.normals import vertex_normals
from ..mesh.topology import face_areas, open_edge_counts
from .settings import BakeSettings

__all__ = ["Analysed", "Body", "analyse"]

LARGEST_FLOAT = float(np.finfo(np.float32).max)
"""Of the numbers that files keep."""


@dataclass(frozen=True)
class Body:
    """Triangles that belong together: the primitives of one mesh.

    Attributes
    ----------
    positions_mm
        (V, 3).
    faces
        (F, 3).
    normals
        (V, 3), or None.
    uvs
        (V, 2), or None.
    """

    positions_mm: FloatArray
    faces: IntArray
    normals: FloatArray | None
    uvs: FloatArray | None


@dataclass(frozen=True)
class Analysed:
    """What came of it.

    Attributes
    ----------
    attributes
        By name: ``curvature`` (V, 1) 1/mm, and where asked ``tensor`` (V, 6) 1/mm in the body's own
        axes, ``thickness`` (V, 1) mm.
    uv_scale_mm
        Length of the unit of UV, or None.
    notes
        What was repaired or noticed, and how often.
    """

    attributes: dict[str, FloatArray]
    uv_scale_mm: float | None
    notes: dict[str, int] = field(default_factory=dict)


def analyse(body: Body, settings: BakeSettings, name: str, progress: Progress = silent) -> Analysed:
    """Compute a body's attributes; every vertex gets finite ones.

    Raises
    ------
    MeshError, ArgumentError
        If positions are not finite, or no triangle has an area.
    """
    points = as_positions(f"{name}: positions", body.positions_mm)
    flat = face_areas(points, body.faces) <= 0.0
    faces = body.faces[~flat]
    if not faces.size:
        raise MeshError(f"{name}: no face has an area")
    notes = {"faces without area left out": int(flat.sum())} | open_edge_counts(points, faces)
    normals = _normals(body, points, faces, notes)
    smoothing = settings.smoothing
    attributes = {"curvature": mesh_curvature(points, faces, normals, smoothing=smoothing)[:, None]}
    if settings.tensor:
        tensor = mesh_curvature_tensor(points, faces, normals, smoothing=smoothing)
        attributes["tensor"] = tensor_to_world(tensor, normals)
    if settings.thickness:
        found = mesh_thickness(
            points, faces, normals, rays=settings.rays, tracing=settings.tracing, progress=progress
        )
        attributes["thickness"] = found[:, None]
    for key, values in attributes.items():
        most = float(np.abs(values).max())
        if not most <= LARGEST_FLOAT:  # NaN is not
            raise MeshError(f"{name}: {key} reaches {most:g}; is its unit right?")
    scale = None
    if body.uvs is not None and np.isfinite(body.uvs).all():
        if float(np.abs(body.uvs).max()) > LARGEST_FLOAT:
            raise MeshError(f"{name}: uvs reach {np.abs(body.uvs).max():g}, which no file can hold")
        try:
            scale = mesh_uv_scale(points, body.uvs, faces)
        except MeshError:
            notes["meshes whose UVs span no area"] = 1
    return Analysed(attributes, scale, {key: count for key, count in notes.items() if count})


def _normals(body: Body, points: FloatArray, faces: IntArray, notes: dict[str, int]) -> FloatArray:
    computed = vertex_normals(points, faces)
    if body.normals is None:
        notes["normals computed"] = len(points)
        chosen = computed
    else:
        length2 = np.square(body.normals).sum(axis=1)
        good = np.isfinite(length2) & (length2 > 1e-12)
        notes["normals computed"] = int((~good).sum())
        chosen = np.where(good[:, None], np.nan_to_num(body.normals), computed)
    length = np.sqrt(np.square(chosen).sum(axis=1, keepdims=True))
    # A vertex of no face points anywhere.
    return np.where(length > 0.0, chosen / np.maximum(length, 1e-300), [0.0, 0.0, 1.0])
