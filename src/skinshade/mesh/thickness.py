"""Thickness of a body behind points of its surface."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import (
    FloatArray,
    FloatVector,
    IntArray,
    as_faces,
    as_floats,
    as_positions,
    dot,
    unit_vectors,
)
from .._core.errors import ArgumentError
from .._core.progress import Progress, silent
from .normals import tangent_frame, vertex_normals
from .rays import RayTracing, open_caster
from .topology import open_edge_counts, used_vertices, weld

__all__ = ["mesh_thickness"]

CHUNK = 1 << 16
"""Rays in a chunk."""
INSIDE = 1e-5
"""Depth below the surface at which rays start, as a share of the body's size."""


def mesh_thickness(
    positions: ArrayLike,
    faces: ArrayLike,
    normals: ArrayLike | None = None,
    *,
    points: ArrayLike | None = None,
    rays: int = 64,
    cone_deg: float = 45.0,
    tracing: str = RayTracing.AUTO,
    progress: Progress = silent,
) -> FloatVector:
    """Return the thickness of a body behind points of its surface.

    Rays go inwards from every point within a cone, with the directions of a Lambert surface. The
    thickness is the mean of d·cos θ over the rays, with the distance d to the first face through which
    the ray leaves the body. It equals the thickness of a slab for any cone, and r(1 + cos² α) for a
    sphere of radius r and a cone of half angle α. Rays that leave through a hole are ignored; if all rays
    of a point do, its thickness is the size of the body.

    Parameters
    ----------
    positions
        (V, 3) in any unit.
    faces
        (F, 3) indices, counter-clockwise seen from outside.
    normals
        (V, 3) outward unit normals, or (P, 3) with `points`; computed if None.
    points
        (P, 3) points on the surface; the vertices if None.
    rays
        Rays per point, 1..4096.
    cone_deg
        Half angle of the cone, degrees, 1..89.
    tracing
        ``embree``, ``builtin``, or ``auto`` for Embree where it is installed.
    progress
        Called with the name of the work and the fraction that is done.

    Returns
    -------
    (V,) or (P,)
        Thickness in the unit of `positions`. With 64 rays it is within 1 % of the mean over the cone on
        smooth bodies. Vertices that no face uses have the thickness of a used vertex at their position.

    Raises
    ------
    ArgumentError
        If an array is malformed, a number is out of range, or Embree is requested and not installed.

    Examples
    --------
    >>> import skinshade as sk
    >>> mesh = sk.builtin_head().mesh
    >>> ear = mesh.positions_mm[:, 0].argmax()
    >>> point, normal = mesh.positions_mm[[ear]], mesh.normals[[ear]]
    >>> thickness = sk.mesh_thickness(mesh.positions_mm, mesh.faces, normal, points=point)
    >>> bool(1.0 < thickness[0] < 15.0)  # mm
    True
    """
    p = as_positions("positions", positions)
    f = as_faces("faces", faces, p.shape[0])
    if not p.size or not f.size:
        raise ArgumentError("positions, faces: there are no vertices or no faces")
    if not 1 <= rays <= 4096 or int(rays) != rays:
        raise ArgumentError(f"rays is {rays}; it must be a whole number, 1..4096")
    if not 1.0 <= cone_deg <= 89.0:
        raise ArgumentError(f"cone_deg is {cone_deg}; it must be 1..89 degrees")
    surface = p if points is None else as_positions("points", points)
    if normals is None:
        if points is not None:
            raise ArgumentError("normals: give the normals of the points")
        n = vertex_normals(p, f)
    else:
        n = unit_vectors(as_floats("normals", normals, surface.shape))
    copies = None
    if points is None:
        own, copies = _vertices_to_trace(p, f)
        surface, n = p[own], n[own]
    if open_edge_counts(p, f)["edges of opposite winding"]:
        # The outside of a face is unknown: rays may leave through either side.
        f = np.concatenate([f, f[:, ::-1]])
    size = float(np.sqrt(np.square(np.ptp(p, axis=0)).sum()))
    caster = open_caster(p, f, tracing)
    local = _cone(rays, cone_deg)
    per_chunk = max(CHUNK // rays, 1)
    starts = range(0, len(surface), per_chunk)

    def chunk_thickness(start: int) -> FloatArray:
        part = slice(start, start + per_chunk)
        u, v = tangent_frame(n[part])
        turned = local[:, 0, None] * u[:, None] + local[:, 1, None] * v[:, None]
        inward = turned - local[:, 2, None] * n[part][:, None]
        origins = np.repeat(surface[part] - INSIDE * size * n[part], rays, axis=0)
        distance = caster.exit_distances(origins, inward.reshape(-1, 3)).reshape(-1, rays)
        hits = np.isfinite(distance)
        across = np.where(hits, distance * local[:, 2], 0.0).sum(axis=1)
        count = hits.sum(axis=1)
        return np.where(count > 0, across / np.maximum(count, 1) + INSIDE * size, size)

    result = np.empty(len(surface))
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        for start, part in zip(starts, pool.map(chunk_thickness, starts), strict=True):
            progress("thickness", start / len(surface))
            result[start : start + per_chunk] = part
    progress("thickness", 1.0)
    return result if copies is None else result[copies]


def _vertices_to_trace(p: FloatArray, faces: IntArray) -> tuple[IntArray, IntArray]:
    """Return the vertices (T,) that need rays, and for every vertex (V,) the one whose result it has.

    A vertex that no face uses, such as one of a doubled face that was dropped, can point into the body's
    outside. It has the result of the first used vertex at its position.
    """
    count = len(p)
    own = np.arange(count)
    used = used_vertices(faces, count)
    if used.all():
        return own, own
    group, first = weld(p)
    leader = np.full(first.size, count)
    np.minimum.at(leader, group[used], own[used])
    source = np.where(used | (leader[group] == count), own, leader[group])
    return np.unique(source, return_inverse=True)


def _cone(rays: int, cone_deg: float) -> FloatArray:
    """Return cosine-weighted unit vectors (rays, 3) around +z, on a sunflower spiral [Vogel1979]."""
    radius = np.sin(np.radians(cone_deg)) * np.sqrt((np.arange(rays) + 0.5) / rays)
    angle = np.arange(rays) * np.pi * (3.0 - np.sqrt(5.0))
    flat = np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=1)
    return np.concatenate([flat, np.sqrt(1.0 - dot(flat, flat))[:, None]], axis=1)
