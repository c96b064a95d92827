import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import shading_tolerances as tol
from skinshade.rendering.prepare.mips import build_texture

SEED = st.integers(0, 2**20)


def picture(seed, height, width, channels=3):
    return np.random.default_rng(seed).random((height, width, channels)).astype(np.float32)


def level_of(texture, index):
    start = texture.starts[index]
    height, width = texture.heights[index], texture.widths[index]
    return texture.texels[start : start + height * width].reshape(height, width, -1)


def centres(height, width):
    v, u = np.meshgrid(
        (np.arange(height) + 0.5) / height, (np.arange(width) + 0.5) / width, indexing="ij"
    )
    return np.stack([u.ravel(), v.ravel()], axis=1)


@pytest.mark.parametrize("size", [(1, 1), (64, 64), (32, 8), (4, 64)])
@given(seed=SEED)
def test_every_level_has_half_the_sides_and_the_same_mean(size, seed):
    source = picture(seed, *size)
    texture = build_texture(source)
    assert texture.starts.size == int(np.log2(max(size))) + 1
    for index in range(texture.starts.size):
        level = level_of(texture, index)
        assert level.shape[:2] == tuple(max(side >> index, 1) for side in size)
        error = level.mean(axis=(0, 1), dtype=float) - source.mean(axis=(0, 1), dtype=float)
        assert np.abs(error).max() <= tol.FLOAT32.value
    assert np.array_equal(level_of(texture, 0), source)
    assert texture.size == max(size)


@given(SEED)
def test_a_texel_is_the_mean_of_the_four_under_it(seed):
    source = picture(seed, 16, 32)
    texture = build_texture(source)
    for index in (1, 2, 3):
        side = 2**index
        blocks = source.reshape(16 // side, side, 32 // side, side, 3).mean(axis=(1, 3))
        assert np.abs(level_of(texture, index) - blocks).max() <= tol.FLOAT32.value


@pytest.mark.parametrize("size", [(5, 7), (3, 1), (1, 6)])
def test_an_odd_last_row_or_column_is_left_out(size):
    source = picture(1, *size)
    height, width = (max(side // 2, 1) for side in size)
    kept = source[: 2 * height if size[0] > 1 else 1, : 2 * width if size[1] > 1 else 1]
    found = level_of(build_texture(source), 1)
    assert found.shape == (height, width, 3)
    assert np.allclose(found.mean(axis=(0, 1)), kept.mean(axis=(0, 1)), atol=tol.FLOAT32.value)


@given(SEED)
def test_averaged_normals_are_shorter_by_what_they_spread(seed):
    """Kept unnormalised: the length is the contrast that blur removed."""
    n = picture(seed, 8, 8) - (0.5, 0.5, -0.5)
    n = (n / np.linalg.norm(n, axis=-1, keepdims=True)).astype(np.float32)
    texture = build_texture(n)
    last = level_of(texture, texture.starts.size - 1)[0, 0]
    assert np.allclose(last, n.mean(axis=(0, 1)), atol=tol.FLOAT32.value)
    lengths = [
        np.linalg.norm(level_of(texture, i), axis=-1).mean() for i in range(texture.starts.size)
    ]
    assert lengths[0] == pytest.approx(1.0, abs=tol.FLOAT32.value)
    assert lengths == sorted(lengths, reverse=True)
    assert lengths[-1] < 0.97


@given(SEED)
def test_texel_centres_give_the_texels_of_every_level(seed):
    texture = build_texture(picture(seed, 8, 32))
    for index in range(texture.starts.size):
        truth = level_of(texture, index)
        at = centres(*truth.shape[:2])
        found = texture.sample(at, np.full(len(at), float(index)))
        assert np.abs(found.reshape(truth.shape) - truth).max() <= tol.BILINEAR.value


@given(SEED)
def test_between_centres_lies_the_bilinear_mix(seed):
    source = picture(seed, 16, 8)
    texture = build_texture(source)
    rng = np.random.default_rng(seed)
    x, y = rng.uniform(0.0, 7.0, 50), rng.uniform(0.0, 15.0, 50)
    found = texture.sample(np.stack([(x + 0.5) / 8, (y + 0.5) / 16], axis=1), np.zeros(50))
    i, j = x.astype(int), y.astype(int)
    fx, fy = (x - i)[:, None], (y - j)[:, None]
    top = source[j, i] * (1 - fx) + source[j, i + 1] * fx
    low = source[j + 1, i] * (1 - fx) + source[j + 1, i + 1] * fx
    assert np.abs(found - (top * (1 - fy) + low * fy)).max() <= tol.BILINEAR.value


def test_a_ramp_is_exact_between_the_first_and_the_last_centre():
    u = (np.arange(64) + 0.5) / 64.0
    ramp = np.broadcast_to(np.stack([u, 1.0 - u], axis=-1), (4, 64, 2)).astype(np.float32)
    at = np.random.default_rng(1).uniform(1.0 / 128, 1 - 1.0 / 128, (200, 2))
    found = build_texture(ramp).sample(at, np.zeros(200))
    assert np.abs(found - np.stack([at[:, 0], 1.0 - at[:, 0]], axis=1)).max() <= tol.BILINEAR.value


@given(SEED, st.integers(-5, 5), st.integers(-5, 5), st.floats(0.0, 6.0))
def test_textures_repeat(seed, du, dv, level):
    texture = build_texture(picture(seed, 16, 32))
    uv = np.random.default_rng(seed).random((20, 2))
    one, other = (texture.sample(at, np.full(20, level)) for at in (uv, uv + np.array([du, dv])))
    assert np.allclose(one, other, atol=1e-10)


@given(SEED)
def test_across_the_seam_the_last_texel_meets_the_first(seed):
    source = picture(seed, 4, 8)
    texture = build_texture(source)
    v = (np.arange(4) + 0.5) / 4
    for u in (0.0, 1.0):
        found = texture.sample(np.stack([np.full(4, u), v], axis=1), np.zeros(4))
        assert np.allclose(found, 0.5 * (source[:, 0] + source[:, -1]), atol=tol.BILINEAR.value)


@given(SEED, st.floats(0.0, 4.0))
def test_between_levels_lies_the_linear_mix(seed, level):
    texture = build_texture(picture(seed, 16, 16))
    uv = np.random.default_rng(seed).random((20, 2))
    low = int(level)
    one, other = (texture.sample(uv, np.full(20, float(at))) for at in (low, low + 1))
    mixed = one + (level - low) * (other - one)
    assert np.allclose(texture.sample(uv, np.full(20, level)), mixed, atol=tol.BILINEAR.value)


def test_a_level_before_the_first_or_after_the_last_is_that_one():
    texture = build_texture(picture(1, 16, 16))
    uv = np.random.default_rng(1).random((20, 2))
    ends = [texture.sample(uv, np.full(20, level)) for level in (-3.0, 0.0, 4.0, 99.0)]
    assert np.array_equal(ends[0], ends[1])
    assert np.array_equal(ends[2], ends[3])
    assert np.allclose(ends[3], ends[3][0]), "a single texel is left"


@pytest.mark.parametrize("octave", [0, 1, 2.5, 5])
def test_a_pixel_as_wide_as_so_many_texels_takes_the_level_of_their_octave(octave):
    texture = build_texture(picture(1, 64, 64))
    step = np.array([[2.0**octave / 64.0, 0.0]])
    assert texture.level(step, step[:, ::-1])[0] == pytest.approx(octave, abs=1e-12)
    turned = step @ np.array([[0.6, 0.8], [-0.8, 0.6]])
    assert texture.level(turned, turned[:, ::-1] * (-1, 1))[0] == pytest.approx(octave, abs=1e-12)


def test_levels_count_texels_not_uv():
    texture = build_texture(picture(1, 16, 128))
    across = np.array([[4.0 / 128.0, 0.0]]), np.array([[0.0, 4.0 / 16.0]])
    assert texture.level(*across)[0] == pytest.approx(2.0)


@pytest.mark.parametrize(("ratio", "extra"), [(2.0, 0.0), (8.0, 0.0), (32.0, 2.0)])
def test_a_slanted_pixel_takes_its_short_side_up_to_eight_times(ratio, extra):
    texture = build_texture(picture(1, 256, 256))
    short, long = np.array([[2.0 / 256.0, 0.0]]), np.array([[0.0, 2.0 * ratio / 256.0]])
    for one, other in ((short, long), (long, short)):
        assert texture.level(one, other)[0] == pytest.approx(1.0 + extra)


def test_a_magnified_texture_takes_its_first_level_and_a_still_one_too():
    texture = build_texture(picture(1, 64, 64))
    tiny = np.array([[1e-5, 0.0], [0.0, 0.0]])
    assert texture.level(tiny, tiny[:, ::-1]).tolist() == [0.0, 0.0]
