"""Dask clusters without a scheduler or a worker: an error or failed results in 15 s, and no hang."""

import os
import signal
import socket
import subprocess
import sys
import time
from collections import Counter
from contextlib import contextmanager
from pathlib import Path

import pytest
from test_baking_library import write_library
from test_baking_plan import SETTINGS

from skinshade._core.errors import BackendError
from skinshade.baking import cluster
from skinshade.baking.jobs import plan_jobs, run_job
from skinshade.baking.library import bake_library

pytest.importorskip("distributed", reason="distributed is not installed")

MOST_SECONDS = 15.0
"""Time from the start, or from the loss of the cluster, to the end."""
SCHEDULER = """
import asyncio
from distributed import Scheduler

async def main():
    async with Scheduler(host="127.0.0.1", port=0, dashboard=False) as scheduler:
        print(scheduler.address, flush=True)
        await scheduler.finished()

asyncio.run(main())
"""
WORKER = """
import asyncio, sys
from distributed import Worker

async def main():
    async with Worker(sys.argv[1], nthreads=1) as worker:
        print("ready", flush=True)
        await worker.finished()

asyncio.run(main())
"""


@contextmanager
def started(script, *arguments):
    """Yield a process that runs a script, and the first line that it prints."""
    folders = [entry for entry in sys.path if entry]
    process = subprocess.Popen(
        [sys.executable, "-c", script, *arguments],
        env=os.environ | {"PYTHONPATH": os.pathsep.join(folders)},
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    )
    with process:
        try:
            yield process, process.stdout.readline().strip()
        finally:
            process.kill()


def block_at_the_fourth(job):
    """Bake the first three assets; the next one leaves its process number, and never ends."""
    if job.source.stem == "a003":
        job.source.with_suffix(".pid").write_text(str(os.getpid()))
        time.sleep(100.0)
    return run_job(job)


@pytest.fixture
def jobs(tmp_path):
    write_library(tmp_path / "in", 6)
    jobs = plan_jobs([tmp_path / "in"], tmp_path / "out", SETTINGS)
    return sorted(jobs, key=lambda job: job.source.stem)


def assert_is_refused(jobs, address, message):
    start = time.monotonic()
    with pytest.raises(BackendError, match=message) as caught:
        bake_library(jobs, cluster=address)
    assert time.monotonic() - start < MOST_SECONDS
    assert str(caught.value).startswith(f"{address}: ")


def test_the_limits_of_all_steps_are_15_seconds_together():
    steps = (cluster.CONNECT_SECONDS, cluster.WORKER_SECONDS, cluster.CLOSE_SECONDS)
    assert sum(steps) + cluster.POLL_SECONDS < MOST_SECONDS


def test_an_address_without_a_scheduler_is_refused(jobs, monkeypatch):
    monkeypatch.setattr(cluster, "CONNECT_SECONDS", 1.0)
    with socket.socket() as unused:
        unused.bind(("127.0.0.1", 0))
        address = f"tcp://127.0.0.1:{unused.getsockname()[1]}"
    assert_is_refused(jobs, address, "no Dask scheduler answers")


def test_a_server_that_never_answers_is_refused(jobs, monkeypatch):
    """Dask itself waits forever in the handshake."""
    monkeypatch.setattr(cluster, "CONNECT_SECONDS", 1.0)
    with socket.socket() as server:
        server.bind(("127.0.0.1", 0))
        server.listen()
        assert_is_refused(jobs, f"tcp://127.0.0.1:{server.getsockname()[1]}", "no answer in 1 s")


@pytest.mark.slow
def test_a_scheduler_without_workers_is_refused(jobs, monkeypatch):
    monkeypatch.setattr(cluster, "WORKER_SECONDS", 1.0)
    with started(SCHEDULER) as (_, address):
        assert_is_refused(jobs, address, f"has no worker; start one: dask worker {address}")


@pytest.mark.slow
@pytest.mark.parametrize("lost", ["worker", "scheduler"])
def test_what_finished_before_the_cluster_is_lost_is_kept(jobs, lost, monkeypatch):
    monkeypatch.setattr(cluster, "WORKER_SECONDS", 4.0)
    times, finished = [], []

    def report(result):
        finished.append(result)
        if len(finished) == 3:
            process.send_signal(signal.SIGKILL)
            times.append(time.monotonic())

    with (
        started(SCHEDULER) as (scheduler, address),
        started(WORKER, address) as (worker, ready),
    ):
        assert ready == "ready"
        process = {"worker": worker, "scheduler": scheduler}[lost]
        results = bake_library(jobs, cluster=address, report=report, work=block_at_the_fourth)
        assert time.monotonic() - times[0] < MOST_SECONDS
    assert Counter(result.status for result in results) == {"baked": 3, "failed": 3}
    assert [Path(result.source).stem for result in results[:3]] == ["a000", "a001", "a002"]
    for job, result in zip(jobs[3:], results[3:], strict=True):
        assert result.error.startswith(f"{job.source}: the Dask cluster {address} has lost its")
    assert len(finished) == 6
