"""Ray casting: a compiled bounding volume hierarchy, its NumPy twin, or Embree."""

from __future__ import annotations

from collections.abc import Iterator
from importlib.util import find_spec
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import FloatArray, FloatRows, FloatVector, IntArray, dot
from .._core.choice import Choice
from .._core.errors import ArgumentError
from . import compiled_rays
from .compiled_rays import CompiledHierarchy
from .ray_frame import RayFrame, RayHits, morton_codes
from .topology import face_normals

__all__ = ["RayCaster", "RayHits", "RayTracing", "open_caster"]

LEAF = 4
"""Triangles in a leaf."""
MOST_PAIRS = 1 << 20
"""Pairs of rays and boxes in one step: with coincident faces, all rays intersect all boxes."""
MOST_WALLS = 16
"""Faces that a ray may enter before it leaves the body; real bodies have fewer."""
BOX_SLACK = 1e-6
"""Margin of boxes for the rounding of single precision; coordinates are in -1..1."""
RATIO_SLACK = 1.0 + 2.0**-18
"""Factor of the distance at which a ray leaves a box, for the rounding of distances."""


class RayTracing(Choice):
    """Ray caster; ``auto`` is the compiled one, else Embree where it is installed, else NumPy's."""

    AUTO = "auto"
    EMBREE = "embree"
    BUILTIN = "builtin"


class RayCaster(Protocol):
    """Interface of a ray caster. Directions are unit vectors."""

    def exit_distances(self, origins: FloatArray, directions: FloatArray) -> FloatVector:
        """Return the distance (N,) to the first face that a ray leaves through; infinite without one."""

    def nearest(self, origins: FloatArray, directions: FloatArray) -> RayHits:
        """Return the nearest faces on rays, from either side."""

    def occluded(
        self, origins: FloatArray, directions: FloatArray, distances: FloatArray
    ) -> NDArray[np.bool_]:
        """Return whether (N,) rays hit a face, from either side, within their distances (N,)."""


def open_caster(
    positions: FloatArray, faces: IntArray, tracing: str = RayTracing.AUTO
) -> RayCaster:
    """Return a ray caster for a mesh: positions (V, 3), faces (F, 3).

    The compiled hierarchy intersects in float64, Embree in float32.

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
    if choice != RayTracing.EMBREE and compiled_rays.serves(positions, faces):
        return CompiledHierarchy.of(positions, faces)
    if choice == RayTracing.BUILTIN or not has_embree:
        return Hierarchy(positions, faces)
    return Embree(positions, faces)


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
        self._normals = face_normals(positions, faces)
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

    def nearest(self, origins: FloatArray, directions: FloatArray) -> RayHits:
        """Return the nearest faces on rays, from either side."""
        start = ((origins - self._middle) / self._size).astype(np.float32)
        hits = self._scene.run(start, np.asarray(directions, dtype=np.float32), output=True)
        face = hits["primID"].astype(np.int64)
        is_hit = face >= 0
        weights = np.stack([1.0 - hits["u"] - hits["v"], hits["u"], hits["v"]], axis=1)
        return RayHits(
            np.where(is_hit, hits["tfar"] * self._size, np.inf),
            face,
            np.where(is_hit[:, None], weights, 0.0).astype(np.float64),
        )

    def occluded(
        self, origins: FloatArray, directions: FloatArray, distances: FloatArray
    ) -> NDArray[np.bool_]:
        """Return whether (N,) rays hit a face, from either side, within their distances (N,)."""
        nearest = self.nearest(origins, directions).distances
        return np.isfinite(nearest) & (nearest <= distances)


class Hierarchy:
    """Complete binary tree of boxes over triangles in Morton order. All rays descend level by level.

    The intersection is that of the compiled hierarchy: no ray passes between faces that share an edge.

    Parameters
    ----------
    positions, faces
        (V, 3) and (F, 3).
    """

    def __init__(self, positions: FloatArray, faces: IntArray) -> None:
        self._frame = RayFrame.of(positions, faces)
        corners = self._frame.points(positions)[faces]
        order = np.argsort(morton_codes(corners.mean(axis=1)), kind="stable")
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
        self._levels = [
            [
                (
                    np.ascontiguousarray(low[:, axis] - BOX_SLACK, dtype=np.float32),
                    np.ascontiguousarray(high[:, axis] + BOX_SLACK, dtype=np.float32),
                )
                for axis in range(3)
            ]
            for low, high in levels
        ]
        self._corners = corners

    def exit_distances(self, origins: FloatArray, directions: FloatArray) -> FloatVector:
        """Return the distance (N,) to the first face that a ray leaves through; infinite without one."""
        start = self._frame.points(origins)
        result = np.empty(len(start))
        for part, ray, leaf in self._batches(start, directions):
            result[part] = self._nearest(start[part], directions[part], ray, leaf)
        return result / self._frame.scale

    def nearest(self, origins: FloatArray, directions: FloatArray) -> RayHits:
        """Return the nearest faces on rays, from either side."""
        start = self._frame.points(origins)
        distances, faces = np.full(len(start), np.inf), np.full(len(start), -1, dtype=np.int64)
        weights = np.zeros((len(start), 3))
        for part, ray, leaf in self._batches(start, directions):
            ray, face, distance, weight, _ = self._hits(start[part], directions[part], ray, leaf)
            order = np.lexsort((face, distance, ray))
            ray, first = np.unique(ray[order], return_index=True)
            row, order = part.start + ray, order[first]
            distances[row], faces[row], weights[row] = distance[order], face[order], weight[order]
        return RayHits(distances / self._frame.scale, faces, weights)

    def occluded(
        self, origins: FloatArray, directions: FloatArray, distances: FloatArray
    ) -> NDArray[np.bool_]:
        """Return whether (N,) rays hit a face, from either side, within their distances (N,)."""
        start = self._frame.points(origins)
        limits = np.broadcast_to(np.asarray(distances) * self._frame.scale, len(start))
        blocked = np.zeros(len(start), dtype=np.bool_)
        for part, ray, leaf in self._batches(start, directions):
            ray, _, distance, _, _ = self._hits(start[part], directions[part], ray, leaf)
            blocked[part.start + ray[distance <= limits[part][ray]]] = True
        return blocked

    def _batches(
        self, origins: FloatRows, directions: FloatArray
    ) -> Iterator[tuple[slice, IntArray, IntArray]]:
        """Yield ranges of rays, and pairs of their rays and the leaves that these enter."""
        left = [(0, len(origins))]
        while left:
            first, last = left.pop()
            part = slice(first, last)
            pairs = self._entered(origins[part], directions[part])
            if pairs is not None:
                yield part, *pairs
                continue
            middle = (first + last) // 2
            left += [(middle, last), (first, middle)]

    def _entered(
        self, origins: FloatRows, directions: FloatArray
    ) -> tuple[IntArray, IntArray] | None:
        """Return pairs of rays and leaves, or None if they are too many for several rays."""
        safe = np.where(np.abs(directions) < 1e-9, 1e-9, directions)
        # All boxes are within 2 of the middle: distant rays start near them, for single precision.
        away = np.maximum(np.sqrt(dot(origins, origins)) - 2.0, 0.0)
        near = origins + away[:, None] * directions
        starts = [np.ascontiguousarray(axis, dtype=np.float32) for axis in near.T]
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
            hit = np.flatnonzero(leave * np.float32(RATIO_SLACK) >= enter)
            if hit.size > MOST_PAIRS and len(origins) > 1:
                return None
            ray, node = ray[hit], node[hit]
        return ray, node

    def _nearest(
        self, origins: FloatRows, directions: FloatArray, ray: IntArray, leaf: IntArray
    ) -> FloatVector:
        """Return the nearest exit (N,) among the faces of the leaves that rays enter."""
        ray, _, distance, _, leaves = self._hits(origins, directions, ray, leaf)
        result = np.full(len(origins), np.inf)
        np.minimum.at(result, ray[leaves], distance[leaves])
        return result

    def _hits(
        self, origins: FloatRows, directions: FloatArray, ray: IntArray, leaf: IntArray
    ) -> tuple[IntArray, IntArray, FloatVector, FloatRows, NDArray[np.bool_]]:
        """Return for every hit its ray, face, distance, weights, and whether the ray leaves the body.

        The ray is an axis of the frame [Woop2013]: an edge has opposite values for both of its faces, and
        0 counts as a hit.
        """
        face = self._leaf_faces[leaf]
        ray = np.repeat(ray, LEAF)[face.ravel() >= 0]
        face = face.ravel()[face.ravel() >= 0]
        z = np.abs(directions).argmax(axis=1)
        axes = np.stack([(z + 1) % 3, (z + 2) % 3, z], axis=1)
        along = np.take_along_axis(directions, axes, axis=1)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            shear_x, shear_y = along[:, 0] / along[:, 2], along[:, 1] / along[:, 2]
            shear_z = 1.0 / along[:, 2]
            x, y, depth = [], [], []
            for corner in range(3):
                moved = self._corners[face, corner] - origins[ray]
                a, b, c = np.take_along_axis(moved, axes[ray], axis=1).T
                x.append(a - shear_x[ray] * c)
                y.append(b - shear_y[ray] * c)
                depth.append(shear_z[ray] * c)
            u, v = x[2] * y[1] - y[2] * x[1], x[0] * y[2] - y[0] * x[2]
            w = x[1] * y[0] - y[1] * x[0]
            determinant = u + v + w
            distance = (u * depth[0] + v * depth[1] + w * depth[2]) / determinant
            positive, negative = (u >= 0) & (v >= 0) & (w >= 0), (u <= 0) & (v <= 0) & (w <= 0)
            hit = (positive | negative) & (determinant != 0.0) & (distance > 0.0)
            weights = np.stack([u, v, w], axis=1)[hit] / determinant[hit, None]
        leaves = np.where(shear_z[ray] < 0.0, positive, negative)
        return ray[hit], face[hit], distance[hit], weights, leaves[hit]
