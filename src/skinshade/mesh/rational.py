"""Functions of a Laplacian by Lanczos' iteration with its shifted inverse (MODEL §7).

It serves profiles that are much wider than the shortest edges, for which polynomials need too high a degree.
The number of its steps does not depend on the shortest edge, but the sparse matrix is factorised once.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .._core.arrays import FloatArray, FloatVector
from .._core.errors import MeshError
from .laplacian import Laplacian

__all__ = ["MOST_POINTS", "transferred"]

MOST_POINTS = 500_000
"""Most points of a mesh whose matrix is factorised: 250,000 take 8 s and 1.3 GB, more than in proportion."""
MOST_STEPS = 400
"""Steps after which the iteration counts as divergent."""
CHECK_EVERY = 12
"""Steps of the iteration between tests of its convergence."""


def transferred(
    laplacian: Laplacian,
    transfer: Callable[[FloatArray], FloatArray],
    values: FloatArray,
    tolerance: float,
    shift: float,
    report: Callable[[float], None],
) -> FloatArray:
    """Return T(√(M⁻¹K)) (P, n, 3) times values (P, n).

    Parameters
    ----------
    laplacian
        Laplacian of P points.
    transfer
        T(k) (m, 3) at frequencies (m,) in rad/mm; T(0) = 1.
    values
        (P, n) values.
    tolerance
        Change of the result, relative to the norm of the values, at which the iteration stops.
    shift
        Eigenvalue about which T changes most, 1/mm².
    report
        Called with the fraction that is done.

    Raises
    ------
    MeshError
        If the mesh has too many points, or the iteration does not converge.
    """
    from scipy.sparse import csc_array, diags_array
    from scipy.sparse.csgraph import connected_components
    from scipy.sparse.linalg import splu

    count = len(laplacian.masses)
    if count > MOST_POINTS:
        raise MeshError(
            f"diffusion over a mesh of {count} points (most are {MOST_POINTS}) by a profile that is much"
            " wider than its shortest edges; check the unit of the mesh, remove needle-like faces, or give a"
            " greater tolerance"
        )
    mass, stiffness = laplacian.masses, laplacian.stiffness()
    part = connected_components(stiffness, directed=False)[1]
    # No eigenvalue but 0 is much smaller than this; a smaller shift would be lost in the rounding of K.
    shift = max(shift, 1.0 / float(mass.sum()))
    factorised = splu(
        csc_array(stiffness + diags_array(shift * mass)),
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )
    root = np.sqrt(mass)

    def inverse(vector: FloatVector) -> FloatVector:
        return root * factorised.solve(root * vector)

    result = np.empty((*values.shape, 3))
    for column, own in enumerate(values.T):
        # Diffusion keeps the mean over a connected part: it is subtracted here and added at the end.
        mean = (np.bincount(part, mass * own) / np.bincount(part, mass))[part]
        rest = root * (own - mean)
        result[:, column] = mean[:, None]
        if np.linalg.norm(rest) > 1e-14 * np.linalg.norm(root * mean):
            change = _by_lanczos(inverse, transfer, rest, tolerance, shift)
            result[:, column] += change / root[:, None]
        report((column + 1) / values.shape[1])
    return result


def _by_lanczos(
    inverse: Callable[[FloatVector], FloatVector],
    transfer: Callable[[FloatArray], FloatArray],
    start: FloatVector,
    tolerance: float,
    shift: float,
) -> FloatArray:
    """Return T(√A) (P, 3) times a vector, where `inverse` multiplies by (A + shift)⁻¹ [Higham2008]."""
    norm = float(np.linalg.norm(start))
    basis = np.empty((CHECK_EVERY + 1, start.size))
    basis[0] = start / norm
    diagonal: list[float] = []
    beside: list[float] = []
    previous, last_change = np.zeros((0, 3)), np.inf
    for step in range(1, min(MOST_STEPS, start.size) + 1):
        vector = inverse(basis[step - 1])
        diagonal.append(float(vector @ basis[step - 1]))
        for _ in range(2):  # two passes keep the basis orthogonal
            vector -= (basis[:step] @ vector) @ basis[:step]
        length = float(np.linalg.norm(vector))
        exhausted = length <= 1e-14 * max(diagonal) or step == start.size
        if exhausted or step % CHECK_EVERY == 0:
            weights = _small_function(diagonal, beside, transfer, shift)
            difference = weights.copy()
            difference[: len(previous)] -= previous
            change = float(np.linalg.norm(difference, axis=0).max())
            # Changes decrease by about a constant ratio: this is the sum of those to come.
            left = change * change / max(last_change - change, 1e-300)
            if exhausted or (change < last_change and max(change, left) < 0.5 * tolerance):
                result: FloatArray = norm * (basis[:step].T @ weights)
                return result
            previous, last_change = weights, change
            basis = np.concatenate([basis, np.empty((CHECK_EVERY, start.size))])
        beside.append(length)
        basis[step] = vector / length
    raise MeshError(
        f"diffusion has not converged in {MOST_STEPS} steps; remove needle-like faces, or give a greater"
        " tolerance"
    )


def _small_function(
    diagonal: list[float],
    beside: list[float],
    transfer: Callable[[FloatArray], FloatArray],
    shift: float,
) -> FloatArray:
    """Return T(√(H⁻¹ − shift)) e₁ (m, 3) of the tridiagonal matrix H of the iteration."""
    inverses, vectors = np.linalg.eigh(np.diag(diagonal) + np.diag(beside, 1) + np.diag(beside, -1))
    squares = 1.0 / np.maximum(inverses, 1e-300) - shift
    response = transfer(np.sqrt(np.maximum(squares, 0.0)))
    weights: FloatArray = vectors @ (vectors[0][:, None] * response)
    return weights
