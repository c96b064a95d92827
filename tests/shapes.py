"""Meshes of shapes whose normals and curvatures are known.

Curvature is positive where convex, and faces are counter-clockwise seen from outside.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np
import trimesh
from scipy.spatial import ConvexHull, Delaunay


@dataclass(frozen=True)
class Shape:
    """A mesh of a known surface.

    Attributes
    ----------
    positions, normals
        (V, 3) points on the surface, and their unit normals.
    faces
        (F, 3).
    k_max, k_min
        (V,) principal curvatures.
    """

    positions: np.ndarray
    faces: np.ndarray
    normals: np.ndarray
    k_max: np.ndarray
    k_min: np.ndarray

    @property
    def mean_curvature(self) -> np.ndarray:
        return 0.5 * (self.k_max + self.k_min)

    def rms_error(self, mean_curvature: np.ndarray) -> float:
        return relative_rms(mean_curvature, self.mean_curvature)


def relative_rms(value: np.ndarray, truth: np.ndarray) -> float:
    return float(np.sqrt(np.mean(np.square(value - truth)) / np.mean(np.square(truth))))


def outward(positions: np.ndarray, faces: np.ndarray, normals: np.ndarray) -> np.ndarray:
    """Return the faces; those that disagree with the normals are reversed."""
    p = positions[faces]
    face_normals = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
    inward = np.einsum("ij,ij->i", face_normals, normals[faces].sum(axis=1)) < 0.0
    turned = faces.astype(np.int64)
    turned[inward] = turned[inward][:, ::-1]
    return turned


# -- the unit sphere, by three triangulations ------------------------------------------------------


@cache
def unit_icosphere(level: int) -> tuple[np.ndarray, np.ndarray]:
    ball = trimesh.creation.icosphere(subdivisions=level)
    return np.array(ball.vertices), np.array(ball.faces)


@cache
def unit_regular(around: int) -> tuple[np.ndarray, np.ndarray]:
    """Return a grid of longitude and latitude with poles."""
    phi = np.arange(around) * 2.0 * np.pi / around
    theta = (np.arange(around // 2) + 0.5) * np.pi / (around // 2)
    t, f = np.meshgrid(theta, phi, indexing="ij")
    grid = np.stack([np.sin(t) * np.cos(f), np.sin(t) * np.sin(f), np.cos(t)], axis=-1)
    u = np.concatenate([grid.reshape(-1, 3), [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]])
    return u, ConvexHull(u).simplices


@cache
def unit_random(count: int) -> tuple[np.ndarray, np.ndarray]:
    u = np.random.default_rng(7).normal(size=(count, 3))
    u /= np.linalg.norm(u, axis=1)[:, None]
    return u, ConvexHull(u).simplices


UNIT_SPHERES: dict[str, Callable[[int], tuple[np.ndarray, np.ndarray]]] = {
    "icosphere": unit_icosphere,
    "regular": unit_regular,
    "random": unit_random,
}


@cache
def ellipsoid(kind: str, size: int, axes: tuple[float, float, float]) -> Shape:
    """Return an ellipsoid from a unit sphere: key of `UNIT_SPHERES`, and its size."""
    u, faces = UNIT_SPHERES[kind](size)
    a, b, c = axes
    p = u * axes
    n = p / np.square(axes)
    s = np.einsum("ij,ij->i", n, n)
    n /= np.sqrt(s)[:, None]
    mean = (a * a + b * b + c * c - np.einsum("ij,ij->i", p, p)) / (2.0 * (a * b * c) ** 2 * s**1.5)
    gauss = 1.0 / ((a * b * c) ** 2 * s**2)
    half = np.sqrt(np.maximum(mean**2 - gauss, 0.0))
    return Shape(p, outward(p, faces, n), n, mean + half, mean - half)


def sphere(kind: str, size: int, radius: float = 1.0) -> Shape:
    return ellipsoid(kind, size, (radius, radius, radius))


# -- the torus -------------------------------------------------------------------------------------


def torus_points(angles: np.ndarray, R: float, r: float) -> tuple[np.ndarray, ...]:
    u, v = angles.T
    ring = R + r * np.cos(v)
    p = np.stack([ring * np.cos(u), ring * np.sin(u), r * np.sin(v)], axis=1)
    n = np.stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)], axis=1)
    return p, n, np.full(u.size, 1.0 / r), np.cos(v) / ring


@cache
def torus(kind: str, size: int, R: float = 3.0, r: float = 1.0) -> Shape:
    """Return a torus: ``regular`` with `size` vertices around, or `size` ``random`` vertices."""
    angles, faces = _torus_grid(size) if kind == "regular" else _torus_random(size, R / r)
    p, n, k_max, k_min = torus_points(angles, R, r)
    return Shape(p, outward(p, faces, n), n, k_max, k_min)


def _torus_grid(around: int) -> tuple[np.ndarray, np.ndarray]:
    across = around // 3
    i, j = (x.ravel() for x in np.meshgrid(np.arange(around), np.arange(across), indexing="ij"))
    a, b = i * across + j, (i + 1) % around * across + j
    c, d = (i + 1) % around * across + (j + 1) % across, i * across + (j + 1) % across
    faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return np.stack([i * 2.0 * np.pi / around, j * 2.0 * np.pi / across], axis=1), faces


def _torus_random(count: int, stretch: float) -> tuple[np.ndarray, np.ndarray]:
    """Return a Delaunay triangulation of the square of both angles, periodic by copied margins."""
    full = 2.0 * np.pi
    angles = np.random.default_rng(7).random((count, 2)) * full
    points, index = [angles], [np.arange(count)]
    margin = 8.0 * full / np.sqrt(count)
    for shift in np.array([(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1) if i or j]) * full:
        copy = angles + shift
        near = ((copy > -margin) & (copy < full + margin)).all(axis=1)
        points.append(copy[near])
        index.append(np.flatnonzero(near))
    plane, owner = np.concatenate(points), np.concatenate(index)
    triangles = Delaunay(plane * (stretch, 1.0)).simplices
    centre = plane[triangles].mean(axis=1)
    inside = ((centre >= 0.0) & (centre < full)).all(axis=1)
    return angles, owner[triangles[inside]]


# -- open patches ----------------------------------------------------------------------------------


@cache
def cylinder(radius: float, height: float, around: int, along: int) -> Shape:
    """Return a tube along z, open at both ends, with `along` rows of faces."""
    phi = np.arange(around) * 2.0 * np.pi / around
    z = np.linspace(0.0, height, along + 1)
    h, f = np.meshgrid(z, phi, indexing="ij")
    n = np.stack([np.cos(f), np.sin(f), np.zeros_like(f)], axis=-1).reshape(-1, 3)
    p = n * radius + np.stack([0.0 * h, 0.0 * h, h], axis=-1).reshape(-1, 3)
    i, j = (x.ravel() for x in np.meshgrid(np.arange(along), np.arange(around), indexing="ij"))
    a, b = i * around + j, i * around + (j + 1) % around
    faces = np.concatenate(
        [np.stack([a, b, b + around], axis=1), np.stack([a, b + around, a + around], axis=1)]
    )
    curved = np.full(len(p), 1.0 / radius)
    return Shape(p, outward(p, faces, n), n, curved, 0.0 * curved)


@cache
def square(side: float, cells: int) -> Shape:
    """Return a flat square in the plane z = 0 with normals along +z."""
    x = np.linspace(0.0, side, cells + 1)
    gx, gy = np.meshgrid(x, x, indexing="ij")
    p = np.stack([gx, gy, 0.0 * gx], axis=-1).reshape(-1, 3)
    i, j = (k.ravel() for k in np.meshgrid(np.arange(cells), np.arange(cells), indexing="ij"))
    a = i * (cells + 1) + j
    b, c, d = a + cells + 1, a + cells + 2, a + 1
    faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    n = np.tile([0.0, 0.0, 1.0], (len(p), 1))
    flat = np.zeros(len(p))
    return Shape(p, outward(p, faces, n), n, flat, flat)


def split_seam(shape: Shape) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Split the vertices at y = 0, as a UV seam does: faces at y < 0 get separate vertices.

    Returns
    -------
    positions, faces, normals, original
        `original` (V',) holds the indices of the vertices in the shape.
    """
    count = len(shape.positions)
    behind = shape.positions[shape.faces].mean(axis=1)[:, 1] < 0.0
    faces = shape.faces + np.where(behind, count, 0)[:, None]
    used, compact = np.unique(faces, return_inverse=True)
    original = used % count
    return shape.positions[original], compact.reshape(-1, 3), shape.normals[original], original
