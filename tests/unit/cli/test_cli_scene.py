"""Options that describe a scene, and the scene that they give."""

from dataclasses import fields

import numpy as np
import pytest
from cli_runs import write_inputs

import skinshade as sk
from skinshade._core.errors import SceneFileError
from skinshade.cli.scene import LightOptions, MaterialOptions, ModelOptions, build_scene
from skinshade.heads import head_scene, load_head
from skinshade.heads.portrait import portrait_camera
from skinshade.mesh.axes import UpAxis
from skinshade.params.gloss import gloss_from_roughness
from skinshade.scene import DirectionalLight, load_scene


@pytest.fixture(scope="module")
def inputs(tmp_path_factory):
    folder = tmp_path_factory.mktemp("inputs")
    write_inputs(folder)
    return folder


@pytest.fixture(scope="module")
def ball(inputs):
    return ModelOptions(model=inputs / "ball.obj", unit_mm="1")


@pytest.fixture(scope="module")
def file(inputs):
    return ModelOptions(model=inputs / "good.json")


def built(model, material=None, light=None):
    return build_scene(model, MaterialOptions(**(material or {})), LightOptions(**(light or {})))


def same_camera(one, other):
    return np.array_equal(one.view_projection(1.5), other.view_projection(1.5))


# -- models ----------------------------------------------------------------------------------------


def test_without_a_model_the_scene_is_the_portrait_of_the_built_in_head():
    scene, truth = built(ModelOptions()), head_scene(sk.builtin_head())
    assert scene.mesh is truth.mesh
    assert scene.material is not None
    assert same_camera(scene.camera, truth.camera)
    assert len(scene.lights) == 1


@pytest.mark.parametrize(("text", "unit_mm"), [("1", 1.0), ("cm", 10.0), ("25.4", 25.4)])
def test_a_model_is_read_in_its_unit(inputs, text, unit_mm):
    scene = built(ModelOptions(model=inputs / "ball.obj", unit_mm=text))
    truth = head_scene(load_head(inputs / "ball.obj", unit_mm=unit_mm))
    assert scene.mesh.unit_mm == unit_mm
    assert same_camera(scene.camera, truth.camera)


def test_maps_and_flip_v_are_those_of_load_head(inputs):
    options = {"albedo": inputs / "grey.png", "flip_v": True}
    scene = built(ModelOptions(model=inputs / "ball.obj", unit_mm="1", **options))
    truth = load_head(inputs / "ball.obj", unit_mm=1.0, **options)
    assert np.array_equal(scene.material.albedo, truth.material.albedo)
    assert np.array_equal(scene.mesh.uvs, truth.mesh.uvs)


def test_a_model_with_z_up_is_turned(inputs):
    scene = built(ModelOptions(model=inputs / "ball.obj", unit_mm="1", up=UpAxis.Z))
    x, y, z = load_head(inputs / "ball.obj", unit_mm=1.0).mesh.positions.T
    assert np.array_equal(scene.mesh.positions, np.stack([x, z, -y], axis=1))


@pytest.mark.parametrize("suffix", [".json", ".JSON"])
def test_a_model_in_json_is_a_scene(tmp_path, suffix):
    assert ModelOptions(model=tmp_path / f"scene{suffix}").is_scene_file
    assert not ModelOptions(model=tmp_path / "scene.json.obj").is_scene_file
    assert not ModelOptions().is_scene_file


def test_a_scene_file_keeps_its_camera_unless_a_view_is_given(file):
    truth = load_scene(file.model)
    assert same_camera(built(file).camera, truth.camera)
    around = built(file, light={"view": "40,-10"})
    assert same_camera(around.camera, portrait_camera(truth.mesh, 40.0, -10.0))


# -- material --------------------------------------------------------------------------------------


@pytest.mark.parametrize("roughness", [0.0, 0.2, 0.45, 1.0])
@pytest.mark.parametrize("kind", ["ball", "file"])
def test_roughness_sets_the_gloss_of_a_lobe_of_that_roughness(request, kind, roughness):
    scene = built(request.getfixturevalue(kind), {"roughness": roughness})
    assert scene.material.params.gloss == float(gloss_from_roughness(roughness))


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("gloss", 0.5),
        ("gloss", 0.0),
        ("specular", "ggx-two-lobes"),
        ("specular", "blinn-phong"),
        ("scatter_scale", 2.0),
        ("normal_strength", 0.0),
        ("deep_scatter_strength", 0.0),
    ],
)
def test_a_parameter_is_set_and_the_others_keep_their_values(ball, name, value):
    params, default = built(ball, {name: value}).material.params, sk.SkinParams()
    assert getattr(params, name) == value
    for parameter in fields(sk.SkinParams):
        if parameter.name != name:
            assert getattr(params, parameter.name) == getattr(default, parameter.name)


def test_a_profile_is_a_preset(ball):
    assert built(ball).material.profile.name == "skin-deon2007"
    assert built(ball, {"profile": "marble"}).material.profile.name == "marble"


# -- light -----------------------------------------------------------------------------------------


def test_lights_of_a_model_are_given_by_angles_and_intensity(ball):
    assert len(built(ball).lights) == 1
    scene = built(ball, light={"light": ["-38,26,0.5", "152,12,1.6"]})
    truth = [DirectionalLight.from_angles(*v) for v in ((-38, 26, 0.5), (152, 12, 1.6))]
    for light, expected in zip(scene.lights, truth, strict=True):
        assert np.array_equal(light.to_light, expected.to_light)
        assert np.array_equal(light.irradiance, expected.irradiance)


@pytest.mark.parametrize(
    ("names", "directions"),
    [
        (None, [[0, 0, 1]]),
        (["front"], [[0, 0, 1]]),
        (["side"], [[1, 0, 0]]),
        (["side", "front"], [[0, 0, 1], [1, 0, 0]]),
    ],
)
def test_lights_of_a_scene_file_are_given_by_name(file, names, directions):
    scene = built(file, light={"light": names})
    assert [light.to_light.tolist() for light in scene.lights] == directions


def test_a_light_that_a_scene_file_does_not_have_is_named(file):
    with pytest.raises(SceneFileError, match="there is no light 'back'; there are front, side"):
        built(file, light={"light": ["back"]})


def test_an_environment_replaces_that_of_the_scene(ball, file, inputs):
    for model in (ball, file):
        options = {"env": inputs / "sky.exr", "env_scale": 0.5, "show_env": True}
        environment = built(model, light=options).environment
        assert (environment.scale, environment.visible) == (0.5, True)
        assert np.array_equal(environment.radiance, np.full((8, 16, 3), 0.5, dtype=np.float32))


def test_scale_and_visibility_change_the_environment_of_the_scene(ball, file):
    studio = built(ball).environment
    environment = built(ball, light={"env_scale": 0.5, "show_env": True}).environment
    assert environment.scale == 0.5 * studio.scale
    assert (studio.visible, environment.visible) == (False, True)
    assert built(file, light={"env_scale": 0.5}).environment is None


def test_the_sun_is_extracted_unless_an_option_keeps_it_in_the_image(ball, file, inputs):
    sky = {"env": inputs / "sky.exr"}
    for model, light in ((ball, {}), (ball, sky), (file, sky)):
        assert built(model, light=light).environment.extract_sun
        kept = built(model, light=light | {"no_extract_sun": True})
        assert not kept.environment.extract_sun


def test_light_from_the_camera_does_not_turn_the_environment(ball):
    view = {"view": "90,0", "light": ["0,0,1"]}
    fixed, turned = (built(ball, light=view | {"light_from_camera": on}) for on in (False, True))
    assert not np.allclose(fixed.lights[0].to_light, turned.lights[0].to_light)
    assert np.array_equal(fixed.environment.radiance, turned.environment.radiance)


def test_view_background_exposure_and_tone_are_those_of_the_options(ball):
    options = {"view": "10,20", "background": "0.1,0.2,0.3", "exposure": 0.0, "tone": "srgb"}
    scene, default = built(ball, light=options), built(ball)
    truth = portrait_camera(scene.mesh, 10.0, 20.0)
    assert same_camera(scene.camera, truth)
    assert scene.background.tolist() == [0.1, 0.2, 0.3]
    assert (scene.exposure, scene.tone) == (0.0, "srgb")
    assert same_camera(default.camera, portrait_camera(scene.mesh, 28.0, 4.0))
    assert (default.exposure, default.tone) == (1.0, "filmic")
