import copy
import json

import numpy as np
import pytest

import shading_tolerances as tol
from skinshade.scene import DirectionalLight, SpotLight, load_scene
from skinshade.scene.images import write_exr, write_png
from skinshade.shading.specular import gloss_from_roughness

GOOD = {
    "unit_mm": 10.0,
    "mesh": {"path": "sheet.obj"},
    "textures": {"color": "colour.png (sRGB)", "normal": "normal.png"},
    "camera": {"position": [1, 2, 30], "target": [1, 0, 0], "up": [0, 1, 0], "vfov_deg": 25},
    "sun": {
        "irradiance_perpendicular": [3.0, 2.0, 1.0],
        "to_light": {"front": [0, 0, 2], "side": [1, 0, 0]},
    },
    "lights": [
        {"position": [0, 3, 40], "target": [0, 3, 0], "irradiance": [1, 2, 3], "cone_deg": 20},
        {"to_light": [0, 5, 0], "irradiance": [1, 1, 1]},
    ],
    "environment": {"path": "sky.exr", "scale": 0.3, "visible_to_camera": True},
    "materials": {
        "other": {"base": "colour.png"},
        "skin": {"radius_mm": [3.0, 1.0, 0.5], "ior": 1.4, "roughness": 0.45},
    },
}


def write_files(at):
    """A sheet of 20 mm with UVs, its maps, a sky, and a corrupt picture."""
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    lines = [f"v {x} {y} 0" for x, y in corners]
    lines += [f"vt {0.5 + 0.5 * x} {0.5 + 0.25 * y}" for x, y in corners]
    (at / "sheet.obj").write_text("\n".join([*lines, "f 1/1 2/2 3/3", "f 1/1 3/3 4/4"]))
    write_png(at / "colour.png", np.full((2, 2, 3), 128.0 / 255.0))
    write_png(at / "normal.png", np.tile([0.5, 0.5, 1.0], (2, 2, 1)))
    write_exr(at / "sky.exr", np.full((8, 16, 3), 0.5, dtype=np.float32))
    (at / "noise.png").write_bytes(b"\x89PNG and nothing of it")
    return at


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return write_files(tmp_path_factory.mktemp("scene"))


def write(folder, record, name="scene.json"):
    file = folder / name
    file.write_text(record if isinstance(record, str) else json.dumps(record), encoding="utf-8")
    return file


def changed(field, value=None):
    """The good record with a field (``a.b.c``) set, or dropped if the value is None."""
    record = copy.deepcopy(GOOD)
    *parents, last = field.split(".")
    inner = record
    for name in parents:
        inner = inner[name]
    if value is None:
        del inner[last]
    else:
        inner[last] = value
    return record


def test_everything_in_the_file_reaches_the_scene_in_millimetres(folder):
    scene = load_scene(write(folder, GOOD))
    assert scene.mesh.unit_mm == 10.0
    assert np.ptp(scene.mesh.positions_mm, axis=0).tolist() == [20.0, 20.0, 0.0]
    assert scene.camera.position_mm.tolist() == [10.0, 20.0, 300.0]
    assert scene.camera.target_mm.tolist() == [10.0, 0.0, 0.0]
    assert scene.camera.vertical_fov_deg == 25.0
    sun, lamp, rim = scene.lights
    assert isinstance(sun, DirectionalLight)
    assert isinstance(lamp, SpotLight)
    assert lamp.position_mm.tolist() == [0.0, 30.0, 400.0]
    assert lamp.cone_deg == 20.0
    direction, irradiance = lamp.at(lamp.target_mm)
    assert np.allclose(direction, [0.0, 0.0, 1.0])
    assert np.allclose(irradiance, [1.0, 2.0, 3.0])
    assert rim.to_light.tolist() == [0.0, 1.0, 0.0]
    assert sun.to_light.tolist() == [0.0, 0.0, 1.0]
    assert sun.irradiance.tolist() == [3.0, 2.0, 1.0]
    assert scene.environment.scale == 0.3
    assert scene.environment.visible
    assert np.allclose(scene.environment.radiance, 0.5)
    grey = ((128 / 255 + 0.055) / 1.055) ** 2.4
    assert np.allclose(scene.material.albedo, grey, rtol=1e-6)
    assert np.allclose(scene.material.normal, [0.0, 0.0, 1.0], atol=0.005)


def test_skin_is_the_first_material_with_a_radius(folder):
    material = load_scene(write(folder, GOOD)).material
    assert material.params.gloss == pytest.approx(float(gloss_from_roughness(0.45)))
    assert material.params.reflectance == pytest.approx((0.4 / 2.4) ** 2)
    rms = material.profile.rms_radius_mm
    assert rms[0] / rms[1] == pytest.approx(3.0, rel=tol.ROUNDING_SUMS.value)
    assert rms[1] / rms[2] == pytest.approx(2.0, rel=tol.ROUNDING_SUMS.value)
    assert np.allclose(material.profile.albedo, material.albedo.mean(axis=(0, 1)))


def test_another_sun_can_be_asked_for(folder):
    sun, *_ = load_scene(write(folder, GOOD), light="side").lights
    assert sun.to_light.tolist() == [1.0, 0.0, 0.0]


def test_only_mesh_unit_and_camera_are_needed(folder):
    record = {name: GOOD[name] for name in ("unit_mm", "mesh", "camera")}
    scene = load_scene(write(folder, record))
    assert (scene.lights, scene.environment, scene.material.normal) == ((), None, None)
    assert scene.tone == "srgb"
    filmic = load_scene(write(folder, record | {"tonemap": "filmic, exposure 0"}))
    assert filmic.tone == "filmic"


def test_v_is_turned_where_the_file_says_so(folder):
    plain = load_scene(write(folder, GOOD)).mesh.uvs
    for mark in ({"flip_v": True}, {"uv_note": "the V runs UP"}):
        record = changed("mesh", GOOD["mesh"] | mark)
        turned = load_scene(write(folder, record)).mesh.uvs
        assert np.allclose(turned, plain * (1, -1) + (0, 1))


@pytest.mark.parametrize("place", [".", "data"])
@pytest.mark.parametrize("note", ["", " (sRGB)", " (sRGB, " + 300 * "n" + ")"])
def test_a_name_may_hold_spaces_or_have_a_note_after_one(folder, tmp_path, place, note):
    (tmp_path / "data").mkdir()
    for name in ("sheet.obj", "normal.png", "sky.exr"):
        (tmp_path / name).write_bytes((folder / name).read_bytes())
    name = "plain.png" if note else "my colour.png"
    write_png(tmp_path / place / name, np.zeros((2, 2, 3)))
    scene = load_scene(write(tmp_path, changed("textures.color", name + note)))
    assert not scene.material.albedo.any()


def test_files_may_lie_in_a_data_folder_beside(folder, tmp_path):
    (tmp_path / "data").mkdir()
    for name in ("sheet.obj", "colour.png", "normal.png", "sky.exr"):
        (tmp_path / "data" / name).write_bytes((folder / name).read_bytes())
    assert load_scene(write(tmp_path, GOOD)).mesh.faces.shape == (2, 3)


@pytest.mark.slow
def test_the_scan_loads_as_its_file_says(data_dir):
    scene = load_scene(data_dir / "scene-head.json")
    assert scene.mesh.unit_mm == 50.35
    assert np.allclose(scene.camera.position_mm, np.array([8.4, 2.0, 18.3]) * 50.35)
    assert scene.camera.vertical_fov_deg == 16.5
    assert 200.0 < np.ptp(scene.mesh.positions_mm, axis=0)[1] < 500.0
    assert np.allclose(scene.lights[0].irradiance, np.pi, rtol=1e-6)
    assert scene.environment.scale == 0.3
    assert scene.material.normal is not None
    assert scene.material.albedo.shape[2] == 3
    back = load_scene(data_dir / "scene-head.json", light="back")
    towards = scene.camera.position_mm - scene.camera.target_mm
    assert scene.lights[0].to_light @ towards > 0.0 > back.lights[0].to_light @ towards
