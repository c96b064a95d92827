import pytest
from test_scene_json import GOOD, changed, write, write_files

from skinshade._core.errors import ImageFileError, InputError, MeshFileError, SceneFileError
from skinshade.scene import load_scene

HUGE = 10**400


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return write_files(tmp_path_factory.mktemp("faults"))


NEEDED = (
    "unit_mm",
    "mesh",
    "mesh.path",
    "camera",
    "camera.position",
    "camera.target",
    "camera.vfov_deg",
    "sun.irradiance_perpendicular",
    "sun.to_light",
    "environment.path",
)


@pytest.mark.parametrize("field", NEEDED)
def test_a_field_that_lacks_is_named(folder, field):
    file = write(folder, changed(field))
    with pytest.raises(SceneFileError) as caught:
        load_scene(file)
    assert str(caught.value).startswith(f"{file}: ")
    assert repr(field.split(".")[-1]) in str(caught.value)


WRONG = (
    ("unit_mm", "wide"),
    ("unit_mm", -1.0),
    ("unit_mm", [1]),
    ("unit_mm", HUGE),
    ("mesh", 5),
    ("mesh", "sheet.obj"),
    ("mesh.path", 5),
    ("textures", 5),
    ("textures.color", 5),
    ("textures.normal", [1]),
    ("camera", 5),
    ("camera", [1, 2]),
    ("camera.position", 5),
    ("camera.position", [0, 1]),
    ("camera.position", [0, 1, "x"]),
    ("camera.position", [0, 1, HUGE]),
    ("camera.target", {"x": 1}),
    ("camera.up", [0, 1]),
    ("camera.up", [0, 0, 0]),
    ("camera.vfov_deg", "wide"),
    ("camera.vfov_deg", 0),
    ("camera.vfov_deg", [1]),
    ("sun", 5),
    ("sun", [1]),
    ("sun.to_light", [0, 0, 1]),
    ("sun.to_light", 5),
    ("sun.to_light.front", [0, 1]),
    ("sun.to_light.front", [0, 0, 0]),
    ("sun.irradiance_perpendicular", [1, -1, 1]),
    ("sun.irradiance_perpendicular", "bright"),
    ("lights", 5),
    ("lights", {"irradiance": [1, 1, 1]}),
    ("lights", [5]),
    ("lights", [{"irradiance": [1, 1, 1], "to_light": [0, 0, 0]}]),
    ("lights", [{"irradiance": [1, -1, 1], "to_light": [0, 0, 1]}]),
    ("lights", [{"irradiance": [1, 1, 1], "position": [0, 0, 1], "target": [0, 0, 1]}]),
    ("lights", [{"irradiance": [1, 1, 1], "position": [0, 0, 1], "to_light": [0, 0, 1]}]),
    ("lights", [{"irradiance": [1, 1, 1], "to_light": [0, 0, 1], "cone_deg": 9}]),
    ("lights", [{"irradiance": [1, 1, 1], "position": [0, 0, 1], "target": [0, 0], "cone_deg": 9}]),
    (
        "lights",
        [{"irradiance": [1, 1, 1], "position": [0, 0, 1], "target": [0, 0, 0], "cone_deg": 90}],
    ),
    ("environment", 5),
    ("environment.path", 5),
    ("environment.scale", "bright"),
    ("environment.scale", -1),
    ("materials", 5),
    ("materials.skin", 5),
    ("materials.skin.radius_mm", 0),
    ("materials.skin.radius_mm", "x"),
    ("materials.skin.radius_mm", [1, -1, 1]),
    ("materials.skin.ior", "x"),
    ("materials.skin.ior", -1),
    ("materials.skin.ior", HUGE),
    ("materials.skin.roughness", "x"),
)
SAID_AS = {
    "radius_mm": ("radius_mm", "length_mm"),
    "ior": ("ior", "reflectance"),
    "vfov_deg": ("vfov_deg", "vertical_fov_deg"),
    "irradiance_perpendicular": ("irradiance",),
    "front": ("to_light",),
}


@pytest.mark.parametrize(("field", "value"), WRONG, ids=lambda v: str(v)[:24])
def test_a_field_that_is_wrong_is_named(folder, field, value):
    file = write(folder, changed(field, value))
    with pytest.raises(InputError) as caught:
        load_scene(file)
    assert isinstance(caught.value, SceneFileError)
    last = field.split(".")[-1]
    assert str(caught.value).startswith(f"{file}: ")
    assert any(
        name in str(caught.value).removeprefix(str(file)) for name in SAID_AS.get(last, (last,))
    )


@pytest.mark.parametrize(
    ("field", "value", "kind"),
    [
        ("mesh.path", "gone.obj", MeshFileError),
        ("textures.color", "gone.png", ImageFileError),
        ("textures.color", "noise.png", ImageFileError),
        ("textures.normal", "noise.png", ImageFileError),
        ("environment.path", "noise.png", ImageFileError),
    ],
)
def test_a_file_that_a_scene_names_and_cannot_be_read_is_named(folder, field, value, kind):
    with pytest.raises(kind, match=value):
        load_scene(write(folder, changed(field, value)))


@pytest.mark.parametrize(
    ("text", "said"),
    [("{nope", "not JSON"), ("[1]", "JSON object"), ("5", "JSON object"), ("", "empty")],
)
def test_a_file_that_is_no_record_is_refused(folder, text, said):
    with pytest.raises(SceneFileError, match=said):
        load_scene(write(folder, text, "bad.json"))


def test_bytes_that_are_no_text_are_refused(folder):
    (folder / "bytes.json").write_bytes(b"\xff\xfe\x00{")
    for name, said in (("bytes.json", "not JSON"), ("gone.json", "no such file")):
        with pytest.raises(SceneFileError, match=f"{name}: {said}"):
            load_scene(folder / name)


def test_a_sun_that_is_not_there_is_named_with_those_that_are(folder):
    with pytest.raises(SceneFileError, match="'back'; there are front, side"):
        load_scene(write(folder, GOOD), light="back")
