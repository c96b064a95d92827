"""Vertex normals, and tangents with handedness."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, FloatRows, IntArray, dot, unit_vectors
from . import compiled
from .topology import half_edges, weld

__all__ = ["tangent_frame", "vertex_normals", "vertex_tangents"]

FIT_RIDGE = 1e-3
"""Ridge of the quadric's fit, for vertices with fewer neighbours than the quadric has coefficients."""


def vertex_normals(positions: FloatArray, faces: IntArray) -> FloatRows:
    """Return unit normals (V, 3); vertices at one position have equal normals.

    The first estimate is a weighted mean of face normals [Max1999]. The osculating quadric through the
    neighbours corrects it [Cazals2005], which halves the error on random triangulations.
    """
    if compiled.serves(positions, faces):
        return compiled.vertex_normals(positions, faces)
    group, first = weld(positions)
    p, f = positions[first], group[faces]
    normals = _quadric_normals(p, f, unit_vectors(_mean_normals(p, f)))
    return normals[group]


def tangent_frame(normals: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return two unit vectors (..., 3) that form a frame with unit normals (..., 3) [Duff2017]."""
    x, y, z = normals[..., 0], normals[..., 1], normals[..., 2]
    sign = np.copysign(1.0, z)
    a = -1.0 / (sign + z)
    b = x * y * a
    u = np.stack([1.0 + sign * x * x * a, sign * b, -sign * x], axis=-1)
    v = np.stack([b, sign + y * y * a, -y], axis=-1)
    return u, v


def vertex_tangents(
    positions: FloatArray, normals: FloatArray, uvs: FloatArray, faces: IntArray
) -> FloatRows:
    """Return tangents (V, 4): the unit tangent along +u, and the sign of the bitangent.

    The bitangent sign·(N × T) points up in the picture, towards decreasing v, as in glTF. Degenerate UVs
    give an arbitrary tangent.
    """
    p, t = positions[faces], uvs[faces]
    e1, e2 = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
    d1, d2 = t[:, 1] - t[:, 0], t[:, 2] - t[:, 0]
    area = d1[:, 0] * d2[:, 1] - d1[:, 1] * d2[:, 0]
    along_u = (e1 * d2[:, 1:] - e2 * d1[:, 1:]) * np.sign(area)[:, None]
    along_v = (e2 * d1[:, :1] - e1 * d2[:, :1]) * np.sign(area)[:, None]
    count = positions.shape[0]
    tangent, downward = (
        _sum_at_corners(along_u, faces, count),
        _sum_at_corners(along_v, faces, count),
    )
    tangent -= normals * dot(tangent, normals)[:, None]
    lost = dot(tangent, tangent) <= 0.0
    tangent[lost] = tangent_frame(normals[lost])[0]
    tangent = unit_vectors(tangent)
    sign = np.where(dot(np.cross(normals, tangent), downward) > 0.0, -1.0, 1.0)
    return np.concatenate([tangent, sign[:, None]], axis=1)


def _sum_at_corners(per_face: FloatArray, faces: IntArray, count: int) -> FloatArray:
    columns = [
        np.bincount(faces.ravel(), np.repeat(per_face[:, axis], 3), count) for axis in range(3)
    ]
    return np.stack(columns, axis=1)


def _mean_normals(p: FloatArray, f: IntArray) -> FloatArray:
    total = np.zeros_like(p)
    for corner in range(3):
        here = p[f[:, corner]]
        a, b = p[f[:, (corner + 1) % 3]] - here, p[f[:, (corner + 2) % 3]] - here
        scale = dot(a, a) * dot(b, b)
        share = np.cross(a, b) / np.where(scale > 0.0, scale, 1.0)[:, None]
        for axis in range(3):
            total[:, axis] += np.bincount(f[:, corner], share[:, axis], p.shape[0])
    return total


def _quadric_normals(p: FloatArray, f: IntArray, normals: FloatArray) -> FloatArray:
    count = p.shape[0]
    one, other = half_edges(f)
    i, j = np.concatenate([one, other]), np.concatenate([other, one])
    d = p[j] - p[i]
    spread = np.bincount(i, dot(d, d), count) / np.maximum(np.bincount(i, minlength=count), 1)
    d /= np.sqrt(np.where(spread > 0.0, spread, 1.0))[i, None]
    u, v = tangent_frame(normals)
    x, y, z = dot(d, u[i]), dot(d, v[i]), dot(d, normals[i])
    terms = (x, y, x * x, x * y, y * y)
    weight = 1.0 / np.maximum(dot(d, d), 1e-30)
    matrix = np.zeros((count, 5, 5))
    right = np.zeros((count, 5, 1))
    for row, term in enumerate(terms):
        weighted = weight * term
        right[:, row, 0] = np.bincount(i, weighted * z, count)
        for column in range(row, 5):
            entry = np.bincount(i, weighted * terms[column], count)
            matrix[:, row, column] = matrix[:, column, row] = entry
        matrix[:, row, row] += FIT_RIDGE * (
            0.5 if row == 3 else 1.0
        )  # a²+b²/2+c² is invariant to rotation
    slope = np.linalg.solve(matrix, right)[:, :2, 0]
    return unit_vectors(normals - slope[:, :1] * u - slope[:, 1:] * v)
