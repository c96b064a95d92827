"""A baked glTF file has correct attributes, and the rest of the file is unchanged."""

import copy
import shutil

import numpy as np
import pygltflib
import pytest
import trimesh

import gltf_shapes
from gltf_validator import assert_valid
from skinshade.baking import BakeSettings, bake
from tolerances import CONVEX, CURVATURE_OF_ROUNDED, FLOAT32_FILE, QUANTISED_NORMALS

EVERY_SHAPE = pytest.mark.parametrize("name", gltf_shapes.SHAPES)
EVERY_FORM = pytest.mark.parametrize("form", gltf_shapes.FORMS)
EVERYTHING = BakeSettings(
    tensor=True, thickness=True, ambient_transfer=True, rays=4, tracing="builtin"
)
TRANSFER = [f"_AMBIENT_TRANSFER_{number}" for number in range(9)]
WIDTHS = {
    "_CURVATURE": 1,
    "_CURVATURE_TENSOR_0": 3,
    "_CURVATURE_TENSOR_1": 3,
    "_THICKNESS": 1,
    **dict.fromkeys(TRANSFER, 3),
}
TRIANGLE_MODES = (4, 5, 6)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("gltf")


@pytest.fixture(scope="module")
def bakes(folder):
    """Every shape as a GLB: the source file and the result of its bake."""
    (folder / "out").mkdir()
    results = {}
    for name, build in gltf_shapes.SHAPES.items():
        source = gltf_shapes.write(build(), folder, stem=name)
        results[name] = source, bake(source, folder / "out" / f"{name}.glb", EVERYTHING)
    return results


def without_additions(after, before):
    """Return the baked document without the entries that a bake may add."""
    kept = copy.deepcopy(after)
    for key in ("accessors", "bufferViews"):
        kept[key] = kept[key][: len(before[key])]
    for mesh, old in zip(kept["meshes"], before["meshes"], strict=True):
        mesh["extras"].pop("skinshade", None)
        if not mesh["extras"] and "extras" not in old:
            del mesh["extras"]
        for part, old_part in zip(mesh["primitives"], old["primitives"], strict=True):
            for name in WIDTHS:
                if name not in old_part["attributes"]:
                    part["attributes"].pop(name, None)
    return kept


def without_offsets(document):
    """Return the document without the locations of its bytes, which are compared separately."""
    kept = copy.deepcopy(document)
    del kept["buffers"]
    for view in kept["bufferViews"]:
        del view["buffer"]
        view.pop("byteOffset", None)
    return kept


def assert_nothing_lost(source, output):
    before, old = gltf_shapes.read(source)
    after, new = gltf_shapes.read(output)
    kept = without_additions(after, before)
    assert without_offsets(kept) == without_offsets(before)
    assert gltf_shapes.view_bytes(kept, new) == gltf_shapes.view_bytes(before, old)
    for was, now in zip(before["buffers"], after["buffers"], strict=False):
        assert {**now, "uri": 0, "byteLength": 0} == {**was, "uri": 0, "byteLength": 0}


def read_by_pygltflib(path):
    """Return the baked attributes of each primitive with triangles, as pygltflib reads them."""
    gltf = pygltflib.GLTF2().load(str(path))
    tables = []
    for mesh in gltf.meshes:
        for part in mesh.primitives:
            if part.mode not in TRIANGLE_MODES:
                continue
            columns = {}
            for name, width in WIDTHS.items():
                accessor = gltf.accessors[getattr(part.attributes, name)]
                view = gltf.bufferViews[accessor.bufferView]
                uri = gltf.buffers[view.buffer].uri
                data = gltf.get_data_from_buffer_uri(uri) if uri else gltf.binary_blob()
                flat = np.frombuffer(data, "<f4", accessor.count * width, view.byteOffset)
                columns[name] = flat.reshape(-1, width)
                assert accessor.min == columns[name].min(axis=0).tolist()
                assert accessor.max == columns[name].max(axis=0).tolist()
            tables.append(columns)
    return tables


def analysed_columns(baked):
    """Yield the results of the analysis of each mesh, by the names in the file."""
    for mesh in baked.meshes:
        attributes = mesh.analysis.attributes
        tensor = attributes["tensor"]
        values = [attributes["curvature"], tensor[:, :3], tensor[:, 3:], attributes["thickness"]]
        values += np.split(attributes["ambient_transfer"], 9, axis=1)
        yield dict(zip(WIDTHS, values, strict=True))


# -- additions -------------------------------------------------------------------------------------


@EVERY_SHAPE
def test_curvature_is_that_of_the_sphere_at_the_scale_of_the_scene(bakes, name):
    _, baked = bakes[name]
    radii = gltf_shapes.SHAPES[name]().radii_mm
    assert len(baked.meshes) == len(radii)
    tolerance = QUANTISED_NORMALS if name == "quantised" else CURVATURE_OF_ROUNDED
    for mesh, radius_mm in zip(baked.meshes, radii, strict=True):
        curvature = mesh.analysis.attributes["curvature"] * radius_mm
        np.testing.assert_allclose(curvature, 1.0, rtol=tolerance.value)
        distance = np.linalg.norm(mesh.mesh.positions_mm, axis=1)
        np.testing.assert_allclose(distance, radius_mm, rtol=tolerance.value)


# pygltflib reads extras only if they are objects
@pytest.mark.parametrize("name", sorted(gltf_shapes.SHAPES.keys() - {"unknown_extensions"}))
def test_pygltflib_reads_the_values_of_the_analysis(bakes, name):
    _, baked = bakes[name]
    tables = read_by_pygltflib(baked.written[-1])
    document, _ = gltf_shapes.read(baked.written[-1])
    start = 0
    for columns, mesh in zip(analysed_columns(baked), document["meshes"], strict=True):
        parts = [p for p in mesh["primitives"] if p.get("mode", 4) in TRIANGLE_MODES]
        sets = {part["attributes"]["_CURVATURE"] for part in parts}
        for key, values in columns.items():
            distinct = [tables[start + i][key] for i in range(len(parts))][: len(sets)]
            np.testing.assert_array_equal(np.concatenate(distinct), values.astype(np.float32))
        start += len(parts)
    assert start == len(tables)


@pytest.mark.parametrize("name", ["plain", "skinned", "sparse", "unknown_extensions"])
def test_trimesh_reads_the_baked_vertex_attributes(bakes, name):
    _, baked = bakes[name]
    (mesh,) = trimesh.load_scene(baked.written[-1], process=False).geometry.values()
    (columns,) = analysed_columns(baked)
    for key in ("_CURVATURE", "_THICKNESS"):
        values = np.asarray(mesh.vertex_attributes[key]).reshape(-1, 1)
        np.testing.assert_array_equal(values, columns[key].astype(np.float32))


@EVERY_SHAPE
def test_the_extras_state_unit_scale_and_profile(bakes, name):
    _, baked = bakes[name]
    document, _ = gltf_shapes.read(baked.written[-1])
    for mesh, result in zip(document["meshes"], baked.meshes, strict=True):
        note = mesh["extras"]["skinshade"]
        assert note["unit_mm"] == result.mesh.unit_mm
        assert note["profile"] == "skin-deon2007"
        assert note["uv_scale_mm"] == result.analysis.uv_scale_mm
        assert note["attributes"] == dict(
            zip(WIDTHS, ["1/mm", "1/mm", "1/mm", "mm", *["1"] * 9], strict=True)
        )


@EVERY_SHAPE
def test_all_of_an_even_sky_reaches_every_channel_of_a_sphere(bakes, name):
    _, baked = bakes[name]
    for mesh in baked.meshes:
        transfer = mesh.analysis.attributes["ambient_transfer"]
        even = transfer[:, :3] * np.sqrt(4.0 * np.pi)
        np.testing.assert_allclose(even, 1.0, rtol=CONVEX.value)


def test_only_requested_attributes_are_added(tmp_path):
    source = gltf_shapes.write(gltf_shapes.plain(), tmp_path)
    bake(source, tmp_path / "out.glb")
    document, _ = gltf_shapes.read(tmp_path / "out.glb")
    names = set(document["meshes"][0]["primitives"][0]["attributes"])
    assert names == {"POSITION", "NORMAL", "TEXCOORD_0", "_CURVATURE"}


def test_the_trace_of_the_tensor_is_twice_the_mean_curvature(tmp_path):
    source = gltf_shapes.write(gltf_shapes.plain(), tmp_path)
    settings = BakeSettings(tensor=True, thickness=True, ambient_transfer=True, rays=1, smoothing=0)
    (columns,) = read_by_pygltflib(bake(source, tmp_path / "out.glb", settings).written[-1])
    trace = columns["_CURVATURE_TENSOR_0"][:, 0] + columns["_CURVATURE_TENSOR_1"][:, [0, 2]].sum(1)
    np.testing.assert_allclose(
        trace, 2.0 * columns["_CURVATURE"][:, 0], rtol=CURVATURE_OF_ROUNDED.value
    )


def test_primitives_that_share_vertices_share_the_added_accessors(bakes):
    document, _ = gltf_shapes.read(bakes["several_primitives"][1].written[-1])
    first, lines, second, points = document["meshes"][0]["primitives"]
    assert first["attributes"]["_CURVATURE"] == second["attributes"]["_CURVATURE"]
    assert "_CURVATURE" not in lines["attributes"]
    assert "_CURVATURE" not in points["attributes"]


def test_meshes_that_differ_only_in_their_materials_are_analysed_once(tmp_path):
    model = gltf_shapes.plain()
    model.document["meshes"].append(copy.deepcopy(model.document["meshes"][0]))
    model.document["nodes"].append({"mesh": 1})
    baked = bake(gltf_shapes.write(model, tmp_path), tmp_path / "out.glb")
    assert baked.meshes[0].analysis is baked.meshes[1].analysis
    document, _ = gltf_shapes.read(tmp_path / "out.glb")
    added = [mesh["primitives"][0]["attributes"]["_CURVATURE"] for mesh in document["meshes"]]
    assert added[0] == added[1]


def test_meshes_with_equal_vertices_and_other_faces_are_analysed_separately(tmp_path):
    model = gltf_shapes.plain()
    second = copy.deepcopy(model.document["meshes"][0])
    _, _, _, faces = gltf_shapes.sphere()
    corners = model.add_accessor(faces[:100].reshape(-1, 1), "u2", target=34963)
    second["primitives"][0]["indices"] = corners
    model.document["meshes"].append(second)
    model.document["nodes"].append({"mesh": 1})
    whole, part = bake(gltf_shapes.write(model, tmp_path), tmp_path / "out.glb").meshes
    assert (len(whole.mesh.faces), len(part.mesh.faces)) == (320, 100)
    assert "open edges" in part.all_notes
    assert "open edges" not in whole.all_notes


# -- unchanged parts -------------------------------------------------------------------------------


@EVERY_SHAPE
def test_the_rest_of_the_file_is_unchanged_byte_for_byte(bakes, name):
    source, baked = bakes[name]
    assert_nothing_lost(source, baked.written[-1])


def test_khronos_accepts_every_output(bakes):
    assert_valid(*(source for source, _ in bakes.values()))
    assert_valid(*(baked.written[-1] for _, baked in bakes.values()))


def test_khronos_refuses_a_wrong_maximum(tmp_path):
    model = gltf_shapes.plain()
    model.document["accessors"][0]["max"] = [1.0, 1.0, 1.0]
    with pytest.raises(AssertionError, match="ACCESSOR_MAX_MISMATCH"):
        assert_valid(gltf_shapes.write(model, tmp_path))


@EVERY_FORM
@pytest.mark.parametrize("suffix", [".glb", ".gltf"])
@pytest.mark.parametrize("name", ["plain", "skinned"])
def test_every_form_is_converted_to_glb_and_gltf_in_another_folder(tmp_path, form, suffix, name):
    source = gltf_shapes.write(gltf_shapes.SHAPES[name](), tmp_path / "in", form)
    contents = {path: path.read_bytes() for path in (tmp_path / "in").rglob("*.*")}
    (tmp_path / "out").mkdir()
    baked = bake(source, tmp_path / "out" / f"other{suffix}", EVERYTHING)
    assert_nothing_lost(source, baked.written[-1])
    assert {path for path in (tmp_path / "out").rglob("*") if path.is_file()} == set(baked.written)
    assert {path: path.read_bytes() for path in (tmp_path / "in").rglob("*.*")} == contents
    shutil.rmtree(tmp_path / "in")  # the output does not refer to the source
    assert len(read_by_pygltflib(baked.written[-1])) == 1
    assert_valid(baked.written[-1])


def test_textures_beside_the_file_are_copied_to_another_folder(tmp_path):
    model = gltf_shapes.plain()
    model.document["images"] = [{"uri": "maps/skin%20colour.png"}, {"uri": "maps/missing.png"}]
    source = gltf_shapes.write(model, tmp_path / "in", "external")
    (tmp_path / "in" / "maps").mkdir()
    (tmp_path / "in" / "maps" / "skin colour.png").write_bytes(gltf_shapes.PNG)
    (tmp_path / "out").mkdir()
    bake(source, tmp_path / "out" / "head.gltf")
    assert (tmp_path / "out" / "maps" / "skin colour.png").read_bytes() == gltf_shapes.PNG
    assert not (tmp_path / "out" / "maps" / "missing.png").exists()


def test_chunks_of_other_types_are_kept(tmp_path):
    model = gltf_shapes.plain()
    model.document["buffers"] = [{"byteLength": len(model.binary)}]
    other = (0x58585858, b"content of an unknown chunk type")
    (tmp_path / "in.glb").write_bytes(gltf_shapes.pack_glb(model.document, model.binary, other))
    bake(tmp_path / "in.glb", tmp_path / "out.glb")
    assert (tmp_path / "out.glb").read_bytes().endswith(other[1])


def test_half_a_surrogate_pair_in_a_name_is_kept(tmp_path):
    model = gltf_shapes.plain()
    model.document["meshes"][0]["name"] = "\ud800"
    source = gltf_shapes.write(model, tmp_path)
    bake(source, tmp_path / "out.glb")
    assert gltf_shapes.read(tmp_path / "out.glb")[0]["meshes"][0]["name"] == "\ud800"


# -- repeated bakes --------------------------------------------------------------------------------


@pytest.mark.parametrize("form", ["glb", "external"])
def test_a_bake_of_a_baked_file_gives_the_same_curvature(tmp_path, form):
    source = gltf_shapes.write(gltf_shapes.several_primitives(), tmp_path, form)
    once = bake(source, tmp_path / "once.gltf")
    twice = bake(once.written[-1], tmp_path / f"twice{once.written[-1].suffix}")
    for a, b in zip(once.meshes, twice.meshes, strict=True):
        np.testing.assert_array_equal(*(x.analysis.attributes["curvature"] for x in (a, b)))
    assert_valid(twice.written[-1])


# -- units and placement ---------------------------------------------------------------------------


def unit_and_notes(tmp_path, model, **settings):
    source = gltf_shapes.write(model, tmp_path)
    baked = bake(source, tmp_path / "out.glb", BakeSettings(**settings))
    return baked.meshes[0].mesh.unit_mm, baked.meshes[0].notes


@pytest.mark.parametrize("scale", [0.001, 0.5, 7.0])
@pytest.mark.parametrize("unit_mm", [None, 10.0])
def test_the_unit_includes_the_scale_of_the_node(tmp_path, scale, unit_mm):
    model = gltf_shapes.plain()
    model.document["nodes"][0] = {"scale": [scale] * 3, "mesh": 0, "rotation": [0.6, 0, 0, 0.8]}
    unit, notes = unit_and_notes(tmp_path, model, unit_mm=unit_mm)
    assert unit == pytest.approx(scale * (unit_mm or 1000.0), rel=FLOAT32_FILE.value)
    assert notes == {}


def test_the_bind_pose_of_a_skinned_mesh_replaces_the_transform_of_its_node(tmp_path):
    model = gltf_shapes.skinned()
    model.document["nodes"][0]["scale"] = [9.0, 9.0, 9.0]
    assert unit_and_notes(tmp_path, model)[0] == pytest.approx(500.0, rel=FLOAT32_FILE.value)


def test_different_and_uneven_scales_are_noted(tmp_path):
    notes = unit_and_notes(tmp_path, gltf_shapes.instances())[1]
    assert "meshes with nodes of several scales" in notes
    model = gltf_shapes.plain()
    model.document["nodes"][0]["scale"] = [1.0, 1.0, 8.0]
    unit, notes = unit_and_notes(tmp_path, model)
    assert notes == {"meshes of uneven scale": 1}
    assert unit == pytest.approx(2000.0, rel=FLOAT32_FILE.value)
    model.document["nodes"][0] = {"name": "empty"}
    assert unit_and_notes(tmp_path, model) == (1000.0, {"meshes without a node": 1})
