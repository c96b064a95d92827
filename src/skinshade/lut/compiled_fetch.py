"""Compiled fetches from tables: the twin of ``Lut._bilinear``."""

from __future__ import annotations

import numpy as np

from .._core import native
from .._core.arrays import FloatArray, ImageArray

__all__ = ["fetch_table", "serves"]


def serves() -> bool:
    """Return whether the compiled functions are in use."""
    return native.available()


def fetch_table(table: ImageArray, u: FloatArray, v: FloatArray) -> FloatArray:
    """Return bilinear values (..., 3) of a table (H, W, 3) at u (..., 1) or (..., 3) and v (..., 1).

    Every channel of the result is contiguous.
    """
    shape = np.broadcast_shapes(u.shape[:-1], v.shape[:-1])
    values = np.empty((3, *shape))
    columns = _by_column(u, shape)
    rows = _by_column(v, shape)
    height, width, _ = table.shape
    native.run(
        "fetch_table",
        native.blocks(rows.size),
        np.ascontiguousarray(table),
        height,
        width,
        columns,
        u.shape[-1],
        rows,
        rows.size,
        values,
    )
    return np.moveaxis(values, 0, -1)


def _by_column(coordinates: FloatArray, shape: tuple[int, ...]) -> FloatArray:
    """Return coordinates (..., k) as a contiguous array (k, *shape)."""
    columns = np.moveaxis(coordinates, -1, 0)
    return np.ascontiguousarray(np.broadcast_to(columns, (len(columns), *shape)), dtype=np.float64)
