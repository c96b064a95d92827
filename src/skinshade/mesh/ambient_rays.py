"""Rays in evenly spread directions from the vertices of a mesh, for ambient light (MODEL §5)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import FloatArray, FloatRows, IntArray, bounding_sphere
from .._core.cache import content_hash, load_cached, store_cached
from .._core.harmonics import cosine_factors, harmonics
from .._core.progress import Progress, silent
from .ray_pool import near_order
from .rays import RayCaster, RayTracing, open_caster
from .topology import face_normals

__all__ = ["AmbientRays", "SeenFaces", "lattice_directions"]

DIRECTIONS = 256
"""Directions over the whole sphere of a vertex; half of them lie above its surface."""
FEWEST_DIRECTIONS = 32
"""Least directions of a vertex of a large mesh, whose neighbours share theirs."""
MOST_RAYS = 5_000_000
"""Number of rays above which vertices have fewer directions: a few seconds of a core."""
BEHIND_SHARE = 8
"""Quotient of the directions and those in which the body's depth is measured, which varies less."""
SETS = 16
"""Sets of directions that neighbouring vertices of a large mesh have in turn."""
OUTSIDE = 2e-5
"""Distance from the surface at which rays start, as a share of the body's radius."""
VERSION = "ambient-rays-2"
"""Name of the computation in the cache; another algorithm needs another name."""
STORED = {"free", "depth", "starts", "faces", "weights"}
"""Names of the arrays in the cache."""
LEAST_CACHED = 4000
"""Least vertices of a mesh whose rays are kept in the cache; fewer are cast as fast as they are read."""
CHUNK = 1 << 19
"""Rays that are cast at once: their arrays take about 50 MiB."""


@dataclass(frozen=True)
class SeenFaces:
    """Faces that the rays of every vertex hit.

    Attributes
    ----------
    starts
        (V + 1,) index of the first hit of every vertex; the last is the number of hits.
    faces
        (H,) face of every hit.
    weights
        (H,) weight of the ray of every hit.
    """

    starts: NDArray[np.int64]
    faces: NDArray[np.int32]
    weights: NDArray[np.float32]

    @classmethod
    def of(
        cls,
        vertices: Sequence[IntArray],
        faces: Sequence[IntArray],
        weights: Sequence[FloatArray],
        count: int,
    ) -> SeenFaces:
        """Return the hits of `count` vertices from parts that list vertex, face and weight of hits."""
        vertex = np.concatenate(vertices)
        order = np.argsort(vertex, kind="stable")
        ends = np.cumsum(np.bincount(vertex, minlength=count))
        return cls(
            np.concatenate([[0], ends]),
            np.concatenate(faces)[order].astype(np.int32),
            np.concatenate(weights)[order].astype(np.float32),
        )

    def gathered(self, values: FloatArray) -> FloatArray:
        """Return the weighted sums (V, K) of values (F, K) of the faces."""
        result = np.zeros((len(self.starts) - 1, values.shape[1]))
        # reduceat would give a vertex without hits the first hit of the next one.
        hitting = np.flatnonzero(np.diff(self.starts))
        if hitting.size:
            light = values[self.faces] * self.weights[:, None]
            result[hitting] = np.add.reduceat(light, self.starts[hitting], axis=0)
        return result


@dataclass(frozen=True)
class AmbientRays:
    """Hits of rays from the vertices of a mesh, in evenly spread directions.

    A vertex of the set s has the directions ``directions[s]``. Those above its surface have weights
    proportional to the cosine with its normal, whose sum is 1.

    Attributes
    ----------
    normals
        (V, 3) unit normals.
    turn
        (V,) set of each vertex.
    directions
        (S, D, 3) unit vectors.
    free
        (V, D) whether no face lies in a direction above the surface.
    seen
        Faces whose front rays hit.
    behind
        (S, B, 3) directions in which the depth of the body is measured.
    depth
        (V, B) distance at which a ray into the body leaves it for good. 0 above the surface; infinite if the
        ray does not leave, or if another part of the body follows.
    """

    normals: FloatRows
    turn: IntArray
    directions: FloatArray
    free: NDArray[np.bool_]
    seen: SeenFaces
    behind: FloatArray
    depth: NDArray[np.float32]

    @classmethod
    def cast(
        cls,
        positions: FloatArray,
        faces: IntArray,
        normals: FloatRows,
        *,
        directions: int | None = None,
        tracing: str = RayTracing.AUTO,
        progress: Progress = silent,
    ) -> AmbientRays:
        """Return the hits of the rays from all vertices.

        Parameters
        ----------
        positions, faces, normals
            (V, 3), (F, 3) and unit (V, 3).
        directions
            Directions of a vertex over the whole sphere; by the number of vertices if None.
        tracing
            Ray caster, as in `skinshade.mesh_thickness`.
        progress
            Called with the name of the work and the fraction that is done.
        """
        vertices = len(positions)
        name = content_hash(VERSION, positions, faces, normals, directions or 0)
        stored = load_cached(name) if vertices >= LEAST_CACHED else None
        if directions is None:
            directions = int(
                np.clip(2 * MOST_RAYS // max(vertices, 1), FEWEST_DIRECTIONS, DIRECTIONS)
            )
        sets = 1 if directions >= DIRECTIONS else SETS
        order = near_order(positions, np.arange(vertices), faces)
        turn = np.empty(vertices, dtype=np.int64)
        turn[order] = np.arange(vertices) % sets
        above = _turned_lattices(directions, sets)
        behind = _turned_lattices(max(directions // BEHIND_SHARE, 1), sets)
        kept = vertices, behind.shape[1]
        if stored is not None and stored.keys() >= STORED and stored["depth"].shape == kept:
            progress("ambient light", 1.0)
            return cls._restored(normals, turn, above, behind, stored)
        offset = OUTSIDE * bounding_sphere(positions)[1]
        caster = _Caster(open_caster(positions, faces, tracing), positions, normals, offset)
        facing = face_normals(positions, faces)
        free = np.zeros((vertices, directions), dtype=np.bool_)
        depth = np.zeros((vertices, behind.shape[1]), dtype=np.float32)
        rows, columns, shares = [], [], []
        per_chunk = max(CHUNK // directions, 1)
        starts = [
            (number, start)
            for number in range(sets)
            for start in range(0, -(-(vertices - number) // sets), per_chunk)
        ]
        for step, (number, start) in enumerate(starts):
            progress("ambient light", step / len(starts))
            own = order[number::sets][start : start + per_chunk]
            ray, vertex, face, weight = caster.first_faces(own, above[number])
            free[vertex, ray] = face < 0
            hit = np.flatnonzero(face >= 0)
            hit = hit[(facing[face[hit]] * above[number][ray[hit]]).sum(axis=1) < 0.0]
            rows.append(vertex[hit].astype(np.int32))
            columns.append(face[hit].astype(np.int32))
            shares.append(weight[hit].astype(np.float32))
            caster.measure_depth(own, behind[number], depth)
        progress("ambient light", 1.0)
        seen = SeenFaces.of(rows, columns, shares, vertices)
        rays = cls(normals, turn, above, free, seen, behind, depth)
        if vertices >= LEAST_CACHED:
            store_cached(name, rays._stored())
        return rays

    def _stored(self) -> dict[str, NDArray[Any]]:
        """Return the arrays that the directions and the mesh do not give."""
        return {
            "free": np.packbits(self.free, axis=1),
            "depth": self.depth,
            "starts": self.seen.starts,
            "faces": self.seen.faces,
            "weights": self.seen.weights,
        }

    @classmethod
    def _restored(
        cls,
        normals: FloatRows,
        turn: IntArray,
        above: FloatArray,
        behind: FloatArray,
        stored: dict[str, NDArray[Any]],
    ) -> AmbientRays:
        """Return rays from the arrays of `_stored`."""
        free = np.unpackbits(stored["free"], axis=1, count=above.shape[1]).astype(np.bool_)
        seen = SeenFaces(stored["starts"], stored["faces"], stored["weights"])
        return cls(normals, turn, above, free, seen, behind, stored["depth"])

    def arriving(self, values: FloatArray, unoccluded: FloatArray | None = None) -> FloatArray:
        """Return the cosine-weighted means (V, K) of values of the directions; hidden ones count as 0.

        Parameters
        ----------
        values
            (S, D, K) values of the directions of the sets.
        unoccluded
            (V, K) exact means without the body. The error that the sum over all directions has beside them is
            subtracted, in the share of the directions that are free.
        """
        result = np.empty((len(self.normals), values.shape[2]))
        for own, number in self._chunks():
            weights = _weights(self.normals[own], self.directions[number])
            free = weights * self.free[own]
            result[own] = free @ values[number]
            if unoccluded is not None:
                error = weights @ values[number] - unoccluded[own]
                result[own] -= free.sum(axis=1, keepdims=True) * error
        return result

    def visible_harmonics(self, order: int) -> FloatArray:
        """Return the cosine-weighted means (V, (order + 1)²) of the harmonics over the free directions."""
        exact = cosine_factors(order) * harmonics(self.normals, order)
        return self.arriving(harmonics(self.directions, order), exact)

    def bounced(
        self, values: FloatArray, reflectance: FloatArray, faces: IntArray, bounces: int
    ) -> FloatArray:
        """Return the light (V, K) that arrives from other parts of the body after up to `bounces` bounces.

        Parameters
        ----------
        values
            (V, K) light that arrives at the vertices without a bounce, irradiance over π.
        reflectance
            (V, K) or (V, 1) share of the light that a vertex sends back.
        faces
            (F, 3) faces of the mesh.
        bounces
            Number of bounces, ≥ 0.
        """
        total, light = np.zeros_like(values), values
        for _ in range(bounces):
            radiosity = reflectance * light
            light = self.seen.gathered(radiosity[faces].mean(axis=1))
            total += light
        return total

    def through(self, passed: FloatArray, values: FloatArray) -> FloatArray:
        """Return the cosine-weighted means (V, K) of values (S, B, K) of the directions behind the surface.

        Parameters
        ----------
        passed
            (V, B, K) share of the light that passes through the body in each direction.
        values
            (S, B, K) values of the directions.
        """
        result = np.empty((len(self.normals), values.shape[2]))
        for own, number in self._chunks():
            weights = _weights(-self.normals[own], self.behind[number])
            result[own] = np.einsum("vb,vbk,bk->vk", weights, passed[own], values[number])
        return result

    def _chunks(self) -> list[tuple[IntArray, int]]:
        """Return the vertices of every chunk, and their set."""
        per_chunk = max(CHUNK // self.directions.shape[1], 1)
        chunks = []
        for number in range(len(self.directions)):
            own = np.flatnonzero(self.turn == number)
            chunks += [(own[i : i + per_chunk], number) for i in range(0, len(own), per_chunk)]
        return chunks


@dataclass(frozen=True)
class _Caster:
    """Rays from the vertices of a mesh."""

    caster: RayCaster
    positions: FloatArray
    normals: FloatArray
    offset: float

    def first_faces(
        self, own: IntArray, directions: FloatArray
    ) -> tuple[IntArray, IntArray, IntArray, FloatArray]:
        """Return direction, vertex, first face or −1, and weight (N,) of all rays above vertices `own`."""
        weights = _weights(self.normals[own], directions)
        # Successive rays have one direction and neighbouring vertices: they visit the same boxes.
        ray, row = np.nonzero(weights.T > 0.0)
        vertex = own[row]
        origins = self.positions[vertex] + self.offset * self.normals[vertex]
        hits = self.caster.nearest(origins, directions[ray])
        return ray, vertex, hits.faces, weights[row, ray]

    def measure_depth(
        self, own: IntArray, directions: FloatArray, depth: NDArray[np.float32]
    ) -> None:
        """Write the distances at which rays behind vertices `own` leave the body into `depth` (V, B)."""
        ray, row = np.nonzero((self.normals[own] @ directions.T < 0.0).T)
        vertex = own[row]
        origins = self.positions[vertex] - self.offset * self.normals[vertex]
        along = directions[ray]
        distance = self.caster.exit_distances(origins, along)
        leaves = np.flatnonzero(np.isfinite(distance))
        exits = origins[leaves] + (distance[leaves, None] + self.offset) * along[leaves]
        blocked = self.caster.occluded(exits, along[leaves], np.full(leaves.size, np.inf))
        distance[leaves[blocked]] = np.inf
        depth[vertex, ray] = distance


def _weights(normals: FloatArray, directions: FloatArray) -> FloatArray:
    """Return the cosines (V, D) of directions (D, 3) with normals (V, 3), 0 below, with a sum of 1."""
    cosine = np.maximum(normals @ directions.T, 0.0)
    result: FloatArray = cosine / np.maximum(cosine.sum(axis=1, keepdims=True), 1e-12)
    return result


def lattice_directions(count: int) -> FloatArray:
    """Return unit vectors (count, 3) on a spherical Fibonacci lattice."""
    y = 1.0 - (2.0 * np.arange(count) + 1.0) / count
    angle = np.arange(count) * np.pi * (3.0 - np.sqrt(5.0))
    ring = np.sqrt(1.0 - y * y)
    return np.stack([ring * np.cos(angle), y, ring * np.sin(angle)], axis=1)


def _turned_lattices(count: int, sets: int) -> FloatArray:
    """Return `sets` lattices (sets, count, 3), each turned at random but for the first."""
    lattice = lattice_directions(count)
    quaternions = np.random.default_rng(1).normal(size=(sets, 4))
    quaternions[0] = (1.0, 0.0, 0.0, 0.0)
    w, x, y, z = (quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)).T
    turns = np.stack(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    return np.einsum("ijs,dj->sdi", turns, lattice)
