"""Thickness of a body behind each point of its surface, a distance in mm."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import FloatArray, as_faces, as_floats, as_positions, dot, unit_vectors
from .._core.errors import ArgumentError
from .._core.progress import Progress, silent
from .normals import tangent_frame, vertex_normals
from .rays import RayTracing, open_caster
from .topology import open_edge_counts

__all__ = ["mesh_thickness"]

CHUNK = 1 << 16
"""Rays cast at once."""
INSIDE = 1e-5
"""Share of the body's size by which rays start below the surface, past its own faces."""


def mesh_thickness(
    positions: ArrayLike,
    faces: ArrayLike,
    normals: ArrayLike | None = None,
    *,
    points: ArrayLike | None = None,
    rays: int = 64,
    cone_deg: float = 45.0,
    tracing: RayTracing = "auto",
    progress: Progress = silent,
) -> FloatArray:
    """Return how thick a body is behind points of its surface.

    Rays go inwards from each point within a cone, as many towards each direction as a Lambert surface
    sends light. The mean over them of the distance across the surface, d·cos θ, is the thickness of the
    slab that lets ambient light through as the body does: a slab's own at any angle of the cone, r(1 +
    cos² α) for a sphere of radius r and a half angle α. A ray ends at the first wall that it leaves the
    body through; what lies beyond a gap does not count. Rays that leave through a hole count for
    nothing, and a point none of whose rays meets a wall is as thick as the body is large.

    Parameters
    ----------
    positions
        (V, 3) in any unit.
    faces
        (F, 3) indices, counter-clockwise seen from outside.
    normals
        (V, 3) unit, outward, or (P, 3) with `points`; computed if not given.
    points
        (P, 3) on the surface; the vertices if not given.
    rays
        For each point, 1..4096.
    cone_deg
        Half angle of the cone, 1..89.
    tracing
        ``embree``, ``builtin``, or ``auto`` for Embree where it is installed.
    progress
        Called with what is being done and how far it is.

    Returns
    -------
    (V,) or (P,)
        In the unit of `positions`. By 64 rays within 1 % of the mean over the cone on smooth bodies.

    Raises
    ------
    ArgumentError
        If an array is malformed, a number out of its range, or Embree not installed.
    """
    p = as_positions("positions", positions)
    f = as_faces("faces", faces, p.shape[0])
    if not p.size or not f.size:
        raise ArgumentError("positions, faces: there are none")
    if not 1 <= rays <= 4096 or int(rays) != rays:
        raise ArgumentError(f"rays is {rays}; it must be a whole number, 1..4096")
    if not 1.0 <= cone_deg <= 89.0:
        raise ArgumentError(f"cone_deg is {cone_deg}; it must be 1..89 degrees")
    at = p if points is None else as_positions("points", points)
    if normals is None:
        if points is not None:
            raise ArgumentError("normals: points need theirs")
        n = vertex_normals(p, f)
    else:
        n = unit_vectors(as_floats("normals", normals, at.shape))
    if open_edge_counts(p, f)["edges of opposite winding"]:
        # Which side of a face is out cannot be known: every face is one to leave through.
        f = np.concatenate([f, f[:, ::-1]])
    size = float(np.sqrt(np.square(np.ptp(p, axis=0)).sum()))
    caster = open_caster(p, f, tracing)
    local = _cone(rays, cone_deg)
    per_chunk = max(CHUNK // rays, 1)
    starts = range(0, len(at), per_chunk)

    def of_chunk(start: int) -> FloatArray:
        part = slice(start, start + per_chunk)
        u, v = tangent_frame(n[part])
        turned = local[:, 0, None] * u[:, None] + local[:, 1, None] * v[:, None]
        inward = turned - local[:, 2, None] * n[part][:, None]
        origins = np.repeat(at[part] - INSIDE * size * n[part], rays, axis=0)
        far = caster.exit_distances(origins, inward.reshape(-1, 3)).reshape(-1, rays)
        met = np.isfinite(far)
        across = np.where(met, far * local[:, 2], 0.0).sum(axis=1)
        count = met.sum(axis=1)
        return np.where(count > 0, across / np.maximum(count, 1) + INSIDE * size, size)

    found = np.empty(len(at))
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        for start, part in zip(starts, pool.map(of_chunk, starts), strict=True):
            progress("thickness", start / len(at))
            found[start : start + per_chunk] = part
    progress("thickness", 1.0)
    return found


def _cone(rays: int, cone_deg: float) -> FloatArray:
    """Unit vectors (rays, 3) within a half angle of +z, by the cosine, on a sunflower spiral [Vogel1979]."""
    radius = np.sin(np.radians(cone_deg)) * np.sqrt((np.arange(rays) + 0.5) / rays)
    angle = np.arange(rays) * np.pi * (3.0 - np.sqrt(5.0))
    flat = np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=1)
    return np.concatenate([flat, np.sqrt(1.0 - dot(flat, flat))[:, None]], axis=1)
