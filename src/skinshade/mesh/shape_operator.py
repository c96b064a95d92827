"""Shape operator at vertices: a fit to the change of normals along edges, bounded by what they resolve.

The method is that of [Rusinkiewicz2004], with a fit over the edges of every vertex instead of an average
of fits over faces. This halves the error on random triangulations, because an edge gives the curvature at
its middle.

The fit divides by the spread of the edges' directions and by their lengths. It has no meaning where all
edges are almost parallel, or where a tiny edge joins unlike normals. Two bounds limit the greatest
principal curvature there: `CONDITIONING` times the greatest change of normal per length along an edge, and
`RESOLVED_TURN` over the shortest edge.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._core.arrays import (
    FloatArray,
    FloatRows,
    FloatVector,
    IntArray,
    as_faces,
    as_floats,
    as_positions,
    dot,
    unit_vectors,
)
from .._core.errors import ArgumentError
from . import compiled
from .compiled_fit import CompiledFit, mean_curvature
from .normals import vertex_normals
from .numpy_fit import NumpyFit
from .topology import half_edges

__all__ = [
    "ShapeOperator",
    "checked_mesh",
    "checked_smoothing",
    "fitted_mean_curvature",
    "unit_normals",
]

CONDITIONING = 16.0
"""Greatest principal curvature, relative to the greatest change of normal per length along an edge.

A linear map reaches 1/cos φ, with the angle φ from its principal direction to the nearest edge; a ratio of
16 means that all edges lie within 3.6° of one line. An ellipsoid that is stretched tenfold together with
its triangles has a ratio of 14, and its curvature is right: a bound of 4 would raise the error from 1.8 to
6 %. Triangulations that are not stretched have ratios up to 3.5, and the built-in head up to 2."""
RESOLVED_TURN = 4.0
"""Greatest product of a principal curvature and the length of the shortest edge.

Unit normals differ by at most 2 along an edge, and a principal direction 60° from the nearest edge has
twice the curvature along that edge. Coarse shapes come close: an ellipsoid of 12 vertices has 2.2."""
RESOLUTION = 0.05
"""Length as which shorter edges count in the bound by `RESOLVED_TURN`, relative to the mesh's median edge.

Edges that are shorter mostly come from vertices that should be one, with normals of either side. Details
as small as this keep their curvature: their normals turn gently from vertex to vertex."""
SAMPLED_FACES = 1 << 15
"""Greatest number of faces whose sides give the median edge, to about 1 %. All sides of a million vertices
would take a tenth of the time of the fit."""


class Fit(Protocol):
    """Bounded fit at the points of a surface, without smoothing: vertices at one position are one point."""

    @property
    def group(self) -> IntArray:
        """(V,) index of the point at each vertex."""

    @property
    def points(self) -> FloatArray:
        """(P, 3) positions of the points."""

    @property
    def fitted(self) -> FloatArray:
        """(P, 3) k_uu, k_uv, k_vv in the tangent frames of the points."""

    @property
    def bounded(self) -> NDArray[np.bool_]:
        """(P,) whether a bound reduced the fit."""

    def mean(self, passes: int) -> FloatVector:
        """Return the mean curvature (V,) after smoothing."""

    def tensor(self, passes: int) -> FloatRows:
        """Return k_uu, k_uv, k_vv (V, 3) in the tangent frames of the vertices, after smoothing."""


@dataclass(frozen=True)
class ShapeOperator:
    """Shape operator at every vertex, from one fit that both mean and tensor use. Create it with `fit`.

    Attributes
    ----------
    twin
        The fit, compiled or by NumPy.
    """

    twin: Fit

    @classmethod
    def fit(
        cls, positions: ArrayLike, faces: ArrayLike, normals: ArrayLike | None = None
    ) -> ShapeOperator:
        """Fit the shape operator at every vertex of a mesh.

        Parameters
        ----------
        positions
            (V, 3) in any unit.
        faces
            (F, 3) indices.
        normals
            (V, 3) outward unit normals; computed if None. Normals of vertices that no face uses do not
            count.

        Raises
        ------
        ArgumentError
            If an array has a wrong shape, a value is not finite or an index out of range.

        Examples
        --------
        >>> import skinshade as sk
        >>> from skinshade.mesh.shape_operator import ShapeOperator
        >>> mesh = sk.builtin_head().mesh
        >>> operator = ShapeOperator.fit(mesh.positions_mm, mesh.faces, mesh.normals)
        >>> operator.mean().shape, operator.tensor().shape, operator.bounded_vertices
        ((20560,), (20560, 3), 0)
        """
        p, f, n = checked_mesh(positions, faces, normals)
        if compiled.serves(p, f):
            return cls(CompiledFit.of(p, f, n, _bounds(p, f)))
        return cls(NumpyFit.of(p, f, unit_normals(p, f, n), _bounds(p, f)))

    @property
    def group(self) -> IntArray:
        """(V,) index of the point at each vertex."""
        return self.twin.group

    @property
    def points(self) -> FloatArray:
        """(P, 3) positions of the points."""
        return self.twin.points

    @property
    def fitted(self) -> FloatArray:
        """(P, 3) k_uu, k_uv, k_vv of the fit in the tangent frames of the points, without smoothing."""
        return self.twin.fitted

    @property
    def bounded(self) -> NDArray[np.bool_]:
        """(P,) whether a bound reduced the fit."""
        return self.twin.bounded

    @property
    def bounded_vertices(self) -> int:
        """Number of vertices whose curvature a bound reduced."""
        return int(self.bounded[self.group].sum())

    def mean(self, smoothing: int = 2) -> FloatVector:
        """Return the mean curvature (V,) after passes of smoothing, 0..100; positive where convex."""
        return self.twin.mean(checked_smoothing(smoothing))

    def tensor(self, smoothing: int = 2) -> FloatRows:
        """Return k_uu, k_uv, k_vv (V, 3) in the tangent frames of the vertices, after smoothing, 0..100."""
        return self.twin.tensor(checked_smoothing(smoothing))


def fitted_mean_curvature(
    positions: ArrayLike, faces: ArrayLike, normals: ArrayLike | None, smoothing: int
) -> FloatVector:
    """Return ``ShapeOperator.fit(positions, faces, normals).mean(smoothing)`` with less memory."""
    p, f, n = checked_mesh(positions, faces, normals)
    if compiled.serves(p, f):
        return mean_curvature(p, f, n, _bounds(p, f), checked_smoothing(smoothing))
    return NumpyFit.of(p, f, unit_normals(p, f, n), _bounds(p, f)).mean(
        checked_smoothing(smoothing)
    )


def checked_mesh(
    positions: ArrayLike, faces: ArrayLike, normals: ArrayLike | None
) -> tuple[FloatArray, IntArray, FloatArray | None]:
    """Return positions (V, 3), faces (F, 3) and normals (V, 3) or None, after checks.

    Raises
    ------
    ArgumentError
        If an array has a wrong shape, a value is not finite or an index out of range.
    """
    p = as_positions("positions", positions, copy=False)
    if p.shape[0] == 0:
        raise ArgumentError("positions: there are no vertices")
    f = as_faces("faces", faces, p.shape[0])
    if f.shape[0] == 0:
        raise ArgumentError("faces: there are no faces")
    if normals is None:
        return p, f, None
    return p, f, as_floats("normals", normals, p.shape, copy=False)


def unit_normals(p: FloatArray, f: IntArray, normals: FloatArray | None) -> FloatArray:
    """Return unit normals (V, 3) of a checked mesh, computed if None."""
    return vertex_normals(p, f) if normals is None else unit_vectors(normals)


def checked_smoothing(passes: int) -> int:
    """Return a number of passes of smoothing after a check.

    Raises
    ------
    ArgumentError
        If it is not 0..100.
    """
    if not 0 <= passes <= 100:
        raise ArgumentError(f"smoothing is {passes}; it must be 0..100 passes")
    return passes


def _bounds(p: FloatArray, faces: IntArray) -> FloatVector:
    """Return the bounds (3,): CONDITIONING, RESOLVED_TURN, and the length as which shorter edges count."""
    return np.array([CONDITIONING, RESOLVED_TURN, RESOLUTION * _median_edge(p, faces)])


def _median_edge(p: FloatArray, faces: IntArray) -> float:
    """Return the median length of the sides of at most `SAMPLED_FACES` faces; 0 if all are points."""
    step = 1 + len(faces) // SAMPLED_FACES
    square = (
        compiled.side_squares(p, faces, step) if compiled.serves(p) else _squares(p, faces[::step])
    )
    square = square[square > 0.0]
    if not square.size:
        return 0.0
    # The mean of both middle values; np.median imports masked arrays, which costs .01 s.
    low, high = (square.size - 1) // 2, square.size // 2
    ordered = np.partition(square, (low, high))
    return float(np.sqrt(0.5 * (ordered[low] + ordered[high])))


def _squares(p: FloatArray, faces: IntArray) -> FloatVector:
    """Return the squares of the lengths of all sides."""
    one, other = half_edges(faces)
    step = p[other] - p[one]
    return dot(step, step)
