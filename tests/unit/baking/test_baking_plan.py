"""Jobs of a library: where outputs go, and which assets are current by their content."""

import os
from dataclasses import replace

import numpy as np
import pytest
import trimesh

import gltf_shapes
from skinshade._core.errors import ArgumentError
from skinshade.baking import BakeSettings
from skinshade.baking.jobs import plan_jobs, run_job
from skinshade.baking.library import bake_library

SETTINGS = BakeSettings(unit_mm=100.0)
RECORDS = ".skinshade"


def write_asset(path, index=0, form="glb"):
    """Write a tetrahedron whose size depends on the index."""
    corners = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]) * (1.0 + 0.01 * index)
    faces = np.array([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])
    if path.suffix in (".obj", ".ply", ".stl"):
        path.parent.mkdir(parents=True, exist_ok=True)
        trimesh.Trimesh(corners, faces, process=False).export(path)
        return path
    model = gltf_shapes.empty_model()
    position = model.add_accessor(corners)
    model.add_mesh(gltf_shapes.primitive(model, faces, POSITION=position))
    return gltf_shapes.write(model.with_nodes({"mesh": 0}), path.parent, form, path.stem)


# -- plans -----------------------------------------------------------------------------------------


def planned_outputs(sources, folder, **more):
    """Return the outputs, relative to the folder, by their sources."""
    jobs = plan_jobs(sources, folder, SETTINGS, **more)
    return {str(job.source): str(job.output.relative_to(folder)) for job in jobs}


def test_outputs_keep_the_folders_below_the_common_folder(tmp_path):
    for name in ("x/a.glb", "x/b.gltf", "x/deep/c.obj", "y/a.ply", "y/D.STL"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).touch()
    (tmp_path / "x" / "notes.txt").touch()
    (tmp_path / "x" / "folder.glb").mkdir()
    sources = [tmp_path / "x", tmp_path / "y", tmp_path / "x" / "a.glb"]
    outputs = planned_outputs(sources, tmp_path / "out")
    expected = {"x/a.glb": "x/a.glb", "x/b.gltf": "x/b.gltf", "x/deep/c.obj": "x/deep/c.glb"}
    expected |= {"y/a.ply": "y/a.glb", "y/D.STL": "y/D.glb"}
    assert outputs == {str(tmp_path / key): value for key, value in expected.items()}
    outputs = planned_outputs([tmp_path / "x"], tmp_path / "out", output_format="usdc")
    assert sorted(outputs.values()) == ["a.usdc", "b.usdc", "deep/c.usdc"]
    (job,) = plan_jobs([tmp_path / "x" / "a.glb"], tmp_path / "out", SETTINGS)
    assert job.record == tmp_path / "out" / RECORDS / "a.glb.json"


def test_an_unknown_output_format_is_refused_with_the_choices(tmp_path):
    source = write_asset(tmp_path / "a.glb")
    message = "output_format is 'obj'; it must be one of glb, ply, usda, usdc"
    with pytest.raises(ArgumentError, match=message):
        plan_jobs([source], tmp_path / "out", SETTINGS, "obj")


def test_models_with_the_same_output_fail_alone_and_all_of_them_are_named(tmp_path):
    for name in ("a.obj", "a.ply", "b.glb", "c.stl", "c.ply"):
        write_asset(tmp_path / name)
    results = bake_library(plan_jobs([tmp_path], tmp_path / "out", SETTINGS))
    statuses = {os.path.basename(result.source): result.status for result in results}  # noqa: PTH119
    assert statuses == dict.fromkeys(("a.obj", "a.ply", "c.ply", "c.stl"), "failed") | {
        "b.glb": "baked"
    }
    for stem, suffixes in {"a": (".obj", ".ply"), "c": (".ply", ".stl")}.items():
        errors = [result.error for result in results if f"{stem}." in result.error]
        assert len(errors) == 2
        assert all(f"{stem}{suffix}" in error for error in errors for suffix in suffixes)
    assert [path.name for path in (tmp_path / "out").glob("*.glb")] == ["b.glb"]


def test_models_with_the_same_maps_fail_alone(tmp_path):
    for name in ("a.glb", "a.gltf"):
        (tmp_path / name).touch()
    problems = [
        [bool(job.problem) for job in plan_jobs([tmp_path], tmp_path / "out", settings)]
        for settings in (SETTINGS, replace(SETTINGS, map_size=8))
    ]
    assert problems == [[False, False], [True, True]]


def test_a_symbolic_link_has_its_own_output_and_moves_no_other(tmp_path):
    write_asset(tmp_path / "in" / "a.glb")
    elsewhere = write_asset(tmp_path / "far" / "away" / "b.glb")
    (tmp_path / "in" / "link.glb").symlink_to(elsewhere)
    (tmp_path / "in" / "again.glb").symlink_to(tmp_path / "in" / "a.glb")
    outputs = planned_outputs([tmp_path / "in"], tmp_path / "out")
    assert sorted(outputs.values()) == ["a.glb", "again.glb", "link.glb"]
    results = bake_library(plan_jobs([tmp_path / "in"], tmp_path / "out", SETTINGS))
    assert [result.status for result in results] == ["baked"] * 3


def test_a_plan_without_a_model_is_refused(tmp_path):
    (tmp_path / "notes.txt").touch()
    with pytest.raises(ArgumentError, match="no model"):
        plan_jobs([tmp_path], tmp_path / "out", SETTINGS)


def test_baked_files_in_an_output_folder_inside_the_source_folder_are_no_sources(tmp_path):
    write_asset(tmp_path / "a.glb")
    for _ in range(2):
        assert list(planned_outputs([tmp_path], tmp_path / "out").values()) == ["a.glb"]
        bake_library(plan_jobs([tmp_path], tmp_path / "out", SETTINGS))


def test_a_plan_that_would_overwrite_a_source_is_refused(tmp_path):
    source = write_asset(tmp_path / "a.glb")
    with pytest.raises(ArgumentError, match="choose another output folder"):
        plan_jobs([source], tmp_path, SETTINGS)


# -- current assets --------------------------------------------------------------------------------


def append_space(path):
    path.write_bytes(path.read_bytes() + b" ")


def flip_bit(path, index=-1):
    data = bytearray(path.read_bytes())
    data[index] ^= 1
    path.write_bytes(data)


RECORD_FAULTS = ["", "[]", "{}", '{"key": 1, "files": 5}', "null", '{"files": {}, "key": "x"}']
CHANGES = {
    "nothing": ("current", lambda job: None),
    "the date of the source": ("current", lambda job: os.utime(job.source, (1, 1))),
    "the source": ("baked", lambda job: append_space(job.source)),
    "the buffer of the source": (
        "baked",
        lambda job: flip_bit(job.source.parent / "parts of it" / "a 1.bin", 0),
    ),
    "the output is missing": ("baked", lambda job: job.output.unlink()),
    "the output is changed": ("baked", lambda job: flip_bit(job.output)),
    "the new buffer is missing": (
        "baked",
        lambda job: next(job.output.parent.glob("a.skinshade-*.bin")).unlink(),
    ),
    "a copied buffer is missing": (
        "baked",
        lambda job: (job.output.parent / "parts of it" / "a 1.bin").unlink(),
    ),
    "the record is missing": ("baked", lambda job: job.record.unlink()),
    **{
        f"the record is {text!r}": ("baked", lambda job, text=text: job.record.write_text(text))
        for text in RECORD_FAULTS
    },
}


@pytest.mark.parametrize("name", CHANGES)
def test_only_an_asset_whose_content_changed_is_baked_again(tmp_path, name):
    status, change = CHANGES[name]
    write_asset(tmp_path / "in" / "a.gltf", form="external")
    (job,) = plan_jobs([tmp_path / "in"], tmp_path / "out", SETTINGS)
    assert run_job(job).status == "baked"
    times = {path: path.stat().st_mtime_ns for path in files_in(tmp_path / "out")}
    change(job)
    again = run_job(job)
    assert (again.status, again.error) == (status, "")
    # The buffer of the document that was replaced stays until the next bake.
    is_new = [path for path in files_in(tmp_path / "out") if path not in times]
    assert [path.match("a.skinshade-*.bin") for path in is_new] == [True] * (
        name == "the buffer of the source"
    )
    assert all(path.is_file() for path in times)
    if status == "current":
        assert {path: path.stat().st_mtime_ns for path in times} == times
    assert run_job(job).status == "current"


def files_in(folder):
    return [path for path in folder.rglob("*") if path.is_file()]


@pytest.mark.parametrize("change", [{"smoothing": 3}, {"unit_mm": 10.0}, {"tensor": True}])
def test_other_settings_bake_an_asset_again(tmp_path, change):
    write_asset(tmp_path / "in" / "a.glb")
    for settings in (SETTINGS, replace(SETTINGS, **change)):
        (job,) = plan_jobs([tmp_path / "in"], tmp_path / "out", settings)
        assert run_job(job).status == "baked"
        assert run_job(job).status == "current"
