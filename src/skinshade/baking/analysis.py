"""Analysis of one mesh: the attributes that a bake writes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from .._core.arrays import FloatArray, as_positions
from .._core.errors import MeshError
from .._core.progress import Progress, silent
from ..mesh import Mesh, mesh_ambient_transfer, mesh_thickness, mesh_uv_scale
from ..mesh.shape_operator import ShapeOperator
from ..mesh.tensors import tensor_to_world
from ..profile import Profile
from .settings import BakeSettings

__all__ = ["Analysis", "BakedMesh", "analyse"]

LARGEST_FLOAT = float(np.finfo(np.float32).max)
"""Largest number that the files can hold."""


@dataclass(frozen=True)
class Analysis:
    """Result of analysing a mesh.

    Attributes
    ----------
    attributes
        By name: ``curvature`` (V, 1) 1/mm, and on request ``tensor`` (V, 6) 1/mm in the mesh's own
        axes, ``thickness`` (V, 1) mm, and ``ambient_transfer`` (V, 27): R G B of nine harmonics in the
        mesh's own axes.
    uv_scale_mm
        Length of one unit of UV on the surface, mm; None without usable UVs.
    notes
        Counts of faults of the mesh, by their description.
    """

    attributes: Mapping[str, FloatArray]
    uv_scale_mm: float | None
    notes: Mapping[str, int] = field(default_factory=dict)


@dataclass(frozen=True)
class BakedMesh:
    """One mesh of an asset with its analysis.

    Attributes
    ----------
    name
        Name of the mesh, or its index.
    mesh
        Geometry; its unit includes the scale of its node.
    analysis
        Result of the analysis.
    notes
        Counts of faults of the document, such as uneven scales or UVs that are not finite.
    """

    name: str
    mesh: Mesh
    analysis: Analysis
    notes: Mapping[str, int] = field(default_factory=dict)

    @property
    def all_notes(self) -> dict[str, int]:
        """Counts of all faults and repairs, by their description."""
        return {**self.notes, **self.mesh.repairs, **self.analysis.notes}


def analyse(mesh: Mesh, settings: BakeSettings, name: str, progress: Progress = silent) -> Analysis:
    """Return the attributes of a mesh; the values of every vertex are finite.

    Parameters
    ----------
    mesh
        Geometry.
    settings
        Attributes to compute.
    name
        Name of the mesh in error messages.
    progress
        Called with the name of the work and the fraction that is done.

    Raises
    ------
    MeshError, ArgumentError
        If a position in mm or a value is too large for the files.
    """
    points = as_positions(f"{name}: positions", mesh.positions_mm)
    faces, normals = mesh.faces, mesh.normals
    notes: dict[str, int] = {}
    operator = ShapeOperator.fit(points, faces, normals)
    if operator.bounded_vertices:
        notes["vertices with bounded curvature"] = operator.bounded_vertices
    attributes: dict[str, FloatArray] = {"curvature": operator.mean(settings.smoothing)[:, None]}
    if settings.tensor:
        attributes["tensor"] = tensor_to_world(operator.tensor(settings.smoothing), normals)
    if settings.thickness:
        thickness = mesh_thickness(
            points, faces, normals, rays=settings.rays, tracing=settings.tracing, progress=progress
        )
        attributes["thickness"] = thickness[:, None]
    if settings.ambient_transfer:
        profile = Profile.preset(settings.profile)
        transfer = mesh_ambient_transfer(
            points,
            faces,
            normals,
            albedo=profile.albedo,
            profile=profile,
            tracing=settings.tracing,
            progress=progress,
        )
        attributes["ambient_transfer"] = transfer.total.swapaxes(1, 2).reshape(len(points), -1)
    for key, values in attributes.items():
        largest = float(np.abs(values).max())
        if not largest <= LARGEST_FLOAT:  # NaN raises too
            raise MeshError(f"{name}: {key} reaches {largest:g}; check the unit")
    scale = None
    if mesh.uvs is not None:
        if float(np.abs(mesh.uvs).max()) > LARGEST_FLOAT:
            raise MeshError(f"{name}: uvs reach {np.abs(mesh.uvs).max():g}, too large for a file")
        try:
            scale = mesh_uv_scale(points, mesh.uvs, faces)
        except MeshError:
            notes["meshes whose UVs span no area"] = 1
    return Analysis(attributes, scale, notes)
