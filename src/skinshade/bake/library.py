"""A library of assets: on one machine's cores, or on a Dask cluster; resumed where it was cut off."""

from __future__ import annotations

import json
from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import asdict
from importlib.util import find_spec
from multiprocessing import get_context
from pathlib import Path
from typing import Any

from .._core.errors import ArgumentError, BackendError, DependencyError
from .._core.files import atomic_write
from .._core.progress import Progress, silent
from .._core.version import __version__
from .jobs import Job, JobResult, counted, failed, run

__all__ = ["bake_library", "write_report"]

MOST_DEATHS = 3
"""Workers that a job may take with it before it counts as failed."""


def bake_library(
    jobs: list[Job],
    *,
    workers: int = 1,
    cluster: str | None = None,
    progress: Progress = silent,
    work: Callable[[Job], JobResult] = run,
) -> list[JobResult]:
    """Bake every job that is not current.

    Parameters
    ----------
    jobs
        Of `skinshade.bake.jobs.plan`.
    workers
        Processes, 1..1024; the outputs do not depend on it.
    cluster
        Address of a Dask scheduler (``tcp://…``), whose workers see the same files; instead of
        processes of this machine.
    progress
        Called with what is being done and how far it is.
    work
        Does one job.

    Returns
    -------
    list
        A result for each job, in their order. A job that fails stops no other.

    Raises
    ------
    ArgumentError, DependencyError, BackendError
        If the number of workers is out of range, Dask is not installed, or its scheduler not there.
    """
    if not 1 <= workers <= 1024:
        raise ArgumentError(f"jobs is {workers}; it must be 1..1024 processes")
    if cluster is not None:
        finished = _on_cluster(jobs, cluster, work)
    elif workers == 1:
        finished = ((index, work(job)) for index, job in enumerate(jobs))
    else:
        finished = _on_processes(jobs, workers, work)
    results: dict[int, JobResult] = {}
    for index, result in finished:
        results[index] = result
        progress("baking", len(results) / len(jobs))
    return [results[index] for index in range(len(jobs))]


def write_report(results: list[JobResult], path: Path) -> None:
    """Write what became of every asset, as JSON."""
    content: dict[str, Any] = {"version": __version__, **counted(results)}
    content["assets"] = [asdict(each) for each in results]
    with atomic_write(path) as temporary:
        temporary.write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")


def _on_processes(
    jobs: list[Job], workers: int, work: Callable[[Job], JobResult]
) -> Iterator[tuple[int, JobResult]]:
    deaths = dict.fromkeys(range(len(jobs)), 0)
    left = set(deaths)
    while left:
        # After a death those that it took are tried one at a time, so that it is known whose it was.
        suspects = sorted(index for index in left if deaths[index])
        batch = suspects[:1] or sorted(left)
        for index, result in _until_a_death(jobs, batch, workers, work):
            if result is not None:
                left.discard(index)
                yield index, result
                continue
            deaths[index] += 1
            if deaths[index] >= MOST_DEATHS:
                left.discard(index)
                job = jobs[index]
                why = f"{job.source}: its process was killed {MOST_DEATHS} times; is memory short?"
                yield index, failed(job, why)


def _until_a_death(
    jobs: list[Job], batch: list[int], workers: int, work: Callable[[Job], JobResult]
) -> Iterator[tuple[int, JobResult | None]]:
    """Results of a batch until a process dies; None for those that were under way then."""
    waiting, under_way = deque(batch), dict[Future[JobResult], int]()
    broken = False
    with ProcessPoolExecutor(min(workers, len(batch)), get_context("spawn")) as pool:
        while under_way or (waiting and not broken):
            # As many as there are processes, and no more: a death breaks all that were handed over.
            while waiting and len(under_way) < workers and not broken:
                try:
                    under_way[pool.submit(work, jobs[waiting[0]])] = waiting[0]
                except BrokenProcessPool:
                    broken = True
                else:
                    waiting.popleft()
            for future in wait(under_way, return_when=FIRST_COMPLETED).done:
                index = under_way.pop(future)
                try:
                    result = future.result()
                except BrokenProcessPool:
                    broken = True
                    yield index, None
                else:
                    yield index, result


def _on_cluster(
    jobs: list[Job], address: str, work: Callable[[Job], JobResult]
) -> Iterator[tuple[int, JobResult]]:
    if find_spec("distributed") is None:
        raise DependencyError('Dask is not installed: pip install "skinshade[dask]"')
    import distributed

    dask: Any = distributed
    try:
        client = dask.Client(address, timeout="10s", set_as_default=False)
    except (OSError, ValueError) as error:
        raise BackendError(f"{address}: no Dask scheduler answers there ({error})") from None
    with client:
        futures = [client.submit(work, job, retries=MOST_DEATHS, pure=False) for job in jobs]
        places = {future.key: index for index, future in enumerate(futures)}
        doubted = []
        for future in dask.as_completed(futures, loop=client.loop):
            try:
                result = future.result()
            except Exception:  # what a cluster says of workers that died, or of lost data
                doubted.append(places[future.key])
            else:
                yield places[future.key], result
        for index in doubted:  # one at a time: many die with a worker that one of them killed
            job = jobs[index]
            try:
                result = client.submit(work, job, retries=MOST_DEATHS, pure=False).result()
            except Exception as error:
                why = f"{job.source}: the cluster gave up on it ({type(error).__name__}: {error})"
                result = failed(job, why)
            yield index, result
