"""Scenes from JSON files, and the files and documents that the other tests of the reader use."""

import copy
import json

import numpy as np
import pytest
import trimesh

from skinshade.params import SkinParams
from skinshade.params.choices import ToneCurve
from skinshade.params.gloss import gloss_from_roughness
from skinshade.profile import Profile
from skinshade.scene import DirectionalLight, Material, Scene, SpotLight, load_scene
from skinshade.scene.images import write_exr, write_png

SCENE = {
    "skinshade": 1,
    "unit_mm": 10.0,
    "mesh": {"path": "sheet.obj", "credit": "nobody"},
    "material": {
        "albedo": {"path": "albedo.png", "color_space": "srgb", "v": "down"},
        "normal": {"path": "normal.png", "color_space": "linear", "v": "down", "strength": 0.5},
        "deep_scatter": 0.25,
        "profile": {
            "kind": "burley",
            "length_mm": [3.0, 1.0, 0.5],
            "length_kind": "shape",
            "albedo": [0.6, 0.4, 0.3],
        },
        "roughness": 0.45,
        "ior": 1.4,
    },
    "camera": {
        "position": [1, 2, 30],
        "target": [1, 0, 0],
        "up": [0, 1, 0],
        "vertical_fov_deg": 25,
    },
    "lights": [
        {"name": "front", "kind": "sun", "to_light": [0, 0, 2], "irradiance": [3, 2, 1]},
        {
            "name": "lamp",
            "kind": "spot",
            "position": [0, 3, 40],
            "target": [0, 3, 0],
            "irradiance": [1, 2, 3],
            "cone_deg": 20,
        },
        {
            "name": "side",
            "kind": "sun",
            "to_light": [5, 0, 0],
            "angular_diameter_deg": 2.0,
            "irradiance": [1, 1, 1],
            "enabled": False,
        },
    ],
    "environment": {"path": "sky.exr", "scale": 0.3, "visible": True, "extract_sun": False},
    "background": [0.1, 0.2, 0.3],
    "tone": {"curve": "srgb", "exposure": 2.0},
}
"""A document with every section; `write_files` writes the files that it names."""
MINIMAL = {
    "skinshade": 1,
    "unit_mm": 10.0,
    "mesh": {"path": "bare.obj"},
    "camera": {"position": [0, 0, 30], "target": [0, 0, 0]},
}
ROWS = np.array([[51, 102, 153], [230, 179, 128]]) / 255.0
"""Stored colours of the upper and the lower row of both maps."""


def write_files(folder):
    """Write a sheet of 20 × 20 units, with UVs and without, its maps and a sky."""
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    positions = "".join(f"v {x} {y} 0\n" for x, y in corners)
    # v of OBJ counts up: the corners with y = −1 lie in the middle of the lower row of a map.
    uvs = "".join(f"vt {0.5 + 0.25 * x} {0.5 + 0.25 * y}\n" for x, y in corners)
    (folder / "sheet.obj").write_text(f"{positions}{uvs}f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n")
    (folder / "bare.obj").write_text(f"{positions}f 1 2 3\nf 1 3 4\n")
    for name in ("albedo.png", "normal.png"):
        write_png(folder / name, np.repeat(ROWS[:, None], 2, axis=1))
    write_exr(folder / "sky.exr", np.full((8, 16, 3), 0.5, dtype=np.float32))
    return folder


def write(folder, document, name="scene.json"):
    file = folder / name
    text = document if isinstance(document, str) else json.dumps(document)
    file.write_text(text, encoding="utf-8")
    return file


def changed(field, value=None, document=SCENE):
    """Return the document with a field (``lights.0.kind``) set to a value, or without it if None."""
    result = copy.deepcopy(document)
    *parents, last = [int(key) if key.isdigit() else key for key in field.split(".")]
    inner = result
    for key in parents:
        inner = inner[key]
    if value is None:
        del inner[last]
    else:
        inner[last] = value
    return result


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return write_files(tmp_path_factory.mktemp("scene"))


# -- the whole document ----------------------------------------------------------------------------


def test_geometry_camera_and_view_are_those_of_the_file_in_millimetres(folder):
    scene = load_scene(write(folder, SCENE))
    assert isinstance(scene, Scene)
    assert scene.mesh.unit_mm == 10.0
    assert np.ptp(scene.mesh.positions_mm, axis=0).tolist() == [20.0, 20.0, 0.0]
    assert scene.camera.position_mm.tolist() == [10.0, 20.0, 300.0]
    assert scene.camera.target_mm.tolist() == [10.0, 0.0, 0.0]
    assert scene.camera.up.tolist() == [0.0, 1.0, 0.0]
    assert scene.camera.vertical_fov_deg == 25.0
    assert (scene.environment.scale, scene.environment.visible) == (0.3, True)
    assert not scene.environment.extract_sun
    assert np.allclose(scene.environment.radiance, 0.5)
    assert scene.background.tolist() == [0.1, 0.2, 0.3]
    assert (scene.tone, scene.exposure) == (ToneCurve.SRGB, 2.0)


def test_version_mesh_and_camera_are_enough(folder):
    scene = load_scene(write(folder, MINIMAL))
    default = Material()
    assert (scene.lights, scene.environment) == ((), None)
    assert scene.material.params == default.params
    assert scene.material.profile.name == default.profile.name
    assert np.array_equal(scene.material.albedo, default.albedo)
    assert (scene.material.normal, scene.material.deep_scatter) == (None, None)
    assert scene.camera.vertical_fov_deg == 20.0
    assert scene.camera.up.tolist() == [0.0, 1.0, 0.0]
    assert scene.background.tolist() == [0.05, 0.05, 0.05]
    assert (scene.tone, scene.exposure) == (ToneCurve.FILMIC, 1.0)


def test_null_stands_for_a_missing_value(folder):
    document = copy.deepcopy(SCENE)
    document["environment"] = None
    document["material"] = dict.fromkeys(document["material"])
    scene = load_scene(write(folder, document))
    assert scene.environment is None
    assert scene.material.params == SkinParams()


def test_paths_are_relative_to_the_folder_of_the_file(folder, tmp_path, monkeypatch):
    (tmp_path / "maps").mkdir()
    (tmp_path / "sheet.obj").write_bytes((folder / "sheet.obj").read_bytes())
    (tmp_path / "maps" / "my albedo.png").write_bytes((folder / "albedo.png").read_bytes())
    document = MINIMAL | {"mesh": {"path": "sheet.obj"}}
    document["material"] = {"albedo": {"path": "maps/my albedo.png"}}
    write(tmp_path, document)
    monkeypatch.chdir(tmp_path / "maps")
    scene = load_scene("../scene.json")
    assert scene.mesh.faces.shape == (2, 3)
    assert scene.material.albedo.shape == (2, 2, 3)


def test_the_unit_of_a_gltf_file_is_the_metre_unless_the_scene_states_it(tmp_path):
    ball = trimesh.creation.icosphere(subdivisions=1, radius=0.1)
    (tmp_path / "ball.glb").write_bytes(ball.export(file_type="glb"))
    document = MINIMAL | {"mesh": {"path": "ball.glb"}}
    assert load_scene(write(tmp_path, document)).mesh.unit_mm == 10.0
    del document["unit_mm"]
    scene = load_scene(write(tmp_path, document))
    assert scene.mesh.unit_mm == 1000.0
    assert scene.camera.position_mm.tolist() == [0.0, 0.0, 30000.0]


# -- lights ----------------------------------------------------------------------------------------


def test_lights_are_suns_and_spots_in_millimetres(folder):
    sun, spot = load_scene(write(folder, SCENE)).lights
    assert isinstance(sun, DirectionalLight)
    assert sun.to_light.tolist() == [0.0, 0.0, 1.0]
    assert sun.irradiance.tolist() == [3.0, 2.0, 1.0]
    assert isinstance(spot, SpotLight)
    assert spot.position_mm.tolist() == [0.0, 30.0, 400.0]
    assert spot.target_mm.tolist() == [0.0, 30.0, 0.0]
    assert spot.cone_deg == 20.0
    assert spot.irradiance.tolist() == [1.0, 2.0, 3.0]


@pytest.mark.parametrize(
    ("names", "kinds"),
    [
        (None, ["front", "lamp"]),
        ([], []),
        (["side"], ["side"]),
        (("side", "front"), ["front", "side"]),
        (["lamp", "lamp"], ["lamp"]),
    ],
)
def test_lights_are_those_that_the_file_enables_or_those_that_are_named(folder, names, kinds):
    colours = {"front": [3.0, 2.0, 1.0], "lamp": [1.0, 2.0, 3.0], "side": [1.0, 1.0, 1.0]}
    scene = load_scene(write(folder, SCENE), lights=names)
    assert [light.irradiance.tolist() for light in scene.lights] == [colours[k] for k in kinds]


# -- the scan --------------------------------------------------------------------------------------


def test_the_scene_of_the_scan_has_the_values_of_its_file(data_dir):
    file = data_dir / "scene-head-v1.json"
    stated = json.loads(file.read_text("utf-8"))
    scene, material = load_scene(file), stated["material"]
    assert scene.mesh.unit_mm == stated["unit_mm"] == 50.35
    assert 200.0 < np.ptp(scene.mesh.positions_mm, axis=0)[1] < 500.0
    camera = stated["camera"]
    assert np.allclose(scene.camera.position_mm, np.array(camera["position"]) * 50.35)
    assert np.allclose(scene.camera.target_mm, np.array(camera["target"]) * 50.35)
    assert scene.camera.vertical_fov_deg == camera["vertical_fov_deg"]
    assert scene.material.params.gloss == float(gloss_from_roughness(material["roughness"]))
    assert scene.material.params.reflectance == pytest.approx((0.4 / 2.4) ** 2)
    mean = scene.material.albedo.mean(axis=(0, 1), dtype=np.float64)
    length_mm = material["profile"]["length_mm"]
    profile = Profile.burley(length_mm=length_mm, kind="blender-skin-radius", albedo=mean)
    assert np.allclose(scene.material.profile.rms_radius_mm, profile.rms_radius_mm)
    assert scene.material.normal.shape == scene.material.albedo.shape == (1024, 1024, 3)
    assert scene.environment.scale == stated["environment"]["scale"]
    assert not scene.environment.visible
    assert scene.environment.extract_sun
    assert (scene.tone, scene.exposure) == ("srgb", 1.0)


def test_the_scene_of_the_scan_is_lit_from_the_front_or_from_the_back(data_dir):
    file = data_dir / "scene-head-v1.json"
    stated = {light["name"]: light for light in json.loads(file.read_text("utf-8"))["lights"]}
    for scene, name in (
        (load_scene(file), "front"),
        (load_scene(file, lights=["back"]), "back"),
    ):
        (light,) = scene.lights
        assert np.allclose(light.to_light, stated[name]["to_light"], atol=1e-6)
        assert np.allclose(light.irradiance, np.pi, rtol=1e-6)
        to_camera = scene.camera.position_mm - scene.camera.target_mm
        assert (light.to_light @ to_camera > 0.0) == (name == "front")


def test_a_mesh_with_z_up_is_turned(tmp_path):
    write_files(tmp_path)
    scene = load_scene(write(tmp_path, MINIMAL | {"mesh": {"path": "bare.obj", "up": "z"}}))
    plain = load_scene(write(tmp_path, MINIMAL))
    x, y, z = plain.mesh.positions.T
    assert np.array_equal(scene.mesh.positions, np.stack([x, z, -y], axis=1))
