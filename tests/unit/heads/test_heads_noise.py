"""Noise volumes of the built-in head: compiled lookups against SciPy's, and their period."""

import numpy as np
import pytest

from native_twins import both, level, needs_library, threads
from skinshade._core import native
from skinshade.heads.maps.noise import sample_smooth, smooth_volume

VOLUME = smooth_volume(np.random.default_rng(0), 12)
POINTS = np.random.default_rng(1).uniform(-150.0, 150.0, (40_000, 3)).astype(np.float32)


@needs_library
@pytest.mark.parametrize("feature_mm", [0.75, 4.0, 26.0])
def test_compiled_lookups_have_the_bytes_of_scipy(feature_mm):
    compiled, twin = both(sample_smooth, VOLUME, POINTS, feature_mm)
    assert np.array_equal(compiled, twin)


@needs_library
@pytest.mark.parametrize("offset", [-1e-30, -1e-9, 0.0, 12.0, 24.0, np.nextafter(12.0, 0.0)])
def test_compiled_lookups_at_the_ends_of_the_period_are_those_of_scipy(offset):
    points = np.full((3, 3), offset, dtype=np.float32)
    compiled, twin = both(sample_smooth, VOLUME, points, 4.0)
    assert np.allclose(compiled, twin, rtol=0.0, atol=1e-6)


def test_lookups_at_the_samples_are_the_samples_of_any_period():
    index = np.random.default_rng(2).integers(0, 12, (1000, 3))
    for period in (-2, 0, 3):
        points = (index + 12 * period).astype(np.float32)
        assert np.array_equal(sample_smooth(VOLUME, points, 4.0), VOLUME[tuple(index.T)])


@needs_library
def test_lookups_have_the_same_bytes_for_any_number_of_threads():
    with threads(1):
        expected = sample_smooth(VOLUME, POINTS, 2.0)
    for count in (2, 5):
        with threads(count):
            assert np.array_equal(sample_smooth(VOLUME, POINTS, 2.0), expected)


@pytest.mark.skipif(native.reason() != "compiled, x86-64-v3", reason="no second level")
def test_lookups_have_the_same_bytes_for_all_levels_of_instructions():
    with level("v2"):
        expected = sample_smooth(VOLUME, POINTS, 2.0)
    with level("v3"):
        assert np.array_equal(sample_smooth(VOLUME, POINTS, 2.0), expected)
