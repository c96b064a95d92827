"""Compiled kernels of diffusion: the edges of a mesh with their weights, and Chebyshev's recurrence."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .._core import native
from .._core.arrays import FloatArray, FloatRows, FloatVector
from .compiled import packed_points
from .compiled_tables import Corners, Faces, Indices, Points, scratch_for

__all__ = ["COLUMNS", "TERMS", "Edges", "chebyshev_step", "edges_of"]

COLUMNS = 4
"""Columns of values that a step works on, as in diffuse.c."""
TERMS = 3
"""Terms that a step can add to sums, as in diffuse.c."""


@dataclass(frozen=True)
class Edges:
    """Edges of all points; an edge occurs at both its ends.

    Attributes
    ----------
    firsts
        (P + 1,) index of the first edge of every point.
    ends
        (E,) other ends of the edges.
    weights
        (E,) half the sums of the cotangents of the angles opposite to the edges.
    """

    firsts: NDArray[np.int64]
    ends: Indices
    weights: FloatVector


def edges_of(
    points: Points, faces: Faces, floor: float
) -> tuple[Edges, FloatVector, FloatArray, Indices | None, Indices | None]:
    """Return the edges of the points of a welded mesh, and what their rows state.

    Parameters
    ----------
    points, faces
        (V, 3) and (F, 3).
    floor
        Area that faces have at least in cotangents.

    Returns
    -------
    edges, masses, bounds, point, first
        The edges, (P,) masses, (P, 2) bounds of eigenvalues as of `skinshade.mesh.laplacian.edges_of`,
        (V,) points of vertices and (P,) first vertices of points, or None where they are the same.
    """
    scratch = scratch_for(points, faces)
    table = Corners.of(points, faces, scratch)
    packed = packed_points(points, table, scratch)
    rooms = _firsts(2 * table.counts)
    ends, weights = np.empty(rooms[-1], dtype=np.uint32), np.empty(rooms[-1])
    counts = np.empty(table.count, dtype=np.uint32)
    masses, bounds = np.empty(table.count), np.empty((table.count, 2))
    results = rooms, ends, weights, counts, masses, bounds
    native.run("edges_fill", table.slabs, packed, *table.arguments, floor, *results)
    firsts = _firsts(counts)
    edges = Edges(firsts, np.empty(firsts[-1], dtype=np.uint32), np.empty(firsts[-1]))
    arguments = rooms, ends, weights, firsts, edges.ends, edges.weights
    native.run("edges_pack", native.blocks(table.count), *arguments)
    point, first = (None if own is None else own.copy() for own in (table.remap, table.sources))
    return edges, masses, bounds, point, first


def chebyshev_step(
    edges: Edges,
    rates: FloatVector,
    start: bool,
    now: FloatRows,
    previous: FloatRows,
    factors: FloatArray,
    sums: FloatArray,
) -> None:
    """Replace Tₖ₋₁ by Tₖ₊₁ = 2Y Tₖ − Tₖ₋₁ (or by Y Tₖ at the start), and add terms to sums.

    Parameters
    ----------
    edges, rates
        The matrix Y: (Yx)ᵢ = xᵢ − rateᵢ/2 Σⱼ wᵢⱼ (xᵢ − xⱼ).
    start
        Whether the sums are overwritten, and the result is Y Tₖ.
    now, previous
        (P, 4) Tₖ and Tₖ₋₁.
    factors
        (3, 3) factors of Tₖ₋₁, Tₖ and Tₖ₊₁ for every channel.
    sums
        (P, 3, 4) sums for every channel.
    """
    ranges = native.blocks(len(rates))
    arguments = (edges.firsts, edges.ends, edges.weights, rates, int(start), now, previous)
    native.run("chebyshev_step", ranges, *arguments, factors, sums)


def _firsts(counts: Indices) -> NDArray[np.int64]:
    """Return the first place of every row of as many entries, and the end of the last."""
    firsts = np.zeros(len(counts) + 1, dtype=np.int64)
    np.cumsum(counts, out=firsts[1:], dtype=np.int64)
    return firsts
