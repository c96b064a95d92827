"""Cotangent Laplacian of a mesh, with lumped masses (MODEL §7)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import FloatArray, FloatVector, IntArray, dot
from .._core.errors import MeshError
from . import compiled, compiled_diffusion
from .compiled_diffusion import Edges
from .topology import face_areas, used_vertices, weld

if TYPE_CHECKING:
    from scipy.sparse import csr_array

__all__ = ["Laplacian", "edges_of"]

LEAST_AREA = 1e-12
"""Area below which cotangents are bounded, over that of the greatest face. The cotangents of needle-like
faces would exceed the precision of their neighbours."""
MARGIN = 1.0 + 1e-9
"""Factor of the bound of the eigenvalues, which covers its rounding."""


@dataclass(frozen=True)
class Laplacian:
    """Laplacian M⁻¹K of the points of a welded mesh: (M⁻¹K x)ᵢ = Σⱼ wᵢⱼ (xᵢ − xⱼ) / mᵢ.

    Attributes
    ----------
    edges
        Edges of the points, with the weights w.
    masses
        (P,) a third of the areas of the faces around every point, mm².
    greatest
        Upper bound of all eigenvalues, 1/mm².
    point, first
        (V,) point of every vertex, and (P,) first vertex of every point; None where they are the same.
    """

    edges: Edges
    masses: FloatVector
    greatest: float
    point: NDArray[np.integer] | None
    first: NDArray[np.integer] | None

    @classmethod
    def of(cls, positions: FloatArray, faces: IntArray) -> Laplacian:
        """Return the Laplacian of a mesh with checked arrays.

        Raises
        ------
        MeshError
            If the faces around a vertex have no area.
        """
        floor = LEAST_AREA * float(face_areas(positions, faces).max(initial=0.0))
        point: NDArray[np.integer] | None
        first: NDArray[np.integer] | None
        if compiled.serves(positions, faces):
            table = compiled_diffusion.edges_of(positions, faces, floor)
            edges, masses, bounds, point, first = table
        else:
            point, first = weld(positions)
            edges, masses, bounds = edges_of(positions[first], point[faces], floor)
        if not (masses > 0.0).all():
            vertex = int(np.argmin(masses))
            vertex = vertex if first is None else int(first[vertex])
            raise MeshError(
                f"vertex {vertex} at {positions[vertex]}: the faces around it have no area"
            )
        return cls(edges, masses, MARGIN * float(bounds.max(axis=0).min()), point, first)

    def points_of(self, values: FloatArray, faces: IntArray) -> FloatArray:
        """Return values (P, n) of points: the means of those (V, n) of their vertices that faces use."""
        if self.point is None:
            return values
        count, used = len(self.masses), used_vertices(faces, len(values)).astype(np.float64)
        sums = [np.bincount(self.point, used * column, count) for column in values.T]
        return np.stack(sums, axis=1) / np.bincount(self.point, used, count)[:, None]

    def stiffness(self) -> csr_array:
        """Return the matrix K."""
        from scipy.sparse import csr_array, diags_array

        count = len(self.masses)
        parts = self.edges.weights, self.edges.ends.astype(np.int64), self.edges.firsts
        between = csr_array(parts, shape=(count, count))
        return csr_array(diags_array(between.sum(axis=1)) - between)


def edges_of(p: FloatArray, faces: IntArray, floor: float) -> tuple[Edges, FloatVector, FloatArray]:
    """Return edges, masses (P,) and bounds (P, 2) of eigenvalues as `compiled_diffusion.edges_of`.

    The greatest value of both columns of the bounds is a bound. The first column has the greatest
    eigenvalue of the Laplacians of single faces, whose mass is a third of the area at every corner: their
    maximum over the mesh bounds the eigenvalues of the sum. The second has the sums of the absolute values
    of rows: the circles of Gershgorin.
    """
    from scipy.sparse import coo_array, csr_array

    count = len(p)
    # Faces with two equal corners have no area and no edges.
    faces = faces[(faces != faces[:, [1, 2, 0]]).all(axis=1)]
    corners = p[faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = 0.5 * np.sqrt(dot(normal, normal))
    half = np.empty((3, len(faces)))
    rows, columns = [], []
    for corner in range(3):
        after, before = (corner + 1) % 3, (corner + 2) % 3
        a, b = corners[:, after] - corners[:, corner], corners[:, before] - corners[:, corner]
        half[corner] = 0.25 * dot(a, b) / np.maximum(area, floor)
        rows += [faces[:, after], faces[:, before]]
        columns += [faces[:, before], faces[:, after]]
    matrix = csr_array(
        coo_array(
            (np.repeat(half, 2, axis=0).ravel(), (np.concatenate(rows), np.concatenate(columns))),
            (count, count),
        )
    )
    masses = np.zeros(count)
    np.add.at(masses, faces.ravel(), np.repeat(area / 3.0, 3))
    bounds = np.zeros((count, 2))
    total, pairs = half.sum(axis=0), half[0] * half[1] + half[1] * half[2] + half[2] * half[0]
    root = total + np.sqrt(np.maximum(total * total - 3.0 * pairs, 0.0))
    of_faces = np.full(len(faces), np.inf)
    np.divide(3.0 * root, area, out=of_faces, where=area > 0.0)
    np.maximum.at(bounds[:, 0], faces.ravel(), np.repeat(of_faces, 3))
    of_rows = np.abs(matrix.sum(axis=1)) + abs(matrix).sum(axis=1)
    bounds[:, 1] = np.inf
    np.divide(of_rows, masses, out=bounds[:, 1], where=masses > 0.0)
    edges = Edges(matrix.indptr.astype(np.int64), matrix.indices.astype(np.uint32), matrix.data)
    return edges, masses, bounds
