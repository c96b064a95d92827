"""A triangle mesh with a unit, free of everything that would reach a result as NaN."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._core.arrays import (
    FloatArray,
    IntArray,
    as_faces,
    as_floats,
    as_positions,
    dot,
    unit_vectors,
)
from .._core.errors import MeshError
from .._core.units import checked_unit_mm
from .normals import vertex_normals
from .topology import face_areas, open_edge_counts

__all__ = ["Mesh"]


@dataclass(frozen=True)
class Mesh:
    """A triangle mesh; build it with `checked` or `skinshade.load_mesh`.

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
        What was repaired or noticed when the mesh was built, and how often.
    """

    positions: FloatArray
    normals: FloatArray
    faces: IntArray
    unit_mm: float
    uvs: FloatArray | None = None
    attributes: Mapping[str, FloatArray] = field(default_factory=dict)
    repairs: Mapping[str, int] = field(default_factory=dict)

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
        name: str = "mesh",
    ) -> Mesh:
        """Check, repair and count.

        Errors are what no repair can mean: no vertices or faces, NaN or infinite positions or UVs,
        an index out of range, no face with an area. Repairs, each counted in `repairs`: faces
        without area and repeated faces are dropped, then vertices that no face uses; normals that
        are missing, zero or not finite are computed. Edges with one face (``open edges``) or more
        than two (``non-manifold edges``) and neighbours of opposite winding are counted and kept.

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
        name
            What messages call the mesh.

        Raises
        ------
        MeshError, ArgumentError
            Naming the mesh, the array, the index and the value.
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
        triangles = _usable_faces(points, triangles, repairs, name)
        given = _given_normals(normals, count, name)
        used = np.zeros(count, dtype=bool)
        used[triangles] = True
        if not used.all():
            repairs["unreferenced vertices dropped"] = int((~used).sum())
            triangles = (np.cumsum(used) - 1)[triangles]
            points, given = points[used], given[used]
            columns = {key: value[used] for key, value in columns.items()}
            coordinates = None if coordinates is None else coordinates[used]

        missing = ~(np.abs(dot(given, given) - 1.0) < 1e-2)
        if missing.any():
            repairs["normals computed"] = int(missing.sum())
            given[missing] = vertex_normals(points, triangles)[missing]
            given = _any_face_normal_where_zero(given, points, triangles)
        repairs |= open_edge_counts(points, triangles)
        return cls(
            points,
            unit_vectors(given),
            triangles,
            checked_unit_mm(unit_mm, name),
            coordinates,
            columns,
            {key: value for key, value in repairs.items() if value},
        )

    @property
    def positions_mm(self) -> FloatArray:
        """(V, 3) positions in mm."""
        return self.positions * self.unit_mm

    def with_uvs_flipped(self) -> Mesh:
        """Return the mesh with v running the other way: files made for OpenGL count it from below."""
        if self.uvs is None:
            raise MeshError("the mesh has no UVs to flip")
        return replace(self, uvs=self.uvs * (1.0, -1.0) + (0.0, 1.0))


def _any_face_normal_where_zero(
    normals: FloatArray, points: FloatArray, triangles: IntArray
) -> FloatArray:
    """Both sides of one sheet cancel out: there the normal of either will do."""
    zero = np.asarray(~normals.any(axis=1))
    if not zero.any():
        return normals
    p = points[triangles]
    of_face = unit_vectors(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]))
    chosen = np.zeros_like(normals)
    chosen[triangles.ravel()] = np.repeat(of_face, 3, axis=0)
    return np.where(zero[:, None], chosen, normals)


def _usable_faces(
    points: FloatArray, triangles: IntArray, repairs: dict[str, int], name: str
) -> IntArray:
    flat = face_areas(points, triangles) <= 0.0
    if flat.any():
        repairs["faces without area dropped"] = int(flat.sum())
        triangles = triangles[~flat]
    if triangles.shape[0] == 0:
        raise MeshError(f"{name}: no face has an area")
    turned = np.argmin(triangles, axis=1)[:, None] + np.arange(3)
    first = np.take_along_axis(triangles, turned % 3, axis=1)
    _, keep = np.unique(first, axis=0, return_index=True)
    if keep.size < triangles.shape[0]:
        repairs["repeated faces dropped"] = int(triangles.shape[0] - keep.size)
        triangles = triangles[np.sort(keep)]
    return triangles


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
