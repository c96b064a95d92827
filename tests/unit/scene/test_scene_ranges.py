"""Ranges of a scene: values whose products would overflow are refused by name; the ends are accepted."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from test_scene_json import MINIMAL, write_files

import shapes
from skinshade._core.arrays import LARGEST_LIGHT, LARGEST_POSITION, LARGEST_RADIANCE
from skinshade._core.errors import ArgumentError, ImageFileError, SceneFileError
from skinshade._core.limits import use_limits
from skinshade._core.pixels import write_pixels
from skinshade.mesh import Mesh
from skinshade.params import SkinParams
from skinshade.profile import Profile
from skinshade.scene import (
    Camera,
    DirectionalLight,
    Environment,
    Material,
    Scene,
    SpotLight,
    load_scene,
)
from skinshade.scene.maps import read_normal_map, scale_slopes
from skinshade.scene.scene import LARGEST_CURVATURE_PER_MM, LARGEST_UV

SUN = DirectionalLight((0, 0, 1), 3.0)
CAMERA = Camera((0, 0, 700), (0, 0, 0))


def ball(**changes):
    sphere = shapes.sphere("icosphere", 1, 80.0)
    mesh = Mesh.checked(
        sphere.positions, sphere.faces, unit_mm=1.0, uvs=sphere.positions[:, :2] / 200.0
    )
    return replace(mesh, **changes)


def scene(**changes):
    return replace(Scene(ball(), CAMERA, Material(), (SUN,)), **changes)


def constant(*values):
    return np.array([[values]], dtype=np.float32)


def burley(length_mm=1.0, albedo=0.5):
    return Profile.burley(length_mm=length_mm, kind="shape", albedo=albedo)


BEYOND = {
    "camera position": (
        lambda: Camera((0, 0, 1e308), (0, 0, 0)),
        r"camera position_mm\[0, 2\] is 1e\+308",
    ),
    "camera target": (
        lambda: Camera((0, 0, 0), (-2e15, 0, 0)),
        r"camera target_mm\[0, 0\] is -2000000000000000",
    ),
    "camera distance": (lambda: Camera((0, 0, 1e-200), (0, 0, 0)), "1e-200 mm apart"),
    "camera far away": (
        lambda: Camera((1e15, 0, 1), (1e15, 0, 0)),
        "1 mm apart at coordinates up to 1e",
    ),
    "camera orbit": (lambda: Camera.orbit((0, 0, 0), 1e300), r"distance_mm is 1e\+300"),
    "camera orbit of 0": (lambda: Camera.orbit((0, 0, 0), 0.0), r"distance_mm is 0.0"),
    "camera yaw": (lambda: Camera.orbit((0, 0, 0), 1.0, yaw_deg=np.inf), "yaw_deg is inf"),
    "field of view of 0": (lambda: replace(CAMERA, vertical_fov_deg=0.0), r"\[1, 150\]"),
    "field of view of 180": (lambda: replace(CAMERA, vertical_fov_deg=180.0), r"\[1, 150\]"),
    "irradiance": (
        lambda: DirectionalLight((0, 0, 1), 2e6),
        r"light irradiance is 2000000.0; .*1e\+06",
    ),
    "intensity": (
        lambda: DirectionalLight.from_angles(0, 0, 1e300),
        r"light irradiance\[0\] is 3.14",
    ),
    "intensity of infinity": (
        lambda: DirectionalLight.from_angles(0, 0, 1e308 * 10),
        "intensity is inf",
    ),
    "spot position": (
        lambda: SpotLight((0, 0, 1e16), (0, 0, 0), 1.0),
        r"light position_mm\[0, 2\]",
    ),
    "spot distance": (lambda: SpotLight((0, 0, 1e-10), (0, 0, 0), 1.0), "1e-10 mm apart"),
    "spot at 1 mm": (
        lambda: SpotLight((0, 0, 1e13), (0, 0, 0), 1.0),
        r"irradiance is 1e\+26 at 1 mm",
    ),
    "environment scale": (lambda: Environment.studio(scale=1e308), r"scale is 1e\+308; .*1e\+06"),
    "environment radiance": (
        lambda: Environment.constant(2e9),
        r"radiance is 2000000000.0; .*1e\+09",
    ),
    "environment image": (
        lambda: Environment(np.full((2, 2, 3), 2e9, np.float32)),
        "reach from 2e.* to 2e",
    ),
    "background": (
        lambda: scene(background=(1e300, 0, 0)),
        r"background\[0\] is 1e\+300; .*1e\+06",
    ),
    "exposure": (lambda: scene(exposure=1e300), r"exposure is 1e\+300; .*1e\+06"),
    "positions": (
        lambda: scene(mesh=ball(unit_mm=1e14)),
        r"mesh: positions_mm\[\d+, \d\] is .*1e\+15",
    ),
    "UVs": (lambda: scene(mesh=ball(uvs=ball().uvs * 1e30)), r"mesh: uvs\[0, 0\] is"),
    "curvature": (
        lambda: scene(mesh=ball(attributes={"curvature": np.full(42, 1e30)})),
        r"mesh: curvature\[0\] is 1e\+30",
    ),
    "shape operator": (
        lambda: scene(mesh=ball(attributes={"tensor": np.zeros((42, 3))})),
        r"mesh: tensor: shape is \(42, 3\)",
    ),
    "albedo map": (lambda: Material(albedo=constant(0, 1e38, 0)), r"material albedo: .*channel 1"),
    "normal map": (lambda: Material(normal=constant(0, 0, 2)), r"material normal: .*channel 2"),
    "gloss map": (lambda: Material(specular=constant(1, 1000)), r"material specular: .*channel 1"),
    "reflectance map": (lambda: Material(specular=constant(1e38, 0)), r"\[0, 10\] in channel 0"),
    "tint map": (lambda: Material(deep_scatter=constant(-1e38, 0, 0)), "material deep_scatter"),
    "albedo of 0": (lambda: Material(burley(albedo=0.0)), r"profile: albedo\[0\] is 0.0"),
    "albedo of almost 1": (
        lambda: Material(burley(albedo=0.99999)),
        r"profile: albedo\[0\] is 0.99999",
    ),
    "radius of 0": (lambda: Material(burley(1e-300)), r"scaled rms_radius_mm\[0\] is 0.0"),
    "radius of a house": (lambda: Material(burley(1e4)), r"scaled rms_radius_mm\[0\] is 37416"),
    "scaled radius": (
        lambda: Material(burley(1e3), SkinParams(scatter_scale=20.0)),
        r"scaled rms_radius_mm\[0\] is 74833",
    ),
}
WITHIN = {
    "camera": lambda: Camera((0, 0, LARGEST_POSITION), (0, 0, -LARGEST_POSITION)),
    "camera close to its target": lambda: Camera((0, 0, 1e-9), (0, 0, 0)),
    "irradiance": lambda: DirectionalLight((0, 0, 1), LARGEST_LIGHT),
    "spot": lambda: SpotLight((0, 0, 1e9), (0, 0, 0), LARGEST_LIGHT),
    "environment": lambda: Environment.constant(LARGEST_RADIANCE, scale=LARGEST_LIGHT),
    "background and exposure": lambda: scene(background=LARGEST_LIGHT, exposure=LARGEST_LIGHT),
    "UVs": lambda: scene(mesh=ball(uvs=np.full((42, 2), LARGEST_UV))),
    "curvature": lambda: scene(
        mesh=ball(attributes={"curvature": np.full(42, -LARGEST_CURVATURE_PER_MM)})
    ),
    "maps": lambda: Material(
        albedo=constant(-1e3, 0, 1e3), normal=constant(-1, 1, 1), specular=constant(10, 1)
    ),
    "profile": lambda: Material(burley(1e-5, 1e-4)),
}


@pytest.mark.parametrize("name", BEYOND)
def test_a_value_beyond_its_range_is_refused_by_name(name):
    make, message = BEYOND[name]
    with pytest.raises(ArgumentError, match=message):
        make()


@pytest.mark.parametrize("name", WITHIN)
def test_the_ends_of_the_ranges_are_accepted(name):
    assert WITHIN[name]()


@pytest.mark.parametrize("factor", [1e-320, 1e-200, 1.0, 1e200, 1e308])
def test_directions_of_any_length_are_normalised(factor):
    direction = np.array([0.0, 0.5, -1.0]) * factor
    expected = np.array([0.0, 1.0, -2.0]) / np.sqrt(5.0)
    light, camera = DirectionalLight(direction, 1.0), replace(CAMERA, up=direction)
    assert np.allclose(light.to_light, expected, atol=1e-2 if factor < 1e-300 else 1e-12)
    assert np.allclose(camera.up, expected, atol=1e-2 if factor < 1e-300 else 1e-12)
    assert np.isfinite(camera.view_projection(1.5)).all()


def test_a_scene_has_a_limited_number_of_lights():
    assert len(scene(lights=(SUN,) * 32).lights) == 32
    with pytest.raises(
        ArgumentError, match=r"scene: 33 lights; the limit lights is 32 .--limit lights=33"
    ):
        scene(lights=(SUN,) * 33)
    with use_limits(lights=33):
        assert len(scene(lights=(SUN,) * 33).lights) == 33


# -- files -----------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return write_files(tmp_path_factory.mktemp("ranges"))


def read(folder, **changes):
    (folder / "changed.json").write_text(json.dumps(MINIMAL | changes))
    return load_scene(folder / "changed.json")


def test_a_scene_file_with_a_thousand_lights_is_refused_by_name(folder):
    light = {"kind": "sun", "to_light": [0, 0, 1], "irradiance": [1, 1, 1]}
    with pytest.raises(
        SceneFileError, match=r"changed\.json: scene: 1000 lights; the limit lights"
    ):
        read(folder, lights=[light] * 1000)
    enabled = [light | {"enabled": index < 2} for index in range(1000)]
    assert len(read(folder, lights=enabled).lights) == 2


def test_a_scene_file_with_a_thousand_gaussians_is_refused_by_name(folder):
    profile = {"kind": "gaussians", "albedo": [0.5, 0.5, 0.5]}
    profile |= {"variances_mm2": [1.0] * 1000, "weights": [[1, 1, 1]] * 1000}
    with pytest.raises(
        SceneFileError, match=r"material\.profile: 1000 Gaussians; the limit gaussians"
    ):
        read(folder, material={"profile": profile})


def test_a_scene_file_beyond_the_size_of_json_is_refused_before_it_is_read(folder):
    with (
        use_limits(json_bytes=100),
        pytest.raises(SceneFileError, match="the limit json_bytes is 100"),
    ):
        read(folder)


def test_a_position_of_a_scene_file_is_checked_in_mm(folder):
    camera = {"position": [0, 0, 1e15], "target": [0, 0, 0]}
    with pytest.raises(SceneFileError, match=r"camera position_mm\[0, 2\] is 1e\+16"):
        read(folder, camera=camera)


def test_an_environment_file_brighter_than_the_sun_is_refused_by_name(tmp_path):
    image = np.ones((4, 8, 3), dtype=np.float32)
    image[1, 2, 0] = 1e30
    write_pixels(tmp_path / "sky.exr", image)
    with pytest.raises(
        ImageFileError, match=r"sky\.exr: its radiance reaches 1e\+30; the greatest is"
    ):
        Environment.load(tmp_path / "sky.exr")


@pytest.mark.parametrize("value", [1e38, -1e38, 3.0])
def test_a_normal_map_with_values_far_beyond_0_and_1_is_refused(tmp_path, value):
    image = np.full((4, 4, 3), 0.8, dtype=np.float32)
    image[2, 1, 0] = value
    path = tmp_path / "normal.exr"
    write_pixels(path, image)
    with pytest.raises(ImageFileError, match=r"normal\.exr: not a normal map: its values reach"):
        read_normal_map(path)


@pytest.mark.parametrize("strength", [0.0, 0.5, 2.0])
def test_zero_vectors_of_a_normal_map_stay_zero(strength):
    normals = np.array([[[0, 0, 0], [1, 0, 0], [0, 0, 1]]], dtype=np.float32)
    scaled = scale_slopes(normals, strength)
    lengths = [0.0, 1.0 if strength else 0.0, 1.0]
    assert np.linalg.norm(scaled, axis=2).tolist() == [lengths]


def test_the_average_of_an_environment_is_that_of_its_groups_of_rows():
    image = np.random.default_rng(2).random((200, 400, 3)).astype(np.float32)
    whole = Environment(image).radiance_sh()
    weights = -np.diff(np.cos(np.arange(201) / 200 * np.pi))
    mean = np.einsum("h,hwc->c", weights, image.astype(np.float64)) / 800.0
    assert np.allclose(whole[0] / np.sqrt(4.0 * np.pi), mean)
