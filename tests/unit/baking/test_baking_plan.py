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

SETTINGS = BakeSettings(unit_mm=1000.0)
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


def test_two_models_with_the_same_output_are_refused(tmp_path):
    for name in ("a.obj", "a.ply"):
        (tmp_path / name).touch()
    with pytest.raises(ArgumentError, match=r"a\.obj and .*a\.ply would both be written to"):
        plan_jobs([tmp_path], tmp_path / "out", SETTINGS)


def test_two_models_with_the_same_maps_are_refused(tmp_path):
    for name in ("a.glb", "a.gltf"):
        (tmp_path / name).touch()
    assert len(plan_jobs([tmp_path], tmp_path / "out", SETTINGS)) == 2
    with pytest.raises(ArgumentError, match="would both be written to"):
        plan_jobs([tmp_path], tmp_path / "out", replace(SETTINGS, map_size=8))


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
        lambda job: job.output.with_name("a.skinshade.bin").unlink(),
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
    assert set(files_in(tmp_path / "out")) == set(times)
    if status == "current":
        assert {path: path.stat().st_mtime_ns for path in times} == times
    assert run_job(job).status == "current"


def test_temporary_files_of_a_killed_process_are_removed(tmp_path):
    """Otherwise the hidden files stay in the library, and count as models by their suffix."""
    write_asset(tmp_path / "in" / "a.glb")
    write_asset(tmp_path / "in" / "a-b.glb")
    job = plan_jobs([tmp_path / "in"], tmp_path / "out", replace(SETTINGS, map_size=4))[-1]
    assert job.output.name == "a.glb"
    job.record.parent.mkdir(parents=True)
    folder = job.output.parent
    temporary = [folder / ".a-abcd_123.glb", job.record.parent / ".a.glb-12345678.json"]
    temporary += [folder / ".a.curvature-abcdefgh.exr"]
    others = [folder / name for name in (".a-b-abcd_123.glb", ".a-b.glb", "a-12345678.glb")]
    for path in (*temporary, *others):
        path.touch()
    run_job(job)
    assert [path.exists() for path in temporary] == [False] * len(temporary)
    assert [path.exists() for path in others] == [True] * len(others)


def test_a_mesh_of_constant_curvature_has_a_histogram(tmp_path):
    """Values that are equal except for rounding leave no range for bins."""
    write_asset(tmp_path / "in" / "a.glb")
    (job,) = plan_jobs([tmp_path / "in"], tmp_path / "out", SETTINGS)
    result = run_job(job)
    assert result.error == ""
    assert sum(result.meshes[0]["histograms"]["curvature"]) == 4


def files_in(folder):
    return [path for path in folder.rglob("*") if path.is_file()]


@pytest.mark.parametrize("change", [{"smoothing": 3}, {"unit_mm": 10.0}, {"tensor": True}])
def test_other_settings_bake_an_asset_again(tmp_path, change):
    write_asset(tmp_path / "in" / "a.glb")
    for settings in (SETTINGS, replace(SETTINGS, **change)):
        (job,) = plan_jobs([tmp_path / "in"], tmp_path / "out", settings)
        assert run_job(job).status == "baked"
        assert run_job(job).status == "current"
