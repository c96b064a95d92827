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
    """Return the directions (H, W, 3) of the centres of texels, and their solid angles (H, W)."""
    theta = (np.arange(height) + 0.5) / height * np.pi
    phi = ((np.arange(width) + 0.5) / width - 0.5) * 2.0 * np.pi
    sine = np.sin(theta)[:, None]
    up = np.broadcast_to(np.cos(theta)[:, None], (height, width))
    edges = np.cos(np.arange(height + 1) / height * np.pi)
    solid = np.repeat((edges[:-1] - edges[1:])[:, None], width, axis=1) * 2.0 * np.pi / width
    return np.stack([sine * np.cos(phi), up, sine * np.sin(phi)], axis=-1), solid


def grey(image):
    return np.repeat(np.asarray(image, dtype=np.float32)[..., None], 3, axis=-1)


def mean(image):
    return np.tensordot(grid(*image.shape[:2])[1], image.astype(float), 2) / (4.0 * np.pi)


def directions(seed, count=50):
    v = np.random.default_rng(seed).normal(size=(count, 3))
    return v / np.linalg.norm(v, axis=1)[:, None]


def irradiance(environment, normals):
    return np.pi * ambient_irradiance(
        environment.radiance_sh(), np.repeat(normals[:, None], 3, axis=1)
    )


@pytest.fixture(scope="module")
def studio():
    return Environment.studio()


@pytest.fixture(scope="module")
def reflections(studio):
    return studio.preconvolved()


def test_a_constant_sky_has_one_harmonic_and_an_irradiance_of_pi_times_its_radiance():
    constant = Environment.constant((0.5, 1.0, 2.0))
    harmonics = constant.radiance_sh()
    band0 = np.sqrt(4.0 * np.pi) * np.array([0.5, 1.0, 2.0])
    assert np.allclose(harmonics[0], band0, rtol=tol.ROUNDING_SUMS.value)
    assert np.abs(harmonics[1:]).max() <= tol.EVEN_SKY.value
    truth = np.pi * np.array([0.5, 1.0, 2.0])
    assert np.allclose(irradiance(constant, directions(1)), truth, rtol=tol.EVEN_SKY.value)


@given(SEED)
def test_the_irradiance_of_a_small_sun_is_the_sum_over_the_harmonics_of_its_direction(seed):
    """Σ Y(d)Y(s) over nine harmonics is a sum of Legendre polynomials, (1 + 3x + 5(3x²−1)/2)/4π."""
    rng = np.random.default_rng(seed)
    row, column = rng.integers(2, 126), rng.integers(0, 256)
    image = np.zeros((128, 256))
    image[row, column] = 100.0
    texels, solid_angle = grid(128, 256)
    flux, sun = 100.0 * solid_angle[row, column], texels[row, column]
    d = directions(seed)
    x = d @ sun
    truth = (np.pi + 2.0 * np.pi * x + np.pi / 4.0 * 5.0 * (1.5 * x * x - 0.5)) / (4.0 * np.pi)
    result = irradiance(Environment(grey(image)), d)[:, 0]
    assert np.allclose(
        result, flux * np.maximum(truth, 0.0), rtol=1e-6, atol=tol.EVEN_SKY.value * flux
    )


@given(SEED)
def test_the_irradiance_of_a_wide_light_is_that_of_a_sum_over_all_texels(seed):
    axis = directions(seed, 1)[0]
    texels, solid_angle = grid(64, 128)
    image = np.maximum(texels @ axis, 0.0)
    n = directions(seed + 1)
    truth = np.maximum(n @ texels.reshape(-1, 3).T, 0.0) @ (image * solid_angle).ravel()
    result = irradiance(Environment(grey(image)), n)[:, 0]
    assert np.abs(result - truth).max() <= tol.COSINE_LOBE.value * truth.max()


@given(SEED, st.integers(2, 300), st.integers(2, 600))
def test_the_total_light_of_small_suns_is_kept_at_every_size_of_image(seed, height, width):
    rng = np.random.default_rng(seed)
    image = np.zeros((height, width))
    for row, column in ((rng.integers(height), rng.integers(width)), (-1, -1), (0, -1)):
        image[row, column] += 1.0 / grid(height, width)[1][row, column]
    band0 = Environment(grey(image)).radiance_sh()[0, 0] * np.sqrt(4.0 * np.pi)
    assert band0 == pytest.approx(3.0, rel=tol.SUN_KEPT.value)


def test_a_sample_in_the_direction_of_a_texel_is_its_radiance():
    """u = ½ + atan2(z, x)/2π, v = acos(y)/π from the top."""
    axes = np.array([[1.0, 0, 0], [0, 0, 1], [-1, 0, 1e-9], [0, 0, -1], [0, 1, 0], [0, -1, 0]])
    u, v = equirectangular_uv(axes)
    assert np.allclose(u[:4], [0.5, 0.75, 1.0, 0.25])
    assert np.allclose(v, [0.5, 0.5, 0.5, 0.5, 0.0, 1.0])
    image = np.random.default_rng(3).random((8, 16, 3)).astype(np.float32)
    sampled = Environment(image, scale=2.0).sample(grid(8, 16)[0])
    assert np.allclose(sampled, 2.0 * image, atol=tol.BILINEAR.value)


def test_samples_are_continuous_across_the_seam():
    image = np.random.default_rng(4).random((8, 16, 3)).astype(np.float32)
    seam = np.array([[-1.0, 0.2, 1e-12], [-1.0, 0.2, -1e-12]])
    seam /= np.linalg.norm(seam, axis=1)[:, None]
    one, other = Environment(image).sample(seam)
    assert np.allclose(one, other, atol=tol.BILINEAR.value)


@pytest.mark.parametrize("power", LOBE_POWERS)
def test_preconvolution_keeps_the_mean(studio, reflections, power):
    level = reflections.levels[LOBE_POWERS.index(power)]
    assert np.allclose(mean(level), mean(studio.radiance), rtol=tol.LEVEL_MEAN.value)


@pytest.mark.parametrize("power", LOBE_POWERS)
def test_the_reflection_of_a_constant_sky_is_constant(power):
    constant = Environment.constant(2.0).preconvolved()
    sampled = constant.sample(directions(5), np.full(50, power))
    assert np.abs(sampled / 2.0 - 1.0).max() <= tol.EVEN_REFLECTION.value


@pytest.mark.parametrize("power", LOBE_POWERS[:4])
def test_a_reflection_is_the_mean_over_a_phong_lobe(studio, reflections, power):
    texels, solid_angle = grid(*studio.radiance.shape[:2])
    d = directions(6)
    weight = np.maximum(d @ texels.reshape(-1, 3).T, 0.0) ** power * solid_angle.ravel()
    truth = weight @ studio.radiance.reshape(-1, 3).astype(float)
    truth /= weight.sum(axis=1, keepdims=True)
    error = np.abs(reflections.sample(d, np.full(50, power)) - truth).max() / studio.radiance.max()
    assert error <= tol.PHONG_LOBE.value * power


@given(SEED, st.floats(0.0, 4.0))
def test_reflections_are_interpolated_between_powers_and_constant_beyond_them(
    reflections, seed, level
):
    d = directions(seed, 5)
    sample = reflections.sample
    low = int(min(level, 3.0))
    ends = [sample(d, np.full(5, 4.0**k)) for k in (low, low + 1)]
    truth = ends[0] + (level - low) * (ends[1] - ends[0])
    assert np.allclose(sample(d, np.full(5, 4.0**level)), truth, atol=1e-6)
    assert np.array_equal(sample(d, np.full(5, 0.1)), sample(d, np.full(5, 1.0)))
    assert np.array_equal(sample(d, np.full(5, 1e4)), sample(d, np.full(5, 256.0)))


def test_scale_multiplies_harmonics_samples_and_reflections(studio, reflections):
    half = replace(studio, scale=0.5)
    d = directions(7)
    assert np.allclose(half.radiance_sh(), 0.5 * studio.radiance_sh())
    assert np.allclose(half.sample(d), 0.5 * studio.sample(d))
    power = np.full(50, 16.0)
    halved = half.preconvolved().sample(d, power)
    assert np.allclose(halved, 0.5 * reflections.sample(d, power), rtol=1e-5)


def test_the_key_light_of_the_studio_is_at_the_upper_left_with_a_plausible_irradiance(studio):
    assert np.isfinite(studio.radiance).all()
    assert studio.radiance.min() > 0.0
    key, other, below = irradiance(
        studio, np.array([[-0.62, 0.45, 0.64], [0.62, 0.45, 0.64], [0.0, -1.0, 0.0]])
    )
    assert (key > 1.8 * other).all()
    assert (other > below).all()
    assert 0.5 < key.mean() / np.pi < 2.0


def test_an_environment_from_a_file_has_its_radiance_without_negative_values(tmp_path):
    image = np.random.default_rng(8).random((16, 32, 3)).astype(np.float32)
    write_exr(tmp_path / "sky.exr", image)
    loaded = Environment.load(tmp_path / "sky.exr", scale=0.3, visible=True)
    assert np.array_equal(loaded.radiance, image)
    assert (loaded.scale, loaded.visible) == (0.3, True)
    write_exr(tmp_path / "dark.exr", image - 0.5)
    dark = Environment.load(tmp_path / "dark.exr")
    assert np.array_equal(dark.radiance, np.maximum(image - 0.5, 0.0))


@pytest.mark.parametrize(
    ("radiance", "message"),
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
def test_an_array_that_is_no_radiance_is_an_error_that_says_why(radiance, message):
    with pytest.raises(ArgumentError, match=message):
        Environment(radiance)


@pytest.mark.parametrize(
    ("radiance", "message"),
    [
        ([1, 2], r"environment radiance: shape is \(2,\)"),
        (np.ones((16, 32, 3)), "environment radiance: shape"),
        ([1, -2, 1], r"environment radiance\[1\] is -2"),
        (np.nan, "environment radiance is nan"),
        ("bright", "environment radiance: not an array of numbers"),
    ],
)
def test_a_constant_that_is_no_colour_is_an_error_that_says_why(radiance, message):
    with pytest.raises(ArgumentError, match=message):
        Environment.constant(radiance)


def test_a_wrong_scale_or_file_is_an_error_that_names_it(tmp_path):
    for scale in (-1.0, np.nan):
        with pytest.raises(ArgumentError, match="environment scale is"):
            Environment.constant(1.0, scale=scale)
    (tmp_path / "noise.hdr").write_bytes(b"no light")
    for name in ("noise.hdr", "gone.hdr"):
        with pytest.raises(ImageFileError, match=name):
            Environment.load(tmp_path / name)
