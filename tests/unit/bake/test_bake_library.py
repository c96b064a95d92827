"""A library of assets: the same bytes whoever did the work, and nothing lost to a death."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from test_bake_plan import RECORDS, SETTINGS, write_asset

import skinshade
from skinshade._core.errors import ArgumentError, BackendError, DependencyError
from skinshade.bake import library
from skinshade.bake.jobs import plan, run
from skinshade.bake.library import bake_library

ASSETS, BAD = 200, 5


def spoil(path, how):
    data = path.read_bytes()
    broken = {
        0: data[: len(data) // 2],
        1: b"once upon a time",
        2: data.replace(b'"POSITION"', b'"POSITIOM"'),
        3: data.replace(np.float32(1.0).tobytes(), np.float32(np.nan).tobytes()),
        4: b"",
    }
    path.write_bytes(broken[how])


def write_library(folder, count, bad=()):
    for index in range(count):
        write_asset(folder / f"shelf{index % 3}" / f"a{index:03}.glb", index % 7)
    names = []
    for how, index in enumerate(bad):
        path = folder / f"shelf{index % 3}" / f"a{index:03}.glb"
        # The number three has a corner at one only if its index makes it so.
        write_asset(path, 0)
        spoil(path, how)
        names.append(path.name)
    return sorted(names)


def assets_in(folder):
    """All that was baked, by place; records without the paths that differ by folder."""
    found = {}
    for path in sorted(folder.rglob("*")):
        if path.is_file() and path.suffix in (".glb", ".gltf", ".bin", ".exr"):
            found[str(path.relative_to(folder))] = path.read_bytes()
        elif path.is_file() and RECORDS in path.parts:
            told = json.loads(path.read_text())
            del told["output"]
            found[str(path.relative_to(folder))] = told
    return found


# -- who does the work -----------------------------------------------------------------------------


@pytest.fixture(scope="module")
def stock(tmp_path_factory):
    """Two hundred assets, five of them bad, and what one process makes of them."""
    folder = tmp_path_factory.mktemp("stock")
    bad = write_library(folder / "in", ASSETS, bad=(11, 50, 99, 140, 199))
    assert len(bad) == BAD
    results = bake_library(plan([folder / "in"], folder / "one", SETTINGS))
    return folder, bad, results, assets_in(folder / "one")


@pytest.fixture(scope="module")
def cluster():
    distributed = pytest.importorskip("distributed", reason="distributed is not installed")
    import dask

    hurried = {
        "distributed.scheduler.allowed-failures": 1,
        "distributed.comm.timeouts.connect": "3s",  # to workers that were killed: 30 s otherwise
        "distributed.admin.tick.limit": "1h",
    }
    with (
        dask.config.set(hurried),
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0"
        ) as local,
    ):
        yield local.scheduler_address


def statuses(results):
    return {Path(each.source).name: each.status for each in results}


def assert_all_but_the_bad(results, bad):
    assert sorted(name for name, status in statuses(results).items() if status == "failed") == bad
    failed = [each for each in results if each.status == "failed"]
    assert all(each.source in each.error for each in failed)
    assert not any("internal error" in each.error for each in failed)
    assert sum(status == "baked" for status in statuses(results).values()) == ASSETS - BAD


def test_a_bad_file_stops_no_other_and_is_named(stock):
    folder, bad, results, made = stock
    assert_all_but_the_bad(results, bad)
    assert [each.source for each in results] == sorted(each.source for each in results)
    assert len(made) == 2 * (ASSETS - BAD)
    again = bake_library(plan([folder / "in"], folder / "one", SETTINGS))
    assert sum(each.status == "current" for each in again) == ASSETS - BAD
    assert sorted(each.source for each in again if each.status == "failed") == sorted(
        each.source for each in results if each.status == "failed"
    )


@pytest.mark.slow
def test_two_processes_make_the_same_bytes(stock):
    folder, bad, _, made = stock
    told = []
    jobs = plan([folder / "in"], folder / "two", SETTINGS)
    results = bake_library(jobs, workers=2, progress=lambda what, share: told.append(share))
    assert_all_but_the_bad(results, bad)
    assert assets_in(folder / "two") == made
    assert told == sorted(told)
    assert (len(told), told[-1]) == (ASSETS, 1.0)


@pytest.mark.slow
def test_a_dask_cluster_makes_the_same_bytes(stock, cluster):
    folder, bad, _, made = stock
    results = bake_library(plan([folder / "in"], folder / "dask", SETTINGS), cluster=cluster)
    assert_all_but_the_bad(results, bad)
    assert assets_in(folder / "dask") == made


@pytest.mark.slow
def test_the_command_names_the_bad_ones_and_exits_with_two(stock):
    folder, bad, _, made = stock
    words = ["bake", str(folder / "in"), "-o", str(folder / "cli"), "--unit-mm", "m", "--jobs", "2"]
    environment = os.environ | {"PYTHONPATH": str(Path(skinshade.__file__).parents[1])}
    for baked in (ASSETS - BAD, 0):  # and again, when all else is current
        ended = subprocess.run(
            [sys.executable, "-m", "skinshade", *words],
            env=environment,
            capture_output=True,
            text=True,
            timeout=200,
            check=False,
        )
        assert ended.returncode == 2, ended.stderr
        assert "Traceback" not in ended.stderr
        assert [name for name in bad if ended.stderr.count(name) != 1] == []
        report = json.loads((folder / "cli" / "skinshade-bake.json").read_text())
        counts = report["baked"], report["current"], report["failed"]
        assert counts == (baked, ASSETS - BAD - baked, BAD)
        assert len(report["assets"]) == ASSETS
        failed = [each for each in report["assets"] if each["status"] == "failed"]
        assert sorted(Path(each["source"]).name for each in failed) == bad
    assert assets_in(folder / "cli") == made


# -- deaths ----------------------------------------------------------------------------------------


def dies_once(job):
    marker = job.source.with_suffix(".died")
    if job.source.stem == "a004" and not marker.exists():
        marker.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return run(job)


def dies_always(job):
    if job.source.stem == "a004":
        os._exit(1)
    time.sleep(0.02)  # so that others are under way when it dies
    return run(job)


@pytest.fixture
def few(tmp_path):
    write_library(tmp_path / "in", 9)
    bake_library(plan([tmp_path / "in"], tmp_path / "known", SETTINGS))
    return plan([tmp_path / "in"], tmp_path / "out", SETTINGS), assets_in(tmp_path / "known")


@pytest.mark.slow
def test_a_process_that_is_killed_midway_loses_nothing(tmp_path, few):
    jobs, made = few
    results = bake_library(jobs, workers=2, work=dies_once)
    assert [each.error for each in results] == [""] * 9
    assert assets_in(tmp_path / "out") == made
    assert len(list((tmp_path / "in").rglob("*.died"))) == 1


@pytest.mark.slow
def test_a_job_that_always_kills_its_process_fails_alone_and_by_name(tmp_path, few):
    jobs, made = few
    results = bake_library(jobs, workers=2, work=dies_always)
    (failed,) = [each for each in results if each.status == "failed"]
    assert failed.source.endswith("a004.glb")
    assert "a004.glb: its process was killed 3 times" in failed.error
    left = assets_in(tmp_path / "out")
    assert left == {place: data for place, data in made.items() if "a004" not in place}


def test_a_death_leaves_those_in_doubt_that_were_under_way_and_no_others(few):
    """Every job that waited was in doubt too, and was run in a process of its own."""
    jobs, _ = few
    ended = list(library._until_a_death(jobs, [3, *range(3), *range(4, 9)], 1, dies_at_once))
    assert ended == [(3, None)]


def dies_at_once(job):
    os._exit(1)


@pytest.mark.slow
def test_a_worker_of_a_cluster_that_is_killed_loses_nothing(tmp_path, few, cluster):
    jobs, made = few
    results = bake_library(jobs, cluster=cluster, work=dies_once)
    assert [each.error for each in results] == [""] * 9
    assert assets_in(tmp_path / "out") == made
    assert len(list((tmp_path / "in").rglob("*.died"))) == 1


@pytest.mark.slow
def test_a_job_that_always_kills_its_worker_fails_alone_on_a_cluster(tmp_path, few, cluster):
    jobs, made = few
    results = bake_library(jobs, cluster=cluster, work=dies_always)
    (failed,) = [each for each in results if each.status == "failed"]
    assert "a004.glb: the cluster gave up on it" in failed.error
    left = assets_in(tmp_path / "out")
    assert left == {place: data for place, data in made.items() if "a004" not in place}


@pytest.mark.slow
def test_a_run_that_was_killed_is_resumed(stock):
    """Killed as a whole, parent and workers: what was done is current, and only the rest is baked."""
    folder, _, _, made = stock
    words = ["bake", str(folder / "in"), "-o", str(folder / "cut"), "--unit-mm", "m"]
    environment = os.environ | {"PYTHONPATH": str(Path(skinshade.__file__).parents[1])}
    started = subprocess.Popen(
        [sys.executable, "-m", "skinshade", *words],
        env=environment,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
    end = time.monotonic() + 60.0
    while len(list((folder / "cut").rglob("*.json"))) < 20 and time.monotonic() < end:
        time.sleep(0.005)
    os.killpg(started.pid, signal.SIGKILL)
    assert started.wait(timeout=30) == -signal.SIGKILL
    records = (folder / "cut" / RECORDS).rglob("*.json")
    done = {
        path.stem for path in records if path.name[0] != "."
    }  # what was being written is hidden
    assert 20 <= len(done) < ASSETS - BAD
    results = bake_library(plan([folder / "in"], folder / "cut", SETTINGS))
    assert {n for n, status in statuses(results).items() if status == "current"} == done
    assert sum(each.status == "baked" for each in results) == ASSETS - BAD - len(done)
    assert assets_in(folder / "cut") == made


# -- requests --------------------------------------------------------------------------------------


@pytest.mark.parametrize("workers", [0, -1, 1025])
def test_a_number_of_processes_out_of_range_is_named(few, workers):
    with pytest.raises(ArgumentError, match=f"jobs is {workers}"):
        bake_library(few[0], workers=workers)


def test_dask_that_is_not_installed_is_named(few, monkeypatch):
    monkeypatch.setattr(library, "find_spec", lambda name: None)
    with pytest.raises(DependencyError, match=r"skinshade\[dask\]"):
        bake_library(few[0], cluster="tcp://127.0.0.1:1")


def test_a_scheduler_that_is_not_there_is_named(few):
    pytest.importorskip("distributed", reason="distributed is not installed")
    with pytest.raises(BackendError, match="carrier-pigeon://here"):
        bake_library(few[0], cluster="carrier-pigeon://here")
