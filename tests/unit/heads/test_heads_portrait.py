import numpy as np
import pytest

import shading_tolerances as tol
from skinshade.heads import Head, builtin_head, head_scene
from skinshade.heads.portrait import portrait_camera
from skinshade.mesh import Mesh
from skinshade.scene import Environment, Material


@pytest.fixture(scope="module")
def head():
    return builtin_head()


@pytest.mark.parametrize("aspect", [1.0, 16.0 / 9.0])
@pytest.mark.parametrize("yaw", [0.0, 28.0, -90.0])
def test_a_portrait_shows_the_whole_head_and_little_around_it(head, aspect, yaw):
    scene = head_scene(head, yaw_deg=yaw)
    p = scene.mesh.positions_mm
    matrix = scene.camera.view_projection(aspect)
    clip = p @ matrix[:, :3].T + matrix[:, 3]
    x, y = (clip[:, :2] / clip[:, 3:]).T
    skull = p[:, 1] > -100.0  # above the chin
    assert np.abs(x[skull]).max() < 1.0
    assert np.abs(y[skull]).max() < 1.0
    assert y.max() > 0.7


def test_a_portrait_has_a_key_light_and_a_studio_by_default(head):
    scene = head_scene(head)
    assert scene.mesh is head.mesh
    assert scene.material is head.material
    (light,) = scene.lights
    assert light.to_light[0] < 0.0 < light.to_light[1], "from the upper left"
    studio = Environment.studio(scale=0.55)
    assert np.array_equal(scene.environment.radiance, studio.radiance)
    assert scene.environment.scale == studio.scale


def test_a_portrait_takes_other_lights_environments_and_backgrounds(head):
    even = Environment.constant(1.0)
    scene = head_scene(head, lights=(), environment=even, background=(1, 2, 3))
    assert scene.lights == ()
    assert scene.environment is even
    assert scene.background.tolist() == [1.0, 2.0, 3.0]


@pytest.mark.parametrize(("yaw", "pitch"), [(0.0, 0.0), (28.0, 4.0), (-120.0, -30.0)])
def test_the_camera_of_a_portrait_has_the_yaw_and_the_pitch(head, yaw, pitch):
    camera = portrait_camera(head.mesh, yaw, pitch)
    x, y, z = camera.position_mm - camera.target_mm
    assert np.degrees(np.arctan2(x, z)) == pytest.approx(yaw, abs=tol.ROUNDING_SUMS.value)
    elevation = np.degrees(np.arctan2(y, np.hypot(x, z)))
    assert elevation == pytest.approx(pitch, abs=tol.ROUNDING_SUMS.value)


def test_shoulders_do_not_change_the_frame_of_a_head():
    """Points far below the head leave the camera where it is."""
    corners = np.array([[x, y, z] for x in (-70, 70) for y in (0, 250) for z in (-100, 100)])
    faces = [[0, 1, 2], [3, 2, 1], [4, 5, 6], [7, 6, 5]]
    shoulders = [[-300, -400, 0], [300, -400, 0], [0, -200, 50]]
    bust = Mesh.checked([*corners, *shoulders], [*faces, [8, 9, 10]], unit_mm=1.0)
    head = Mesh.checked(corners, faces, unit_mm=1.0)
    cameras = [head_scene(Head(mesh, Material())).camera for mesh in (head, bust)]
    assert np.allclose(cameras[0].position_mm, cameras[1].position_mm)
    assert np.allclose(cameras[0].target_mm, cameras[1].target_mm)
