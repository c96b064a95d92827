"""Symmetric tensors at vertices, in tangent frames and in world axes."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray
from .normals import tangent_frame

__all__ = ["SYMMETRIC", "SYMMETRIC_ROWS", "apply_symmetric", "tensor_to_world"]

SYMMETRIC = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))
"""Rows and columns of the six numbers of a symmetric 3×3 tensor."""
SYMMETRIC_ROWS = ((0, 1, 2), (1, 3, 4), (2, 4, 5))
"""Indices of the entries of a symmetric matrix in xx xy xz yy yz zz."""


def tensor_to_world(tensor: FloatArray, normals: FloatArray) -> FloatArray:
    """Return tensors as xx, xy, xz, yy, yz, zz (..., 6) from tensors (..., 3) at unit normals (..., 3)."""
    u, v = tangent_frame(normals)
    k_uu, k_uv, k_vv = tensor[..., 0], tensor[..., 1], tensor[..., 2]
    su = k_uu[..., None] * u + k_uv[..., None] * v
    sv = k_uv[..., None] * u + k_vv[..., None] * v
    return np.stack(
        [su[..., i] * u[..., j] + sv[..., i] * v[..., j] for i, j in SYMMETRIC], axis=-1
    )


def apply_symmetric(world: FloatArray, vectors: FloatArray) -> FloatArray:
    """Return the products (..., 3) of tensors (..., 6) and vectors (..., 3)."""
    x, y, z = vectors[..., 0], vectors[..., 1], vectors[..., 2]
    return np.stack(
        [world[..., a] * x + world[..., b] * y + world[..., c] * z for a, b, c in SYMMETRIC_ROWS],
        axis=-1,
    )
