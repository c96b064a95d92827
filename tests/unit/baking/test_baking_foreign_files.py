"""A bake replaces and removes only its own files."""

import hashlib
import json
import os
import shutil
import stat
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import gltf_shapes
from skinshade._core.errors import FileError, InputError, MeshFileError, OutputError
from skinshade._core.files import TEMPORARY_MARK
from skinshade._core.processes import MACHINE, output_lock
from skinshade.baking import BakeSettings, bake
from skinshade.baking.jobs import plan_jobs
from skinshade.baking.library import bake_library
from skinshade.scene.images import write_png

PROCESS_LIMIT = 2**22
"""Greatest process number of Linux."""


def with_image(folder, uri, content=gltf_shapes.PNG, stem="face"):
    """Write a GLB that refers to a file beside it."""
    model = gltf_shapes.plain()
    model.document["images"] = [{"uri": uri}]
    file = folder / uri
    file.parent.mkdir(parents=True, exist_ok=True)
    if not file.exists():
        file.write_bytes(content)
    return gltf_shapes.write(model, folder, stem=stem)


# -- copies ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "uri",
    [".bashrc", "Makefile", ".ssh/authorized_keys", ".hidden.png", ".git/x.png", "run.sh", "b.glb"],
)
def test_files_that_are_no_images_or_buffers_are_not_copied(tmp_path, uri):
    source = with_image(tmp_path / "pack", uri, b"hostile")
    home = tmp_path / "home"
    (home / uri).parent.mkdir(parents=True)
    (home / uri).write_bytes(b"precious")
    with pytest.raises(MeshFileError, match="not copied") as caught:
        bake(source, home / "face.glb")
    assert Path(uri).name in str(caught.value)
    assert (home / uri).read_bytes() == b"precious"
    assert [path for path in home.rglob("*") if path.is_file()] == [home / uri]


def test_a_link_to_a_file_that_is_no_image_is_not_copied(tmp_path):
    source = with_image(tmp_path / "pack", "secret")
    (tmp_path / "pack" / "skin.png").symlink_to("secret")
    source = with_image(tmp_path / "pack", "skin.png")
    with pytest.raises(MeshFileError, match="not copied"):
        bake(source, tmp_path / "face.glb")


def test_an_image_is_never_copied_onto_another_file(tmp_path):
    source = with_image(tmp_path / "pack", "skin.png")
    (tmp_path / "skin.png").write_bytes(b"the user's own image")
    with pytest.raises(OutputError) as caught:
        bake(source, tmp_path / "face.glb")
    assert str(tmp_path / "skin.png") in str(caught.value)
    assert str(tmp_path / "pack" / "skin.png") in str(caught.value)
    assert (tmp_path / "skin.png").read_bytes() == b"the user's own image"
    assert not (tmp_path / "face.glb").exists()


def test_an_equal_image_at_the_target_is_kept_and_counted(tmp_path):
    source = with_image(tmp_path / "pack", "skin.png")
    shutil.copy(tmp_path / "pack" / "skin.png", tmp_path / "skin.png")
    before = (tmp_path / "skin.png").stat()
    written = bake(source, tmp_path / "face.glb").written
    assert [path.name for path in written] == ["skin.png", "face.glb"]
    after = (tmp_path / "skin.png").stat()
    assert (after.st_ino, after.st_mtime_ns) == (before.st_ino, before.st_mtime_ns)


def test_copies_have_the_permissions_of_new_files(tmp_path):
    source = with_image(tmp_path / "pack", "skin.png")
    (tmp_path / "pack" / "skin.png").chmod(0o777)
    bake(source, tmp_path / "face.glb")
    new = tmp_path / "new"
    new.touch()
    assert (tmp_path / "skin.png").stat().st_mode == new.stat().st_mode
    assert not stat.S_IMODE(new.stat().st_mode) & stat.S_IXUSR


def test_copies_do_not_leave_the_output_folder_through_a_link(tmp_path):
    source = with_image(tmp_path / "pack", "maps/skin.png")
    (tmp_path / "out").mkdir()
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "out" / "maps").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(OutputError, match="leads out of the output folder"):
        bake(source, tmp_path / "out" / "face.glb")
    assert not list((tmp_path / "elsewhere").iterdir())


@pytest.mark.parametrize("form", ["absolute", "through the parent"])
def test_a_name_that_leads_out_of_the_folder_and_back_is_refused(tmp_path, form):
    pack = tmp_path / "pack"
    source = with_image(pack, "skin.png")
    uri = {"absolute": str(pack / "skin.png"), "through the parent": "../pack/skin.png"}[form]
    document = gltf_shapes.plain()
    document.document["images"] = [{"uri": uri}]
    source = gltf_shapes.write(document, pack, stem="face")
    with pytest.raises(MeshFileError, match="leaves the asset's folder"):
        bake(source, tmp_path / "face.glb")


def test_an_asset_of_a_library_does_not_replace_another_asset(tmp_path):
    gltf_shapes.write(gltf_shapes.plain(), tmp_path / "in", stem="b")
    with_image(tmp_path / "in", "b.glb", stem="a")
    results = bake_library(plan_jobs([tmp_path / "in"], tmp_path / "out", BakeSettings()))
    assert [result.status for result in results] == ["failed", "baked"]
    assert b"_CURVATURE" in (tmp_path / "out" / "b.glb").read_bytes()


def test_a_changed_texture_of_a_library_replaces_the_former_copy(tmp_path):
    with_image(tmp_path / "in", "skin.png")
    with_image(tmp_path / "in", "skin.png", stem="second")
    jobs = plan_jobs([tmp_path / "in"], tmp_path / "out", BakeSettings())
    assert [result.status for result in bake_library(jobs)] == ["baked"] * 2
    (tmp_path / "in" / "skin.png").write_bytes(gltf_shapes.PNG + b"changed")
    assert [result.status for result in bake_library(jobs)] == ["baked"] * 2
    assert (tmp_path / "out" / "skin.png").read_bytes() == gltf_shapes.PNG + b"changed"


def test_a_copy_that_the_user_edited_is_not_replaced(tmp_path):
    with_image(tmp_path / "in", "skin.png")
    jobs = plan_jobs([tmp_path / "in"], tmp_path / "out", BakeSettings())
    bake_library(jobs)
    (tmp_path / "out" / "skin.png").write_bytes(b"edited")
    (result,) = bake_library(jobs)
    assert result.status == "failed"
    assert "skin.png" in result.error
    assert (tmp_path / "out" / "skin.png").read_bytes() == b"edited"


def test_a_linked_texture_keeps_the_name_that_the_document_uses(tmp_path):
    source = with_image(tmp_path / "pack", "shared/original.png")
    (tmp_path / "pack" / "skin.png").symlink_to("shared/original.png")
    source = with_image(tmp_path / "pack", "skin.png")
    written = bake(source, tmp_path / "face.glb").written
    assert [path.name for path in written] == ["skin.png", "face.glb"]


# -- maps ------------------------------------------------------------------------------------------


def test_a_map_replaces_a_former_map_and_no_other_image(tmp_path):
    source = gltf_shapes.write(gltf_shapes.plain(), tmp_path / "in")
    settings = BakeSettings(map_size=8, map_format="png")
    bake(source, tmp_path / "head.glb", settings)
    bake(source, tmp_path / "head.glb", BakeSettings(map_size=16, map_format="png"))
    write_png(tmp_path / "head.curvature.png", np.zeros((4, 4, 3), dtype=np.uint8))
    before = (tmp_path / "head.curvature.png").read_bytes()
    with pytest.raises(OutputError, match="is no map of skinshade"):
        bake(source, tmp_path / "head.glb", settings)
    assert (tmp_path / "head.curvature.png").read_bytes() == before


def test_maps_of_several_meshes_and_of_an_asset_with_a_number_have_different_names(tmp_path):
    for stem, model in (("a", gltf_shapes.several_primitives()), ("a-0", gltf_shapes.plain())):
        gltf_shapes.write(model, tmp_path / "in", stem=stem)
    settings = BakeSettings(map_size=8)
    jobs = plan_jobs([tmp_path / "in"], tmp_path / "out", settings)
    results = bake_library(jobs)
    names = [name for result in results for name in result.files]
    assert len(names) == len(set(names)) == 2 + 2 * 3
    assert [result.status for result in bake_library(jobs)] == ["current"] * 2


# -- temporary files -------------------------------------------------------------------------------


def temporary_name(process, suffix=".glb", machine=MACHINE):
    return f"{TEMPORARY_MARK}{machine}-{process}-{'0' * 16}{suffix}"


def test_only_temporary_files_of_dead_processes_of_this_machine_are_removed(tmp_path):
    source = gltf_shapes.write(gltf_shapes.plain(), tmp_path / "in")
    out = tmp_path / "out"
    out.mkdir()
    dead = [out / temporary_name(PROCESS_LIMIT + 1, suffix) for suffix in (".glb", ".bin", "")]
    kept = [
        out / temporary_name(os.getpid()),
        out / temporary_name(PROCESS_LIMIT + 1, machine="0123abcd"),
        *(out / name for name in (".head-original.glb", ".head-abcd_123.glb", "head-12345678.glb")),
        out / f"{TEMPORARY_MARK}notes.txt",
    ]
    for path in (*dead, *kept):
        path.touch()
    bake(source, out / "head.glb")
    assert [path.exists() for path in dead] == [False] * len(dead)
    assert [path.exists() for path in kept] == [True] * len(kept)


def test_a_hidden_asset_is_baked_and_kept(tmp_path):
    """A file with a name such as `.head-original.glb` once counted as a temporary file."""
    gltf_shapes.write(gltf_shapes.plain(), tmp_path / "in", stem=".head-original")
    gltf_shapes.write(gltf_shapes.plain(), tmp_path / "in", stem="head")
    jobs = plan_jobs([tmp_path / "in"], tmp_path / "out", BakeSettings())
    bake_library(jobs)
    assert [result.status for result in bake_library(jobs)] == ["current"] * 2
    assert (tmp_path / "out" / ".head-original.glb").is_file()


# -- readers during a bake -------------------------------------------------------------------------

WRITER = """
import sys
from skinshade.baking import BakeSettings, bake
for tensor in [False, True] * 12:
    bake(sys.argv[1], sys.argv[2], BakeSettings(tensor=tensor))
"""


@pytest.mark.slow
def test_readers_never_see_a_document_without_its_buffer(tmp_path):
    """Two settings alternate in another process, and every document that is read has its whole buffer."""
    source = gltf_shapes.write(gltf_shapes.plain(), tmp_path / "in")
    output = tmp_path / "head.gltf"
    bake(source, output)
    arguments = [sys.executable, "-c", WRITER, str(source), str(output)]
    reads, documents = 0, set()
    with subprocess.Popen(arguments) as writer:
        while writer.poll() is None:
            text = output.read_text(encoding="utf-8")
            for buffer in json.loads(text)["buffers"]:
                data = (tmp_path / buffer["uri"]).read_bytes()
                assert len(data) == buffer["byteLength"]
                assert hashlib.sha256(data).hexdigest()[:16] in buffer["uri"]
            reads += 1
            documents.add(text)
    assert writer.returncode == 0
    assert len(documents) == 2
    assert reads > 100


def test_two_bakes_of_one_output_at_the_same_time_name_the_first(tmp_path):
    source = gltf_shapes.write(gltf_shapes.plain(), tmp_path / "in")
    with (
        output_lock(tmp_path / "head.glb"),
        pytest.raises(OutputError, match=f"process {os.getpid()} on .* is writing it"),
    ):
        bake(source, tmp_path / "head.glb")
    bake(source, tmp_path / "head.glb")


# -- what a failure leaves -------------------------------------------------------------------------


def test_a_failed_replacement_keeps_the_former_document_with_its_buffer(tmp_path, monkeypatch):
    source = gltf_shapes.write(gltf_shapes.plain(), tmp_path / "in", "embedded")
    output = tmp_path / "head.gltf"
    bake(source, output)
    before = output.read_bytes()
    replace = Path.replace

    def failing(self, target):
        if target.suffix == ".gltf":
            raise OSError(28, "No space left on device")
        return replace(self, target)

    monkeypatch.setattr(Path, "replace", failing)
    with pytest.raises(OutputError, match="No space left"):
        bake(source, output, BakeSettings(tensor=True))
    monkeypatch.undo()
    assert output.read_bytes() == before
    own = [buffer for buffer in json.loads(before)["buffers"] if "skinshade" in buffer["uri"]]
    assert len(own) == 1
    assert len((tmp_path / own[0]["uri"]).read_bytes()) == own[0]["byteLength"]
    assert not list(tmp_path.glob(f"{TEMPORARY_MARK}*"))


@pytest.mark.parametrize("suffix", [".glb", ".gltf", ".ply"])
def test_an_asset_that_fails_leaves_no_file(tmp_path, suffix):
    path = tmp_path / "in" / "broken.glb"
    path.parent.mkdir()
    path.write_bytes(b"glTF")
    out = tmp_path / "out"
    out.mkdir()
    with pytest.raises((InputError, FileError)):
        bake(path, out / f"broken{suffix}")
    assert list(out.iterdir()) == []
