from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import shading_tolerances as tol
from skinshade._core.errors import ArgumentError
from skinshade.scene import Camera
from skinshade.scene.camera import direction_of, look_at, parallel, perspective
from skinshade.shading.deep_scatter import linear_depth

SEED = st.integers(0, 2**20)
ANGLE = st.floats(-180.0, 180.0)
PITCH = st.floats(-90.0, 90.0)
PLAIN = Camera((0.0, 0.0, 500.0), (0.0, 0.0, 0.0), 30.0)


def projected(camera, points, aspect=1.0):
    matrix = camera.view_projection(aspect)
    clip = np.asarray(points, dtype=float) @ matrix[:, :3].T + matrix[:, 3]
    return clip[..., :3] / clip[..., 3:], clip[..., 3]


def random_camera(seed):
    rng = np.random.default_rng(seed)
    position, target, up = rng.normal(size=(3, 3)) * ([300.0], [50.0], [1.0])
    assume(np.linalg.norm(position - target) > 10.0)
    return Camera(position, target, rng.uniform(5.0, 120.0), up)


@given(SEED)
def test_a_view_is_a_rotation_with_the_eye_at_the_origin_and_the_target_on_the_negative_z_axis(
    seed,
):
    camera = random_camera(seed)
    view = look_at(camera.position_mm, camera.target_mm, camera.up)
    rotation = view[:3, :3]
    assert np.allclose(rotation @ rotation.T, np.eye(3), atol=tol.ROUNDING_SUMS.value)
    assert np.linalg.det(rotation) == pytest.approx(1.0)
    assert np.allclose(view @ [*camera.position_mm, 1.0], [0, 0, 0, 1], atol=1e-9)
    distance = np.linalg.norm(camera.target_mm - camera.position_mm)
    assert np.allclose(view @ [*camera.target_mm, 1.0], [0, 0, -distance, 1], atol=1e-9)
    assert (rotation @ camera.up)[1] > 0.0
    assert abs((rotation @ camera.up)[0]) <= 1e-9


@given(SEED, st.floats(0.3, 3.0))
def test_the_target_is_projected_to_the_middle_and_its_w_is_its_distance(seed, aspect):
    camera = random_camera(seed)
    ndc, w = projected(camera, camera.target_mm, aspect)
    assert np.abs(ndc[:2]).max() <= tol.ROUNDING_SUMS.value
    assert w == pytest.approx(np.linalg.norm(camera.target_mm - camera.position_mm))


@pytest.mark.parametrize("aspect", [0.5, 1.0, 16.0 / 9.0])
@pytest.mark.parametrize("fov", [1.0, 20.0, 90.0, 150.0])
def test_the_field_of_view_covers_the_height_and_the_width_is_aspect_times_it(fov, aspect):
    camera = replace(PLAIN, vertical_fov_deg=fov)
    half = 500.0 * np.tan(np.radians(fov / 2.0))
    points = [[0.0, half, 0.0], [0.0, -half, 0.0], [aspect * half, 0.0, 0.0], [half, 0.0, 0.0]]
    ndc, _ = projected(camera, points, aspect)
    truth = [[0.0, 1.0], [0.0, -1.0], [1.0, 0.0], [1.0 / aspect, 0.0]]
    assert np.allclose(ndc[:, :2], truth, atol=tol.ROUNDING_SUMS.value)


def test_a_point_is_projected_to_its_known_position():
    ndc, w = projected(PLAIN, [30.0, 40.0, 100.0])
    f = 1.0 / np.tan(np.radians(15.0))
    assert w == pytest.approx(400.0)
    assert np.allclose(ndc[:2], [30.0 * f / 400.0, 40.0 * f / 400.0])


@given(SEED)
def test_the_inverse_matrix_returns_the_point_that_was_projected(seed):
    camera = random_camera(seed)
    rng = np.random.default_rng(seed + 1)
    distance = np.linalg.norm(camera.position_mm - camera.target_mm)
    point = camera.target_mm + rng.normal(size=3) * 0.1 * distance
    ndc, w = projected(camera, point, 1.5)
    assume(w > 1.0)
    unprojected = np.linalg.inv(camera.view_projection(1.5)) @ [*ndc, 1.0]
    assert np.allclose(unprojected[:3] / unprojected[3], point, atol=tol.UNPROJECTED_MM.value)


@given(st.floats(0.1, 10.0), st.floats(11.0, 1e4))
def test_depth_is_0_at_the_near_plane_and_1_at_the_far_plane(near, far):
    for matrix in (perspective(40.0, 1.5, near, far), parallel(7.0, near, far)):
        for z, depth in ((near, 0.0), (far, 1.0)):
            clip = matrix @ [0.0, 0.0, -z, 1.0]
            assert clip[2] / clip[3] == pytest.approx(depth, abs=1e-9)
        middle = matrix @ [0.0, 0.0, -10.5, 1.0]
        assert linear_depth(middle[2] / middle[3], matrix) == pytest.approx(10.5, rel=1e-6)


def test_a_parallel_projection_has_the_same_scale_at_every_depth():
    matrix = parallel(50.0, 1.0, 100.0)
    for z in (-1.0, -60.0):
        assert np.allclose((matrix @ [50.0, -25.0, z, 1.0])[[0, 1, 3]], [1.0, -0.5, 1.0])


@given(ANGLE, PITCH)
def test_a_direction_is_a_unit_vector_with_the_given_yaw_and_pitch(yaw, pitch):
    x, y, z = direction_of(yaw, pitch)
    assert np.hypot(np.hypot(x, y), z) == pytest.approx(1.0)
    assert np.degrees(np.arcsin(np.clip(y, -1.0, 1.0))) == pytest.approx(pitch, abs=1e-5)
    if abs(pitch) < 89.0:
        difference = (np.degrees(np.arctan2(x, z)) - yaw + 180.0) % 360.0 - 180.0
        assert difference == pytest.approx(0.0, abs=1e-6)


def test_yaw_turns_from_the_front_to_the_left_side_of_the_face_and_pitch_upwards():
    assert np.allclose(direction_of(0.0, 0.0), [0.0, 0.0, 1.0])
    assert np.allclose(direction_of(90.0, 0.0), [1.0, 0.0, 0.0])
    assert np.allclose(direction_of(33.0, 90.0), [0.0, 1.0, 0.0])


@given(ANGLE, PITCH, st.floats(1.0, 1e4), SEED)
def test_a_camera_in_orbit_has_its_distance_and_looks_at_its_target(yaw, pitch, distance, seed):
    target = np.random.default_rng(seed).normal(size=3) * 100.0
    camera = Camera.orbit(target, distance, yaw_deg=yaw, pitch_deg=pitch, vertical_fov_deg=25.0)
    offset = camera.position_mm - target
    assert np.linalg.norm(offset) == pytest.approx(distance)
    assert np.allclose(offset / distance, direction_of(yaw, pitch), atol=1e-9)
    assert np.array_equal(camera.target_mm, target)
    assert camera.vertical_fov_deg == 25.0
    assert np.isfinite(camera.view_projection(1.0)).all(), "also for pitches of ±90°"


@given(ANGLE, ANGLE, st.floats(-80.0, 80.0))
def test_orbited_adds_to_the_yaw(yaw, turn, pitch):
    def orbit(yaw_deg):
        return Camera.orbit((1.0, 2.0, 3.0), 400.0, yaw_deg=yaw_deg, pitch_deg=pitch)

    turned = orbit(yaw).orbited(turn)
    assert np.allclose(turned.position_mm, orbit(yaw + turn).position_mm, atol=1e-9)
    assert np.allclose(turned.orbited(-turn).position_mm, orbit(yaw).position_mm, atol=1e-9)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"position_mm": (0.0, 1.0)}, r"camera position_mm: shape is \(2,\)"),
        ({"target_mm": (0.0, np.nan, 0.0)}, r"camera target_mm\[1\] is nan"),
        ({"up": (0.0, np.inf, 0.0)}, r"camera up\[1\] is inf"),
        ({"position_mm": (0.0, 0.0, 0.0)}, "position and target are both"),
        ({"up": (0, 0, 0)}, "camera up is 0, 0, 0; it must be a direction"),
        ({"position_mm": "far"}, "camera position_mm: not an array of numbers"),
        ({"vertical_fov_deg": 0.5}, r"camera vertical_fov_deg is 0.5; .*\[1, 150\]"),
        ({"vertical_fov_deg": 151.0}, r"camera vertical_fov_deg is 151"),
        ({"vertical_fov_deg": np.nan}, "camera vertical_fov_deg is nan"),
    ],
)
def test_a_wrong_value_of_a_camera_is_an_error_that_names_it(change, message):
    with pytest.raises(ArgumentError, match=message):
        replace(PLAIN, **change)
