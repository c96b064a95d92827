from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import shading_tolerances as tol
from skinshade._core.errors import ArgumentError
from skinshade.scene import DirectionalLight, SpotLight
from skinshade.scene.camera import direction_of

SEED = st.integers(0, 2**20)
SPOT = SpotLight((0.0, 0.0, 100.0), (0.0, 0.0, 0.0), (1.0, 2.0, 3.0), 30.0)
SUN = DirectionalLight((1.0, 2.0, 2.0), (1.0, 2.0, 3.0))


def points(seed, count=20, scale=100.0):
    return np.random.default_rng(seed).normal(size=(count, 3)) * scale


@given(SEED)
def test_a_directional_light_is_the_same_at_every_position(seed):
    to_light, irradiance = SUN.at(points(seed))
    assert np.allclose(to_light, [1 / 3, 2 / 3, 2 / 3], rtol=tol.ROUNDING.value)
    assert (irradiance == [1.0, 2.0, 3.0]).all()
    assert to_light.shape == irradiance.shape == (20, 3)


def test_from_angles_gives_a_white_light_of_irradiance_pi_times_the_intensity():
    light = DirectionalLight.from_angles(30.0, 20.0, 1.0)
    assert np.allclose(light.to_light, direction_of(30.0, 20.0), atol=tol.ROUNDING.value)
    assert np.allclose(light.irradiance, np.pi), "a white Lambert surface has radiance 1"
    dim = DirectionalLight.from_angles(30.0, 20.0, 0.25)
    assert np.allclose(4.0 * dim.irradiance, light.irradiance)


def test_one_number_is_a_white_irradiance():
    assert DirectionalLight((0, 0, 1), 2.0).irradiance.tolist() == [2.0, 2.0, 2.0]
    assert replace(SPOT, irradiance=2.0).irradiance.tolist() == [2.0, 2.0, 2.0]


def test_a_spot_light_has_its_irradiance_at_its_target():
    to_light, irradiance = SPOT.at(np.zeros((1, 3)))
    assert np.allclose(to_light, [[0.0, 0.0, 1.0]])
    assert np.allclose(irradiance, [[1.0, 2.0, 3.0]])


@given(st.floats(1.0, 1e4), st.floats(0.0, 20.0), st.floats(0.0, 360.0))
def test_irradiance_along_a_ray_falls_with_the_square_of_the_distance(distance, off_axis, around):
    angle, turn = np.radians([off_axis, around])
    ray = np.array([np.sin(angle) * np.cos(turn), np.sin(angle) * np.sin(turn), -np.cos(angle)])
    at = SPOT.position_mm + distance * ray
    to_light, irradiance = SPOT.at(at[None])
    assert np.allclose(to_light, -ray, atol=tol.ROUNDING_SUMS.value)
    truth = np.array([1.0, 2.0, 3.0]) * (100.0 / distance) ** 2
    assert np.allclose(irradiance, truth, rtol=tol.ROUNDING_SUMS.value)


def cone(degrees):
    """Return irradiance (N,) at angles off the axis, 50 mm from the light, over that on the axis."""
    angle = np.radians(degrees)
    ray = np.stack([np.sin(angle), 0.0 * angle, -np.cos(angle)], axis=-1)
    return SPOT.at(SPOT.position_mm + 50.0 * ray)[1][:, 0] / 4.0


def test_irradiance_is_full_within_four_fifths_of_the_cone_and_0_outside_it():
    inside, outside = np.linspace(0.0, 23.99, 50), np.linspace(30.01, 180.0, 50)
    assert np.allclose(cone(inside), 1.0, rtol=tol.ROUNDING_SUMS.value)
    assert not cone(outside).any()


def test_irradiance_falls_smoothly_at_the_edge_of_the_cone():
    degrees = np.linspace(20.0, 34.0, 2801)
    slope = np.gradient(cone(degrees), degrees)
    assert slope.max() <= tol.ROUNDING_SUMS.value
    assert np.abs(np.diff(slope)).max() <= tol.CONE_KINK.value, "no kink at either end"
    assert slope.min() == pytest.approx(-1.5 / 6.0, rel=0.1), "a smoothstep over six degrees"


@given(SEED)
def test_a_rotation_of_light_and_points_rotates_the_directions(seed):
    q = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))[0]
    at = points(seed, scale=40.0)
    to_light, irradiance = SPOT.at(at)
    rotated = SpotLight(q @ SPOT.position_mm, q @ SPOT.target_mm, SPOT.irradiance, 30.0)
    to_rotated, rotated_irradiance = rotated.at(at @ q.T)
    assert np.allclose(to_rotated, to_light @ q.T, atol=tol.ROUNDING_SUMS.value)
    assert np.allclose(rotated_irradiance, irradiance, atol=tol.CONE_ROUNDING.value)


def test_a_spot_light_is_finite_at_its_own_position():
    to_light, irradiance = SPOT.at(SPOT.position_mm[None])
    assert np.isfinite(to_light).all()
    assert np.isfinite(irradiance).all()


def on_map(light, at, centre, radius):
    """Return positions on the shadow map (N, 3), normalised, and in the view (N, 3), mm."""
    view, projection = light.view_and_projection(centre, radius)
    in_view = at @ view[:3, :3].T + view[:3, 3]
    clip = in_view @ projection[:, :3].T + projection[:, 3]
    return clip[:, :3] / clip[:, 3:], in_view


@given(SEED, st.floats(1.0, 500.0))
def test_the_shadow_map_of_a_directional_light_contains_the_whole_body(seed, radius):
    rng = np.random.default_rng(seed)
    sun = DirectionalLight(rng.normal(size=3), 1.0)
    centre = rng.normal(size=3) * 100.0
    on_sphere = rng.normal(size=(200, 3))
    on_sphere /= np.linalg.norm(on_sphere, axis=1)[:, None]
    ndc, in_view = on_map(sun, centre + radius * on_sphere, centre, radius)
    assert np.abs(ndc[:, :2]).max() < 1.0
    assert ndc[:, 2].min() > 0.0
    assert ndc[:, 2].max() < 1.0
    # Points nearer to the light are nearer on the map.
    assert np.allclose(
        np.diff(in_view[:, 2]), np.diff(radius * on_sphere @ sun.to_light), atol=1e-7
    )


@pytest.mark.parametrize("to_light", [(0, 1, 0), (0, -1, 0), (0, 0, 1), (1, 0, 0)])
def test_a_directional_light_may_come_from_any_direction(to_light):
    ndc, _ = on_map(DirectionalLight(to_light, 1.0), np.array([[3.0, -4.0, 5.0]]), np.zeros(3), 9.0)
    assert np.isfinite(ndc).all()
    assert np.abs(ndc[:, :2]).max() < 1.0


@given(SEED)
def test_the_shadow_map_of_a_spot_light_contains_the_points_that_it_lights(seed):
    at = points(seed, 400)
    at *= 94.0 / np.maximum(np.linalg.norm(at, axis=1), 94.0)[:, None]
    lit = SPOT.at(at)[1].any(axis=1)
    ndc, in_view = on_map(SPOT, at, np.zeros(3), 95.0)
    assert np.abs(ndc[lit, :2]).max() <= 1.0
    assert (in_view[lit, 2] < 0.0).all()
    assert ndc[lit, 2].max() < 1.0


@pytest.mark.parametrize(
    ("build", "message"),
    [
        (lambda: DirectionalLight((0, 0, 0), 1.0), "light to_light is 0, 0, 0"),
        (lambda: DirectionalLight((0, 1), 1.0), r"light to_light: shape is \(2,\)"),
        (lambda: DirectionalLight((0, np.nan, 1), 1.0), r"light to_light\[1\] is nan"),
        (lambda: DirectionalLight((0, 0, 1), (1, -2, 1)), r"light irradiance\[1\] is -2.0"),
        (lambda: DirectionalLight((0, 0, 1), (1, 2)), r"light irradiance: shape is \(2,\)"),
        (lambda: DirectionalLight.from_angles(0.0, 0.0, -1.0), "light irradiance"),
        (lambda: DirectionalLight.from_angles(np.nan, 0.0, 1.0), "yaw_deg is nan"),
        (lambda: replace(SPOT, target_mm=(0, 0, 100)), "light: position and target are both"),
        (lambda: replace(SPOT, position_mm=(0, np.inf, 0)), r"light position_mm\[1\] is inf"),
        (lambda: replace(SPOT, cone_deg=0.5), r"light cone_deg is 0.5; .*\[1, 80\]"),
        (lambda: replace(SPOT, cone_deg=81.0), "light cone_deg is 81"),
        (lambda: replace(SPOT, irradiance=np.inf), "light irradiance is inf"),
    ],
)
def test_a_wrong_value_of_a_light_is_an_error_that_names_it(build, message):
    with pytest.raises(ArgumentError, match=message):
        build()


@pytest.mark.parametrize(("yaw", "pitch"), [(0.0, 0.0), (90.0, 0.0), (-150.0, 40.0), (10.0, -80.0)])
def test_a_turned_light_keeps_its_angle_to_the_camera(yaw, pitch):
    light = DirectionalLight.from_angles(-38.0, 26.0, 1.0)
    front = direction_of(0.0, 0.0)
    turned = light.turned(yaw, pitch)
    assert turned.to_light @ direction_of(yaw, pitch) == pytest.approx(light.to_light @ front)
    assert np.linalg.norm(turned.to_light) == pytest.approx(1.0)
    # In the picture, the light stays on its side: right and up of the camera turn alike.
    right = direction_of(yaw + 90.0, 0.0)
    assert turned.to_light @ right == pytest.approx(light.to_light @ direction_of(90.0, 0.0))
