import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from test_scene_images import store

import shading_tolerances as tol
from skinshade._core.errors import ImageFileError
from skinshade.scene.maps import read_normal_map, scale_slopes


def encoded(normals, top):
    """Return normals as stored values 0..top."""
    return np.rint((0.5 + 0.5 * np.asarray(normals)) * top)


def random_normals(seed):
    n = np.random.default_rng(seed).normal(size=(8, 8, 3)) * 0.4 + (0.0, 0.0, 1.5)
    return (n / np.linalg.norm(n, axis=-1, keepdims=True)).astype(np.float32)


# -- reading ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(("kind", "top"), [(np.uint8, 255), (np.uint16, 65535)])
def test_a_normal_map_holds_unit_normals_with_y_up(tmp_path, kind, top):
    truth = random_normals(3)
    normals = read_normal_map(store(tmp_path / "n.png", encoded(truth, top).astype(kind)))
    assert np.abs(normals - truth).max() <= 2.0 / top
    assert np.abs(np.linalg.norm(normals, axis=-1) - 1.0).max() <= tol.FLOAT32.value


@pytest.mark.parametrize("normal", [(0.6, 0.0, -0.8), (0.0, 0.8, -0.6)])
def test_a_map_of_normals_that_face_inwards_is_an_error(tmp_path, normal):
    file = store(tmp_path / "in.png", np.tile(encoded(normal, 255).astype(np.uint8), (4, 4, 1)))
    with pytest.raises(ImageFileError, match=r"in\.png: not a tangent-space normal map"):
        read_normal_map(file)


def test_a_map_of_two_channels_is_an_error(tmp_path):
    file = store(tmp_path / "rg.png", np.full((4, 4, 3), (140, 120, 0), dtype=np.uint8))
    with pytest.raises(ImageFileError, match="three channels"):
        read_normal_map(file)


# -- slopes ----------------------------------------------------------------------------------------


@given(st.integers(0, 2**20), st.floats(0.0, 4.0))
def test_scaled_normals_are_unit_vectors_with_scaled_slopes(seed, strength):
    normals = random_normals(seed)
    scaled = scale_slopes(normals, strength)
    assert np.abs(np.linalg.norm(scaled, axis=-1) - 1.0).max() <= tol.FLOAT32.value
    slopes = normals[..., :2] / normals[..., 2:]
    assert np.allclose(scaled[..., :2] / scaled[..., 2:], strength * slopes, rtol=1e-5, atol=1e-6)


def test_a_strength_of_1_keeps_the_map_and_of_0_makes_it_flat():
    normals = random_normals(1)
    assert scale_slopes(normals, 1.0) is normals
    assert np.array_equal(scale_slopes(normals, 0.0), np.broadcast_to([0, 0, 1], normals.shape))
