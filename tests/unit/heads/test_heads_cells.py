"""Cellular volumes and blurs of the built-in head, against SciPy's."""

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter1d
from scipy.spatial import cKDTree

from skinshade.heads.maps.blur import gaussian_blur
from skinshade.heads.maps.noise import MARGIN, cellular_volume


@pytest.mark.parametrize(("samples", "across"), [(32, 6), (16, 3), (7, 1), (20, 5)])
def test_distances_to_the_nearest_two_points_are_those_of_a_tree(samples, across):
    lattice = np.stack(np.meshgrid(*[np.arange(across)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    rng = np.random.default_rng(samples)
    points = lattice + rng.uniform(MARGIN, 1.0 - MARGIN, lattice.shape)
    # Copies of the points around the period, because a single point is its own neighbour.
    turns = np.stack(np.meshgrid(*[np.arange(-3, 4)] * 3, indexing="ij"), axis=-1).reshape(-1, 1, 3)
    tree = cKDTree((points + across * turns).reshape(-1, 3))
    axis = (np.arange(samples) + 0.5) * (across / samples)
    grid = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1).reshape(-1, 3)
    near = tree.query(grid, k=2)[0]
    first, gap = cellular_volume(np.random.default_rng(samples), samples, across)
    assert np.allclose(first, near[:, 0], rtol=1e-6, atol=0.0)
    assert np.allclose(gap, near[:, 1] - near[:, 0], rtol=1e-6, atol=1e-6)


@pytest.mark.parametrize(("mode", "scipy_mode"), [("edge", "nearest"), ("wrap", "wrap")])
@pytest.mark.parametrize("axis", [0, 1])
def test_a_blur_has_the_values_of_scipy(mode, scipy_mode, axis):
    values = np.random.default_rng(0).random((20, 31))
    for sigma in (0.4, 1.1, 3.0):
        expected = gaussian_filter1d(values, sigma, axis=axis, mode=scipy_mode)
        assert np.array_equal(gaussian_blur(values, sigma, axis, mode), expected)
