"""Ray casting inside a body: Embree where it is installed, else a bounding volume hierarchy."""

from __future__ import annotations

from importlib.util import find_spec
from typing import Any, Protocol

import numpy as np

from .._core.arrays import FloatArray, IntArray, dot
from .._core.choice import Choice
from .._core.errors import ArgumentError

__all__ = ["RayCaster", "RayTracing", "open_caster"]

LEAF = 4
"""Triangles in a leaf."""
MOST_PAIRS = 1 << 20
"""Pairs of rays and boxes in one step: with coincident faces, all rays intersect all boxes."""
MOST_WALLS = 16
"""Faces that a ray may enter before it leaves the body; real bodies have fewer."""


class RayTracing(Choice):
    """Ray caster; ``auto`` is Embree where it is installed, else the built-in one."""

    AUTO = "auto"
    EMBREE = "embree"
    BUILTIN = "builtin"


class RayCaster(Protocol):
    """Interface of a ray caster."""

    def exit_distances(self, origins: FloatArray, directions: FloatArray) -> FloatArray:
        """Return the distance (N,) to the first face that a ray leaves through; infinite without one."""


def open_caster(
    positions: FloatArray, faces: IntArray, tracing: str = RayTracing.AUTO
) -> RayCaster:
    """Return a ray caster for a mesh: positions (V, 3), faces (F, 3).

    Raises
    ------
    ArgumentError
        If there is no such caster, or Embree is requested and not installed.
    """
    choice = RayTracing.of(tracing, "tracing")
    has_embree = find_spec("embreex") is not None
    if choice == RayTracing.EMBREE and not has_embree:
        raise ArgumentError(
            'tracing is embree, which is not installed: pip install "skinshade[embree]"'
        )
    if choice == RayTracing.BUILTIN or not has_embree:
        return Hierarchy(positions, faces)
    return Embree(positions, faces)


def _face_normals(positions: FloatArray, faces: IntArray) -> FloatArray:
    p = positions[faces]
    return np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])


class Embree:
    """Embree, in single precision: distances are exact to 1e-6 of the body's size.

    Parameters
    ----------
    positions, faces
        (V, 3) and (F, 3).
    """

    def __init__(self, positions: FloatArray, faces: IntArray) -> None:
        from embreex.mesh_construction import TriangleMesh
        from embreex.rtcore_scene import EmbreeScene

        self._middle = positions.mean(axis=0)
        # Scaled to a size of 1, single precision neither overflows nor underflows.
        self._size = float(np.ptp(positions, axis=0).max()) or 1.0
        self._normals = _face_normals(positions, faces)
        self._scene: Any = EmbreeScene(robust=True)
        points = np.ascontiguousarray((positions - self._middle) / self._size, dtype=np.float32)
        self._mesh = TriangleMesh(self._scene, points, np.ascontiguousarray(faces, dtype=np.int32))

    def exit_distances(self, origins: FloatArray, directions: FloatArray) -> FloatArray:
        """Return the distance (N,) to the first face that a ray leaves through; infinite without one."""
        result = np.full(len(origins), np.inf)
        travelled = np.zeros(len(origins))
        active = np.arange(len(origins))
        origins = (origins - self._middle) / self._size
        step = 1e-6
        for _ in range(MOST_WALLS):
            start = origins[active] + travelled[active, None] * directions[active]
            hits = self._scene.run(
                start.astype(np.float32), directions[active].astype(np.float32), output=True
            )
            hit = hits["primID"] >= 0
            active, face = active[hit], hits["primID"][hit]
            travelled[active] += hits["tfar"][hit]
            leaves = dot(self._normals[face], directions[active]) > 0.0
            result[active[leaves]] = travelled[active[leaves]] * self._size
            active = active[~leaves]
            if not active.size:
                break
            travelled[active] += step
        return result


class Hierarchy:
    """Complete binary tree of boxes over triangles in Morton order. All rays descend level by level.

    Parameters
    ----------
    positions, faces
        (V, 3) and (F, 3).
    """

    def __init__(self, positions: FloatArray, faces: IntArray) -> None:
        corners = positions[faces]
        order = np.argsort(_morton_codes(corners.mean(axis=1)))
        leaves = 1 << max(int(np.ceil(np.log2(max(len(faces) / LEAF, 1.0)))), 0)
        padded = np.full(leaves * LEAF, -1, dtype=np.int64)
        # Evenly spread: leaves hold three or four triangles instead of four or none.
        padded[np.linspace(0, leaves * LEAF, len(faces), endpoint=False).astype(np.int64)] = order
        self._leaf_faces = padded.reshape(leaves, LEAF)
        low = np.where(padded[:, None] >= 0, corners[padded].min(axis=1), np.inf)
        high = np.where(padded[:, None] >= 0, corners[padded].max(axis=1), -np.inf)
        low = low.reshape(leaves, LEAF, 3).min(axis=1)
        high = high.reshape(leaves, LEAF, 3).max(axis=1)
        levels = [(low, high)]
        while len(low) > 1:
            low = np.minimum(low[0::2], low[1::2])
            high = np.maximum(high[0::2], high[1::2])
            levels.insert(0, (low, high))
        # One axis at a time, in single precision; the slack keeps the triangles inside their boxes.
        slack = 1e-6 * float(np.abs(positions).max())
        self._levels = [
            [
                (
                    np.ascontiguousarray(low[:, axis] - slack, dtype=np.float32),
                    np.ascontiguousarray(high[:, axis] + slack, dtype=np.float32),
                )
                for axis in range(3)
            ]
            for low, high in levels
        ]
        self._corner = corners[:, 0]
        self._sides = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]

    def exit_distances(self, origins: FloatArray, directions: FloatArray) -> FloatArray:
        """Return the distance (N,) to the first face that a ray leaves through; infinite without one."""
        safe = np.where(np.abs(directions) < 1e-9, 1e-9, directions)
        starts = [np.ascontiguousarray(axis, dtype=np.float32) for axis in origins.T]
        inverses = [np.ascontiguousarray(axis, dtype=np.float32) for axis in (1.0 / safe).T]
        ray, node = np.arange(len(origins)), np.zeros(len(origins), dtype=np.int64)
        for number, level in enumerate(self._levels):
            if number:
                ray, node = np.repeat(ray, 2), np.repeat(2 * node, 2)
                node[1::2] += 1
            enter = np.zeros(len(ray), dtype=np.float32)
            leave = np.full(len(ray), np.inf, dtype=np.float32)
            for (low, high), start, inverse in zip(level, starts, inverses, strict=True):
                o, i = start[ray], inverse[ray]
                one, other = (low[node] - o) * i, (high[node] - o) * i
                np.maximum(enter, np.minimum(one, other), out=enter)
                np.minimum(leave, np.maximum(one, other), out=leave)
            hit = np.flatnonzero(leave >= enter)
            if hit.size > MOST_PAIRS and len(origins) > 1:
                half = len(origins) // 2
                parts = (slice(None, half), slice(half, None))
                return np.concatenate(
                    [self.exit_distances(origins[part], directions[part]) for part in parts]
                )
            ray, node = ray[hit], node[hit]
        return self._nearest(origins, directions, ray, node)

    def _nearest(
        self, origins: FloatArray, directions: FloatArray, ray: IntArray, leaf: IntArray
    ) -> FloatArray:
        """Return the nearest exit (N,) among the faces of the leaves that rays enter."""
        face = self._leaf_faces[leaf]
        ray = np.repeat(ray, LEAF)[face.ravel() >= 0]
        face = face.ravel()[face.ravel() >= 0]
        # Intersection after Möller and Trumbore, for faces through which a ray leaves.
        one, other = self._sides[0][face], self._sides[1][face]
        d = directions[ray]
        p = np.cross(d, other)
        determinant = dot(one, p)
        t = origins[ray] - self._corner[face]
        q = np.cross(t, one)
        with np.errstate(divide="ignore", invalid="ignore"):
            u, v = dot(t, p) / determinant, dot(d, q) / determinant
            distance = dot(other, q) / determinant
            slack = 1e-9
            left = (determinant < 0.0) & (u >= -slack) & (v >= -slack) & (u + v <= 1.0 + slack)
            left &= distance > 0.0
        result = np.full(len(origins), np.inf)
        np.minimum.at(result, ray[left], distance[left])
        return result


def _morton_codes(points: FloatArray) -> IntArray:
    """Return the positions (N,) of points along the Morton curve, with ten bits per axis."""
    low, extent = points.min(axis=0), np.maximum(np.ptp(points, axis=0), 1e-300)
    cell = np.minimum((points - low) / extent * 1024.0, 1023.0).astype(np.int64)
    codes = np.zeros(len(points), dtype=np.int64)
    for bit in range(10):
        for axis in range(3):
            codes |= ((cell[:, axis] >> bit) & 1) << (3 * bit + axis)
    return codes
