"""Extremes within square windows, against SciPy's filters."""

import numpy as np
import pytest
from scipy.ndimage import maximum_filter, minimum_filter

from skinshade.rendering.prepare.extremes import extreme_within


@pytest.mark.parametrize("reach", [0, 1, 2, 3, 7, 30, 200])
@pytest.mark.parametrize("shape", [(1, 1), (5, 130), (129, 65)])
def test_extremes_are_those_of_scipy_for_windows_inside_and_beyond_the_image(shape, reach):
    values = np.random.default_rng(reach).normal(size=shape)
    values[shape[0] // 2 :, ::3] = np.inf
    least = minimum_filter(values, size=2 * reach + 1, mode="nearest")
    greatest = maximum_filter(values, size=2 * reach + 1, mode="nearest")
    assert np.array_equal(extreme_within(values, reach, np.minimum), least)
    assert np.array_equal(extreme_within(values, reach, np.maximum), greatest)
