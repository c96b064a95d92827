"""Meshing of a field: narrow-band marching cubes, adaptive remeshing, projection."""

from __future__ import annotations

from collections.abc import Callable

import gpytoolbox
import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import connected_components
from skimage.measure import marching_cubes

from .fields import Array, Field, bump, ramp

LOW_MM = np.array([-132.0, -224.0, -128.0])
HIGH_MM = np.array([132.0, 128.0, 132.0])
_CHUNK = 16384
Faces = NDArray[np.int64]


def evaluate(field: Field, points_mm: Array) -> Array:
    """Return a field at many points, evaluated in chunks that fit into the cache."""
    parts = [field(points_mm[i : i + _CHUNK]) for i in range(0, len(points_mm), _CHUNK)]
    return np.concatenate(parts)


def polygonise(field: Field, step_mm: float, *, block: int = 8) -> tuple[Array, Faces]:
    """Return vertices ``(V, 3)``, mm, and faces ``(F, 3)`` of the zero set by marching cubes.

    Faces are counter-clockwise seen from outside. Only blocks that the zero set can cross are evaluated.
    """
    coarse_mm = step_mm * block
    counts = np.ceil((HIGH_MM - LOW_MM) / coarse_mm).astype(int)
    centres = (
        np.stack(
            np.meshgrid(*[np.arange(n) + 0.5 for n in counts], indexing="ij"), axis=-1
        ).reshape(-1, 3)
        * coarse_mm
        + LOW_MM
    )
    far = evaluate(field, centres)
    keep = np.abs(far) < coarse_mm * 0.9 * 1.6 + 3.0
    volume = np.repeat(
        np.repeat(
            np.repeat(np.clip(far, -1e3, 1e3).reshape(counts).astype(np.float32), block, 0),
            block,
            1,
        ),
        block,
        2,
    )
    inner = np.stack(np.meshgrid(*[np.arange(block)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    corners = np.stack(np.unravel_index(np.flatnonzero(keep), counts), axis=1) * block
    for i in range(0, len(corners), 64):
        cells = (corners[i : i + 64, None, :] + inner[None]).reshape(-1, 3)
        volume[cells[:, 0], cells[:, 1], cells[:, 2]] = evaluate(field, cells * step_mm + LOW_MM)
    cubes: Callable[..., tuple[Array, Faces, Array, Array]] = marching_cubes
    vertices, faces, _, _ = cubes(volume, 0.0)
    return vertices.astype(np.float64) * step_mm + LOW_MM, faces.astype(np.int64)


def unit(v: Array) -> Array:
    """Return vectors ``(N, 3)`` divided by their lengths."""
    return np.asarray(v / np.maximum(np.linalg.norm(v, axis=1, keepdims=True), 1e-12))


def face_normals(vertices: Array, faces: Faces) -> Array:
    """Return normals ``(F, 3)`` whose lengths are twice the areas."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return np.asarray(np.cross(b - a, c - a))


def largest_component(vertices: Array, faces: Faces) -> tuple[Array, Faces]:
    """Return the connected component with the most vertices."""
    n = len(vertices)
    ones = np.ones(len(faces) * 2, dtype=np.int8)
    pairs = np.concatenate([faces[:, :2], faces[:, 1:]])
    graph = csr_matrix((ones, (pairs[:, 0], pairs[:, 1])), shape=(n, n))
    count, label = connected_components(graph)
    if count == 1:
        return vertices, faces
    main = int(np.argmax(np.bincount(label)))
    kept = label == main
    index = np.cumsum(kept) - 1
    return vertices[kept], index[faces[kept[faces[:, 0]]]]


def project(
    field: Field, gradient: Field, vertices: Array, *, steps: int = 4, reach_mm: float = 0.6
) -> Array:
    """Return vertices ``(V, 3)`` moved onto the zero set by damped Newton steps."""
    v = vertices.copy()
    for _ in range(steps):
        g = evaluate(gradient, v)
        value = evaluate(field, v)[:, None]
        move = value * g / np.maximum(np.sum(g * g, axis=1, keepdims=True), 0.25)
        length = np.linalg.norm(move, axis=1, keepdims=True)
        v -= move * np.minimum(1.0, reach_mm / np.maximum(length, 1e-12))
    return v


def edge_length_mm(p: Array) -> Array:
    """Return the target edge length: short on ears, nose, lips and lids, long on cranium and neck."""
    x, y, z = np.abs(p[:, 0]), p[:, 1], p[:, 2]
    face = np.exp(-0.5 * ((x / 48.0) ** 4 + ((y + 40.0) / 72.0) ** 4)) * ramp(z, 0.0, 55.0)
    size = 6.6 - 3.1 * face
    side = np.stack([x, y, z], axis=1)
    ears = bump(np.linalg.norm((side - [81, -8, -17]) / [17, 41, 28], axis=1), 0.66)
    nose = bump(np.linalg.norm((p - [0, -40, 102]) / [22, 14, 18], axis=1), 0.65)
    wing = bump(np.linalg.norm((p - [0, -15, 98]) / [18, 30, 20], axis=1), 0.6)
    lips = bump(np.linalg.norm((p - [0, -69.5, 92]) / [32, 13, 18], axis=1), 0.62)
    lids = bump(np.linalg.norm((side - [31, 0, 74]) / [20, 14, 16], axis=1), 0.65)
    for weight, fine in ((ears, 1.55), (nose, 1.35), (wing, 2.1), (lips, 1.45), (lids, 1.15)):
        size = size + (fine - size) * np.minimum(1.0, 1.6 * weight) * (size > fine)
    return np.asarray(size)


def remesh(
    vertices: Array, faces: Faces, field: Field, gradient: Field, scale: float
) -> tuple[Array, Faces]:
    """Return isotropic triangles of the target sizes times ``scale``, with vertices on the zero set.

    There is one pass for each size; it freezes the vertices whose target edge length is shorter.
    """
    v, f = vertices, faces.astype(np.int32)
    for length in (1.15, 1.35, 1.7, 2.15, 2.75, 3.5, 4.4, 5.4, 6.6):
        coarse = edge_length_mm(v) >= length * 0.96
        frozen = np.flatnonzero(~coarse).astype(np.int32)
        v, f = gpytoolbox.remesh_botsch(v, f, 3, length * scale, True, frozen)
        v = project(field, gradient, np.asarray(v), steps=1)
    triangles = np.asarray(f, dtype=np.int64)
    v = project(field, gradient, relax(v, triangles, field, gradient), steps=5)
    return largest_component(v, triangles)


def relax(v: Array, f: Faces, field: Field, gradient: Field, rounds: int = 3) -> Array:
    """Return vertices moved along the surface towards the mean of their neighbours."""
    n = len(v)
    i = np.concatenate([f[:, 0], f[:, 1], f[:, 2]])
    j = np.concatenate([f[:, 1], f[:, 2], f[:, 0]])
    ring = csr_matrix((np.ones(len(i)), (i, j)), shape=(n, n))
    degree = np.asarray(ring.sum(axis=1))
    for _ in range(rounds):
        normal = unit(evaluate(gradient, v))
        pull = np.asarray(ring @ v) / degree - v
        pull -= np.sum(pull * normal, axis=1, keepdims=True) * normal
        v = project(field, gradient, v + 0.4 * pull, steps=1, reach_mm=0.3)
    return v
