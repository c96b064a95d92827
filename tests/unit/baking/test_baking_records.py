"""Records of assets: hostile ones are ignored, valid ones decide which assets are current."""

import copy
import json
import os
import shutil
import sys
import tracemalloc
from dataclasses import fields, replace

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from test_baking_plan import SETTINGS, write_asset

from skinshade.baking import records
from skinshade.baking.jobs import JobResult, plan_jobs, run_job
from skinshade.baking.records import (
    MESH,
    RECORD,
    MeshRecord,
    Record,
    are_unchanged,
    file_hash,
    read_record,
    write_record,
)
from skinshade.baking.report import write_page, write_report

ONE_FOLDER = [HealthCheck.function_scoped_fixture]
"""All examples write to one folder."""


def baked_job(folder, with_thumbnails=False):
    """Return a job that has run, and the content of its record."""
    write_asset(folder / "in" / "a.glb")
    jobs = plan_jobs([folder / "in"], folder / "out", SETTINGS, with_thumbnails=with_thumbnails)
    assert run_job(jobs[0]).error == ""
    return jobs[0], json.loads(jobs[0].record.read_text("ascii"))


@pytest.fixture(scope="module")
def baked(tmp_path_factory):
    return baked_job(tmp_path_factory.mktemp("baked"), with_thumbnails=True)


# -- content ---------------------------------------------------------------------------------------


def test_a_record_describes_the_mesh(baked):
    job, content = baked
    (mesh,) = content["meshes"]
    assert (content["source"], content["output"]) == ("a.glb", "a.glb")
    assert content["files"] == {"a.glb": file_hash(job.output)}
    assert content["thumbnail"] == file_hash(job.thumbnail)
    assert (mesh["vertices"], mesh["triangles"], mesh["unit_mm"]) == (4, 4, 100.0)
    assert mesh["size_mm"] == [200.0] * 3
    assert mesh["notes"] == {"normals computed": 4}


def test_a_mesh_of_constant_curvature_has_a_histogram(baked):
    """Values that are equal except for rounding leave no range for bins."""
    assert sum(baked[1]["meshes"][0]["histograms"]["curvature"]) == 4


TEXT = st.text(st.characters(), max_size=20)  # includes lone surrogates
NAMES = st.text(st.characters(exclude_characters="/\0."), min_size=1, max_size=20)


@settings(suppress_health_check=ONE_FOLDER)
@given(files=st.dictionaries(NAMES, st.just("0" * 64), min_size=1, max_size=3), source=NAMES)
def test_a_record_with_any_names_is_read_as_it_was_written(tmp_path, baked, files, source):
    record = replace(read_record(baked[0].record), files=files, source=source)
    write_record(record, tmp_path / "a.json")
    assert read_record(tmp_path / "a.json") == record


def test_records_of_a_library_do_not_depend_on_its_folders(tmp_path):
    contents = []
    for name in ("one", "two"):
        job, _ = baked_job(tmp_path / name)
        contents.append(job.record.read_bytes())
        assert str(tmp_path).encode() not in contents[-1]
    assert contents[0] == contents[1]


def test_the_assets_of_a_library_that_was_moved_are_current(tmp_path):
    baked_job(tmp_path / "old", with_thumbnails=True)
    shutil.move(tmp_path / "old", tmp_path / "new")
    new = tmp_path / "new"
    (job,) = plan_jobs([new / "in"], new / "out", SETTINGS, with_thumbnails=True)
    assert run_job(job).status == "current"


def test_the_schemas_have_the_fields_of_the_records():
    for kind, schema in ((Record, RECORD), (MeshRecord, MESH)):
        assert list(schema) == [field.name for field in fields(kind)]


# -- hostile content -------------------------------------------------------------------------------

LEAVES = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(),
    st.sampled_from([10**400, -1, 2**64, 1e308, float("nan"), float("inf"), "0" * 64, "../a", ""]),
    st.floats(),
    TEXT,
)
VALUES = st.recursive(
    LEAVES, lambda inner: st.lists(inner, max_size=3) | st.dictionaries(TEXT, inner, max_size=3)
)


def positions(value, path=()):
    """Return the path of every value in a document of JSON."""
    if not isinstance(value, (dict, list)):
        return [path]
    items = value.items() if isinstance(value, dict) else enumerate(value)
    return [path, *(p for key, child in items for p in positions(child, (*path, key)))]


def different_positions(content):
    """Return the paths without those of all bins of a histogram but the first three."""
    return [path for path in positions(content) if not path or path[-1] not in range(3, 48)]


@settings(max_examples=200, suppress_health_check=ONE_FOLDER)
@given(data=st.data(), value=VALUES, action=st.sampled_from(["replace", "remove", "add"]))
def test_a_record_with_any_value_anywhere_is_ignored_or_has_a_page(
    tmp_path, baked, data, value, action
):
    job, content = baked
    content = copy.deepcopy(content)
    *parents, last = data.draw(st.sampled_from(different_positions(content)[1:]))
    target = content
    for key in parents:
        target = target[key]
    if action == "remove":
        del target[last]
    elif action == "add" and isinstance(target, dict):
        target[data.draw(TEXT)] = value
    else:
        target[last] = value
    path = tmp_path / "record.json"
    path.write_text(json.dumps(content), encoding="ascii")
    record = read_record(path)
    if record is not None:
        names = str(job.source), str(job.output)
        result = JobResult(*names, "current", "", record.key, record.files, record.meshes)
        write_page([job], [result], tmp_path / "page.html")
        write_report([job], [result], tmp_path / "report.json")
        assert isinstance(are_unchanged(record.files, tmp_path), bool)
        write_record(record, path)
        assert read_record(path) == record


def changed(content, path, value):
    content = copy.deepcopy(content)
    *parents, last = path
    target = content
    for key in parents:
        target = target[key]
    target[last] = value
    return content


FIRST_MESH = ("meshes", 0)
HOSTILE = {
    "an unknown key": (("more",), 1),
    "an absolute source": (("source",), "/secret/a.glb"),
    "an output outside": (("output",), "../a.glb"),
    "a key that is no hash": (("key",), "x"),
    "no files": (("files",), {}),
    "another file": (("files",), {"b.glb": "0" * 64}),
    "a thumbnail that is no hash": (("thumbnail",), "../../secret.png"),
    "an unknown key of a mesh": ((*FIRST_MESH, "more"), 1),
    "a name of a million characters": ((*FIRST_MESH, "name"), "x" * 10**6),
    "a unit of zero": ((*FIRST_MESH, "unit_mm"), 0.0),
    "a unit that is text": ((*FIRST_MESH, "unit_mm"), "1.0"),
    "a negative count": ((*FIRST_MESH, "vertices"), -1),
    "a count that is true": ((*FIRST_MESH, "triangles"), True),
    "a count that is no integer": ((*FIRST_MESH, "triangles"), 4.0),
    "a size of two lengths": ((*FIRST_MESH, "size_mm"), [1.0, 1.0]),
    "a range of three values": ((*FIRST_MESH, "ranges", "curvature"), [0.0, 0.0, 0.0]),
    "an infinite range": ((*FIRST_MESH, "ranges", "curvature"), [0.0, float("inf")]),
    "a range without histogram": ((*FIRST_MESH, "ranges", "tensor"), [0.0, 1.0]),
    "a histogram of an unknown attribute": ((*FIRST_MESH, "histograms", "<b>"), [1] * 48),
    "a histogram without range": ((*FIRST_MESH, "histograms", "tensor"), [1] * 48),
    "an empty histogram": ((*FIRST_MESH, "histograms", "curvature"), []),
    "a histogram of a million bins": ((*FIRST_MESH, "histograms", "curvature"), [1] * 10**6),
    "a count of 10^400": ((*FIRST_MESH, "histograms", "curvature"), [10**400] * 48),
    "a note that is no count": ((*FIRST_MESH, "notes"), {"x": "<script>"}),
    "a note of a million characters": ((*FIRST_MESH, "notes"), {"x" * 10**6: 1}),
    "a thousand notes": ((*FIRST_MESH, "notes"), {str(i): 1 for i in range(1000)}),
}


@pytest.mark.parametrize("fault", HOSTILE)
def test_a_hostile_record_is_ignored_and_the_asset_is_baked_again(baked, fault):
    job, content = baked
    assert read_record(job.record) is not None
    valid = job.record.read_bytes()
    job.record.write_text(json.dumps(changed(content, *HOSTILE[fault])), encoding="ascii")
    assert run_job(job).status == "baked"
    assert job.record.read_bytes() == valid
    assert run_job(job).status == "current"


def test_a_record_that_is_too_large_is_ignored(baked, tmp_path, monkeypatch):
    path = shutil.copy(baked[0].record, tmp_path / "a.json")
    monkeypatch.setattr(records, "LARGEST_RECORD", path.stat().st_size)
    assert read_record(path) is not None
    monkeypatch.setattr(records, "LARGEST_RECORD", path.stat().st_size - 1)
    assert read_record(path) is None


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"\xff\xfe",
        b'\xef\xbb\xbf{"key": 1}',
        b"[" * 100_000,
        b'{"a":' * 5000,
        b'{"key": 1, "key": 2}',
        b"1" * 5000,
        b"NaN",
        b'"\\ud800"',
    ],
)
def test_a_file_that_is_no_record_is_ignored(tmp_path, data):
    (tmp_path / "a.json").write_bytes(data)
    assert read_record(tmp_path / "a.json") is None


def test_hostile_json_takes_less_than_a_hundred_times_its_size_of_memory(tmp_path):
    """A validator that collects every fault took a thousand times the size."""
    data = b'{"meshes":[' + b"{}," * (1 << 16) + b"0]}"
    (tmp_path / "a.json").write_bytes(data)
    tracemalloc.start()
    try:
        assert read_record(tmp_path / "a.json") is None
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak < 100 * len(data)


def test_a_record_that_is_no_regular_file_is_ignored(tmp_path):
    assert read_record(tmp_path) is None
    assert read_record(tmp_path / "missing.json") is None
    if sys.platform != "win32":
        os.mkfifo(tmp_path / "pipe.json")  # reading it would wait for a writer
        assert read_record(tmp_path / "pipe.json") is None


# -- names of files --------------------------------------------------------------------------------


def test_files_outside_the_folder_are_never_unchanged(tmp_path):
    """Each hash is right; only the place of the file is at fault."""
    folder = tmp_path / "out"
    folder.mkdir()
    secret = tmp_path / "secret.bin"
    secret.write_bytes(b"secret")
    (folder / "inside.bin").write_bytes(b"secret")
    (folder / "link.bin").symlink_to(secret)
    (folder / "linked").symlink_to(tmp_path)
    (folder / "loop").symlink_to("loop")
    value = file_hash(secret)
    assert are_unchanged({"inside.bin": value}, folder)
    for name in (
        "../secret.bin",
        str(secret),
        "link.bin",
        "linked/secret.bin",
        "loop",
        "\0",
        "x" * 999,
    ):
        assert not are_unchanged({"inside.bin": value, name: value}, folder), name


def test_a_pipe_in_the_place_of_a_file_is_not_read(tmp_path):
    if sys.platform == "win32":
        pytest.skip("Windows has no pipes in folders")
    os.mkfifo(tmp_path / "pipe")
    assert not are_unchanged({"pipe": "0" * 64}, tmp_path)


def test_a_record_that_omits_the_output_does_not_make_it_current(tmp_path):
    job, content = baked_job(tmp_path)
    job.output.unlink()
    (job.output.parent / "b.bin").write_bytes(b"b")
    content["files"] = {"b.bin": file_hash(job.output.parent / "b.bin")}
    job.record.write_text(json.dumps(content), encoding="ascii")
    assert run_job(job).status == "baked"
    assert job.output.is_file()


def test_a_thumbnail_that_is_older_than_the_asset_is_drawn_again(tmp_path):
    job, _ = baked_job(tmp_path, with_thumbnails=True)
    before = job.thumbnail.read_bytes()
    write_asset(job.source, 60)
    (without,) = plan_jobs([tmp_path / "in"], tmp_path / "out", SETTINGS)
    assert run_job(without).status == "baked"
    assert run_job(job).status == "baked"
    assert run_job(job).status == "current"
    job.thumbnail.write_bytes(before[:-1])
    assert run_job(job).status == "baked", "the thumbnail is damaged"
    assert run_job(job).status == "current"


def test_a_name_that_is_not_utf_8_is_baked_and_then_current(tmp_path):
    source = write_asset(tmp_path / "in" / "a.glb")
    try:
        source.rename(tmp_path / "in" / os.fsdecode(b"latin\xe9.glb"))
    except OSError:
        pytest.skip("the file system has no such names")
    (job,) = plan_jobs([tmp_path / "in"], tmp_path / "out", SETTINGS, with_thumbnails=True)
    results = [run_job(job), run_job(job)]
    assert [(result.status, result.error) for result in results] == [("baked", ""), ("current", "")]
    write_report([job], results[1:], tmp_path / "out" / "report.json")
    report = json.loads((tmp_path / "out" / "report.json").read_text("ascii"))
    assert os.fsencode(report["assets"][0]["output"]) == b"latin\xe9.glb"
