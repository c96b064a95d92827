"""Geometry, JSON and GLB that mean harm, each by name: an error of ours, or a result without a NaN."""

import base64
import struct

import numpy as np
import pytest
from hostile import SOUND, changed, one_triangle, refused

import gltf_shapes
import shapes
from skinshade._core.errors import InputError, MeshError, UnitError
from skinshade.bake import BakeSettings, bake
from tolerances import CURVATURE_OF_ROUNDED

# -- geometry --------------------------------------------------------------------------------------

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], float)


@pytest.mark.parametrize("out", ["out.glb", "out.ply"])
@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 3e38])
def test_positions_that_are_no_numbers(tmp_path, value, out):
    spoiled = CORNERS.copy()
    spoiled[1, 2] = value
    bounds = {"min": [0, 0, 0], "max": [1, 1, 1]}
    refused(one_triangle(tmp_path, spoiled, **bounds), r"positions\[1, 2\]", InputError, out)


@pytest.mark.parametrize("out", ["out.glb", "out.ply"])
@pytest.mark.parametrize("name", ["NORMAL", "TEXCOORD_0"])
def test_normals_and_uvs_that_are_no_numbers(tmp_path, name, out):
    built = SOUND()
    index = built.document["meshes"][0]["primitives"][0]["attributes"][name]
    view = built.document["bufferViews"][built.document["accessors"][index]["bufferView"]]
    built.binary[view["byteOffset"] : view["byteOffset"] + 4] = struct.pack("<f", np.nan)
    path = gltf_shapes.write(built, tmp_path)
    if out == "out.ply" and name == "TEXCOORD_0":
        refused(path, "uvs", InputError, out)
        return
    (mesh,) = bake(path, tmp_path / out).meshes
    assert np.isfinite(mesh.analysed.attributes["curvature"]).all()
    assert out == "out.glb" or np.isfinite(mesh.body.normals).all()


def test_a_signalling_nan(tmp_path):
    """The processor warns of one as soon as it is copied into another type."""
    built = SOUND()
    view = built.document["bufferViews"][0]
    built.binary[view["byteOffset"] : view["byteOffset"] + 4] = bytes.fromhex("0100807f")
    path = gltf_shapes.write(built, tmp_path)
    refused(path, r"positions\[0, 0\] is nan", InputError)


@pytest.mark.parametrize("out", ["out.glb", "out.ply", "out.usda"])
def test_uvs_that_no_file_can_hold(tmp_path, out):
    path = tmp_path / "in.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 1e200\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n")
    refused(path, "uvs reach 1e\\+200", MeshError, out, unit_mm=1.0)


@pytest.mark.parametrize("out", ["out.glb", "out.ply"])
def test_a_curvature_that_no_file_can_hold(tmp_path, out):
    path = one_triangle(tmp_path, shapes.sphere("icosphere", 1, 1e-42).positions[:3] * [1, 1, 1])
    p, _, _, faces = gltf_shapes.ball(1.0, 1)
    built = gltf_shapes.new()
    tiny = {"POSITION": built.accessor(p * 1e-42), "NORMAL": built.accessor(p)}
    built.mesh(gltf_shapes.primitive(built, faces, **tiny))
    path = gltf_shapes.write(built.show({"mesh": 0}), tmp_path)
    refused(path, "curvature reaches|no face has an area", MeshError, out)


@pytest.mark.parametrize("out", ["out.glb", "out.ply"])
def test_faces_without_area_alone(tmp_path, out):
    refused(one_triangle(tmp_path, CORNERS[[0, 1, 1]]), "no face has an area", MeshError, out)
    line = one_triangle(tmp_path, [[0, 0, 0], [1, 1, 1], [2, 2, 2]])
    refused(line, "no face has an area", MeshError, out)


def test_no_vertices(tmp_path):
    built = SOUND()
    built.document["accessors"][0]["count"] = 0
    refused(gltf_shapes.write(built, tmp_path), "count is 0")
    built = SOUND()
    built.document["meshes"] = []
    built.document["nodes"] = []
    refused(gltf_shapes.write(built, tmp_path), "holds no triangles")


def test_more_vertices_than_sixteen_bits_count(tmp_path):
    flat = shapes.square(1.0, 270)
    assert len(flat.positions) > 70_000
    path = one_triangle(tmp_path, flat.positions, flat.faces)
    (mesh,) = bake(path, tmp_path / "out.glb").meshes
    assert len(mesh.analysed.attributes["curvature"]) == len(flat.positions)
    np.testing.assert_allclose(
        mesh.analysed.attributes["curvature"], 0.0, atol=CURVATURE_OF_ROUNDED.value
    )
    assert mesh.body.faces.max() == len(flat.positions) - 1


def test_edges_of_many_faces_and_faces_of_both_sides(tmp_path):
    fan = np.array([[0, 0, 0], [0, 0, 1], *([np.cos(a), np.sin(a), 0] for a in range(6))])
    faces = [[0, 1, i] for i in range(2, 8)] + [[1, 0, 2], [0, 1, 2]]
    path = one_triangle(tmp_path, fan, faces)
    settings = BakeSettings(thickness=True, tensor=True, rays=8)
    (mesh,) = bake(path, tmp_path / "out.glb", settings).meshes
    assert all(np.isfinite(values).all() for values in mesh.analysed.attributes.values())
    assert mesh.analysed.notes["non-manifold edges"] >= 1


@pytest.mark.parametrize("unit", [0, 0.0, -1.0, np.nan, np.inf, 1e300, "wide", None])
def test_a_unit_without_meaning(unit):
    if unit is None:
        assert BakeSettings(unit_mm=unit).unit_mm is None
        return
    with pytest.raises(UnitError, match="unit_mm is"):
        BakeSettings(unit_mm=unit)


# -- JSON and GLB ----------------------------------------------------------------------------------


def in_json(folder, old, new):
    path = gltf_shapes.write(SOUND(), folder, "embedded")
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))
    return path


@pytest.mark.parametrize("depth", [200, 900, 100_000])
@pytest.mark.parametrize("bracket", ["[]", "{}"])
def test_nesting_without_end(tmp_path, depth, bracket):
    begin, end = ("[", "]") if bracket == "[]" else ('{"a":', "}")
    inner = begin * depth + "0" + end * depth
    refused(in_json(tmp_path, '"asset": {', f'"extras": {inner}, "asset": {{'), "JSON")


@pytest.mark.parametrize("constant", ["NaN", "Infinity", "-Infinity", "1e999", "-1e400"])
def test_a_constant_that_is_no_number(tmp_path, constant):
    path = in_json(tmp_path, '"asset": {', f'"extras": {constant}, "asset": {{')
    refused(path, "JSON")


@pytest.mark.parametrize("text", ["1", "null", '"glTF"', "[]", "[{}]", "true"])
def test_json_that_is_no_object(tmp_path, text):
    path = tmp_path / "in.gltf"
    path.write_text(text)
    refused(path, "its JSON is no object")


def test_a_key_that_stands_twice(tmp_path):
    refused(in_json(tmp_path, '"asset": {', '"scene": 0, "scene": 0, "asset": {'), "'scene' twice")


def test_an_integer_of_five_thousand_digits(tmp_path):
    path = in_json(tmp_path, '"asset": {', f'"extras": {"9" * 5000}, "asset": {{')
    refused(path, "JSON")


@pytest.mark.parametrize(
    "part", ["accessors", "bufferViews", "buffers", "meshes", "nodes", "skins", "images"]
)
@pytest.mark.parametrize("value", [None, True, 5, "x", {}, [5], [None], [[]]])
def test_a_list_that_is_none(tmp_path, part, value):
    built = gltf_shapes.skinned()
    path = gltf_shapes.write(built, tmp_path)
    document, (data,) = gltf_shapes.read(path)
    document[part] = value
    path.write_bytes(gltf_shapes.pack_glb(document, data))
    (tmp_path / "out").mkdir()
    refused(path, part, out="out/out.glb")


@pytest.mark.parametrize("value", [None, True, 5, "x", [], {"version": 2}, {"version": "1.0"}, {}])
def test_an_asset_of_another_version(tmp_path, value):
    refused(changed(tmp_path, asset=value), "glTF 2 is read")


@pytest.mark.parametrize("key", ["mode", "attributes", "extensions", "indices"])
@pytest.mark.parametrize("value", [None, -1, 7, 1.5, "4", [1], {"POSITION": True}, 10**30])
def test_a_primitive_whose_parts_are_of_other_types(tmp_path, key, value):
    built = SOUND()
    built.document["meshes"][0]["primitives"][0][key] = value
    if key == "extensions" and isinstance(value, dict):
        return  # an object is one
    refused(gltf_shapes.write(built, tmp_path), "mesh 0")


def lying(field, value):
    data = bytearray(gltf_shapes.pack_glb(SOUND().document | {"buffers": []}, b"1234"))
    struct.pack_into("<I", data, field, value)
    return bytes(data)


@pytest.mark.parametrize("field", [4, 8, 12, 16])
@pytest.mark.parametrize("value", [0, 1, 3, 13, 2**31, 2**32 - 1])
def test_a_glb_that_lies_of_its_lengths(tmp_path, field, value):
    path = tmp_path / "in.glb"
    path.write_bytes(lying(field, value))
    refused(path, "")


@pytest.mark.parametrize("length", [1, 4, 11, 12, 19, 20, 21, 100, 1000])
def test_a_glb_that_ends_early(tmp_path, length):
    path = gltf_shapes.write(SOUND(), tmp_path)
    path.write_bytes(path.read_bytes()[:length])
    refused(path, "")


def test_base64_of_a_glb_that_is_no_text(tmp_path):
    path = tmp_path / "in.gltf"
    path.write_bytes(base64.b64encode(gltf_shapes.pack_glb(SOUND().document, b"1234")))
    refused(path, "JSON")
