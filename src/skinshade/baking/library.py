"""Baking of a library of assets in this process, in several processes, or on a Dask cluster."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from importlib.util import find_spec
from multiprocessing import get_context
from typing import Any

from .._core.errors import ArgumentError, BackendError, DependencyError
from .._core.progress import Progress, silent
from .jobs import Job, JobResult, failure, run_job

__all__ = ["bake_library"]

MAX_CRASHES = 3
"""Crashes of its process after which a job counts as failed."""


def bake_library(
    jobs: list[Job],
    *,
    workers: int = 1,
    cluster: str | None = None,
    progress: Progress = silent,
    work: Callable[[Job], JobResult] = run_job,
) -> list[JobResult]:
    """Bake every job that is not current.

    Parameters
    ----------
    jobs
        Jobs from `skinshade.baking.jobs.plan_jobs`.
    workers
        Number of processes, 1..1024. The outputs do not depend on it.
    cluster
        Address of a Dask scheduler (``tcp://…``), whose workers replace the processes of this machine. The
        workers need access to the same files.
    progress
        Called with the name of the work and the fraction that is done.
    work
        Function that bakes one job.

    Returns
    -------
    list
        Result of each job, in the order of the jobs. A failed job does not stop the others.

    Raises
    ------
    ArgumentError, DependencyError, BackendError
        If the number of workers is out of range, Dask is not installed, or its scheduler does not answer.
    """
    if not 1 <= workers <= 1024:
        raise ArgumentError(f"workers is {workers}; it must be 1..1024 processes")
    if cluster is not None:
        results_by_index = _on_cluster(jobs, cluster, work)
    elif workers == 1:
        results_by_index = ((index, work(job)) for index, job in enumerate(jobs))
    else:
        results_by_index = _on_processes(jobs, workers, work)
    results: dict[int, JobResult] = {}
    for index, result in results_by_index:
        results[index] = result
        progress("baking", len(results) / len(jobs))
    return [results[index] for index in range(len(jobs))]


def _on_processes(
    jobs: list[Job], workers: int, work: Callable[[Job], JobResult]
) -> Iterator[tuple[int, JobResult]]:
    crashes = dict.fromkeys(range(len(jobs)), 0)
    unfinished = set(crashes)
    while unfinished:
        # A crash breaks the whole pool. The jobs that were running are then run one at a time, which
        # identifies the job that crashes.
        suspects = sorted(index for index in unfinished if crashes[index])
        batch = suspects[:1] or sorted(unfinished)
        for index, result in _until_crash(jobs, batch, workers, work):
            if result is not None:
                unfinished.discard(index)
                yield index, result
                continue
            crashes[index] += 1
            if crashes[index] >= MAX_CRASHES:
                unfinished.discard(index)
                job = jobs[index]
                reason = (
                    f"{job.source}: its process was killed {MAX_CRASHES} times; the machine may be short"
                    " of memory"
                )
                yield index, failure(job, reason)


def _until_crash(
    jobs: list[Job], batch: list[int], workers: int, work: Callable[[Job], JobResult]
) -> Iterator[tuple[int, JobResult | None]]:
    """Yield results of a batch until a process crashes, then None for the jobs that were running."""
    waiting, running = deque(batch), dict[Future[JobResult], int]()
    broken = False
    with ProcessPoolExecutor(min(workers, len(batch)), get_context("spawn")) as pool:
        while running or (waiting and not broken):
            # No more jobs are submitted than there are processes, because a crash fails all submitted jobs.
            while waiting and len(running) < workers and not broken:
                try:
                    running[pool.submit(work, jobs[waiting[0]])] = waiting[0]
                except BrokenProcessPool:
                    broken = True
                else:
                    waiting.popleft()
            for future in wait(running, return_when=FIRST_COMPLETED).done:
                index = running.pop(future)
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
        raise BackendError(f"{address}: no Dask scheduler answers ({error})") from None
    with client:
        futures = [client.submit(work, job, retries=MAX_CRASHES, pure=False) for job in jobs]
        indices = {future.key: index for index, future in enumerate(futures)}
        suspects = []
        for future in dask.as_completed(futures, loop=client.loop):
            try:
                result = future.result()
            except Exception:  # killed workers and lost data raise many types
                suspects.append(indices[future.key])
            else:
                yield indices[future.key], result
        # Failed jobs run again one at a time, because a job that kills its worker also fails the worker's
        # other jobs.
        for index in suspects:
            job = jobs[index]
            try:
                result = client.submit(work, job, retries=MAX_CRASHES, pure=False).result()
            except Exception as error:
                reason = (
                    f"{job.source}: the cluster cannot bake it ({type(error).__name__}: {error})"
                )
                result = failure(job, reason)
            yield index, result
