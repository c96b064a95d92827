"""Worker processes: what they import and print, and how they end."""

import os
import signal
import sys
import time
from pathlib import Path

import pytest
from test_baking_library import library_content, write_library
from test_baking_plan import SETTINGS

from processes import Started, wait_until
from skinshade._core.errors import BackendError
from skinshade._core.files import atomic_write
from skinshade.baking import workers
from skinshade.baking.jobs import plan_jobs, run_job
from skinshade.baking.library import bake_library

MODULES = ("multiprocessing", "pickle", "queue", "threading", "numpy", "scipy", "embreex", "PIL")
LINUX = pytest.mark.skipif(sys.platform != "linux", reason="processes are found in /proc")


@pytest.fixture
def jobs(tmp_path):
    """Jobs of four assets."""
    write_library(tmp_path / "in", 4)
    return plan_jobs([tmp_path / "in"], tmp_path / "out", SETTINGS)


def statuses(results):
    return {Path(result.source).stem: result.status for result in results}


# -- the current folder ----------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("is_module", [False, True])
def test_a_python_file_in_the_current_folder_is_not_executed(tmp_path, is_module):
    """A folder of downloads can contain a file with the name of a module."""
    write_library(tmp_path / "work" / "in", 3)
    # `python -m` imports the modules of its own start from the current folder.
    for name in MODULES[4:] if is_module else MODULES:
        path = tmp_path / "work" / f"{name}.py"
        path.write_text(f"open(r'{tmp_path / 'executed'}', 'a').write('{name} ')\n")
    program = tmp_path / "program.py"  # the installed program, too, is a file in another folder
    program.write_text("from skinshade.cli import main\nmain()\n")
    words = ["bake", "in", "-o", "out", "--unit-mm", "100", "--jobs", "2"]
    start = ["-m", "skinshade"] if is_module else [str(program)]
    code, _, err = Started(tmp_path / "work", *start, *words).finish()
    assert (code, err) == (0, "")
    assert not (tmp_path / "executed").exists()


@pytest.mark.slow
def test_workers_import_skinshade_from_the_current_folder_if_the_parent_did(tmp_path, jobs):
    """The folder itself is not on their search path."""
    source = Path(workers.__file__).parents[2]
    words = ["bake", str(tmp_path / "in"), "-o", str(tmp_path / "out"), "--unit-mm", "100"]
    run = Started(source, "-m", "skinshade", *words, "--jobs", "2", PYTHONPATH="")
    code, _, err = run.finish()
    assert (code, err) == (0, "")
    assert len(library_content(tmp_path / "out")) == 2 * len(jobs)


def test_the_search_path_of_workers_lacks_the_current_folder(tmp_path, monkeypatch):
    (tmp_path / "work").mkdir()
    (tmp_path / "link").symlink_to(tmp_path / "work")
    monkeypatch.chdir(tmp_path / "work")
    folders = ["", ".", str(tmp_path / "work"), str(tmp_path / "link"), "missing", str(tmp_path)]
    monkeypatch.setattr(sys, "path", folders)
    assert workers._search_path() == ["missing", str(tmp_path)]


# -- failures --------------------------------------------------------------------------------------


def fail_in_three_kinds(job):
    """Fail for the first three of four assets."""
    if job.source.stem == "a000":
        return bytes(1 << 62)
    if job.source.stem == "a001":
        return recurse(job)
    if job.source.stem == "a002":
        raise LookupError("a fault")
    return run_job(job)


def recurse(job):
    return recurse(job)


def print_and_run(job):
    print("a line")
    os.write(1, b"bytes")
    return run_job(job)


REASONS = {
    "a000": "out of memory",
    "a001": "its content is nested too deeply",
    "a002": "internal error: LookupError: a fault",
}


@pytest.mark.slow
@pytest.mark.parametrize("count", [1, 2])
def test_an_error_of_python_is_a_failed_result(jobs, count):
    results = bake_library(jobs, workers=count, work=fail_in_three_kinds)
    errors = {Path(r.source).stem: r.error for r in results if r.status == "failed"}
    assert errors == {
        Path(r.source).stem: f"{r.source}: {REASONS[Path(r.source).stem]}"
        for r in results
        if Path(r.source).stem in REASONS
    }
    assert statuses(results)["a003"] == "baked"


@pytest.mark.slow
def test_what_a_job_prints_goes_to_the_standard_error(jobs, capfd, monkeypatch):
    monkeypatch.delenv("PYTHONUNBUFFERED", raising=False)
    results = bake_library(jobs, workers=2, work=print_and_run)
    assert set(statuses(results).values()) == {"baked"}
    out, err = capfd.readouterr()
    assert out == ""
    assert (err.count("a line\n"), err.count("bytes")) == (4, 4)


@pytest.mark.slow
def test_work_that_workers_cannot_import_is_a_failed_result(jobs, monkeypatch):
    monkeypatch.setattr(sys, "path", [p for p in sys.path if p != str(Path(__file__).parent)])
    results = bake_library(jobs, workers=2, work=print_and_run)
    assert {result.error.partition(": ")[2] for result in results} == {
        "internal error: ModuleNotFoundError: No module named 'test_baking_workers'"
    }


@pytest.mark.parametrize("path", ["", "no/such/python"])
def test_an_interpreter_that_cannot_be_started_is_an_error(jobs, monkeypatch, path):
    monkeypatch.setattr(sys, "executable", path)
    with pytest.raises(BackendError, match="process"):
        bake_library(jobs, workers=2)


@pytest.mark.slow
def test_results_are_reported_as_they_finish(jobs):
    reported = []
    results = bake_library(jobs, workers=2, report=reported.append)
    assert sorted(reported, key=lambda result: result.source) == results


# -- ends ------------------------------------------------------------------------------------------


def hold_once(job):
    """Keep a temporary file open at the first call, and bake at the second."""
    marker = job.source.with_suffix(".pid")
    if job.source.stem == "a000" and not marker.exists():
        with atomic_write(job.output) as temporary:
            temporary.write_text("a part")
            marker.write_text(str(os.getpid()))
            time.sleep(100.0)
    return run_job(job)


def hold_against_interruptions(job):
    marker = job.source.with_suffix(".pid")
    marker.write_text(str(os.getpid()))
    while True:
        try:
            time.sleep(100.0)
        except KeyboardInterrupt:
            continue


def terminate_the_holder(result):
    marker = Path(result.source).parents[1] / "shelf0" / "a000.pid"
    wait_until(marker.exists)
    if not marker.with_suffix(".killed").exists():
        marker.with_suffix(".killed").touch()
        os.kill(int(marker.read_text()), signal.SIGTERM)


@LINUX
@pytest.mark.slow
def test_a_terminated_worker_removes_its_temporary_file_and_loses_no_asset(tmp_path, jobs):
    jobs[0].output.parent.mkdir(parents=True)
    results = bake_library(jobs, workers=2, work=hold_once, report=terminate_the_holder)
    assert set(statuses(results).values()) == {"baked"}
    assert len(library_content(tmp_path / "out")) == 2 * len(jobs)


SCRIPT = """
import sys
sys.path[:0] = {folders}
from pathlib import Path
import test_baking_workers as tests
jobs = tests.plan_jobs([Path("in")], Path("out"), tests.SETTINGS)
jobs[0].output.parent.mkdir(parents=True)
tests.bake_library(jobs, workers=2, work=tests.{work})
"""


@LINUX
@pytest.mark.slow
@pytest.mark.parametrize("work", ["hold_once", "hold_against_interruptions"])
def test_a_killed_parent_leaves_no_worker_and_its_workers_no_temporary_file(tmp_path, jobs, work):
    folders = [str(Path(__file__).parent), str(Path(__file__).parents[2])]
    run = Started(tmp_path, "-c", SCRIPT.format(folders=folders, work=work))
    wait_until(lambda: list((tmp_path / "in").rglob("a000.pid")))
    assert len(run.others()) == 2
    run.process.kill()
    assert run.others_after(5.0) == []
    run.finish()
    assert [path for path in (tmp_path / "out").rglob(".a*") if path.is_file()] == []
