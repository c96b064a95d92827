"""Functions of a Laplacian by Chebyshev polynomials (MODEL §7).

A transfer function T(√λ) over the range 0..Λ of eigenvalues λ is a sum of Chebyshev polynomials of
1 − 2λ/Λ, whose factors decrease fast where it is smooth. The sum needs one product with the sparse matrix per
degree, for all channels at once, and no factorisation.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .._core.arrays import FloatArray, FloatRows, FloatVector
from . import compiled, compiled_diffusion
from .compiled_diffusion import COLUMNS, TERMS
from .laplacian import Laplacian

__all__ = ["MOST_DEGREE", "chebyshev_factors", "filtered"]

MOST_DEGREE = 10_000
"""Greatest degree. A degree takes 20 ms for a million vertices on two cores."""
SAMPLES_PER_WAVE = 4
"""Least samples of T over its greatest frequency times the root mean square radius. Four resolve the
oscillation of the transform of a disk of three times that radius."""
LEAST_SAMPLES, MOST_SAMPLES = 32, 1 << 15
"""Samples of T; the most are some times the greatest degree."""
CHANNELS = 3


def chebyshev_factors(
    transfer: Callable[[FloatArray], FloatArray], greatest: float, reach_mm: float, tolerance: float
) -> FloatRows | None:
    """Return the factors of Chebyshev polynomials of 1 − 2λ/`greatest`, whose sum is T(√λ).

    Parameters
    ----------
    transfer
        T(k) (n, 3) at frequencies (n,) in rad/mm; T(0) = 1.
    greatest
        Greatest eigenvalue λ, 1/mm².
    reach_mm
        Root mean square radius of the widest channel.
    tolerance
        Greatest error of the sum.

    Returns
    -------
    (degree + 1, 3) or None
        Factors of the degrees 0, 1 … The factors of a channel are 0 above the degree that it needs, and add
        up to 1, so that constants are kept. None if a channel needs a degree above `MOST_DEGREE`.
    """
    needed = SAMPLES_PER_WAVE * reach_mm * np.sqrt(greatest)
    if not needed <= MOST_SAMPLES:
        return None
    count = LEAST_SAMPLES << max(0, int(np.ceil(np.log2(needed / LEAST_SAMPLES))))
    while count <= MOST_SAMPLES:
        factors = _interpolated(transfer, greatest, count)
        # Every factor bounds what its polynomial adds: their sum bounds the error of those that are left out.
        left_out = np.cumsum(np.abs(factors[::-1]), axis=0)[::-1]
        terms = int((left_out > 0.5 * tolerance).any(axis=1).sum())
        # The samples resolve T if the upper half of the factors is small, and T(0) is 1 between the samples.
        missing = np.abs(factors.sum(axis=0) - 1.0).max()
        if 2 * terms <= count and missing <= 0.5 * tolerance:
            factors[left_out <= 0.5 * tolerance] = 0.0
            factors = factors[: max(terms, 2)]
            factors[0] += 1.0 - factors.sum(axis=0)
            return factors if terms - 1 <= MOST_DEGREE else None
        count *= 2
    return None


def _interpolated(
    transfer: Callable[[FloatArray], FloatArray], greatest: float, count: int
) -> FloatRows:
    """Return the factors (count, 3) of the polynomial through T at as many Chebyshev points."""
    angle = np.pi * (np.arange(count) + 0.5) / count
    values = transfer(np.sqrt(greatest) * np.sin(0.5 * angle))
    # The cosine transform by a Fourier transform of the even continuation.
    spectrum = np.fft.rfft(np.concatenate([values, values[::-1]]), axis=0)[:count]
    turned = spectrum * np.exp(-0.5j * np.pi * np.arange(count) / count)[:, None]
    factors: FloatRows = turned.real / count
    factors[0] *= 0.5
    return factors


def filtered(
    laplacian: Laplacian, factors: FloatRows, values: FloatArray, report: Callable[[float], None]
) -> FloatArray:
    """Return the sum of Chebyshev polynomials of a Laplacian times values.

    Parameters
    ----------
    laplacian
        Laplacian of P points.
    factors
        (degree + 1, 3) factors of the polynomials for three channels, from `chebyshev_factors`.
    values
        (P, n) values.
    report
        Called with the fraction that is done.

    Returns
    -------
    (P, n, 3)
    """
    if not compiled.serves(laplacian.masses):
        return _numpy_filtered(laplacian, factors, values, report)
    result = np.empty((*values.shape, CHANNELS))
    for first in range(0, values.shape[1], COLUMNS):
        part = values[:, first : first + COLUMNS]
        start, share = first / values.shape[1], part.shape[1] / values.shape[1]

        def report_part(done: float, start: float = start, share: float = share) -> None:
            report(start + done * share)

        sums = _filtered_columns(laplacian, factors, part, report_part)
        result[:, first : first + COLUMNS] = sums[..., : part.shape[1]].swapaxes(1, 2)
    return result


def _filtered_columns(
    laplacian: Laplacian, factors: FloatRows, values: FloatArray, report: Callable[[float], None]
) -> FloatArray:
    """Return the sums (P, 3, 4) of `filtered` for up to four columns; those without values are 0."""
    shape = len(values), COLUMNS
    now, previous = np.zeros(shape), np.zeros(shape)
    now[:, : values.shape[1]] = values
    sums = np.empty((len(values), CHANNELS, COLUMNS))
    rates = _rates(laplacian)
    last, added = len(factors) - 1, -1
    for degree in range(1, len(factors)):
        # Sums are read and written once for three degrees: a step has that many polynomials at hand.
        terms = np.zeros((CHANNELS, TERMS))
        if degree in (1, last) or degree - added == TERMS:
            new = range(added + 1, degree + 1)
            terms[:, TERMS - len(new) :] = factors[new.start : new.stop].T
            added = degree
        start = degree == 1
        compiled_diffusion.chebyshev_step(laplacian.edges, rates, start, now, previous, terms, sums)
        now, previous = previous, now
        report(degree / last)
    return sums


def _numpy_filtered(
    laplacian: Laplacian, factors: FloatRows, values: FloatArray, report: Callable[[float], None]
) -> FloatArray:
    """Return the sums of `filtered`."""
    stiffness, rates = laplacian.stiffness(), _rates(laplacian)[:, None]
    previous, now = values, values - 0.5 * rates * (stiffness @ values)
    sums = factors[0] * previous[..., None] + factors[1] * now[..., None]
    for degree in range(2, len(factors)):
        previous, now = now, 2.0 * now - rates * (stiffness @ now) - previous
        for channel in np.flatnonzero(factors[degree]):
            sums[..., channel] += factors[degree, channel] * now
        report(degree / (len(factors) - 1))
    return sums


def _rates(laplacian: Laplacian) -> FloatVector:
    """Return the factors (P,) of K in twice the matrix 1 − 2/Λ M⁻¹K, the argument of the polynomials."""
    return 4.0 / (laplacian.greatest * laplacian.masses)
