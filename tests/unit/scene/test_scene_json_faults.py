"""Faults of scene files: every error names the file and the field."""

import json
import re

import numpy as np
import pytest
from test_scene_json import MINIMAL, SCENE, changed, write, write_files

from skinshade._core.errors import (
    FileError,
    ImageFileError,
    MeshFileError,
    SceneFileError,
)
from skinshade._core.text import printable
from skinshade.scene import load_scene
from skinshade.scene.images import write_png

HUGE = 10**400


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = write_files(tmp_path_factory.mktemp("faults"))
    (folder / "noise.png").write_bytes(b"\x89PNG and nothing of it")
    (folder / "noise.glb").write_bytes(b"glTF and nothing of it")
    write_png(folder / "flat.png", np.zeros((2, 2, 3)))
    return folder


def in_message(field):
    """Return the name of a field in error messages: ``lights[0].kind`` for ``lights.0.kind``."""
    return re.sub(r"\.(\d+)", r"[\1]", field)


def scene_error(folder, document, **options):
    """Return the message of the SceneFileError of a document, without the name of the file."""
    file = write(folder, document)
    with pytest.raises(FileError) as caught:
        load_scene(file, **options)
    assert type(caught.value) is SceneFileError
    message = str(caught.value)
    assert message.startswith(f"{file}: ")
    assert "\n" not in message
    return message.removeprefix(f"{file}: ")


# -- missing, unknown and repeated keys ------------------------------------------------------------

NEEDED = [
    "skinshade",
    "mesh",
    "mesh.path",
    "material.albedo.path",
    "material.normal.path",
    "material.profile.length_mm",
    "material.profile.length_kind",
    "material.profile.albedo",
    "camera",
    "camera.position",
    "camera.target",
    "lights.0.to_light",
    "lights.0.irradiance",
    "lights.1.position",
    "lights.1.target",
    "environment.path",
]


@pytest.mark.parametrize("field", NEEDED)
def test_a_missing_field_is_named(folder, field):
    assert scene_error(folder, changed(field)) == f"{in_message(field)}: missing"


@pytest.mark.parametrize("field", ["material.profile", "lights.0"])
def test_a_missing_kind_is_named(folder, field):
    message = scene_error(folder, changed(f"{field}.kind"))
    assert message.startswith(f"{in_message(field)}: ")
    assert "'kind'" in message


SECTIONS = [
    "",
    "mesh.",
    "material.",
    "material.albedo.",
    "material.normal.",
    "material.profile.",
    "camera.",
    "lights.0.",
    "lights.1.",
    "environment.",
    "tone.",
]


@pytest.mark.parametrize("value", [1, "x", {"y": 1}], ids=str)
@pytest.mark.parametrize("section", SECTIONS)
def test_an_unknown_key_is_named(folder, section, value):
    message = scene_error(folder, changed(f"{section}extra", value))
    assert message.startswith(f"{in_message(section)}extra: unknown key")


@pytest.mark.parametrize("section", ["", "material."])
@pytest.mark.parametrize("key", ["sun", "object", "a[0]"])
def test_an_unknown_key_with_the_name_of_a_kind_of_value_is_named(folder, section, key):
    message = scene_error(folder, changed(f"{section}{key}", 1))
    assert message.startswith(f"{in_message(section)}{key}: unknown key")


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("lights.0.cone_deg", 20),
        ("lights.0.position", [0, 0, 1]),
        ("lights.1.to_light", [0, 0, 1]),
        ("lights.1.angular_diameter_deg", 1),
        ("material.profile.ior", 1.3),
        ("material.albedo.strength", 1.0),
        ("version", 1),
    ],
)
def test_a_key_of_another_kind_of_entry_is_unknown(folder, field, value):
    message = scene_error(folder, changed(field, value))
    assert message.startswith(f"{in_message(field)}: unknown key")


@pytest.mark.parametrize(
    ("key", "text"),
    [
        ("skinshade", '{"skinshade": 1, "skinshade": 1}'),
        ("path", json.dumps(SCENE).replace('{"path"', '{"path": "other.obj", "path"')),
        ("name", json.dumps(SCENE).replace('{"name"', '{"name": "x", "name"')),
    ],
)
def test_a_repeated_key_is_named(folder, key, text):
    assert scene_error(folder, text) == f"an object has the key {key!r} twice"


# -- wrong types and values ------------------------------------------------------------------------

NO_NUMBERS = ("wide", [1], {"x": 1}, True, HUGE)
NO_VECTORS = (5, "x", {"x": 1}, [0, 1], [0, 1, "x"], [0, 1, None], [0, 1, HUGE], [0, 1, 2, 3])
NO_OBJECTS = (5, "x", [1], True)
WRONG = {
    "skinshade": (0, 2, "1", True, None, [1]),
    "unit_mm": (*NO_NUMBERS, 0, -1.0, 1e-9, 1e12),
    "mesh": (*NO_OBJECTS, None),
    "mesh.path": (5, None, "", ["sheet.obj"]),
    "mesh.credit": (5, None),
    "material": (*NO_OBJECTS, None),
    "material.albedo": ("albedo.png", True, -0.1, 1.1, [0.1, 0.2], [0.1, 0.2, 1.1]),
    "material.albedo.color_space": ("acescg", 5),
    "material.albedo.v": ("left", 5, None),
    "material.normal": ("normal.png", 0.5, [0, 0, 1]),
    "material.normal.strength": (*NO_NUMBERS, -0.1, 2.1, None),
    "material.deep_scatter": ("x", 2.0, [0.1, 0.2, -0.1]),
    "material.profile": ("skin1", 5, [1]),
    "material.profile.kind": ("disk", 5, None),
    "material.profile.length_mm": (*NO_VECTORS, [1, -1, 1], None),
    "material.profile.length_kind": ("radius", 5, None),
    "material.profile.albedo": (*NO_VECTORS, 0.5, "mean", [0.5, 0.5, 1.5], None),
    "material.roughness": (*NO_NUMBERS, -0.1, 1.1),
    "material.ior": (*NO_NUMBERS, 0.9, 3.1),
    "material.gloss": (*NO_NUMBERS, -0.1, 1.1),
    "material.scatter_scale": (*NO_NUMBERS, 0, 21),
    "material.deep_scatter_tint": (*NO_VECTORS, [1, 1, 2]),
    "camera": (*NO_OBJECTS, None),
    "camera.position": (*NO_VECTORS, [0, 1, 1e16], None),
    "camera.target": (*NO_VECTORS, None),
    "camera.up": (*NO_VECTORS, None),
    "camera.vertical_fov_deg": (*NO_NUMBERS, 0, 151, None),
    "lights": (5, "x", {"kind": "sun"}, None),
    "lights.0": (5, "front", None),
    "lights.0.kind": ("moon", 5, None),
    "lights.0.name": (5, None),
    "lights.0.enabled": ("yes", 1, None),
    "lights.0.to_light": (*NO_VECTORS, None),
    "lights.0.irradiance": (*NO_VECTORS, 1.0, [1, -1, 1], [1, 1, 1e7], None),
    "lights.2.angular_diameter_deg": (*NO_NUMBERS, -1, 181, None),
    "lights.1.position": (*NO_VECTORS, None),
    "lights.1.cone_deg": (*NO_NUMBERS, 0, 81, None),
    "environment": NO_OBJECTS,
    "environment.path": (5, None, ""),
    "environment.scale": (*NO_NUMBERS, -0.1, None),
    "environment.visible": ("yes", 1, None),
    "environment.extract_sun": ("yes", 1, None),
    "background": (*NO_VECTORS, 0.5, [0, 0, -0.1], None),
    "tone": (*NO_OBJECTS, None),
    "tone.curve": ("aces", 5, None),
    "tone.exposure": (*NO_NUMBERS, -0.1, None),
}
WRONG_VALUES = [(field, value) for field, values in WRONG.items() for value in values]


@pytest.mark.parametrize(("field", "value"), WRONG_VALUES, ids=lambda value: str(value)[:24])
def test_a_value_of_a_wrong_type_or_out_of_range_is_named(folder, field, value):
    document = changed(field, 0)  # a value of None would remove the field
    *parents, last = [int(key) if key.isdigit() else key for key in field.split(".")]
    inner = document
    for key in parents:
        inner = inner[key]
    inner[last] = value
    message = scene_error(folder, document)
    parent = in_message(field.removesuffix(".kind"))
    assert re.match(rf"{re.escape(parent)}(\[\d\])?: .", message), message


@pytest.mark.parametrize("number", ["NaN", "Infinity", "-Infinity", "1e999", "-1e999"])
def test_a_number_that_is_not_finite_is_quoted(folder, number):
    text = json.dumps(changed("tone.exposure", "HERE")).replace('"HERE"', number)
    assert number in scene_error(folder, text)


# -- values that do not fit together ---------------------------------------------------------------

CONFLICTS = {
    "camera at its target": ("camera.position", [1, 0, 0], "camera: position and target"),
    "camera without up": ("camera.up", [0, 0, 0], "camera up is 0, 0, 0"),
    "sun without direction": ("lights.0.to_light", [0, 0, 0], "light 'front': light to_light is 0"),
    "spot at its target": ("lights.1.target", [0, 3, 40], "light 'lamp': light: position and targ"),
    "zero length": ("material.profile.length_mm", [1, 0, 1], "length_mm is [1. 0. 1.]"),
    "albedo of 1": ("material.profile.albedo", [0.5, 1, 0.5], "albedo is [0.5 1.  0.5]"),
    "strength twice": ("material.normal_strength", 0.5, "material.normal_strength: give it as mat"),
    "ior and reflectance": ("material.reflectance", 0.03, "material: give ior or reflectance"),
    "a preset that is unknown": (
        "material.profile",
        {"kind": "preset", "name": "chalk"},
        "there is no profile 'chalk'; there are skin-deon2007, skin1",
    ),
    "no Gaussians": (
        "material.profile",
        {"kind": "gaussians", "variances_mm2": [], "weights": [], "albedo": [0.5, 0.5, 0.5]},
        "variances_mm2 is []",
    ),
    "Gaussians without weights": (
        "material.profile",
        {"kind": "gaussians", "variances_mm2": [1, 2], "weights": [], "albedo": [0.5, 0.5, 0.5]},
        "weights: shape is",
    ),
    "dipole without absorption": (
        "material.profile",
        {"kind": "dipole", "sigma_s_prime_per_mm": [1, 1, 1], "sigma_a_per_mm": [0, 1, 1]},
        "sigma_a_per_mm is",
    ),
}


@pytest.mark.parametrize("name", CONFLICTS)
def test_values_that_do_not_fit_together_are_named(folder, name):
    field, value, expected = CONFLICTS[name]
    message = scene_error(folder, changed(field, value))
    assert message.startswith(expected)


@pytest.mark.parametrize(
    ("name", "v"),
    [("albedo", "down"), ("albedo", "up"), ("normal", "down"), ("normal", "up")],
)
def test_maps_for_a_mesh_without_uvs_are_an_error_that_says_so(folder, name, v):
    material = {name: {"path": f"{name}.png", "v": v}}
    message = scene_error(folder, MINIMAL | {"material": material})
    assert "the mesh has no UVs" in message


def test_a_mesh_file_without_a_unit_asks_for_unit_mm(folder):
    assert re.match(r".*sheet\.obj: .*give unit_mm", scene_error(folder, changed("unit_mm")))


# -- lights by name --------------------------------------------------------------------------------


@pytest.mark.parametrize("names", [["back"], ["front", "back"], ("back",)])
def test_a_light_that_does_not_exist_is_named_with_those_that_do(folder, names):
    message = scene_error(folder, SCENE, lights=names)
    assert message == "there is no light 'back'; there are front, lamp, side"


def test_a_light_of_a_scene_without_lights_does_not_exist(folder):
    assert "there is no light 'front'" in scene_error(folder, MINIMAL, lights=["front"])


# -- files -----------------------------------------------------------------------------------------

FILES = [
    ("mesh.path", "none.obj", MeshFileError, "no such file"),
    ("mesh.path", "none/none.obj", MeshFileError, "no such file"),
    ("mesh.path", "\0.obj", MeshFileError, "no such file"),
    ("mesh.path", ".", MeshFileError, "not a file"),
    ("mesh.path", "albedo.png", MeshFileError, r"\.png; a mesh is one of"),
    ("mesh.path", "noise.glb", MeshFileError, "GLB version"),
    ("material.albedo.path", "none.png", ImageFileError, "no such file"),
    ("material.albedo.path", "noise.png", ImageFileError, "not an image|corrupt"),
    ("material.normal.path", "noise.png", ImageFileError, "not an image|corrupt"),
    ("material.normal.path", "flat.png", ImageFileError, "not a tangent-space normal map"),
    ("material.deep_scatter", {"path": "none.png"}, ImageFileError, "no such file"),
    ("environment.path", "none.hdr", ImageFileError, "no such file"),
    ("environment.path", "sheet.obj", ImageFileError, "not an image"),
]


@pytest.mark.parametrize(("field", "value", "kind", "reason"), FILES, ids=lambda v: str(v)[:24])
def test_a_file_that_cannot_be_used_is_named(folder, field, value, kind, reason):
    name = value["path"] if isinstance(value, dict) else value
    with pytest.raises(FileError) as caught:
        load_scene(write(folder, changed(field, value)))
    assert type(caught.value) is kind
    assert str(caught.value).startswith(f"{folder / printable(name)}: ")
    assert re.search(reason, str(caught.value))


@pytest.mark.parametrize(
    ("field", "kind"),
    [
        ("mesh.path", MeshFileError),
        ("material.albedo.path", ImageFileError),
        ("environment.path", ImageFileError),
        (None, SceneFileError),
    ],
)
def test_a_file_name_that_is_too_long_for_the_system_is_named(folder, field, kind):
    name = 300 * "n"
    file = folder / name if field is None else write(folder, changed(field, name))
    with pytest.raises(FileError) as caught:
        load_scene(file)
    assert type(caught.value) is kind
    assert str(caught.value).startswith(f"{folder / printable(name)}: ")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "the file is empty"),
        (" ", "not JSON"),
        ("{nope", "not JSON"),
        ("{'skinshade': 1}", "not JSON"),
        ("[1]", "the file: should be an object"),
        ("5", "the file: should be an object"),
        ("null", "the file: should be an object"),
        ('{"skinshade": "\\ud800"}', "the file: Invalid JSON"),
        ('{"skinshade": ' + "1" * 5000 + "}", "not JSON"),
        ("\ufeff{}", "not JSON"),
        ("[" * 200 + "]" * 200, "it nests 200 levels deep; the limit json_depth is 128"),
        ("[" * 1000 + "]" * 1000, "it nests too deep to be read; the limit json_depth is 128"),
        ('{"a": ' * 1000 + "1" + "}" * 1000, "it nests too deep to be read"),
        ("[" * 100_000, "it nests too deep to be read"),
    ],
    ids=lambda text: ascii(text)[:24],
)
def test_a_file_that_is_no_json_object_is_an_error(folder, text, message):
    assert scene_error(folder, text).startswith(message)


def test_a_file_in_another_encoding_or_none_is_named(folder):
    (folder / "latin.json").write_bytes('{"skinshade": "ä"}'.encode("latin-1"))
    for name, reason in (
        ("latin.json", "not UTF-8"),
        ("none.json", "no such file"),
        (".", "not a file"),
    ):
        with pytest.raises(SceneFileError) as caught:
            load_scene(folder / name)
        assert str(caught.value).startswith(f"{folder / name}: {reason}")
