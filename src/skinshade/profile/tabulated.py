"""Profiles from data: the exitant flux of each annulus around a point of entry, measured or simulated."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike
from scipy.interpolate import CubicSpline
from scipy.special import j1

from .._core.arrays import FloatArray, as_floats
from .._core.errors import ArgumentError

__all__ = ["TabulatedKernel"]

TABLE_SIZE = 4096
"""Frequencies at which T is summed once; a cubic spline between them errs by 1e-5."""


@dataclass(frozen=True)
class TabulatedKernel:
    """Uniform flux within each annulus.

    Attributes
    ----------
    edges_mm
        (bins + 1,) radii that bound the annuli, rising from ≥ 0, mm.
    flux
        (3, bins) share of the light that leaves within each annulus; each channel sums to 1.
    """

    edges_mm: FloatArray
    flux: FloatArray

    @classmethod
    def checked(cls, edges_mm: ArrayLike, flux: ArrayLike) -> TabulatedKernel:
        """Build one from untrusted numbers; flux is scaled to sum to 1 in each channel.

        Raises
        ------
        ArgumentError
            If the edges do not rise, a flux is negative, or a channel has none.
        """
        edges = as_floats("edges_mm", edges_mm, (None,), low=0.0)
        if edges.size < 2 or (np.diff(edges) <= 0.0).any():
            raise ArgumentError(
                "edges_mm: the radii of the annuli must rise strictly, two at least"
            )
        values = as_floats("flux", flux, (3, edges.size - 1), low=0.0)
        totals = values.sum(axis=1, keepdims=True)
        if (totals <= 0.0).any():
            raise ArgumentError(
                f"flux sums to {totals[:, 0]} over the channels; each must be positive"
            )
        return cls(edges, values / totals)

    @property
    def mean_square_radius_mm2(self) -> FloatArray:
        """(3,) Σ flux (a² + b²)/2, mm²."""
        a2, b2 = np.square(self.edges_mm[:-1]), np.square(self.edges_mm[1:])
        result: FloatArray = self.flux @ (0.5 * (a2 + b2))
        return result

    def transfer(self, k_per_mm: FloatArray) -> FloatArray:
        """Return T(k) (..., 3) at spatial frequencies in rad/mm, within 1e-5 of the sum."""
        low, high = self._table.x[0], self._table.x[-1]
        k = np.asarray(k_per_mm, dtype=np.float64)
        inside = self._table(np.clip(np.log(np.maximum(k, 1e-300)), low, high))
        below = 1.0 - 0.25 * np.square(k)[..., None] * self.mean_square_radius_mm2
        result: FloatArray = np.where(k[..., None] < np.exp(low), below, inside)
        return np.where(k[..., None] > np.exp(high), 0.0, result)

    def radial(self, r_mm: FloatArray) -> FloatArray:
        """Return R(r) (..., 3) per mm², constant within an annulus, 0 beyond the last."""
        density = self.flux / (np.pi * np.diff(np.square(self.edges_mm)))
        padded = np.concatenate([np.zeros((3, 1)), density, np.zeros((3, 1))], axis=1)
        result: FloatArray = padded.T[np.searchsorted(self.edges_mm, r_mm, side="right")]
        return result

    def scaled(self, factor: float) -> TabulatedKernel:
        """Return the kernel with every length multiplied by `factor`."""
        return TabulatedKernel(self.edges_mm * factor, self.flux)

    def transfer_sum(self, k_per_mm: FloatArray) -> FloatArray:
        """Return the Hankel transform of the annuli (n, 3), summed without a table."""
        a, b = self.edges_mm[:-1], self.edges_mm[1:]
        bessel = self.edges_mm * j1(k_per_mm[:, None] * self.edges_mm)
        disks = 2.0 * np.diff(bessel, axis=1) / (k_per_mm[:, None] * (b**2 - a**2))
        result: FloatArray = disks @ self.flux.T
        return result

    @cached_property
    def _table(self) -> CubicSpline:
        # T oscillates with the period of the widest annulus that holds light; past 2000/rms what is
        # left of it is below the noise of any measurement.
        rms = np.sqrt(self.mean_square_radius_mm2)
        log_k = np.linspace(np.log(1e-4 / rms.max()), np.log(2000.0 / rms.min()), TABLE_SIZE)
        return CubicSpline(log_k, self.transfer_sum(np.exp(log_k)))
