"""Triangle meshes with a unit, checked and repaired on construction."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._core.arrays import (
    FloatArray,
    FloatRows,
    IndexRows,
    IntArray,
    as_faces,
    as_floats,
    as_positions,
    dot,
    unit_vectors,
)
from .._core.errors import MeshError, UnitError
from .._core.notebook import table_html
from .normals import vertex_normals
from .repairs import usable_faces
from .topology import face_normals, open_edge_counts, used_vertices, weld

__all__ = ["Mesh"]

LONGEST_REPR = 200


@dataclass(frozen=True, repr=False)
class Mesh:
    """Triangle mesh. Create one with `checked` or `skinshade.load_mesh`.

    Attributes
    ----------
    positions
        (V, 3) in units of `unit_mm` millimetres.
    normals
        (V, 3) unit, pointing out of the body.
    faces
        (F, 3) indices of vertices, counter-clockwise seen from outside.
    unit_mm
        Length of one unit of `positions`, mm.
    uvs
        (V, 2) texture coordinates, v down (glTF), or None.
    attributes
        Further per-vertex values by name, (V,) or (V, n).
    repairs
        Counts of repairs and faults, by their names.
    materials
        (F,) number of every face's material in the file, −1 for none; None if the file has no materials.
    """

    positions: FloatRows
    normals: FloatRows
    faces: IndexRows
    unit_mm: float
    uvs: FloatRows | None = None
    attributes: Mapping[str, FloatArray] = field(default_factory=dict)
    repairs: Mapping[str, int] = field(default_factory=dict)
    materials: IntArray | None = None

    @classmethod
    def checked(
        cls,
        positions: ArrayLike,
        faces: ArrayLike,
        *,
        unit_mm: float,
        normals: ArrayLike | None = None,
        uvs: ArrayLike | None = None,
        attributes: Mapping[str, ArrayLike] | None = None,
        materials: ArrayLike | None = None,
        keep_vertices: bool = False,
        name: str = "mesh",
    ) -> Mesh:
        """Return a mesh from arrays, checked and repaired; repairs are counted.

        Repairs: faces without area, repeated faces and the second sides of doubled faces are dropped
        (`skinshade.mesh.repairs.usable_faces`), then vertices that no face uses; normals that are
        missing, zero or not finite are computed. Counted, but kept: edges with one face
        (``open edges``) or more than two (``non-manifold edges``), and neighbours of opposite winding.

        Parameters
        ----------
        positions
            (V, 3) in units of `unit_mm`, ±1e15.
        faces
            (F, 3) indices of vertices, counter-clockwise seen from outside.
        unit_mm
            Length of one unit of `positions`, mm, > 0.
        normals
            (V, 3) of any length, pointing out of the body; computed if not given.
        uvs
            (V, 2) texture coordinates, v down (glTF).
        attributes
            Further per-vertex values by name, (V,) or (V, n).
        materials
            (F,) number of every face's material, −1 for none.
        keep_vertices
            Keep vertices that no face uses, so that every vertex keeps its index.
        name
            Name of the mesh in error messages.

        Raises
        ------
        MeshError, ArgumentError
            If there are no vertices or faces, no face has an area, a position or UV is not finite, or
            an index is out of range; naming the mesh, the array, the index and the value.

        Examples
        --------
        >>> import skinshade as sk
        >>> sk.Mesh.checked([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], unit_mm=10)
        Mesh(3 vertices, 1 faces, 10 × 10 × 0 mm; 3 normals computed, 3 open edges)
        """
        points = as_positions(f"{name}: positions", positions)
        if points.shape[0] == 0:
            raise MeshError(f"{name}: has no vertices")
        triangles = as_faces(f"{name}: faces", faces, points.shape[0])
        if triangles.shape[0] == 0:
            raise MeshError(f"{name}: has no faces")
        count = points.shape[0]
        columns: dict[str, FloatArray] = {
            key: as_floats(f"{name}: {key}", value) for key, value in (attributes or {}).items()
        }
        for key, value in columns.items():
            if value.ndim not in (1, 2) or value.shape[0] != count:
                raise MeshError(f"{name}: {key} has shape {value.shape} for {count} vertices")
        coordinates = None if uvs is None else as_floats(f"{name}: uvs", uvs, (count, 2))

        repairs: dict[str, int] = {}
        group, _ = weld(points)
        kept = usable_faces(points, triangles, group, repairs, name)
        numbers = None
        if materials is not None:
            values = as_floats(f"{name}: materials", materials, (triangles.shape[0],))
            numbers = values.astype(np.int64)[kept]
        triangles = triangles if kept.size == len(triangles) else triangles[kept]
        welded = group[triangles]
        given = _given_normals(normals, count, name)
        used = used_vertices(triangles, count)
        if not keep_vertices and not used.all():
            repairs["unreferenced vertices dropped"] = int((~used).sum())
            triangles = (np.cumsum(used) - 1)[triangles]
            points, given = points[used], given[used]
            columns = {key: value[used] for key, value in columns.items()}
            coordinates = None if coordinates is None else coordinates[used]
        given = _complete_normals(given, points, triangles, repairs)
        repairs |= open_edge_counts(points, triangles, welded)
        return cls(
            points,
            given,
            triangles,
            _positive_unit(unit_mm, name),
            coordinates,
            columns,
            {key: value for key, value in repairs.items() if value},
            numbers,
        )

    @property
    def positions_mm(self) -> FloatRows:
        """(V, 3) positions in mm."""
        return self.positions * self.unit_mm

    def with_uvs_flipped(self) -> Mesh:
        """Return the mesh with v reversed, for files made for OpenGL, where v counts from below.

        Raises
        ------
        MeshError
            If the mesh has no UVs.
        """
        if self.uvs is None:
            raise MeshError("the mesh has no UVs to flip")
        return replace(self, uvs=self.uvs * (1.0, -1.0) + (0.0, 1.0))

    def __repr__(self) -> str:
        size = " × ".join(f"{side:.4g}" for side in np.ptp(self.positions_mm, axis=0))
        parts = [f"{len(self.positions)} vertices", f"{len(self.faces)} faces", f"{size} mm"]
        parts += ["UVs"] if self.uvs is not None else []
        parts += [f"attributes: {' '.join(self.attributes)}"] if self.attributes else []
        repairs = ", ".join(f"{count} {repair}" for repair, count in self.repairs.items())
        text = f"Mesh({', '.join(parts)}{'; ' if repairs else ''}{repairs})"
        return text if len(text) <= LONGEST_REPR else text[: LONGEST_REPR - 2] + "…)"

    def _repr_html_(self) -> str:
        size = " × ".join(f"{side:.4g}" for side in np.ptp(self.positions_mm, axis=0))
        rows: dict[str, object] = {
            "vertices": len(self.positions),
            "faces": len(self.faces),
            "size, mm": size,
            "unit, mm": f"{self.unit_mm:g}",
            "UVs": "yes" if self.uvs is not None else "no",
            "attributes": ", ".join(self.attributes) or "none",
        }
        return table_html("Mesh", rows | dict(self.repairs))


def _positive_unit(unit_mm: float, name: str) -> float:
    """Return a unit after a check. Any positive length is valid, as it may include a node's scale."""
    try:
        value = float(unit_mm)
    except (TypeError, ValueError):
        value = 0.0
    if not 0.0 < value < np.inf:
        raise UnitError(f"{name}: unit_mm is {unit_mm}; it must be a positive number of mm")
    return value


def _complete_normals(
    normals: FloatArray, points: FloatArray, triangles: IntArray, repairs: dict[str, int]
) -> FloatArray:
    """Return unit normals (V, 3), computed where the given ones (V, 3) are not unit vectors.

    Where both sides of one sheet cancel out, the normal is that of either side; vertices of no face get
    (0, 0, 1).
    """
    missing = ~(np.abs(dot(normals, normals) - 1.0) < 1e-2)
    if not missing.any():
        return unit_vectors(normals)
    repairs["normals computed"] = int(missing.sum())
    completed = np.where(missing[:, None], vertex_normals(points, triangles), normals)
    zero = np.asarray(~completed.any(axis=1))
    if zero.any():
        own = unit_vectors(face_normals(points, triangles))
        chosen = np.tile([0.0, 0.0, 1.0], (len(points), 1))
        chosen[triangles.ravel()] = np.repeat(own, 3, axis=0)
        completed = np.where(zero[:, None], chosen, completed)
    return unit_vectors(completed)


def _given_normals(normals: ArrayLike | None, count: int, name: str) -> FloatArray:
    if normals is None:
        return np.zeros((count, 3))
    try:
        array = np.array(normals, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise MeshError(f"{name}: normals are not an array of numbers ({error})") from None
    if array.shape != (count, 3):
        raise MeshError(f"{name}: normals have shape {array.shape} for {count} vertices")
    finite: NDArray[np.bool_] = np.asarray(np.isfinite(array).all(axis=1))
    array[~finite] = 0.0
    return unit_vectors(array)
