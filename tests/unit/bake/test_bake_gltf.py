"""glTF baked: the attributes are those of the shape, and nothing else of the file is another."""

import copy
import shutil

import numpy as np
import pygltflib
import pytest
import trimesh

import gltf_shapes
from gltf_validator import assert_valid
from skinshade._core.errors import MeshFileError
from skinshade.bake import BakeSettings, bake
from tolerances import CURVATURE_OF_ROUNDED, FLOAT32_FILE, QUANTISED_NORMALS

EVERY_SHAPE = pytest.mark.parametrize("name", gltf_shapes.SHAPES)
EVERY_FORM = pytest.mark.parametrize("form", gltf_shapes.FORMS)
EVERYTHING = BakeSettings(tensor=True, thickness=True, rays=4, tracing="builtin")
WIDTHS = {"_CURVATURE": 1, "_CURVATURE_TENSOR_0": 3, "_CURVATURE_TENSOR_1": 3, "_THICKNESS": 1}
TRIANGLE_MODES = (4, 5, 6)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("gltf")


@pytest.fixture(scope="module")
def outcomes(folder):
    """Every shape as a GLB: the source and what came of it."""
    (folder / "out").mkdir()
    found = {}
    for name, build in gltf_shapes.SHAPES.items():
        source = gltf_shapes.write(build(), folder, stem=name)
        found[name] = source, bake(source, folder / "out" / f"{name}.glb", EVERYTHING)
    return found


def without_additions(after, before):
    """The document after, less what a bake may add to the one before."""
    left = copy.deepcopy(after)
    for key in ("accessors", "bufferViews"):
        left[key] = left[key][: len(before[key])]
    for mesh, old in zip(left["meshes"], before["meshes"], strict=True):
        mesh["extras"].pop("skinshade", None)
        if not mesh["extras"] and "extras" not in old:
            del mesh["extras"]
        for part, old_part in zip(mesh["primitives"], old["primitives"], strict=True):
            for name in WIDTHS:
                if name not in old_part["attributes"]:
                    part["attributes"].pop(name, None)
    return left


def without_places(document):
    """Where the bytes lie is no content; what they are is compared apart."""
    left = copy.deepcopy(document)
    del left["buffers"]
    for view in left["bufferViews"]:
        del view["buffer"]
        view.pop("byteOffset", None)
    return left


def assert_nothing_lost(source, output):
    before, old = gltf_shapes.read(source)
    after, new = gltf_shapes.read(output)
    kept = without_additions(after, before)
    assert without_places(kept) == without_places(before)
    assert gltf_shapes.view_bytes(kept, new) == gltf_shapes.view_bytes(before, old)
    for was, now in zip(before["buffers"], after["buffers"], strict=False):
        assert {**now, "uri": 0, "byteLength": 0} == {**was, "uri": 0, "byteLength": 0}


def by_pygltflib(path):
    """The attributes of ours of each primitive of triangles, by another reader."""
    gltf = pygltflib.GLTF2().load(str(path))
    found = []
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
            found.append(columns)
    return found


def analysed_columns(baked):
    """The same, as the analysis gave them, of all primitives of a mesh one after the other."""
    for mesh in baked.meshes:
        found = mesh.analysed.attributes
        tensor = found["tensor"]
        values = found["curvature"], tensor[:, :3], tensor[:, 3:], found["thickness"]
        yield dict(zip(WIDTHS, values, strict=True))


# -- what is added ---------------------------------------------------------------------------------


@EVERY_SHAPE
def test_curvature_is_that_of_the_sphere_at_the_scale_it_is_shown_at(outcomes, name):
    _, baked = outcomes[name]
    radii = gltf_shapes.SHAPES[name]().radii_mm
    assert len(baked.meshes) == len(radii)
    within = QUANTISED_NORMALS if name == "quantised" else CURVATURE_OF_ROUNDED
    for mesh, radius_mm in zip(baked.meshes, radii, strict=True):
        curvature = mesh.analysed.attributes["curvature"] * radius_mm
        np.testing.assert_allclose(curvature, 1.0, rtol=within.value)
        size = np.linalg.norm(mesh.body.positions_mm, axis=1)
        np.testing.assert_allclose(size, radius_mm, rtol=within.value)


# pygltflib takes no extras but objects
@pytest.mark.parametrize("name", sorted(gltf_shapes.SHAPES.keys() - {"foreign"}))
def test_other_readers_find_the_values_of_the_analysis(outcomes, name):
    _, baked = outcomes[name]
    read = by_pygltflib(baked.written[-1])
    document, _ = gltf_shapes.read(baked.written[-1])
    at = 0
    for columns, mesh in zip(analysed_columns(baked), document["meshes"], strict=True):
        parts = [p for p in mesh["primitives"] if p.get("mode", 4) in TRIANGLE_MODES]
        sets = {part["attributes"]["_CURVATURE"] for part in parts}
        for key, values in columns.items():
            distinct = [read[at + i][key] for i in range(len(parts))][: len(sets)]
            np.testing.assert_array_equal(np.concatenate(distinct), values.astype(np.float32))
        at += len(parts)
    assert at == len(read)


@pytest.mark.parametrize("name", ["plain", "skinned", "sparse", "foreign"])
def test_trimesh_finds_the_curvature_at_the_vertices(outcomes, name):
    _, baked = outcomes[name]
    (mesh,) = trimesh.load_scene(baked.written[-1], process=False).geometry.values()
    (columns,) = analysed_columns(baked)
    for key in ("_CURVATURE", "_THICKNESS"):
        read = np.asarray(mesh.vertex_attributes[key]).reshape(-1, 1)
        np.testing.assert_array_equal(read, columns[key].astype(np.float32))


@EVERY_SHAPE
def test_the_extras_tell_unit_scale_and_profile(outcomes, name):
    _, baked = outcomes[name]
    document, _ = gltf_shapes.read(baked.written[-1])
    for mesh, told in zip(document["meshes"], baked.meshes, strict=True):
        block = mesh["extras"]["skinshade"]
        assert block["unit_mm"] == told.unit_mm
        assert block["profile"] == "skin-deon2007"
        assert block["uv_scale_mm"] == told.analysed.uv_scale_mm
        assert block["attributes"] == dict(zip(WIDTHS, ["1/mm", "1/mm", "1/mm", "mm"], strict=True))


def test_only_what_is_asked_for_is_added(tmp_path):
    source = gltf_shapes.write(gltf_shapes.plain(), tmp_path)
    bake(source, tmp_path / "out.glb")
    document, _ = gltf_shapes.read(tmp_path / "out.glb")
    names = set(document["meshes"][0]["primitives"][0]["attributes"])
    assert names == {"POSITION", "NORMAL", "TEXCOORD_0", "_CURVATURE"}


def test_the_tensors_trace_is_twice_the_mean_curvature(tmp_path):
    source = gltf_shapes.write(gltf_shapes.plain(), tmp_path)
    settings = BakeSettings(tensor=True, thickness=True, rays=1, smoothing=0)
    (columns,) = by_pygltflib(bake(source, tmp_path / "out.glb", settings).written[-1])
    trace = columns["_CURVATURE_TENSOR_0"][:, 0] + columns["_CURVATURE_TENSOR_1"][:, [0, 2]].sum(1)
    np.testing.assert_allclose(
        trace, 2.0 * columns["_CURVATURE"][:, 0], rtol=CURVATURE_OF_ROUNDED.value
    )


def test_primitives_that_share_vertices_share_what_is_added(outcomes):
    document, _ = gltf_shapes.read(outcomes["several"][1].written[-1])
    first, lines, second, points = document["meshes"][0]["primitives"]
    assert first["attributes"]["_CURVATURE"] == second["attributes"]["_CURVATURE"]
    assert "_CURVATURE" not in lines["attributes"]
    assert "_CURVATURE" not in points["attributes"]


def test_meshes_that_differ_in_their_materials_alone_are_analysed_once(tmp_path):
    built = gltf_shapes.plain()
    built.document["meshes"].append(copy.deepcopy(built.document["meshes"][0]))
    built.document["nodes"].append({"mesh": 1})
    baked = bake(gltf_shapes.write(built, tmp_path), tmp_path / "out.glb")
    assert baked.meshes[0].analysed is baked.meshes[1].analysed
    document, _ = gltf_shapes.read(tmp_path / "out.glb")
    added = [mesh["primitives"][0]["attributes"]["_CURVATURE"] for mesh in document["meshes"]]
    assert added[0] == added[1]


def test_meshes_of_the_same_vertices_and_other_faces_are_apart(tmp_path):
    built = gltf_shapes.plain()
    second = copy.deepcopy(built.document["meshes"][0])
    _, _, _, faces = gltf_shapes.ball()
    corners = built.accessor(faces[:100].reshape(-1, 1), "u2", target=34963)
    second["primitives"][0]["indices"] = corners
    built.document["meshes"].append(second)
    built.document["nodes"].append({"mesh": 1})
    one, other = bake(gltf_shapes.write(built, tmp_path), tmp_path / "out.glb").meshes
    assert (len(one.body.faces), len(other.body.faces)) == (320, 100)
    assert "open edges" in other.analysed.notes
    assert "open edges" not in one.analysed.notes


# -- what stays ------------------------------------------------------------------------------------


@EVERY_SHAPE
def test_all_else_stays_byte_for_byte(outcomes, name):
    source, baked = outcomes[name]
    assert_nothing_lost(source, baked.written[-1])


def test_khronos_accepts_every_output(outcomes):
    assert_valid(*(source for source, _ in outcomes.values()))
    assert_valid(*(baked.written[-1] for _, baked in outcomes.values()))


def test_khronos_refuses_what_is_wrong(tmp_path):
    built = gltf_shapes.plain()
    built.document["accessors"][0]["max"] = [1.0, 1.0, 1.0]
    with pytest.raises(AssertionError, match="ACCESSOR_MAX_MISMATCH"):
        assert_valid(gltf_shapes.write(built, tmp_path))


@EVERY_FORM
@pytest.mark.parametrize("suffix", [".glb", ".gltf"])
@pytest.mark.parametrize("name", ["plain", "skinned"])
def test_every_form_becomes_every_other_in_another_folder(tmp_path, form, suffix, name):
    source = gltf_shapes.write(gltf_shapes.SHAPES[name](), tmp_path / "in", form)
    untouched = {path: path.read_bytes() for path in (tmp_path / "in").rglob("*.*")}
    (tmp_path / "out").mkdir()
    baked = bake(source, tmp_path / "out" / f"other{suffix}", EVERYTHING)
    assert_nothing_lost(source, baked.written[-1])
    assert {path for path in (tmp_path / "out").rglob("*") if path.is_file()} == set(baked.written)
    assert {path: path.read_bytes() for path in (tmp_path / "in").rglob("*.*")} == untouched
    shutil.rmtree(tmp_path / "in")  # the output stands by itself
    assert len(by_pygltflib(baked.written[-1])) == 1
    assert_valid(baked.written[-1])


def test_textures_beside_the_file_are_carried_to_another_folder(tmp_path):
    built = gltf_shapes.plain()
    built.document["images"] = [{"uri": "maps/skin%20colour.png"}, {"uri": "maps/gone.png"}]
    source = gltf_shapes.write(built, tmp_path / "in", "external")
    (tmp_path / "in" / "maps").mkdir()
    (tmp_path / "in" / "maps" / "skin colour.png").write_bytes(gltf_shapes.PNG)
    (tmp_path / "out").mkdir()
    bake(source, tmp_path / "out" / "head.gltf")
    assert (tmp_path / "out" / "maps" / "skin colour.png").read_bytes() == gltf_shapes.PNG
    assert not (tmp_path / "out" / "maps" / "gone.png").exists()


def test_chunks_of_other_types_stay(tmp_path):
    built = gltf_shapes.plain()
    built.document["buffers"] = [{"byteLength": len(built.binary)}]
    foreign = (0x58585858, b"nobody here knows what this is..")
    (tmp_path / "in.glb").write_bytes(gltf_shapes.pack_glb(built.document, built.binary, foreign))
    bake(tmp_path / "in.glb", tmp_path / "out.glb")
    assert (tmp_path / "out.glb").read_bytes().endswith(foreign[1])


def test_half_a_surrogate_pair_in_a_name_stays(tmp_path):
    built = gltf_shapes.plain()
    built.document["meshes"][0]["name"] = "\ud800"
    source = gltf_shapes.write(built, tmp_path)
    bake(source, tmp_path / "out.glb")
    assert gltf_shapes.read(tmp_path / "out.glb")[0]["meshes"][0]["name"] == "\ud800"


# -- again -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("form", ["glb", "external"])
def test_a_bake_of_a_bake_finds_the_same(tmp_path, form):
    once = bake(gltf_shapes.write(gltf_shapes.several(), tmp_path, form), tmp_path / "once.gltf")
    twice = bake(once.written[-1], tmp_path / f"twice{once.written[-1].suffix}")
    for a, b in zip(once.meshes, twice.meshes, strict=True):
        np.testing.assert_array_equal(*(x.analysed.attributes["curvature"] for x in (a, b)))
    assert_valid(twice.written[-1])


def test_a_bake_in_place_keeps_the_bytes_of_the_bake_before(tmp_path):
    """Both would name their buffer after the file: the older one was overwritten."""
    source = gltf_shapes.write(gltf_shapes.plain(), tmp_path, "external")
    bake(source, source, BakeSettings(thickness=True, rays=4))
    before, old = gltf_shapes.read(source)
    bake(source, source)
    after, new = gltf_shapes.read(source)
    kept = gltf_shapes.view_bytes(after, new)[: len(before["bufferViews"])]
    assert kept == gltf_shapes.view_bytes(before, old)
    assert_valid(source)


# -- where meshes stand ----------------------------------------------------------------------------


def unit_of(tmp_path, built, **settings):
    baked = bake(gltf_shapes.write(built, tmp_path), tmp_path / "out.glb", BakeSettings(**settings))
    return baked.meshes[0].unit_mm, baked.meshes[0].notes


@pytest.mark.parametrize("scale", [0.001, 0.5, 7.0])
@pytest.mark.parametrize("unit_mm", [None, 10.0])
def test_the_nodes_scale_is_part_of_the_unit(tmp_path, scale, unit_mm):
    built = gltf_shapes.plain()
    built.document["nodes"][0] = {"scale": [scale] * 3, "mesh": 0, "rotation": [0.6, 0, 0, 0.8]}
    unit, notes = unit_of(tmp_path, built, unit_mm=unit_mm)
    assert unit == pytest.approx(scale * (unit_mm or 1000.0), rel=FLOAT32_FILE.value)
    assert notes == {}


def test_a_skinned_mesh_stands_in_its_bind_pose_whatever_its_node_says(tmp_path):
    built = gltf_shapes.skinned()
    built.document["nodes"][0]["scale"] = [9.0, 9.0, 9.0]
    assert unit_of(tmp_path, built)[0] == pytest.approx(500.0, rel=FLOAT32_FILE.value)


def test_instances_at_other_scales_and_uneven_ones_are_noted(tmp_path):
    assert "meshes shown at several scales" in unit_of(tmp_path, gltf_shapes.instances())[1]
    built = gltf_shapes.plain()
    built.document["nodes"][0]["scale"] = [1.0, 1.0, 8.0]
    unit, notes = unit_of(tmp_path, built)
    assert notes == {"meshes of uneven scale": 1}
    assert unit == pytest.approx(2000.0, rel=FLOAT32_FILE.value)
    built.document["nodes"][0] = {"name": "empty"}
    assert unit_of(tmp_path, built) == (1000.0, {"meshes that no node shows": 1})


# -- what cannot be read ---------------------------------------------------------------------------


@pytest.mark.parametrize("extension", ["EXT_meshopt_compression", "KHR_meshopt_compression"])
@pytest.mark.parametrize("required", [True, False])
def test_compressed_geometry_is_refused_by_name(tmp_path, extension, required):
    built = gltf_shapes.plain()
    built.document["extensionsUsed"] = [extension]
    if required:
        built.document["extensionsRequired"] = [extension]
    else:
        built.document["meshes"][0]["primitives"][0]["extensions"] = {extension: {}}
    source = gltf_shapes.write(built, tmp_path)
    with pytest.raises(MeshFileError, match="meshopt") as caught:
        bake(source, tmp_path / "out.glb")
    assert str(source) in str(caught.value)
    assert "uncompressed" in str(caught.value)


def test_a_file_without_triangles_is_refused(tmp_path):
    built = gltf_shapes.plain()
    built.document["meshes"][0]["primitives"][0]["mode"] = 1
    with pytest.raises(MeshFileError, match="no triangles"):
        bake(gltf_shapes.write(built, tmp_path), tmp_path / "out.glb")
    assert not (tmp_path / "out.glb").exists()
