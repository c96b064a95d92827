from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import shading_tolerances as tol
from skinshade._core.errors import ArgumentError, ImageFileError
from skinshade.scene import Environment
from skinshade.scene.images import write_exr
from skinshade.shading.ambient import ambient_irradiance
from skinshade.shading.image_light import LOBE_POWERS, equirectangular_uv

SEED = st.integers(0, 2**20)


def grid(height, width):
    """Directions (H, W, 3) of the texels' centres, and their solid angles (H, W)."""
    theta = (np.arange(height) + 0.5) / height * np.pi
    phi = ((np.arange(width) + 0.5) / width - 0.5) * 2.0 * np.pi
    sine = np.sin(theta)[:, None]
    up = np.broadcast_to(np.cos(theta)[:, None], (height, width))
    edges = np.cos(np.arange(height + 1) / height * np.pi)
    solid = np.repeat((edges[:-1] - edges[1:])[:, None], width, axis=1) * 2.0 * np.pi / width
    return np.stack([sine * np.cos(phi), up, sine * np.sin(phi)], axis=-1), solid


def grey(picture):
    return np.repeat(np.asarray(picture, dtype=np.float32)[..., None], 3, axis=-1)


def mean(picture):
    return np.tensordot(grid(*picture.shape[:2])[1], picture.astype(float), 2) / (4.0 * np.pi)


def directions(seed, count=50):
    v = np.random.default_rng(seed).normal(size=(count, 3))
    return v / np.linalg.norm(v, axis=1)[:, None]


def irradiance(environment, normals):
    return np.pi * ambient_irradiance(
        environment.radiance_sh, np.repeat(normals[:, None], 3, axis=1)
    )


@pytest.fixture(scope="module")
def studio():
    return Environment.studio()


def test_an_even_sky_is_one_harmonic_and_its_irradiance_is_pi_times_it():
    even = Environment.constant((0.5, 1.0, 2.0))
    band0 = np.sqrt(4.0 * np.pi) * np.array([0.5, 1.0, 2.0])
    assert np.allclose(even.radiance_sh[0], band0, rtol=tol.ROUNDING_SUMS.value)
    assert np.abs(even.radiance_sh[1:]).max() <= tol.EVEN_SKY.value
    found = irradiance(even, directions(1))
    assert np.allclose(found, np.pi * np.array([0.5, 1.0, 2.0]), rtol=tol.EVEN_SKY.value)


@given(SEED)
def test_a_small_sun_has_the_harmonics_of_its_direction(seed):
    """Σ over nine harmonics of Y(d)Y(s) is Legendre's: (1 + 3x + 5(3x²−1)/2)/4π."""
    rng = np.random.default_rng(seed)
    row, column = rng.integers(2, 126), rng.integers(0, 256)
    picture = np.zeros((128, 256))
    picture[row, column] = 100.0
    to_all, solid = grid(128, 256)
    flux, sun = 100.0 * solid[row, column], to_all[row, column]
    d = directions(seed)
    x = d @ sun
    truth = (np.pi + 2.0 * np.pi * x + np.pi / 4.0 * 5.0 * (1.5 * x * x - 0.5)) / (4.0 * np.pi)
    found = irradiance(Environment(grey(picture)), d)[:, 0]
    assert np.allclose(found, flux * np.maximum(truth, 0.0), rtol=1e-6, atol=1e-9)


@given(SEED)
def test_a_wide_light_is_as_bright_as_by_brute_force(seed):
    axis = directions(seed, 1)[0]
    to_all, solid = grid(64, 128)
    picture = np.maximum(to_all @ axis, 0.0)
    n = directions(seed + 1)
    truth = np.maximum(n @ to_all.reshape(-1, 3).T, 0.0) @ (picture * solid).ravel()
    found = irradiance(Environment(grey(picture)), n)[:, 0]
    assert np.abs(found - truth).max() <= tol.COSINE_LOBE.value * truth.max()


@given(SEED, st.integers(2, 300), st.integers(2, 600))
def test_no_light_is_lost_however_large_the_picture_and_small_the_sun(seed, height, width):
    rng = np.random.default_rng(seed)
    picture = np.zeros((height, width))
    for row, column in ((rng.integers(height), rng.integers(width)), (-1, -1), (0, -1)):
        picture[row, column] += 1.0 / grid(height, width)[1][row, column]
    band0 = Environment(grey(picture)).radiance_sh[0, 0] * np.sqrt(4.0 * np.pi)
    assert band0 == pytest.approx(3.0, rel=tol.SUN_KEPT.value)


def test_a_map_is_read_from_its_own_directions():
    """u = ½ + atan2(z, x)/2π, v = acos(y)/π from the top."""
    axes = np.array([[1.0, 0, 0], [0, 0, 1], [-1, 0, 1e-9], [0, 0, -1], [0, 1, 0], [0, -1, 0]])
    u, v = equirectangular_uv(axes)
    assert np.allclose(u[:4], [0.5, 0.75, 1.0, 0.25])
    assert np.allclose(v, [0.5, 0.5, 0.5, 0.5, 0.0, 1.0])
    rng = np.random.default_rng(3)
    picture = rng.random((8, 16, 3)).astype(np.float32)
    found = Environment(picture, scale=2.0).sample(grid(8, 16)[0])
    assert np.allclose(found, 2.0 * picture, atol=tol.BILINEAR.value)


def test_across_its_seam_a_map_is_continuous():
    picture = np.random.default_rng(4).random((8, 16, 3)).astype(np.float32)
    behind = np.array([[-1.0, 0.2, 1e-12], [-1.0, 0.2, -1e-12]])
    behind /= np.linalg.norm(behind, axis=1)[:, None]
    one, other = Environment(picture).sample(behind)
    assert np.allclose(one, other, atol=tol.BILINEAR.value)


@pytest.mark.parametrize("power", LOBE_POWERS)
def test_reflections_keep_the_mean(studio, power):
    level = studio.preconvolved.levels[LOBE_POWERS.index(power)]
    assert np.allclose(mean(level), mean(studio.radiance), rtol=tol.LEVEL_MEAN.value)


@pytest.mark.parametrize("power", LOBE_POWERS)
def test_an_even_sky_is_reflected_evenly(power):
    found = Environment.constant(2.0).preconvolved.sample(directions(5), np.full(50, power))
    assert np.abs(found / 2.0 - 1.0).max() <= tol.EVEN_REFLECTION.value


@pytest.mark.parametrize("power", LOBE_POWERS[:4])
def test_a_reflection_is_the_mean_over_a_phong_lobe(studio, power):
    to_all, solid = grid(*studio.radiance.shape[:2])
    d = directions(6)
    weight = np.maximum(d @ to_all.reshape(-1, 3).T, 0.0) ** power * solid.ravel()
    truth = weight @ studio.radiance.reshape(-1, 3).astype(float)
    truth /= weight.sum(axis=1, keepdims=True)
    found = studio.preconvolved.sample(d, np.full(50, power))
    error = np.abs(found - truth).max() / studio.radiance.max()
    assert error <= tol.PHONG_LOBE.value * power


@given(SEED, st.floats(0.0, 4.0))
def test_between_two_powers_reflections_are_mixed_and_beyond_them_they_stay(studio, seed, level):
    d = directions(seed, 5)
    sample = studio.preconvolved.sample
    low = int(min(level, 3.0))
    ends = [sample(d, np.full(5, 4.0**at)) for at in (low, low + 1)]
    mixed = ends[0] + (level - low) * (ends[1] - ends[0])
    assert np.allclose(sample(d, np.full(5, 4.0**level)), mixed, atol=1e-6)
    assert np.array_equal(sample(d, np.full(5, 0.1)), sample(d, np.full(5, 1.0)))
    assert np.array_equal(sample(d, np.full(5, 1e4)), sample(d, np.full(5, 256.0)))


def test_scale_multiplies_everything(studio):
    half = replace(studio, scale=0.5)
    d = directions(7)
    assert np.allclose(half.radiance_sh, 0.5 * studio.radiance_sh)
    assert np.allclose(half.sample(d), 0.5 * studio.sample(d))
    power = np.full(50, 16.0)
    pair = (each.preconvolved.sample(d, power) for each in (half, studio))
    assert np.allclose(next(pair), 0.5 * next(pair), rtol=1e-5)


def test_the_studio_lights_from_the_upper_left_and_is_no_brighter_than_a_studio(studio):
    assert np.isfinite(studio.radiance).all()
    assert studio.radiance.min() > 0.0
    key, other, below = irradiance(
        studio, np.array([[-0.62, 0.45, 0.64], [0.62, 0.45, 0.64], [0.0, -1.0, 0.0]])
    )
    assert (key > 1.8 * other).all()
    assert (other > below).all()
    assert 0.5 < key.mean() / np.pi < 2.0


def test_a_map_on_disk_is_the_same_light(tmp_path):
    picture = np.random.default_rng(8).random((16, 32, 3)).astype(np.float32)
    write_exr(tmp_path / "sky.exr", picture)
    loaded = Environment.load(tmp_path / "sky.exr", scale=0.3, visible=True)
    assert np.array_equal(loaded.radiance, picture)
    assert (loaded.scale, loaded.visible) == (0.3, True)
    write_exr(tmp_path / "dark.exr", picture - 0.5)
    assert np.array_equal(
        Environment.load(tmp_path / "dark.exr").radiance, np.maximum(picture - 0.5, 0.0)
    )


@pytest.mark.parametrize(
    ("radiance", "said"),
    [
        (np.ones((4, 8), np.float32), r"environment radiance: shape is \(4, 8\)"),
        (np.ones((4, 8, 4), np.float32), r"shape is \(4, 8, 4\); it must be \(H, W, 3\)"),
        (np.ones((1, 8, 3), np.float32), "environment radiance: shape"),
        ([[1]], r"environment radiance: shape is \(1, 1\)"),
        ([[[1, 2, "x"]]], "environment radiance: not an array of numbers"),
        (None, "environment radiance: shape"),
        (np.full((4, 8, 3), np.nan, np.float32), "finite"),
        (np.full((4, 8, 3), -1.0, np.float32), "not negative"),
    ],
)
def test_a_picture_that_is_no_sky_is_refused(radiance, said):
    with pytest.raises(ArgumentError, match=said):
        Environment(radiance)


@pytest.mark.parametrize(
    ("radiance", "said"),
    [
        ([1, 2], r"environment radiance: shape is \(2,\)"),
        (np.ones((16, 32, 3)), "environment radiance: shape"),
        ([1, -2, 1], r"environment radiance\[1\] is -2"),
        (np.nan, "environment radiance is nan"),
        ("bright", "environment radiance: not an array of numbers"),
    ],
)
def test_a_colour_that_is_none_is_refused(radiance, said):
    with pytest.raises(ArgumentError, match=said):
        Environment.constant(radiance)


def test_a_bad_scale_or_file_is_refused_by_name(tmp_path):
    for scale in (-1.0, np.nan):
        with pytest.raises(ArgumentError, match="environment scale is"):
            Environment.constant(1.0, scale=scale)
    (tmp_path / "noise.hdr").write_bytes(b"no light")
    for name in ("noise.hdr", "gone.hdr"):
        with pytest.raises(ImageFileError, match=name):
            Environment.load(tmp_path / name)
