"""Mixtures of Gaussians [dEon2007], and their fit to a transfer function (MODEL §1)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import FloatArray, as_floats
from .._core.cache import content_hash, load_cached, store_cached
from .._core.errors import ArgumentError

__all__ = ["GaussianMixture", "fit_gaussians"]

FIT_LOBES = 40
"""Candidate widths of a fit; more widths do not lower the residual of Burley's profile."""
FIT_SUM_WEIGHT = 30.0
"""Weight of the equation Σw = 1: the sum is 1 within 1e-5 before the final normalisation."""
FIT_RIDGE = 1e-5
"""Ridge of the fit: neighbouring widths are nearly collinear in k, and their weights would be noise."""


FIT_NAME = "gaussian-fit-1"
"""Name of the fit in the user's cache; another algorithm needs another name."""


@dataclass(frozen=True)
class GaussianMixture:
    """Mixture Σ w_i exp(−r²/2v_i)/(2πv_i); the channels share the variances v_i.

    Attributes
    ----------
    variances_mm2
        (n,) variances of the lobes along one axis, mm².
    weights
        (n, 3) weights of the lobes in the channels; every column sums to 1.
    """

    variances_mm2: FloatArray
    weights: FloatArray

    @classmethod
    def checked(cls, variances_mm2: ArrayLike, weights: ArrayLike) -> GaussianMixture:
        """Return a mixture after checks; columns of `weights` are scaled to sum to 1.

        Raises
        ------
        ArgumentError
            If a variance is not positive, a weight negative, or a channel has no weight.
        """
        variances = as_floats("variances_mm2", variances_mm2, (None,))
        if variances.size == 0 or variances.min() <= 0.0:
            raise ArgumentError(f"variances_mm2 is {variances}; every variance must be positive")
        lobes = as_floats("weights", weights, (variances.size, 3), low=0.0)
        totals = lobes.sum(axis=0)
        if (totals <= 0.0).any():
            raise ArgumentError(
                f"weights sum to {totals} over the channels; each sum must be positive"
            )
        return cls(variances, lobes / totals)

    @property
    def sigmas_mm(self) -> FloatArray:
        """(n,) standard deviations of the lobes along one axis, mm."""
        return np.sqrt(self.variances_mm2)

    @property
    def mean_square_radius_mm2(self) -> FloatArray:
        """(3,) second moment of R over the plane: 2 Σ w v, mm²."""
        return 2.0 * (self.weights * self.variances_mm2[:, None]).sum(axis=0)

    def transfer(self, k_per_mm: FloatArray) -> FloatArray:
        """Return T(k) (..., 3) at spatial frequencies in rad/mm."""
        exponent = -0.5 * np.square(k_per_mm)
        lobes = [np.exp(variance * exponent) for variance in self.variances_mm2]
        channels = [
            sum(weight * lobe for weight, lobe in zip(weights, lobes, strict=True))
            for weights in self.weights.T
        ]
        return np.stack(channels, axis=-1)

    def radial(self, r_mm: FloatArray) -> FloatArray:
        """Return R(r) (..., 3) per mm², which integrates to 1 over the plane."""
        v = self.variances_mm2
        lobes = np.exp(-0.5 * np.square(r_mm)[..., None] / v) / (2.0 * np.pi * v)
        result: FloatArray = lobes @ self.weights
        return result

    def scaled(self, factor: float) -> GaussianMixture:
        """Return the mixture with every length multiplied by `factor`."""
        return GaussianMixture(self.variances_mm2 * factor**2, self.weights)


def fit_gaussians(
    transfer: Callable[[FloatArray], FloatArray], rms_radius_mm: FloatArray
) -> tuple[GaussianMixture, float]:
    """Fit a mixture with weights ≥ 0 to a transfer function.

    Parameters
    ----------
    transfer
        Function from k (n,) in rad/mm to T (n, 3).
    rms_radius_mm
        (3,) root mean square radii; the widths σ of the fit cover rms·[1/300, 3].

    Returns
    -------
    mixture, residual
        The fit, and max |ΔT| over its frequencies, which is ≤ 4e-4 for Burley's profile.
    """
    low, high = rms_radius_mm.min() / 300.0, rms_radius_mm.max() * 3.0
    sigmas = np.geomspace(low, high, FIT_LOBES)
    k = np.concatenate([[0.0], np.geomspace(0.01 / high, 0.5 / low, 400)])
    target = transfer(k)
    name = content_hash(FIT_NAME, target, sigmas)
    stored = (load_cached(name) or {}).get("weights")
    if stored is not None and stored.shape == (FIT_LOBES, 3):
        weights = np.asarray(stored, dtype=np.float64)
    else:
        weights = _fitted_weights(k, target, sigmas)
        store_cached(name, {"weights": weights})
    used = weights.max(axis=1) > 0.0
    mixture = GaussianMixture(sigmas[used] ** 2, weights[used])
    return mixture, float(np.abs(mixture.transfer(k) - target).max())


def _fitted_weights(k: FloatArray, target: FloatArray, sigmas: FloatArray) -> FloatArray:
    """Return weights (n, 3) ≥ 0 of Gaussians of widths (n,) whose transfer is near a target (K, 3)."""
    from scipy.optimize import nnls  # costs .4 s; most presets are Gaussians and need no fit

    basis = np.exp(-0.5 * np.square(k[:, None] * sigmas))
    rows = np.vstack(
        [basis, np.full((1, FIT_LOBES), FIT_SUM_WEIGHT), FIT_RIDGE * np.eye(FIT_LOBES)]
    )
    weights = np.empty((FIT_LOBES, 3))
    for channel in range(3):
        right = np.concatenate([target[:, channel], [FIT_SUM_WEIGHT], np.zeros(FIT_LOBES)])
        weights[:, channel] = nnls(rows, right, maxiter=100 * FIT_LOBES)[0]
    result: FloatArray = weights / weights.sum(axis=0)
    return result
