"""The sun of an environment: its flux, its direction, and skies that have none."""

from dataclasses import replace

import numpy as np
import pytest

import tolerances as tol
from skinshade.scene import Environment, split_sun
from skinshade.scene.equirectangular import grid_directions, row_solid_angle

COLOUR = np.array([1.0, 0.8, 0.4])
"""Ratio of the irradiance of the synthetic sun in red, green and blue."""
SKY = np.array([0.2, 0.3, 0.5])
SIDE = 9
"""Samples along a side of a texel that decide how much of it the sun covers."""


def direction(yaw_deg, pitch_deg):
    yaw, pitch = np.radians([yaw_deg, pitch_deg])
    return np.array([np.cos(pitch) * np.cos(yaw), np.sin(pitch), np.cos(pitch) * np.sin(yaw)])


def solid_angles(height, width):
    return np.repeat(row_solid_angle(height)[:, None] / width, width, axis=1)


def flux(image):
    """Return the integral (3,) of an image over the sphere."""
    return np.tensordot(solid_angles(*image.shape[:2]), np.asarray(image, dtype=np.float64), 2)


def disc(height, width, to_sun, radius_deg=0.9):
    """Return the share of each texel (H, W) that a disc covers, at least one texel."""
    near = grid_directions(height, width) @ to_sun > np.cos(np.radians(radius_deg + 360.0 / width))
    offsets = (np.arange(SIDE) + 0.5) / SIDE - 0.5
    row, column = np.nonzero(near)
    theta = (row[:, None, None] + 0.5 + offsets[:, None]) / height * np.pi
    phi = ((column[:, None, None] + 0.5 + offsets) / width - 0.5) * 2.0 * np.pi
    sine, up = np.sin(theta), np.cos(theta)
    cosine = sine * np.cos(phi) * to_sun[0] + up * to_sun[1] + sine * np.sin(phi) * to_sun[2]
    image = np.zeros((height, width))
    image[row, column] = (cosine > np.cos(np.radians(radius_deg))).mean(axis=(1, 2))
    return image


def sunny(height, width, to_sun, irradiance=3.0):
    """Return an even sky with a sun of an irradiance times `COLOUR`."""
    cover = disc(height, width, to_sun)
    cover *= irradiance / (cover * solid_angles(height, width)).sum()
    return Environment(SKY + cover[..., None] * COLOUR, scale=0.5)


def angle_deg(a, b):
    return np.degrees(2.0 * np.arcsin(0.5 * np.linalg.norm(a - b)))


def test_the_light_of_a_texel_of_equal_width_and_height_is_its_radiance_times_its_solid_angle():
    assert np.isclose(flux(np.ones((40, 80, 3)))[0], 4.0 * np.pi)


@pytest.mark.parametrize(
    ("yaw_deg", "pitch_deg"),
    [(36.0, 10.0), (180.0, 30.0), (179.9, -20.0), (10.0, 90.0), (77.0, 89.2), (-130.0, -88.7)],
    ids=[
        "sky",
        "on the seam",
        "beside the seam",
        "zenith",
        "beside the zenith",
        "beside the nadir",
    ],
)
@pytest.mark.parametrize("height", [256, 512])
def test_a_sun_has_its_irradiance_and_its_direction_everywhere_on_the_sphere(
    yaw_deg, pitch_deg, height
):
    to_sun = direction(yaw_deg, pitch_deg)
    sun, sky = split_sun(sunny(height, 2 * height, to_sun))
    assert np.allclose(sun.irradiance, 0.5 * 3.0 * COLOUR, rtol=tol.SUN_FLUX.value)
    assert angle_deg(sun.to_light, to_sun) <= tol.SUN_DIRECTION_DEG.value
    assert np.abs(sky.radiance - SKY).max() <= tol.FLOAT32.value


@pytest.mark.parametrize("shape", [(54, 108), (64, 128), (100, 300), (128, 256), (1024, 2048)])
def test_a_sun_is_the_same_at_every_resolution_that_resolves_it(shape):
    to_sun = direction(-60.0, 40.0)
    sun, sky = split_sun(sunny(*shape, to_sun))
    assert np.allclose(sun.irradiance, 0.5 * 3.0 * COLOUR, rtol=tol.SUN_FLUX.value)
    # Within a texel, the light has no direction: two discs of 1.8° can have the same image.
    fifth_of_a_texel_deg = 0.2 * max(180.0 / shape[0], 360.0 / shape[1])
    error_deg = angle_deg(sun.to_light, to_sun)
    assert error_deg <= max(tol.SUN_DIRECTION_DEG.value, fifth_of_a_texel_deg)
    assert np.abs(sky.radiance - SKY).max() <= tol.FLOAT32.value


@pytest.mark.parametrize("shape", [(2, 2), (2, 64), (64, 2), (8, 16), (53, 108)])
def test_an_image_that_does_not_resolve_a_sun_has_none(shape):
    image = np.full((*shape, 3), 0.1)
    image[shape[0] // 2, shape[1] // 2] = 1e4
    environment = Environment(image)
    assert split_sun(environment) == (None, environment)


@pytest.mark.parametrize("name", ["black", "even", "studio", "horizon", "noise"])
def test_a_sky_without_a_concentrated_light_has_no_sun(name):
    random = np.random.default_rng(3)
    environment = {
        "black": Environment.constant(0.0),
        "even": Environment(np.full((256, 512, 3), 2.0)),
        "studio": Environment.studio(),
        "horizon": Environment(np.where(grid_directions(128, 256)[..., 1:2] > 0.0, 4.0, [0.1] * 3)),
        "noise": Environment(random.exponential(size=(256, 512, 3))),
    }[name]
    assert split_sun(environment) == (None, environment)


@pytest.mark.parametrize("row", [0, 20, 32])
def test_a_bright_pixel_of_a_coarse_sky_is_no_sun(row):
    """It has 40 times the radiance of the sky, which is .8 % of the light or less."""
    image = np.full((64, 128, 3), 1.0)
    image[row, 40] = 40.0
    assert split_sun(Environment(image))[0] is None


@pytest.mark.parametrize("radius_deg", [3.0, 6.0, 15.0, 40.0])
def test_a_softbox_with_a_hard_edge_is_no_sun(radius_deg):
    cover = disc(256, 512, direction(30.0, 35.0), radius_deg)
    environment = Environment(0.02 + cover[..., None] * 20.0 * COLOUR)
    assert split_sun(environment) == (None, environment)


@pytest.mark.parametrize("share", [0.009, 0.011])
def test_a_sun_has_a_hundredth_of_the_light_or_more(share):
    environment = Environment(np.ones((256, 512, 3)))
    cover = disc(256, 512, direction(0.0, 20.0))
    cover *= 4.0 * np.pi * share / (1.0 - share) / (cover * solid_angles(256, 512)).sum()
    sun, _ = split_sun(replace(environment, radiance=1.0 + cover[..., None] * np.ones(3)))
    assert (sun is not None) == (share > 0.01)


def test_a_sun_beyond_the_irradiance_of_a_light_stays_in_the_sky():
    bright = sunny(128, 256, direction(0.0, 20.0), irradiance=1e4)
    assert split_sun(replace(bright, scale=50.0))[0] is not None
    assert split_sun(replace(bright, scale=200.0))[0] is None


def test_a_bright_pixel_of_a_large_image_does_not_hide_its_sun():
    to_sun = direction(100.0, 25.0)
    environment = sunny(1024, 2048, to_sun)
    image = environment.radiance.copy()
    image[600, 300] = image[0, 7] = 2.0 * image.max()
    sun, _ = split_sun(replace(environment, radiance=image))
    assert angle_deg(sun.to_light, to_sun) <= tol.SUN_DIRECTION_DEG.value


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_sun_and_rest_have_the_light_of_the_environment(seed):
    random = np.random.default_rng(seed)
    to_sun = direction(random.uniform(-180.0, 180.0), random.uniform(-90.0, 90.0))
    environment = sunny(200, 400, to_sun)
    noise = random.uniform(0.5, 1.5, environment.radiance.shape)
    environment = replace(environment, radiance=environment.radiance * noise)
    sun, rest = split_sun(environment)
    total = environment.scale * flux(rest.radiance) + sun.irradiance
    assert np.allclose(total, 0.5 * flux(environment.radiance), rtol=tol.SUN_CONSERVATION.value)


def test_the_rest_keeps_the_other_fields_and_the_environment_is_unchanged():
    environment = replace(sunny(128, 256, direction(0.0, 20.0)), visible=True, extract_sun=False)
    before = environment.radiance.copy()
    _, rest = split_sun(environment)
    assert (rest.scale, rest.visible, rest.extract_sun) == (0.5, True, False)
    assert np.array_equal(environment.radiance, before)


@pytest.mark.parametrize(
    ("name", "shares"),
    [("quarry_01_1k", (0.60, 0.48, 0.26)), ("venice_sunset_1k", (0.07, 0.01, 0.00))],
)
def test_the_suns_of_photographed_skies_have_known_shares_of_the_light(data_dir, name, shares):
    environment = Environment.load(data_dir / "env" / f"{name}.hdr", scale=0.5)
    sun, rest = split_sun(environment)
    total = 0.5 * flux(environment.radiance)
    assert np.allclose(sun.irradiance / total, shares, atol=tol.SUN_SHARE.value)
    conserved = 0.5 * flux(rest.radiance) + sun.irradiance
    assert np.allclose(conserved, total, rtol=tol.SUN_CONSERVATION.value)
    again, _ = split_sun(rest)
    assert again is None


def test_the_sun_of_the_quarry_has_a_known_irradiance(data_dir):
    sun, _ = split_sun(Environment.load(data_dir / "env" / "quarry_01_1k.hdr", scale=0.5))
    digits = np.abs(sun.irradiance - np.array([2.88, 2.00, 0.78])) * 100.0
    assert digits.max() <= tol.PUBLISHED_DIGIT.value
