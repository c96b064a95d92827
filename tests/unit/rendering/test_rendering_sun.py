"""The sun of an environment as a light of a prepared scene."""

from dataclasses import replace

import numpy as np
import pytest

from shapes import unit_icosphere
from skinshade import use_limits
from skinshade.mesh import Mesh
from skinshade.rendering import RenderSettings, open_renderer
from skinshade.scene import Camera, DirectionalLight, Environment, Material, Scene, split_sun

CAMERA = Camera((0.0, 0.0, 700.0), (0.0, 0.0, 0.0), 20.0)
KEY = DirectionalLight.from_angles(-40.0, 25.0, 1.0)
SIZE = (48, 48)


def sunny_sky(**changes):
    """Return a dim sky whose sun is 45° to the right of the camera's back."""
    radiance = np.full((128, 256, 3), 0.2, dtype=np.float32)
    radiance[63:65, 159:161] = 2000.0
    return Environment(radiance, **changes)


@pytest.fixture(scope="module")
def scene():
    u, faces = unit_icosphere(2)
    ball = Mesh.checked(80.0 * u, faces, unit_mm=1.0, normals=u)
    return Scene(ball, CAMERA, Material(), (KEY,), sunny_sky(scale=0.5))


def draw(scene):
    return open_renderer(scene, "cpu").draw(CAMERA, SIZE, 1, RenderSettings())


def test_the_sun_is_the_last_light_and_the_environment_is_without_it(scene):
    prepared = open_renderer(scene, "cpu").prepared
    sun, sky = split_sun(scene.environment)
    assert prepared.lights[0] is KEY
    assert len(prepared.lights) == len(prepared.shadow_maps) == 2
    assert np.array_equal(prepared.lights[1].to_light, sun.to_light)
    assert np.array_equal(prepared.lights[1].irradiance, sun.irradiance)
    assert np.array_equal(prepared.environment.radiance, sky.radiance)
    assert np.allclose(prepared.radiance_sh, sky.radiance_sh())
    assert scene.lights == (KEY,)


def test_a_picture_with_the_sun_is_that_of_the_same_light_and_the_rest_of_the_sky(scene):
    sun, sky = split_sun(scene.environment)
    given = replace(scene, lights=(KEY, sun), environment=replace(sky, extract_sun=False))
    assert np.array_equal(draw(scene), draw(given))


def test_the_sun_stays_in_an_environment_that_does_not_extract_it(scene):
    whole = replace(scene, environment=sunny_sky(extract_sun=False))
    prepared = open_renderer(whole, "cpu").prepared
    assert prepared.lights == (KEY,)
    assert prepared.environment is whole.environment


def test_the_sun_stays_in_the_sky_of_a_scene_with_the_most_lights(scene):
    with use_limits(lights=1):
        prepared = open_renderer(scene, "cpu").prepared
    assert prepared.lights == (KEY,)
    assert prepared.environment is scene.environment


def test_the_background_shows_the_sun(scene):
    behind = DirectionalLight((0.3, 0.15, -1.0), 1.0).to_light
    u = 0.5 + np.arctan2(behind[2], behind[0]) / (2.0 * np.pi)
    row, column = int(np.arccos(behind[1]) / np.pi * 128), int(u * 256)
    radiance = np.full((128, 256, 3), 0.2, dtype=np.float32)
    radiance[row, column] = 5000.0
    sky = Environment(radiance, visible=True)
    wide = Camera(CAMERA.position_mm, CAMERA.target_mm, 60.0)
    renderer = open_renderer(replace(scene, environment=sky), "cpu")
    assert len(renderer.prepared.lights) == 2
    picture = renderer.draw(wide, SIZE, 1, RenderSettings())
    assert picture[picture[..., 3] == 0.0].max() > 100.0
