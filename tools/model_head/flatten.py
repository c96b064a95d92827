"""Flattening of one chart without flipped triangles, by the symmetric Dirichlet energy."""

from __future__ import annotations

import numpy as np
from scipy.sparse import bmat, csr_matrix, identity
from scipy.sparse.linalg import splu

from .fields import Array
from .mesh import Faces


def _operators(p: Array, faces: Faces, scale: Array) -> tuple[csr_matrix, csr_matrix, Array]:
    """Return the gradient operators ``(F, V)`` in the triangles' planes, and the rest areas ``(F,)``."""
    a, b, c = (p[faces[:, k]] for k in range(3))
    e1, e2 = (b - a) * scale[:, None], (c - a) * scale[:, None]
    length = np.linalg.norm(e1, axis=1)
    along = np.sum(e1 * e2, axis=1) / length
    across = np.linalg.norm(np.cross(e1, e2), axis=1) / length
    area = 0.5 * length * across
    rows = np.repeat(np.arange(len(faces)), 3)
    gx = np.stack([-1.0 / length, 1.0 / length, np.zeros_like(length)], axis=1)
    gy = np.stack(
        [(along / length - 1.0) / across, -along / (length * across), 1.0 / across], axis=1
    )
    shape = (len(faces), len(p))
    dx = csr_matrix((gx.ravel(), (rows, faces.ravel())), shape=shape)
    dy = csr_matrix((gy.ravel(), (rows, faces.ravel())), shape=shape)
    return dx, dy, area


def _jacobian(dx: csr_matrix, dy: csr_matrix, uv: Array) -> Array:
    """Return Jacobians ``(F, 2, 2)``; their columns are the images of the axes of the rest triangles."""
    return np.stack([dx @ uv, dy @ uv], axis=2)


def _energy(jac: Array, weight: Array) -> float:
    det = np.linalg.det(jac)
    if det.min() <= 0.0:
        return np.inf
    norm2 = np.sum(jac * jac, axis=(1, 2))
    return float(weight @ (norm2 * (1.0 + 1.0 / (det * det))))


def _first_flip(uv: Array, move: Array, faces: Faces) -> float:
    """Return the length of the step at which the first triangle collapses."""
    e1, e2 = (uv[faces[:, k]] - uv[faces[:, 0]] for k in (1, 2))
    d1, d2 = (move[faces[:, k]] - move[faces[:, 0]] for k in (1, 2))
    a = d1[:, 0] * d2[:, 1] - d1[:, 1] * d2[:, 0]
    b = e1[:, 0] * d2[:, 1] - e1[:, 1] * d2[:, 0] + d1[:, 0] * e2[:, 1] - d1[:, 1] * e2[:, 0]
    c = e1[:, 0] * e2[:, 1] - e1[:, 1] * e2[:, 0]
    root = np.sqrt(np.maximum(b * b - 4.0 * a * c, 0.0))
    real = b * b - 4.0 * a * c >= 0.0
    with np.errstate(divide="ignore", invalid="ignore"):
        # both roots, by the numerically stable formula
        q = -0.5 * (b + np.where(b >= 0.0, root, -root))
        t = np.stack([q / a, c / q])
    t = np.where(real & np.isfinite(t) & (t > 0.0), t, np.inf)
    return float(t.min())


def flatten(p: Array, faces: Faces, scale: Array, start: Array, rounds: int) -> Array:
    """Return flat coordinates ``(V, 2)`` in scaled mm, from a ``start`` ``(V, 2)`` without flips.

    ``scale`` ``(F,)`` enlarges the rest triangles. Each round minimizes the quadratic proxy of scalable
    locally injective mappings (Rabinovich et al. 2017), followed by a line search that ends before the
    first flip.
    """
    dx, dy, area = _operators(p, faces, scale)
    weight = area / area.sum()
    uv = start.copy()
    uv /= np.sqrt(np.sum(np.linalg.det(_jacobian(dx, dy, uv)) * weight))
    jac = _jacobian(dx, dy, uv)
    value = _energy(jac, weight)
    if not np.isfinite(value):
        raise RuntimeError("the starting embedding has flipped triangles")
    count = len(p)
    for _ in range(rounds):
        left, sigma, right = np.linalg.svd(jac)
        nearest_rotation = left @ right
        s3 = np.maximum(sigma, 1e-6)
        gap = np.where(np.abs(s3 - 1.0) < 1e-6, 1.0, s3 - 1.0)
        pull = np.where(np.abs(s3 - 1.0) < 1e-6, 4.0, (s3 - s3**-3.0) / gap)
        metric = left @ (np.minimum(pull, 1e9)[:, :, None] * np.swapaxes(left, 1, 2))
        metric *= weight[:, None, None]
        target = metric @ nearest_rotation
        blocks = [[csr_matrix((count, count)) for _ in range(2)] for _ in range(2)]
        right_side = np.zeros((2, count))
        for d, column in ((dx, 0), (dy, 1)):
            for i in range(2):
                right_side[i] += d.T @ target[:, i, column]
                for j in range(2):
                    blocks[i][j] = blocks[i][j] + d.T @ d.multiply(metric[:, i, j][:, None])
        system = bmat(blocks).tocsc()
        system = system + 1e-9 * system.diagonal().mean() * identity(2 * count, format="csc")
        minimum = splu(system).solve(right_side.ravel()).reshape(2, count).T
        move = minimum - uv
        move -= move.mean(axis=0)
        step = min(1.0, 0.8 * _first_flip(uv, move, faces))
        while True:
            trial = _jacobian(dx, dy, uv + step * move)
            new_value = _energy(trial, weight)
            if new_value < value or step < 1e-9:
                break
            step *= 0.5
        if step < 1e-9:
            break
        converged = value - new_value < 1e-4 * value
        uv, jac, value = uv + step * move, trial, new_value
        if converged:
            break
    return uv
