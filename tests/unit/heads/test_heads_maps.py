import numpy as np
import pytest

from native_twins import numpy_twins
from skinshade._core.errors import ArgumentError
from skinshade.heads import builtin_head
from skinshade.heads.maps import head_maps

NAMES = ("albedo", "normal", "specular", "deep_scatter")
SIZE = 256


@pytest.fixture(scope="module")
def small_maps():
    """Maps of seed 0, of seed 0 again, and of seed 1."""
    mesh = builtin_head().mesh
    arrays = (mesh.positions_mm, mesh.normals, mesh.uvs, mesh.faces, mesh.attributes["_REGION"])
    return [head_maps(*arrays, size=SIZE, seed=seed) for seed in (0, 0, 1)]


@pytest.mark.parametrize("name", NAMES)
def test_equal_seeds_give_the_same_bytes_and_other_seeds_do_not(small_maps, name):
    first, again, other = (getattr(maps, name) for maps in small_maps)
    assert first.tobytes() == again.tobytes()
    assert first.tobytes() != other.tobytes()


def test_the_maps_have_the_same_bytes_without_compiled_kernels(small_maps):
    mesh = builtin_head().mesh
    arrays = (mesh.positions_mm, mesh.normals, mesh.uvs, mesh.faces, mesh.attributes["_REGION"])
    with numpy_twins():
        twin = head_maps(*arrays, size=SIZE)
    for name in NAMES:
        assert getattr(small_maps[0], name).tobytes() == getattr(twin, name).tobytes()


def test_seeds_change_the_mean_albedo_little(small_maps):
    first, _, other = (maps.albedo.mean(axis=(0, 1)) for maps in small_maps)
    assert np.allclose(first, other, rtol=0.05)


def test_albedo_and_normals_have_the_size_and_the_other_maps_half_of_it(small_maps):
    maps = small_maps[0]
    assert maps.albedo.shape == maps.normal.shape == (SIZE, SIZE, 3)
    assert maps.specular.shape == (SIZE // 2, SIZE // 2, 2)
    assert maps.deep_scatter.shape == (SIZE // 2, SIZE // 2, 3)
    assert {getattr(maps, name).dtype for name in NAMES} == {np.dtype(np.float32)}


@pytest.mark.parametrize("size", [15, 14, 17])
def test_a_size_that_is_odd_or_too_small_is_an_error_that_names_it(size):
    empty = np.zeros((0, 3))
    with pytest.raises(ArgumentError, match=f"size is {size}; it must be even and at least 16"):
        head_maps(empty, empty, empty, empty.astype(int), empty, size=size)
