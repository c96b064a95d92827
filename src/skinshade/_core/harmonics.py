"""Real spherical harmonics of orders 0 to 4."""

from __future__ import annotations

import numpy as np

from .arrays import FloatArray, FloatVector

__all__ = ["MOST_ORDER", "cosine_factors", "harmonics"]

MOST_ORDER = 4
"""Greatest order: 25 harmonics."""


def harmonics(directions: FloatArray, order: int = 2) -> FloatArray:
    """Return the real orthonormal harmonics (..., (order + 1)²) at unit directions (..., 3).

    Parameters
    ----------
    directions
        (..., 3) unit vectors.
    order
        Greatest band, 0..4. Within a band l, the harmonics are ordered by m = −l..l, as y z x in band 1.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade._core.harmonics import harmonics
    >>> harmonics(np.array([0.0, 0.0, 1.0]), 1).round(3)
    array([0.282, 0.   , 0.489, 0.   ])
    """
    x, y, z = directions[..., 0], directions[..., 1], directions[..., 2]
    x2, y2, z2 = x * x, y * y, z * z
    values: list[FloatArray] = [np.full_like(x, _root(1 / 4))]
    if order >= 1:
        values += [_root(3 / 4) * axis for axis in (y, z, x)]
    if order >= 2:
        values += [
            _root(15 / 4) * x * y,
            _root(15 / 4) * y * z,
            _root(5 / 16) * (3 * z2 - 1),
            _root(15 / 4) * x * z,
            _root(15 / 16) * (x2 - y2),
        ]
    if order >= 3:
        values += [
            _root(35 / 32) * y * (3 * x2 - y2),
            _root(105 / 4) * x * y * z,
            _root(21 / 32) * y * (5 * z2 - 1),
            _root(7 / 16) * z * (5 * z2 - 3),
            _root(21 / 32) * x * (5 * z2 - 1),
            _root(105 / 16) * z * (x2 - y2),
            _root(35 / 32) * x * (x2 - 3 * y2),
        ]
    if order >= 4:
        values += [
            _root(315 / 16) * x * y * (x2 - y2),
            _root(315 / 32) * y * z * (3 * x2 - y2),
            _root(45 / 16) * x * y * (7 * z2 - 1),
            _root(45 / 32) * y * z * (7 * z2 - 3),
            _root(9 / 256) * (35 * z2 * z2 - 30 * z2 + 3),
            _root(45 / 32) * x * z * (7 * z2 - 3),
            _root(45 / 64) * (x2 - y2) * (7 * z2 - 1),
            _root(315 / 32) * x * z * (x2 - 3 * y2),
            _root(315 / 256) * (x2 * x2 - 6 * x2 * y2 + y2 * y2),
        ]
    return np.stack(values, axis=-1)


def cosine_factors(order: int) -> FloatVector:
    """Return the factor ((order + 1)²,) of each harmonic for the clamped cosine over π [Ramamoorthi2001]."""
    return np.repeat([1.0, 2 / 3, 1 / 4, 0.0, -1 / 24][: order + 1], 2 * np.arange(order + 1) + 1)


def _root(share: float) -> float:
    """Return √(share/π), the norm of a harmonic."""
    return float(np.sqrt(share / np.pi))
