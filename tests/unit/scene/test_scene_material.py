import numpy as np
import pytest

from skinshade._core.errors import ArgumentError
from skinshade.scene import Material

CHANNELS = {"albedo": 3, "normal": 3, "specular": 2, "deep_scatter": 3}


@pytest.mark.parametrize(
    ("name", "shape"),
    [
        ("albedo", (4, 4)),
        ("albedo", (4, 4, 4)),
        ("albedo", (0, 4, 3)),
        ("normal", (4, 4, 2)),
        ("specular", (4, 4, 3)),
        ("deep_scatter", (4, 4, 1)),
    ],
)
def test_a_map_of_a_wrong_shape_is_an_error_that_names_it(name, shape):
    with pytest.raises(ArgumentError, match=f"material {name}: shape is "):
        Material(**{name: np.ones(shape, dtype=np.float32)})


@pytest.mark.parametrize("name", CHANNELS)
def test_a_map_with_values_that_are_not_finite_is_an_error_that_names_it(name):
    image = np.full((2, 2, CHANNELS[name]), np.nan, dtype=np.float32)
    with pytest.raises(ArgumentError, match=f"material {name}: all values must be finite"):
        Material(**{name: image})


@pytest.mark.parametrize("name", CHANNELS)
def test_has_maps_is_true_of_a_map_of_more_than_one_texel(name):
    one, two = (np.full((1, width, CHANNELS[name]), 0.5, dtype=np.float32) for width in (1, 2))
    assert not Material(**{name: one}).has_maps
    assert Material(**{name: two}).has_maps
