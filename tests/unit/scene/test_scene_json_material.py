"""Materials of scenes from JSON files: parameters, maps and profiles."""

import numpy as np
import pytest
from test_scene_json import MINIMAL, ROWS, SCENE, changed, write, write_files

import shading_tolerances as tol
from skinshade.params import SkinParams
from skinshade.params.fields import number_fields
from skinshade.params.gloss import gloss_from_roughness
from skinshade.profile import Profile
from skinshade.scene import load_scene


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return write_files(tmp_path_factory.mktemp("scene"))


def load(folder, field, value):
    return load_scene(write(folder, changed(field, value)))


def linear(srgb):
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def test_roughness_ior_and_the_strength_of_the_normal_map_become_parameters(folder):
    params = load_scene(write(folder, SCENE)).material.params
    assert params.gloss == pytest.approx(float(gloss_from_roughness(0.45)))
    assert params.reflectance == pytest.approx((0.4 / 2.4) ** 2)
    assert params.normal_strength == 0.5
    assert params.scatter_scale == SkinParams().scatter_scale


@pytest.mark.parametrize("name", [field.name for field in number_fields(SkinParams)])
def test_every_skin_parameter_can_be_given_by_its_name(folder, name):
    default = getattr(SkinParams(), name)
    value = [0.2, 0.4, 0.6] if isinstance(default, tuple) else 0.5 * default
    document = MINIMAL | {"material": {name: value}}
    params = load_scene(write(folder, document)).material.params
    assert getattr(params, name) == (tuple(value) if isinstance(value, list) else value) != default


@pytest.mark.parametrize("name", ["albedo", "deep_scatter"])
@pytest.mark.parametrize(("value", "colour"), [(0.25, (0.25,) * 3), ([0.1, 0.2, 0.3],) * 2])
def test_a_number_or_three_are_one_linear_colour(folder, name, value, colour):
    scene = load_scene(write(folder, MINIMAL | {"material": {name: value}}))
    assert np.array_equal(getattr(scene.material, name), np.float32(colour).reshape(1, 1, 3))


@pytest.mark.parametrize("name", ["albedo", "deep_scatter"])
def test_the_colour_space_of_a_map_is_srgb_by_default_and_linear_on_request(folder, name):
    for entry, truth in (
        ({}, linear(ROWS)),
        ({"color_space": "srgb"}, linear(ROWS)),
        ({"color_space": "linear"}, ROWS),
    ):
        scene = load(folder, f"material.{name}", {"path": "albedo.png"} | entry)
        image = getattr(scene.material, name)
        assert np.abs(image - truth[:, None]).max() <= tol.FLOAT32.value


def test_a_map_in_exr_is_linear_by_default(folder):
    scene = load(folder, "material.albedo", {"path": "sky.exr"})
    assert np.array_equal(scene.material.albedo, np.full((8, 16, 3), 0.5, dtype=np.float32))


def at_corners(scene, name):
    """Return a map of two rows at the vertices of the sheet, (4, 3)."""
    row = (2.0 * scene.mesh.uvs[:, 1]).astype(int)
    return getattr(scene.material, name)[row, 0]


def normals_at_corners(scene):
    """Return the normals of the map in space, (4, 3): T = +x, B against ∂P/∂v, N = +z."""
    slope = np.polyfit(scene.mesh.uvs[:, 1], scene.mesh.positions[:, 1], 1)[0]
    return at_corners(scene, "normal") * (1.0, -np.sign(slope), 1.0)


@pytest.mark.parametrize("normal_v", ["down", "up"])
@pytest.mark.parametrize("albedo_v", ["down", "up"])
def test_every_map_has_its_own_direction_of_v(folder, albedo_v, normal_v):
    """With v up, the corners at the top of the sheet show the lower row of the map."""
    document = changed("material.albedo.v", albedo_v)
    scene = load_scene(write(folder, changed("material.normal.v", normal_v, document)))
    top = scene.mesh.positions[:, 1] > 0.0
    upper, lower = linear(ROWS)
    if albedo_v == "up":
        upper, lower = lower, upper
    truth = np.where(top[:, None], upper, lower)
    assert np.abs(at_corners(scene, "albedo") - truth).max() <= tol.FLOAT32.value
    upper, lower = 2.0 * ROWS - 1.0
    if normal_v == "up":
        upper, lower = lower * (1, -1, 1), upper * (1, -1, 1)
    truth = np.where(top[:, None], upper, lower)
    truth /= np.linalg.norm(truth, axis=1)[:, None]
    assert np.abs(normals_at_corners(scene) - truth).max() <= tol.FLOAT32.value


# -- profiles --------------------------------------------------------------------------------------


def same_profile(one, other):
    k = np.geomspace(0.01, 10.0, 20)
    return np.array_equal(one.transfer(k), other.transfer(k)) and np.array_equal(
        one.albedo, other.albedo
    )


LENGTH_KINDS = [
    ("shape", "shape"),
    ("mean-free-path-searchlight", "mean-free-path-searchlight"),
    ("mean-free-path-diffuse", "mean-free-path-diffuse"),
    ("diffuse-mean-free-path", "diffuse-mean-free-path"),
    ("blender-skin-radius", "blender-skin-radius"),
]


@pytest.mark.parametrize(("length_kind", "kind"), LENGTH_KINDS)
def test_every_kind_of_length_is_that_of_burleys_profile(folder, length_kind, kind):
    scene = load(folder, "material.profile.length_kind", length_kind)
    truth = Profile.burley(length_mm=(3.0, 1.0, 0.5), kind=kind, albedo=(0.6, 0.4, 0.3))
    assert same_profile(scene.material.profile, truth)


def test_the_mean_of_the_map_is_the_albedo_of_a_profile_on_request(folder):
    material = load(folder, "material.profile.albedo", "mean-of-map").material
    mean = material.albedo.mean(axis=(0, 1), dtype=np.float64)
    assert np.allclose(material.profile.albedo, mean, rtol=tol.ROUNDING.value)
    assert np.allclose(mean, linear(ROWS).mean(axis=0), atol=tol.FLOAT32.value)


PROFILES = [
    ({"kind": "preset", "name": "marble"}, lambda: Profile.preset("marble")),
    (
        {
            "kind": "gaussians",
            "variances_mm2": [0.1, 2.0],
            "weights": [[1, 2, 3], [3, 2, 1]],
            "albedo": [0.6, 0.4, 0.3],
        },
        lambda: Profile.gaussians(
            variances_mm2=[0.1, 2.0], weights=[[1, 2, 3], [3, 2, 1]], albedo=[0.6, 0.4, 0.3]
        ),
    ),
    (
        {"kind": "dipole", "sigma_s_prime_per_mm": [1, 2, 3], "sigma_a_per_mm": [0.1, 0.2, 0.3]},
        lambda: Profile.dipole(sigma_s_prime_per_mm=[1, 2, 3], sigma_a_per_mm=[0.1, 0.2, 0.3]),
    ),
    (
        {
            "kind": "dipole",
            "sigma_s_prime_per_mm": [1, 2, 3],
            "sigma_a_per_mm": [0.1, 0.2, 0.3],
            "ior": 1.5,
        },
        lambda: Profile.dipole(
            sigma_s_prime_per_mm=[1, 2, 3], sigma_a_per_mm=[0.1, 0.2, 0.3], ior=1.5
        ),
    ),
]


@pytest.mark.parametrize(("entry", "build"), PROFILES, ids=["preset", "gaussians", "dipole", "ior"])
def test_a_profile_is_that_of_the_library(folder, entry, build):
    scene = load(folder, "material.profile", entry)
    assert same_profile(scene.material.profile, build())


@pytest.mark.parametrize(
    ("material", "expected"),
    [
        ({}, "ggx"),
        ({"roughness": 0.4}, "ggx"),
        ({"gloss": 0.4}, "blinn-phong"),
        ({"gloss": 0.4, "specular": "ggx"}, "ggx"),
        ({"roughness": 0.4, "specular": "ggx-two-lobes"}, "ggx-two-lobes"),
        ({"specular": "blinn-phong"}, "blinn-phong"),
    ],
)
def test_a_gloss_keeps_the_lobes_of_blinn_phong_unless_others_are_named(folder, material, expected):
    params = load_scene(write(folder, MINIMAL | {"material": material})).material.params
    assert params.specular == expected


def test_the_boundary_is_named_or_left_to_the_profile(folder):
    for material, expected in (({}, None), ({"boundary": "blender-skin"}, "blender-skin")):
        params = load_scene(write(folder, MINIMAL | {"material": material})).material.params
        assert params.boundary == expected
