"""Profiles from measured or simulated data: the flux that leaves within annuli around a point of entry."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import FloatArray, as_floats
from .._core.errors import ArgumentError

if TYPE_CHECKING:
    from scipy.interpolate import CubicSpline

__all__ = ["TabulatedKernel"]

NEGLIGIBLE = 1e-5
"""Accuracy of the table: smaller oscillations of T are ignored."""
LOG_STEP = 0.02
"""Greatest distance of the table's nodes in log k."""
PHASE_STEP = 0.25
"""Greatest distance of nodes in k·b for radii b that oscillate: the spline is exact within 3e-6."""
MOST_NODES = 1 << 15
SUMMED_AT_ONCE = 1 << 22
"""Bessel functions in memory at once."""


@dataclass(frozen=True)
class TabulatedKernel:
    """Piecewise constant kernel over annuli.

    Attributes
    ----------
    edges_mm
        (bins + 1,) increasing radii that bound the annuli, ≥ 0, mm.
    flux
        (3, bins) shares of the light that leave within the annuli; every channel sums to 1.
    table
        Transfer function of the annuli, in units of the greatest radius.
    """

    edges_mm: FloatArray
    flux: FloatArray
    table: AnnuliTransfer = field(repr=False, compare=False)

    @classmethod
    def checked(cls, edges_mm: ArrayLike, flux: ArrayLike) -> TabulatedKernel:
        """Return a kernel after checks; every channel of `flux` is scaled to sum to 1.

        Raises
        ------
        ArgumentError
            If the edges do not increase, a flux is negative, or a channel has no flux.
        """
        edges = as_floats("edges_mm", edges_mm, (None,), low=0.0)
        if edges.size < 2 or (np.diff(edges) <= 0.0).any():
            raise ArgumentError("edges_mm: there must be two or more radii, and they must increase")
        values = as_floats("flux", flux, (3, edges.size - 1), low=0.0)
        totals = values.sum(axis=1, keepdims=True)
        if (totals <= 0.0).any():
            raise ArgumentError(
                f"flux sums to {totals[:, 0]} over the channels; each sum must be positive"
            )
        shares = values / totals
        return cls(edges, shares, AnnuliTransfer.of(edges / edges[-1], shares))

    @property
    def mean_square_radius_mm2(self) -> FloatArray:
        """(3,) second moment of R over the plane: Σ flux (a² + b²)/2, mm²."""
        return _mean_square_radius(self.edges_mm, self.flux)

    def transfer(self, k_per_mm: FloatArray) -> FloatArray:
        """Return T(k) (..., 3) at spatial frequencies in rad/mm, within 1e-5 of the sum over annuli."""
        return self.table(np.asarray(k_per_mm, dtype=np.float64) * self.edges_mm[-1])

    def radial(self, r_mm: FloatArray) -> FloatArray:
        """Return R(r) (..., 3) per mm², constant within an annulus, 0 outside."""
        density = self.flux / (np.pi * np.diff(np.square(self.edges_mm)))
        padded = np.concatenate([np.zeros((3, 1)), density, np.zeros((3, 1))], axis=1)
        result: FloatArray = padded.T[np.searchsorted(self.edges_mm, r_mm, side="right")]
        return result

    def scaled(self, factor: float) -> TabulatedKernel:
        """Return the kernel with every length multiplied by `factor`."""
        return TabulatedKernel(self.edges_mm * factor, self.flux, self.table)


@dataclass(frozen=True)
class AnnuliTransfer:
    """Transfer function of annuli with the greatest radius 1: a spline, and the sum where it ends.

    Attributes
    ----------
    edges, flux
        Radii (bins + 1,) and shares (3, bins).
    over_log_k
        Spline of T (3,) over log k.
    last_k
        Frequency above which T is negligible.
    """

    edges: FloatArray
    flux: FloatArray
    over_log_k: CubicSpline
    last_k: float

    @classmethod
    def of(cls, edges: FloatArray, flux: FloatArray) -> AnnuliTransfer:
        """Return the transfer function of annuli."""
        from scipy.interpolate import CubicSpline  # costs .4 s, and most profiles have no table

        ends = _oscillation_ends(edges, flux)
        k = _nodes(edges, ends)
        spline = CubicSpline(np.log(k), _transfer_sum(edges, flux, k))
        return cls(edges, flux, spline, float(ends.max()))

    def __call__(self, k: FloatArray) -> FloatArray:
        """Return T(k) (..., 3) at frequencies (...)."""
        first, end = np.exp(self.over_log_k.x[[0, -1]])
        result: FloatArray = self.over_log_k(np.log(np.clip(k, first, end)))
        low, beyond = k < first, k > end
        second_moment = _mean_square_radius(self.edges, self.flux)
        result[low] = 1.0 - 0.25 * np.square(k[low])[:, None] * second_moment
        result[beyond] = 0.0
        beyond &= k < self.last_k
        if beyond.any():
            result[beyond] = _transfer_sum(self.edges, self.flux, k[beyond])
        return result


def _oscillation_ends(edges: FloatArray, flux: FloatArray) -> FloatArray:
    """Return the frequencies (bins + 1,) above which an edge and all wider ones add nothing to T.

    T is a sum over the edges b of (jump of the density)·2b J₁(kb)/k, and |J₁(x)| ≤ √(2/πx).
    """
    density = flux / np.diff(np.square(edges))
    jumps = np.abs(np.diff(density, axis=1, prepend=0.0, append=0.0)).max(axis=0)
    envelope = jumps * np.sqrt(8.0 * edges / np.pi)
    from_outside: FloatArray = np.cumsum(envelope[::-1])[::-1]
    ends: FloatArray = (from_outside / NEGLIGIBLE) ** (2.0 / 3.0)
    return ends


def _nodes(edges: FloatArray, ends: FloatArray) -> FloatArray:
    """Return frequencies (n,) that resolve T: equidistant in log k, or in k where an edge oscillates."""
    parts, start, count = [], 1e-4, 0
    for radius, end in zip(edges[::-1], ends[::-1], strict=True):
        if end <= start or radius <= 0.0:
            continue
        turn = min(PHASE_STEP / (LOG_STEP * radius), end)
        if start < turn:
            steps = int(np.log(turn / start) / LOG_STEP) + 1
            parts.append(np.geomspace(start, turn, steps, endpoint=False))
            start = turn
        if start < end:
            steps = int((end - start) * radius / PHASE_STEP) + 1
            steps = min(steps, MOST_NODES - min(count, MOST_NODES - 2))
            parts.append(start + PHASE_STEP / radius * np.arange(steps))
            start = end
        count = sum(map(len, parts))
        if count >= MOST_NODES:
            break
    nodes = np.concatenate(parts)
    return np.append(nodes, max(start, nodes[-1] * 1.001)) if count < MOST_NODES else nodes


def _mean_square_radius(edges: FloatArray, flux: FloatArray) -> FloatArray:
    squares = np.square(edges)
    result: FloatArray = flux @ (0.5 * (squares[:-1] + squares[1:]))
    return result


def _transfer_sum(edges: FloatArray, flux: FloatArray, k: FloatArray) -> FloatArray:
    """Return the Hankel transform (n, 3) of annuli at frequencies (n,) > 0."""
    from scipy.special import j1

    step = max(SUMMED_AT_ONCE // edges.size, 1)
    parts = []
    for start in range(0, k.size, step):
        part = k[start : start + step, None]
        disks = 2.0 * np.diff(edges * j1(part * edges), axis=1)
        parts.append(disks / (part * np.diff(np.square(edges))) @ flux.T)
    return np.concatenate(parts)
