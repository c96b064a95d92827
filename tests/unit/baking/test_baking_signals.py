"""Signals to `skinshade bake --jobs 2`: no process, no traceback and no temporary file stays behind."""

import os
import random
import signal
import sys
import time

import pytest
import trimesh
from test_baking_library import library_content

import skinshade as sk
from processes import Started, wait_until
from skinshade.baking.jobs import plan_jobs
from skinshade.baking.library import bake_library

TRIALS = int(os.environ.get("SKINSHADE_SIGNAL_TRIALS", "3"))
"""Trials of each signal. With ``-rP``, pytest shows the outcomes."""
SETTINGS = sk.BakeSettings(unit_mm=1.0, thickness=True, rays=16)
OPTIONS = ["--unit-mm", "1", "--thickness", "--rays", "16", "--jobs", "2"]
SECONDS_TO_END = 5.0

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="processes are found in /proc")


def content(folder):
    """Return assets and records, without temporary files, which the next run removes."""
    return {
        path: data
        for path, data in library_content(folder).items()
        if not path.rpartition("/")[2].startswith(".")
    }


def command(output):
    return ["-m", "skinshade", "bake", "in", "-o", output, *OPTIONS]


def records(output):
    return list(output.glob(".skinshade/[!.]*.json"))


@pytest.fixture(scope="module")
def assets(tmp_path_factory):
    """A library of a dozen balls, the content of its bake, and the times of a run until it bakes and ends."""
    folder = tmp_path_factory.mktemp("library")
    (folder / "in").mkdir()
    for index in range(12):
        ball = trimesh.creation.icosphere(subdivisions=4, radius=50.0 + index)
        ball.export(folder / "in" / f"ball{index}.ply")
    bake_library(plan_jobs([folder / "in"], folder / "expected", SETTINGS))
    run = Started(folder, *command("timed"))
    run.wait_for_handler()
    start = time.monotonic()
    wait_until(lambda: records(folder / "timed"))
    baking = time.monotonic()
    assert run.finish()[0] == 0
    end = time.monotonic()
    return folder, content(folder / "expected"), (end - start, end - baking)


EXPECTED = {
    "SIGINT": (130, "skinshade: interrupted\n"),
    "SIGTERM": (143, "skinshade: terminated\n"),
    "SIGKILL": (-9, ""),
}


@pytest.mark.slow
@pytest.mark.parametrize("trial", range(TRIALS))
@pytest.mark.parametrize("name", EXPECTED)
def test_after_a_signal_no_process_is_left_and_a_second_run_completes_the_library(
    assets, name, trial
):
    folder, expected, (whole, baking) = assets
    output = folder / f"{name}{trial}"
    run = Started(folder, *command(output.name))
    run.wait_for_handler()
    if is_baking := trial % 2 == 0:  # the other half of the trials also meets the imports
        wait_until(lambda: records(output) or run.process.poll() is not None)
    time.sleep(random.Random(f"{name} {trial}").uniform(0.0, baking if is_baking else whole))
    number, workers = signal.Signals[name], run.others()
    # A terminal sends SIGINT to all processes of the run.
    (os.killpg if name == "SIGINT" else os.kill)(run.process.pid, number)
    start = time.monotonic()
    code, _, err = run.finish(SECONDS_TO_END)
    assert run.others_after(SECONDS_TO_END - (time.monotonic() - start)) == []
    if code != 0:  # else the run was complete when the signal came
        assert (code, err) == EXPECTED[name]
    print(f"{name}: exit code {code}, {len(records(output))} of 12 assets, {len(workers)} workers")
    bake_library(plan_jobs([folder / "in"], output, SETTINGS))
    assert content(output) == expected
