"""Which asset goes where, and what is current by its content and left alone."""

import os
from dataclasses import replace

import numpy as np
import pytest

import gltf_shapes
from skinshade._core.errors import ArgumentError
from skinshade.bake import BakeSettings
from skinshade.bake.jobs import plan, run
from skinshade.bake.library import bake_library

SETTINGS = BakeSettings(unit_mm=1000.0)
RECORDS = ".skinshade"


def write_asset(path, index=0, form="glb"):
    """A tetrahedron of its own shape, or whatever the index makes of it."""
    corners = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]) * (1.0 + 0.01 * index)
    faces = np.array([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])
    if path.suffix in (".obj", ".ply", ".stl"):
        import trimesh

        path.parent.mkdir(parents=True, exist_ok=True)
        trimesh.Trimesh(corners, faces, process=False).export(path)
        return path
    built = gltf_shapes.new()
    position = built.accessor(corners)
    built.mesh(gltf_shapes.primitive(built, faces, POSITION=position))
    return gltf_shapes.write(built.show({"mesh": 0}), path.parent, form, path.stem)


# -- the plan --------------------------------------------------------------------------------------


def outputs(sources, folder, **more):
    jobs = plan(sources, folder, more.pop("settings", SETTINGS), **more)
    return {str(job.source): str(job.output.relative_to(folder)) for job in jobs}


def test_places_below_the_common_folder_are_kept(tmp_path):
    for name in ("x/a.glb", "x/b.gltf", "x/deep/c.obj", "y/a.ply", "y/D.STL"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).touch()
    (tmp_path / "x" / "notes.txt").touch()
    (tmp_path / "x" / "folder.glb").mkdir()
    found = outputs([tmp_path / "x", tmp_path / "y", tmp_path / "x" / "a.glb"], tmp_path / "out")
    places = {"x/a.glb": "x/a.glb", "x/b.gltf": "x/b.gltf", "x/deep/c.obj": "x/deep/c.glb"}
    places |= {"y/a.ply": "y/a.glb", "y/D.STL": "y/D.glb"}
    assert found == {str(tmp_path / key): value for key, value in places.items()}
    found = outputs([tmp_path / "x"], tmp_path / "out", suffix=".usdc")
    assert sorted(found.values()) == ["a.usdc", "b.usdc", "deep/c.usdc"]
    (job,) = plan([tmp_path / "x" / "a.glb"], tmp_path / "out", SETTINGS)
    assert job.record == tmp_path / "out" / RECORDS / "a.glb.json"


def test_two_models_of_one_place_are_refused(tmp_path):
    for name in ("a.obj", "a.ply"):
        (tmp_path / name).touch()
    with pytest.raises(ArgumentError, match=r"a\.obj and .*a\.ply would both become"):
        plan([tmp_path], tmp_path / "out", SETTINGS)


def test_two_models_whose_maps_have_one_name_are_refused(tmp_path):
    for name in ("a.glb", "a.gltf"):
        (tmp_path / name).touch()
    assert len(plan([tmp_path], tmp_path / "out", SETTINGS)) == 2
    with pytest.raises(ArgumentError, match="would both become"):
        plan([tmp_path], tmp_path / "out", replace(SETTINGS, map_size=8))


def test_no_model_is_refused(tmp_path):
    (tmp_path / "notes.txt").touch()
    with pytest.raises(ArgumentError, match="no model"):
        plan([tmp_path], tmp_path / "out", SETTINGS)


def test_what_was_baked_into_a_folder_within_is_no_source(tmp_path):
    write_asset(tmp_path / "a.glb")
    for _ in range(2):
        assert list(outputs([tmp_path], tmp_path / "out").values()) == ["a.glb"]
        bake_library(plan([tmp_path], tmp_path / "out", SETTINGS))


def test_a_source_is_never_overwritten(tmp_path):
    source = write_asset(tmp_path / "a.glb")
    with pytest.raises(ArgumentError, match="choose another output folder"):
        plan([source], tmp_path, SETTINGS)


# -- what is current -------------------------------------------------------------------------------


def change(path, by=b" "):
    path.write_bytes(path.read_bytes() + by)


def corrupt(path, at=-1):
    data = bytearray(path.read_bytes())
    data[at] ^= 1
    path.write_bytes(data)


RECORD_FAULTS = ["", "[]", "{}", '{"key": 1, "files": 5}', "null", '{"files": {}, "key": "x"}']
CHANGES = {
    "nothing": ("current", lambda job: None),
    "the source's date": ("current", lambda job: os.utime(job.source, (1, 1))),
    "the source": ("baked", lambda job: change(job.source)),
    "the buffer beside it": (
        "baked",
        lambda job: corrupt(job.source.parent / "parts of it" / "a 1.bin", 0),
    ),
    "the output is gone": ("baked", lambda job: job.output.unlink()),
    "the output is another": ("baked", lambda job: corrupt(job.output)),
    "the new buffer is gone": (
        "baked",
        lambda job: job.output.with_name("a.skinshade.bin").unlink(),
    ),
    "a carried buffer is gone": (
        "baked",
        lambda job: (job.output.parent / "parts of it" / "a 1.bin").unlink(),
    ),
    "the record is gone": ("baked", lambda job: job.record.unlink()),
    **{
        f"the record is {text!r}": ("baked", lambda job, text=text: job.record.write_text(text))
        for text in RECORD_FAULTS
    },
}


@pytest.mark.parametrize("name", CHANGES)
def test_what_is_current_by_content_is_left_alone(tmp_path, name):
    expected, act = CHANGES[name]
    write_asset(tmp_path / "in" / "a.gltf", form="external")
    (job,) = plan([tmp_path / "in"], tmp_path / "out", SETTINGS)
    assert run(job).status == "baked"
    first = {path: path.stat().st_mtime_ns for path in assets_paths(tmp_path / "out")}
    act(job)
    again = run(job)
    assert (again.status, again.error) == (expected, "")
    assert set(assets_paths(tmp_path / "out")) == set(first)
    if expected == "current":
        assert {path: path.stat().st_mtime_ns for path in first} == first
    assert run(job).status == "current"


def test_what_a_killed_process_left_half_written_is_removed(tmp_path):
    """Hidden files stayed in the library forever, and were models by their suffix."""
    write_asset(tmp_path / "in" / "a.glb")
    write_asset(tmp_path / "in" / "a-b.glb")
    job = plan([tmp_path / "in"], tmp_path / "out", replace(SETTINGS, map_size=4))[-1]
    assert job.output.name == "a.glb"
    job.record.parent.mkdir(parents=True)
    left = [job.output.parent / ".a-abcd_123.glb", job.record.parent / ".a.glb-12345678.json"]
    left += [job.output.parent / ".a.curvature-abcdefgh.exr"]
    others = [
        job.output.parent / name for name in (".a-b-abcd_123.glb", ".a-b.glb", "a-12345678.glb")
    ]
    for path in (*left, *others):
        path.touch()
    run(job)
    assert [path.exists() for path in left] == [False] * len(left)
    assert [path.exists() for path in others] == [True] * len(others)


def test_a_body_of_one_curvature_has_a_histogram(tmp_path):
    """Values that are equal but for rounding left no room for bins: an internal error."""
    write_asset(tmp_path / "in" / "a.glb")
    (job,) = plan([tmp_path / "in"], tmp_path / "out", SETTINGS)
    result = run(job)
    assert result.error == ""
    assert sum(result.meshes[0]["histograms"]["curvature"]) == 4


def assets_paths(folder):
    return [path for path in folder.rglob("*") if path.is_file()]


@pytest.mark.parametrize("change", [{"smoothing": 3}, {"unit_mm": 10.0}, {"tensor": True}])
def test_other_settings_bake_again(tmp_path, change):
    write_asset(tmp_path / "in" / "a.glb")
    for settings, status in ((SETTINGS, "baked"), (replace(SETTINGS, **change), "baked")):
        (job,) = plan([tmp_path / "in"], tmp_path / "out", settings)
        assert run(job).status == status
        assert run(job).status == "current"
