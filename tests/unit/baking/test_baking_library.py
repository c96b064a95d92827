"""Libraries of assets: every kind of worker writes the same bytes, and a crash loses no result."""

import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from test_baking_plan import RECORDS, SETTINGS, write_asset

import skinshade
from skinshade._core.errors import ArgumentError, BackendError, DependencyError
from skinshade.baking.jobs import plan_jobs, run_job
from skinshade.baking.library import bake_library
from skinshade.baking.report import write_page, write_report

ASSETS, BAD = 200, 5


def corrupt(path, fault):
    """Corrupt an asset by one of five faults."""
    data = path.read_bytes()
    contents = {
        0: data[: len(data) // 2],
        1: b"once upon a time",
        2: data.replace(b'"POSITION"', b'"POSITIOM"'),
        3: data.replace(np.float32(1.0).tobytes(), np.float32(np.nan).tobytes()),
        4: b"",
    }
    path.write_bytes(contents[fault])


def write_library(folder, count, bad=()):
    """Write a library in three folders; return the names of the corrupt assets."""
    for index in range(count):
        write_asset(folder / f"shelf{index % 3}" / f"a{index:03}.glb", index % 7)
    names = []
    for fault, index in enumerate(bad):
        path = folder / f"shelf{index % 3}" / f"a{index:03}.glb"
        # Fault 3 replaces the number 1, which only the asset of index 0 has.
        write_asset(path, 0)
        corrupt(path, fault)
        names.append(path.name)
    return sorted(names)


def library_content(folder):
    """Return assets and records by their paths; records without their outputs' absolute paths."""
    content = {}
    for path in sorted(folder.rglob("*")):
        if path.is_file() and path.suffix in (".glb", ".gltf", ".bin", ".exr"):
            content[str(path.relative_to(folder))] = path.read_bytes()
        elif path.is_file() and RECORDS in path.parts:
            record = json.loads(path.read_text())
            del record["output"]
            content[str(path.relative_to(folder))] = record
    return content


# -- workers ---------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def reference(tmp_path_factory):
    """Two hundred assets, five of them corrupt, and their bakes by one process."""
    folder = tmp_path_factory.mktemp("library")
    bad = write_library(folder / "in", ASSETS, bad=(11, 50, 99, 140, 199))
    assert len(bad) == BAD
    results = bake_library(plan_jobs([folder / "in"], folder / "one", SETTINGS))
    return folder, bad, results, library_content(folder / "one")


@pytest.fixture(scope="module")
def cluster():
    distributed = pytest.importorskip("distributed", reason="distributed is not installed")
    import dask

    timeouts = {
        "distributed.scheduler.allowed-failures": 1,
        "distributed.comm.timeouts.connect": "3s",  # 30 s for killed workers by default
        "distributed.admin.tick.limit": "1h",
    }
    with (
        dask.config.set(timeouts),
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0"
        ) as local,
    ):
        yield local.scheduler_address


def statuses(results):
    return {Path(result.source).name: result.status for result in results}


def assert_only_bad_ones_failed(results, bad):
    assert sorted(name for name, status in statuses(results).items() if status == "failed") == bad
    failed = [result for result in results if result.status == "failed"]
    assert all(result.source in result.error for result in failed)
    assert not any("internal error" in result.error for result in failed)
    assert sum(status == "baked" for status in statuses(results).values()) == ASSETS - BAD


def test_a_corrupt_asset_fails_with_an_error_and_does_not_stop_the_others(reference):
    folder, bad, results, content = reference
    assert_only_bad_ones_failed(results, bad)
    assert [result.source for result in results] == sorted(result.source for result in results)
    assert len(content) == 2 * (ASSETS - BAD)
    again = bake_library(plan_jobs([folder / "in"], folder / "one", SETTINGS))
    assert sum(result.status == "current" for result in again) == ASSETS - BAD
    assert sorted(result.source for result in again if result.status == "failed") == sorted(
        result.source for result in results if result.status == "failed"
    )


@pytest.mark.parametrize("workers", [1, pytest.param(2, marks=pytest.mark.slow)])
def test_warnings_are_in_the_results_the_records_and_the_report(tmp_path, workers):
    for name in "ab":
        write_asset(tmp_path / "in" / f"{name}.glb")
    jobs = plan_jobs([tmp_path / "in"], tmp_path / "out", replace(SETTINGS, unit_mm=1e5))
    text = (
        "with the given unit of 100000 mm, the object is 346 m across; skin is on bodies of 80 mm to 3 m."
        " If this is wrong, give unit_mm, the length of one unit of the file in mm"
    )
    for status in ("baked", "current"):
        results = bake_library(jobs, workers=workers)
        assert [(result.status, result.warnings) for result in results] == [(status, [text])] * 2
        write_report(jobs, results, tmp_path / "report.json")
        report = json.loads((tmp_path / "report.json").read_text())
        assert [asset["warnings"] for asset in report["assets"]] == [[text]] * 2
        write_page(jobs, results, tmp_path / "page.html")
        assert (tmp_path / "page.html").read_text().count(f">{text}<") == 2


def test_the_command_prints_the_warnings_of_its_processes(tmp_path):
    write_library(tmp_path / "in", 2)
    words = ["bake", str(tmp_path / "in"), "-o", str(tmp_path / "out"), "--jobs", "2"]
    done = subprocess.run(
        [sys.executable, "-m", "skinshade", *words, "--unit-mm", "1e5"],
        capture_output=True,
        text=True,
        check=True,
    )
    lines = sorted(done.stderr.splitlines())
    assert len(lines) == 2
    for line, name in zip(lines, ("shelf0/a000.glb", "shelf1/a001.glb"), strict=True):
        assert line.startswith(
            f"skinshade: warning: {tmp_path / 'in' / name}: with the given unit of 100000 mm, "
        )


@pytest.mark.slow
def test_two_processes_write_the_same_bytes_as_one(reference):
    folder, bad, _, content = reference
    shares = []
    jobs = plan_jobs([folder / "in"], folder / "two", SETTINGS)
    results = bake_library(jobs, workers=2, progress=lambda work, share: shares.append(share))
    assert_only_bad_ones_failed(results, bad)
    assert library_content(folder / "two") == content
    assert shares == sorted(shares)
    assert (len(shares), shares[-1]) == (ASSETS, 1.0)


@pytest.mark.slow
def test_a_dask_cluster_writes_the_same_bytes_as_one_process(reference, cluster):
    folder, bad, _, content = reference
    results = bake_library(plan_jobs([folder / "in"], folder / "dask", SETTINGS), cluster=cluster)
    assert_only_bad_ones_failed(results, bad)
    assert library_content(folder / "dask") == content


@pytest.mark.slow
def test_the_command_names_the_failed_assets_and_exits_with_2(reference):
    folder, bad, _, content = reference
    words = [
        "bake",
        str(folder / "in"),
        "-o",
        str(folder / "cli"),
        "--unit-mm",
        "100",
        "--jobs",
        "2",
    ]
    environment = os.environ | {"PYTHONPATH": str(Path(skinshade.__file__).parents[1])}
    for baked in (ASSETS - BAD, 0):  # the second time, all valid assets are current
        process = subprocess.run(
            [sys.executable, "-m", "skinshade", *words],
            env=environment,
            capture_output=True,
            text=True,
            timeout=200,
            check=False,
        )
        assert process.returncode == 2, process.stderr
        assert "Traceback" not in process.stderr
        assert [name for name in bad if process.stderr.count(name) != 1] == []
        report = json.loads((folder / "cli" / "skinshade-bake.json").read_text())
        counts = report["baked"], report["current"], report["failed"]
        assert counts == (baked, ASSETS - BAD - baked, BAD)
        assert len(report["assets"]) == ASSETS
        failed = [asset for asset in report["assets"] if asset["status"] == "failed"]
        assert sorted(Path(asset["source"]).name for asset in failed) == bad
    assert library_content(folder / "cli") == content


# -- crashes ---------------------------------------------------------------------------------------


def crash_once(job):
    marker = job.source.with_suffix(".crashed")
    if job.source.stem == "a004" and not marker.exists():
        marker.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return run_job(job)


def crash_always(job):
    if job.source.stem == "a004":
        os._exit(1)
    time.sleep(0.02)  # so that other jobs are running at the crash
    return run_job(job)


@pytest.fixture
def few(tmp_path):
    """Jobs of nine assets, and the content of their library."""
    write_library(tmp_path / "in", 9)
    bake_library(plan_jobs([tmp_path / "in"], tmp_path / "expected", SETTINGS))
    jobs = plan_jobs([tmp_path / "in"], tmp_path / "out", SETTINGS)
    return jobs, library_content(tmp_path / "expected")


@pytest.mark.slow
def test_a_killed_process_loses_no_asset(tmp_path, few):
    jobs, content = few
    results = bake_library(jobs, workers=2, work=crash_once)
    assert [result.error for result in results] == [""] * 9
    assert library_content(tmp_path / "out") == content
    assert len(list((tmp_path / "in").rglob("*.crashed"))) == 1


@pytest.mark.slow
def test_only_the_job_that_always_kills_its_process_fails(tmp_path, few):
    jobs, content = few
    results = bake_library(jobs, workers=2, work=crash_always)
    (failed,) = [result for result in results if result.status == "failed"]
    assert failed.source.endswith("a004.glb")
    assert "a004.glb: its process was killed 3 times" in failed.error
    expected = {path: data for path, data in content.items() if "a004" not in path}
    assert library_content(tmp_path / "out") == expected


@pytest.mark.slow
def test_a_killed_worker_of_a_cluster_loses_no_asset(tmp_path, few, cluster):
    jobs, content = few
    results = bake_library(jobs, cluster=cluster, work=crash_once)
    assert [result.error for result in results] == [""] * 9
    assert library_content(tmp_path / "out") == content
    assert len(list((tmp_path / "in").rglob("*.crashed"))) == 1


@pytest.mark.slow
def test_only_the_job_that_always_kills_its_worker_fails_on_a_cluster(tmp_path, few, cluster):
    jobs, content = few
    results = bake_library(jobs, cluster=cluster, work=crash_always)
    (failed,) = [result for result in results if result.status == "failed"]
    assert "a004.glb: the cluster cannot bake it" in failed.error
    expected = {path: data for path, data in content.items() if "a004" not in path}
    assert library_content(tmp_path / "out") == expected


@pytest.mark.slow
def test_a_killed_run_is_resumed(reference):
    """The parent and its workers are killed: finished assets are current, the others are baked."""
    folder, _, _, content = reference
    words = ["bake", str(folder / "in"), "-o", str(folder / "killed"), "--unit-mm", "100"]
    environment = os.environ | {"PYTHONPATH": str(Path(skinshade.__file__).parents[1])}
    process = subprocess.Popen(
        [sys.executable, "-m", "skinshade", *words],
        env=environment,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
    end = time.monotonic() + 60.0
    while len(list((folder / "killed").rglob("[!.]*.json"))) < 20 and time.monotonic() < end:
        time.sleep(0.005)
    os.killpg(process.pid, signal.SIGKILL)
    assert process.wait(timeout=30) == -signal.SIGKILL
    records = (folder / "killed" / RECORDS).rglob("*.json")
    finished = {path.stem for path in records if path.name[0] != "."}  # temporary files are hidden
    assert 20 <= len(finished) < ASSETS - BAD
    results = bake_library(plan_jobs([folder / "in"], folder / "killed", SETTINGS))
    assert {n for n, status in statuses(results).items() if status == "current"} == finished
    assert sum(result.status == "baked" for result in results) == ASSETS - BAD - len(finished)
    assert library_content(folder / "killed") == content


# -- arguments -------------------------------------------------------------------------------------


@pytest.mark.parametrize("workers", [0, -1, 1025])
def test_a_number_of_processes_out_of_range_is_refused(few, workers):
    with pytest.raises(ArgumentError, match=f"workers is {workers}"):
        bake_library(few[0], workers=workers)


def test_without_dask_the_error_states_what_to_install(few, monkeypatch):
    monkeypatch.setattr("skinshade.baking.cluster.find_spec", lambda name: None)
    with pytest.raises(DependencyError, match=r"skinshade\[dask\]"):
        bake_library(few[0], cluster="tcp://127.0.0.1:1")


def test_the_error_of_a_scheduler_that_does_not_answer_names_its_address(few):
    pytest.importorskip("distributed", reason="distributed is not installed")
    with pytest.raises(BackendError, match="carrier-pigeon://here"):
        bake_library(few[0], cluster="carrier-pigeon://here")
