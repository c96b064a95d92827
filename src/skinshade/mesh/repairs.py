"""Faces that a mesh keeps: those with an area, once, and of doubled faces one side."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import FloatArray, IntArray, dot
from .._core.errors import MeshError
from . import compiled
from .topology import edge_counts, face_areas

__all__ = ["usable_faces"]


def usable_faces(
    points: FloatArray, triangles: IntArray, group: IntArray, repairs: dict[str, int], name: str
) -> IntArray:
    """Return the increasing indices (K,) of the faces to keep; count those that are dropped.

    Faces without area, and repetitions of a face with the same vertices and winding, are dropped. So are
    faces that span the positions of an earlier face with the opposite winding: the other side of two-sided
    cloth, hair cards and single-sided exports. Faces of equal winding at these positions are kept, if their
    vertices differ. If every face of a closed body is doubled, the sides that enclose a positive volume
    are kept, so that the body has an inside; otherwise the first side is.

    Parameters
    ----------
    points, triangles
        (V, 3) positions, and (F, 3) indices of vertices.
    group
        (V,) groups of vertices at equal positions, as `skinshade.mesh.topology.weld` returns them.
    repairs
        Receives the counts, by the names of the repairs.
    name
        Name of the mesh in error messages.

    Raises
    ------
    MeshError
        If no face has an area.
    """
    kept = np.flatnonzero(face_areas(points, triangles) > 0.0)
    if kept.size == 0:
        raise MeshError(f"{name}: no face has an area")
    repairs["faces without area dropped"] = len(triangles) - kept.size
    faces = triangles if kept.size == len(triangles) else triangles[kept]
    suspects = _perhaps_coincident(group[faces])
    if not suspects.size:
        return kept
    once = first_of_equal(faces[suspects], len(points))
    repeated, distinct = np.delete(suspects, once), suspects[once]
    repairs["repeated faces dropped"] = repeated.size
    is_whole = distinct.size + repeated.size == kept.size
    second = distinct[_second_sides(points, faces[distinct], group[faces[distinct]], is_whole)]
    repairs["faces doubled with opposite winding dropped"] = second.size
    return np.delete(kept, np.concatenate([repeated, second]))


def _perhaps_coincident(welded: IntArray) -> IntArray:
    """Return the indices of faces (F, 3) that include all faces with the corners of another face.

    Every position has a number of mixed bits [Steele2014]. Faces with the same corners in any order have
    equal sums of these numbers. Sorting the sums alone is fast; few meshes need more.
    """
    number = np.arange(1, int(welded.max()) + 2, dtype=np.uint64) * np.uint64(0x9E3779B97F4A7C15)
    for shift, factor in ((30, 0xBF58476D1CE4E5B9), (27, 0x94D049BB133111EB)):
        number = (number ^ (number >> np.uint64(shift))) * np.uint64(factor)
    sums = number[welded[:, 0]] + number[welded[:, 1]] + number[welded[:, 2]]
    ordered = np.sort(sums)
    repeated = ordered[1:][ordered[1:] == ordered[:-1]]
    return np.flatnonzero(np.isin(sums, repeated)) if repeated.size else np.zeros(0, dtype=np.int64)


def first_of_equal(triangles: IntArray, vertex_count: int) -> IntArray:
    """Return the increasing indices of the first of every set of faces of equal vertices and winding."""
    if compiled.serves(triangles):
        return compiled.first_of_equal(triangles)
    turned = (np.argmin(triangles, axis=1)[:, None] + np.arange(3)) % 3
    first, _ = _distinct(np.take_along_axis(triangles, turned, axis=1), vertex_count)
    return np.sort(first)


def _distinct(rows: IntArray, count: int) -> tuple[IntArray, IntArray]:
    """Return the first index of every distinct row (D,), and the distinct row of every row (F,).

    Rows are three indices below `count`.
    """
    a, b, c = rows.T
    if count < 1 << 21:  # three indices fit in 63 bits
        keys = (a * count + b) * count + c
        _, first, inverse = np.unique(keys, return_index=True, return_inverse=True)
    else:
        _, first, inverse = np.unique(rows, axis=0, return_index=True, return_inverse=True)
    return first, inverse.ravel()


def _second_sides(
    points: FloatArray, triangles: IntArray, welded: IntArray, is_whole: bool
) -> NDArray[np.bool_]:
    """Return which faces (F,) are the side of a doubled face that is dropped.

    Parameters
    ----------
    points
        (V, 3).
    triangles, welded
        (F, 3) vertices of the faces, and groups of vertices.
    is_whole
        Whether these are all faces of the mesh.
    """
    a, b, c = welded.T
    # Of a<b, b<c and c<a, two hold in one winding and one in the other.
    winding = ((a < b).astype(np.int64) + (b < c) + (c < a)) == 2
    first, face = _distinct(np.sort(welded, axis=1), int(welded.max()) + 1)
    second = winding != winding[first][face]
    if is_whole and np.bincount(face, second).all():
        kept = ~second
        if _encloses_negative_volume(points, triangles[kept], welded[kept]):
            return kept
    return second


def _encloses_negative_volume(points: FloatArray, triangles: IntArray, welded: IntArray) -> bool:
    """Return whether faces of one winding close a body and face into it."""
    counts = edge_counts(welded)
    if counts["open edges"] or counts["edges of opposite winding"]:
        return False
    corners = points[triangles] - points.mean(axis=0)
    volumes = dot(corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))
    return float(volumes.sum()) < 0.0
