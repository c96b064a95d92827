"""Malformed JSON, GLB containers and buffers: `load_mesh` and a bake refuse them with one message."""

import base64
import json
import struct

import pytest

import gltf_shapes
from malformed import assert_bake_refuses, assert_refused, plain_with
from skinshade.gltf import read_gltf

# -- JSON ------------------------------------------------------------------------------------------


def embedded_with(folder, old, new):
    """Write the plain model as ``.gltf`` with a part of its text replaced."""
    path = gltf_shapes.write(gltf_shapes.plain(), folder, "embedded")
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))
    return path


@pytest.mark.parametrize("depth", [200, 900, 100_000])
@pytest.mark.parametrize("bracket", ["[]", "{}"])
def test_deeply_nested_json_is_refused(tmp_path, depth, bracket):
    begin, end = ("[", "]") if bracket == "[]" else ('{"a":', "}")
    inner = begin * depth + "0" + end * depth
    path = embedded_with(tmp_path, '"asset": {', f'"extras": {inner}, "asset": {{')
    assert_refused(path, "JSON")


@pytest.mark.parametrize("constant", ["NaN", "Infinity", "-Infinity", "1e999", "-1e400"])
def test_a_number_that_is_not_finite_is_refused(tmp_path, constant):
    path = embedded_with(tmp_path, '"asset": {', f'"extras": {constant}, "asset": {{')
    assert_refused(path, "JSON")


@pytest.mark.parametrize("text", ["1", "null", '"glTF"', "[]", "[{}]", "true"])
def test_json_that_is_not_an_object_is_refused(tmp_path, text):
    path = tmp_path / "in.gltf"
    path.write_text(text)
    assert_refused(path, "its JSON is not an object")


def test_a_repeated_key_is_refused(tmp_path):
    path = embedded_with(tmp_path, '"asset": {', '"scene": 0, "scene": 0, "asset": {')
    assert_refused(path, "'scene' twice")


def test_an_integer_of_five_thousand_digits_is_refused(tmp_path):
    path = embedded_with(tmp_path, '"asset": {', f'"extras": {"9" * 5000}, "asset": {{')
    assert_refused(path, "JSON")


@pytest.mark.parametrize(
    "part", ["accessors", "bufferViews", "buffers", "meshes", "nodes", "skins", "images"]
)
@pytest.mark.parametrize("value", [None, True, 5, "x", {}, [5], [None], [[]]])
def test_a_top_level_entry_that_is_not_an_array_of_objects_is_refused(tmp_path, part, value):
    path = gltf_shapes.write(gltf_shapes.skinned(), tmp_path)
    document, (data,) = gltf_shapes.read(path)
    document[part] = value
    path.write_bytes(gltf_shapes.pack_glb(document, data))
    (tmp_path / "out").mkdir()
    if part == "images":  # only a bake into another folder reads them
        assert_bake_refuses(path, part, output="out/out.glb")
    else:
        assert_refused(path, part, output="out/out.glb")


@pytest.mark.parametrize("value", [None, True, 5, "x", [], {"version": 2}, {"version": "1.0"}, {}])
def test_another_version_than_2_is_refused(tmp_path, value):
    assert_refused(plain_with(tmp_path, asset=value), "glTF version .*; it must be 2")


@pytest.mark.parametrize("key", ["mode", "attributes", "extensions", "indices"])
@pytest.mark.parametrize("value", [None, -1, 7, 1.5, "4", [1], {"POSITION": True}, 10**30])
def test_an_entry_of_a_primitive_of_another_type_is_refused(tmp_path, key, value):
    model = gltf_shapes.plain()
    model.document["meshes"][0]["primitives"][0][key] = value
    if key == "extensions" and isinstance(value, dict):
        return  # an object is valid
    assert_refused(gltf_shapes.write(model, tmp_path), "mesh 0")


@pytest.mark.parametrize("extension", ["EXT_meshopt_compression", "KHR_meshopt_compression"])
@pytest.mark.parametrize("required", [True, False])
def test_geometry_compressed_by_meshopt_is_refused_by_name(tmp_path, extension, required):
    model = gltf_shapes.plain()
    model.document["extensionsUsed"] = [extension]
    if required:
        model.document["extensionsRequired"] = [extension]
    else:
        model.document["meshes"][0]["primitives"][0]["extensions"] = {extension: {}}
    path = gltf_shapes.write(model, tmp_path)
    assert_refused(path, "compressed by meshopt.*export it uncompressed")


# -- GLB -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("offset", [4, 8, 12, 16])
@pytest.mark.parametrize("value", [0, 1, 3, 13, 2**31, 2**32 - 1])
def test_a_glb_with_a_wrong_number_in_its_headers_is_refused(tmp_path, offset, value):
    document = gltf_shapes.plain().document | {"buffers": []}
    data = bytearray(gltf_shapes.pack_glb(document, b"1234"))
    struct.pack_into("<I", data, offset, value)
    path = tmp_path / "in.glb"
    path.write_bytes(data)
    assert_refused(path, "")


@pytest.mark.parametrize("length", [1, 4, 11, 12, 19, 20, 21, 100, 1000])
def test_a_truncated_glb_is_refused(tmp_path, length):
    path = gltf_shapes.write(gltf_shapes.plain(), tmp_path)
    path.write_bytes(path.read_bytes()[:length])
    assert_refused(path, "")


def test_a_glb_encoded_as_base64_is_refused(tmp_path):
    path = tmp_path / "in.gltf"
    path.write_bytes(base64.b64encode(gltf_shapes.pack_glb(gltf_shapes.plain().document, b"1234")))
    assert_refused(path, "JSON")


def test_chunks_are_separated_by_their_type(tmp_path):
    document = {"asset": {"version": "2.0"}}
    other = (0x58585858, b"unknown content.")
    (tmp_path / "in.glb").write_bytes(gltf_shapes.pack_glb(document, b"1234", other))
    gltf = read_gltf(tmp_path / "in.glb")
    assert (gltf.json, gltf.binary, gltf.chunks) == (document, b"1234", [other])


# -- buffers ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("uri", ["data:;base64,AAAA", "data:;base64,", "data:text/plain,AAAA"])
def test_a_data_uri_that_is_short_or_not_base64_is_refused(tmp_path, uri):
    path = gltf_shapes.write(gltf_shapes.plain(), tmp_path, "embedded")
    document = json.loads(path.read_text())
    document["buffers"][0]["uri"] = uri
    path.write_text(json.dumps(document))
    assert_refused(path, "buffer 0")


@pytest.mark.parametrize("form", gltf_shapes.FORMS)
def test_every_form_of_buffer_has_the_bytes_that_were_written(tmp_path, form):
    model = gltf_shapes.plain()
    gltf = read_gltf(gltf_shapes.write(model, tmp_path, form))
    for index in range(len(gltf.items("buffers"))):
        assert gltf.buffer(index, "test")[: len(model.binary)] == bytes(model.binary)


def test_a_document_without_triangles_is_refused(tmp_path):
    model = gltf_shapes.plain()
    model.document["meshes"][0]["primitives"][0]["mode"] = 1
    assert_refused(gltf_shapes.write(model, tmp_path), "holds no triangles")
