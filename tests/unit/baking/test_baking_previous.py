"""A bake of a baked asset replaces the former attributes, so that files do not grow."""

import json

import pytest

import gltf_shapes
from gltf_validator import assert_valid
from skinshade._core.errors import ArgumentError
from skinshade.baking import BakeSettings, bake
from skinshade.baking.previous import without_bake
from skinshade.gltf import read_gltf

THOROUGH = BakeSettings(tensor=True, thickness=True, rays=4)
FORMS = ["glb", "external", "embedded", "two"]
MODELS = {
    "plain": gltf_shapes.plain,
    "sparse": gltf_shapes.sparse,
    "several primitives": gltf_shapes.several_primitives,
}


def files_in(folder):
    return {path.name: path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.mark.parametrize("suffix", [".glb", ".gltf"])
@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("name", MODELS)
def test_a_second_bake_gives_the_bytes_of_the_first(tmp_path, name, form, suffix):
    source = gltf_shapes.write(MODELS[name](), tmp_path / "in", form)
    for folder in ("one", "two", "three"):
        (tmp_path / folder).mkdir()
    first = bake(source, tmp_path / "one" / f"head{suffix}", THOROUGH).written[-1]
    second = bake(first, tmp_path / "two" / f"head{suffix}", THOROUGH).written[-1]
    assert files_in(tmp_path / "two") == files_in(tmp_path / "one")
    reduced = bake(second, tmp_path / "three" / f"head{suffix}").written[-1]
    (tmp_path / "direct").mkdir()
    bake(source, tmp_path / "direct" / f"head{suffix}")
    assert files_in(tmp_path / "three") == files_in(tmp_path / "direct")
    assert_valid(reduced)


@pytest.mark.parametrize("form", ["glb", "external"])
def test_repeated_bakes_in_place_do_not_grow(tmp_path, form):
    source = gltf_shapes.write(gltf_shapes.plain(), tmp_path, form)
    bake(source, source, THOROUGH, in_place=True)
    once = files_in(tmp_path)
    bake(source, source, in_place=True)
    bake(source, source, THOROUGH, in_place=True)
    again = files_in(tmp_path)
    assert {name: again[name] for name in once} == once
    # The buffer that the last bake replaced stays until the next one, for readers of the former document.
    assert len(again) - len(once) == (form == "external")
    bake(source, source, THOROUGH, in_place=True)
    assert files_in(tmp_path) == once
    assert_valid(source)


def test_an_output_that_is_the_source_is_refused_and_the_source_is_kept(tmp_path):
    source = gltf_shapes.write(gltf_shapes.plain(), tmp_path)
    content = source.read_bytes()
    (tmp_path / "folder").mkdir()
    (tmp_path / "link.glb").symlink_to(source)
    (tmp_path / "hard.glb").hardlink_to(source)
    for output in (source, tmp_path / "folder" / ".." / "head.glb", *tmp_path.glob("*k.glb")):
        with pytest.raises(ArgumentError, match="is the source itself"):
            bake(source, output)
    assert source.read_bytes() == content


def test_an_output_in_place_through_a_link_keeps_the_link(tmp_path):
    source = gltf_shapes.write(gltf_shapes.plain(), tmp_path)
    link = tmp_path / "link.glb"
    link.symlink_to(source)
    bake(source, link, in_place=True)
    assert link.is_symlink()
    assert b"_CURVATURE" in source.read_bytes()


def test_formats_that_lose_content_are_not_baked_in_place(tmp_path):
    path = tmp_path / "head.ply"
    path.write_text("ply")
    with pytest.raises(ArgumentError, match="only glTF"):
        bake(path, path, in_place=True)


def changed_document(tmp_path, change):
    """Return a baked GLB as a document after a change of its JSON."""
    source = gltf_shapes.write(gltf_shapes.plain(), tmp_path)
    baked = bake(source, tmp_path / "baked.glb", THOROUGH).written[-1]
    gltf = read_gltf(baked)
    gltf.json = json.loads(json.dumps(gltf.json))
    change(gltf.json)
    return gltf


def test_an_accessor_that_another_attribute_uses_is_kept(tmp_path):
    def share(document):
        attributes = document["meshes"][0]["primitives"][0]["attributes"]
        attributes["_COPY"] = attributes["_CURVATURE"]

    gltf = changed_document(tmp_path, share)
    index = gltf.json["meshes"][0]["primitives"][0]["attributes"]["_COPY"]
    cleaned = without_bake(gltf)
    kept = cleaned.json["meshes"][0]["primitives"][0]["attributes"]
    assert kept["_COPY"] == index < len(cleaned.json["accessors"])
    assert "_CURVATURE" not in kept


def test_bytes_after_the_attributes_of_a_bake_are_kept(tmp_path):
    """Another program appended an image."""

    def append(document):
        start = document["buffers"][0]["byteLength"] - 8
        document["bufferViews"].append({"buffer": 0, "byteOffset": start, "byteLength": 8})
        document["images"] = [
            {"bufferView": len(document["bufferViews"]) - 1, "mimeType": "image/png"}
        ]

    gltf = changed_document(tmp_path, append)
    cleaned = without_bake(gltf)
    assert cleaned.json["bufferViews"] == gltf.json["bufferViews"]
    assert cleaned.buffer(0, "test") == gltf.buffer(0, "test")


def test_a_document_without_a_note_of_a_bake_is_returned_as_it_is(tmp_path):
    def forget(document):
        del document["meshes"][0]["extras"]

    gltf = changed_document(tmp_path, forget)
    assert without_bake(gltf) is gltf


@pytest.mark.parametrize("primitives", [True, 3, "text", None, [True], [{"attributes": 5}]])
def test_primitives_of_another_type_are_left_to_the_reader(tmp_path, primitives):
    model = gltf_shapes.plain()
    model.document["meshes"] = [{"primitives": primitives, "extras": {"skinshade": {}}}]
    gltf = read_gltf(gltf_shapes.write(model, tmp_path))
    assert without_bake(gltf).json["meshes"][0].get("primitives") == primitives
