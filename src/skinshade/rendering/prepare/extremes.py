"""Least and greatest values within a square window around every texel."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from ..._core.arrays import FloatArray

__all__ = ["extreme_within"]

LINES = 64
"""Rows or columns that are worked on at once: their arrays fit in the cache of a core."""


def extreme_within(values: FloatArray, reach: int, extreme: np.ufunc) -> FloatArray:
    """Return the extreme of an image (H, W) within a square of 2·reach + 1 texels around every texel.

    Windows end at the edge of the image. SciPy has such filters; its import takes .4 s.

    Parameters
    ----------
    values
        (H, W) image.
    reach
        Texels to each side of the centre, ≥ 0.
    extreme
        ``np.minimum`` or ``np.maximum``.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.rendering.prepare.extremes import extreme_within
    >>> extreme_within(np.array([[3.0, 1.0, 2.0, 5.0]]), 1, np.maximum)
    array([[3., 3., 5., 5.]])
    """
    along_rows = np.empty_like(values)
    result = np.empty_like(values)

    def work_on_rows(first: int) -> None:
        rows = slice(first, first + LINES)
        along_rows[rows] = _within_columns(values[rows].T, reach, extreme).T

    def work_on_columns(first: int) -> None:
        columns = slice(first, first + LINES)
        result[:, columns] = _within_columns(along_rows[:, columns], reach, extreme)

    height, width = values.shape
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        list(pool.map(work_on_rows, range(0, height, LINES)))
        list(pool.map(work_on_columns, range(0, width, LINES)))
    return result


def _within_columns(values: FloatArray, reach: int, extreme: np.ufunc) -> FloatArray:
    """Return the extremes over 2·reach + 1 rows around every row.

    The windows double in size until two of them cover the one that is wanted.
    """
    count, wanted = len(values), 2 * reach + 1
    # Texels of the edge are within the window already where it reaches beyond the edge.
    windows = np.pad(values, ((reach, reach), (0, 0)), mode="edge")
    size = 1
    while 2 * size <= wanted:
        windows = extreme(windows[:-size], windows[size:])
        size *= 2
    result: FloatArray = extreme(windows[:count], windows[wanted - size :][:count])
    return result
