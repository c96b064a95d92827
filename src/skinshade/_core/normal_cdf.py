"""Distribution function of the normal distribution, without SciPy, whose import takes .3 s."""

from __future__ import annotations

from functools import cache
from math import erfc, sqrt

import numpy as np

from .arrays import FloatArray

__all__ = ["normal_cdf"]

REACH = 37
"""Distance from 0 beyond which the function is 0 or 1 within 1e-299."""
NODES_PER_UNIT = 256
"""Nodes of the table: a Taylor polynomial of degree 4 errs by 3e-16 halfway between them."""


def normal_cdf(x: FloatArray) -> FloatArray:
    """Return Φ(x) (...), the integral of the normal density up to finite x (...), within 4e-16.

    For x of -37 or more the error is also less than 1e-7 of the value.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade._core.normal_cdf import normal_cdf
    >>> normal_cdf(np.array([-1.0, 0.0, 2.0])).round(4)
    array([0.1587, 0.5   , 0.9772])
    """
    values, densities = _table()
    bounded = np.clip(x, -REACH, REACH)
    index = np.rint(bounded * NODES_PER_UNIT)
    node = index * (1.0 / NODES_PER_UNIT)
    step = bounded - node
    row = index.astype(np.int64) + REACH * NODES_PER_UNIT
    # The derivatives of the density are its products with Hermite polynomials.
    square = node * node
    series = step * (1.0 / 24.0) * node * (3.0 - square)
    series += (square - 1.0) * (1.0 / 6.0)
    series *= step
    series -= 0.5 * node
    series *= step
    series += 1.0
    series *= step
    series *= densities.take(row)
    series += values.take(row)
    result: FloatArray = series
    return result


@cache
def _table() -> tuple[FloatArray, FloatArray]:
    """Return Φ and the density at the nodes."""
    nodes = np.arange(-REACH * NODES_PER_UNIT, REACH * NODES_PER_UNIT + 1) / NODES_PER_UNIT
    values = np.array([0.5 * erfc(-node / sqrt(2.0)) for node in nodes.tolist()])
    return values, np.exp(-0.5 * nodes * nodes) / np.sqrt(2.0 * np.pi)
