"""The JSON Schema of scene descriptions says what the reader accepts."""

import json

import pytest

from skinshade.params import SkinParams
from skinshade.params.fields import meaning, number_fields
from skinshade.scene.schema import json_schema


@pytest.fixture(scope="module")
def schema():
    return json_schema()


def test_the_schema_is_json_of_one_version(schema):
    assert json.loads(json.dumps(schema)) == schema
    assert schema["$schema"].startswith("https://json-schema.org/")
    assert schema["properties"]["skinshade"]["const"] == 1
    assert "version" not in schema["properties"]


def test_the_title_of_the_schema_names_the_program_and_the_version(schema):
    assert schema["title"] == "skinshade scene, version 1"


def test_every_object_of_the_schema_refuses_unknown_keys(schema):
    for entry in (schema, *schema["$defs"].values()):
        assert entry["type"] == "object"
        assert entry["additionalProperties"] is False


def test_version_mesh_and_camera_are_required(schema):
    assert sorted(schema["required"]) == ["camera", "mesh", "skinshade"]
    assert schema["$defs"]["MeshFile"]["required"] == ["path"]
    assert schema["$defs"]["CameraFile"]["required"] == ["position", "target"]


@pytest.mark.parametrize("parameter", number_fields(SkinParams), ids=lambda field: field.name)
def test_every_skin_parameter_has_its_range_and_its_meaning(schema, parameter):
    entry = schema["$defs"]["MaterialFile"]["properties"][parameter.name]
    expected = meaning(parameter)
    assert entry["description"].startswith(expected.about)
    assert expected.unit == "1" or f"Unit: {expected.unit}." in entry["description"]
    number, null = entry["anyOf"]
    assert null == {"type": "null"}
    items = number.get("prefixItems", [number])
    assert len(items) == (3 if isinstance(parameter.default, tuple) else 1)
    for item in items:
        assert (item["minimum"], item["maximum"]) == (expected.low, expected.high)
