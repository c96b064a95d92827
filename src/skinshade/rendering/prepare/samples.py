"""Sample positions within a pixel."""

from __future__ import annotations

import numpy as np

__all__ = ["sample_offsets"]

STEP = (0.7548776662466927, 0.5698402909980532)
"""Steps 1/ρ and 1/ρ² of the additive recurrence R₂ [Roberts2018], where ρ³ = ρ + 1."""


def sample_offsets(samples: int, seed: int) -> list[tuple[float, float]]:
    """Return the positions of samples within a pixel, 0..1 from the top left; a seed shifts them."""
    if samples == 1:
        return [(0.5, 0.5)]
    start = np.random.default_rng(seed).random(2) if seed else np.array([0.5, 0.5])
    points = (start + np.array(STEP) * np.arange(samples)[:, None]) % 1.0
    return [(float(x), float(y)) for x, y in points]
