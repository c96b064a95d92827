"""Baking of a library of assets in this process, in several processes, or on a Dask cluster."""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextlib import closing

from .._core.errors import ArgumentError
from .._core.progress import Progress, silent
from .jobs import Job, JobResult, failure, run_job
from .worker import failure_reason
from .workers import run_on_processes

__all__ = ["bake_library"]

Work = Callable[[Job], JobResult]


def _ignore(result: JobResult) -> None:
    """Report nothing."""


def bake_library(
    jobs: list[Job],
    *,
    workers: int = 1,
    cluster: str | None = None,
    progress: Progress = silent,
    report: Callable[[JobResult], None] = _ignore,
    work: Work = run_job,
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
    report
        Called with the result of each job as it finishes.
    work
        Function that bakes one job. Processes import it by its name, without the current folder.

    Returns
    -------
    list
        Result of each job, in the order of the jobs. A failed job does not stop the others. If a cluster
        is lost during the work, the remaining jobs are failed results.

    Raises
    ------
    ArgumentError, DependencyError, BackendError
        If the number of workers is out of range, a process cannot be started, Dask is not installed, or
        its scheduler does not answer or has no worker.
    """
    if not 1 <= workers <= 1024:
        raise ArgumentError(f"workers is {workers}; it must be 1..1024 processes")
    results: dict[int, JobResult] = {}
    # An interruption closes the iterator, which ends the processes.
    with closing(_finished_jobs(jobs, workers, cluster, work)) as finished:
        for index, result in finished:
            results[index] = result
            report(result)
            progress("baking", len(results) / len(jobs))
    return [results[index] for index in range(len(jobs))]


def _finished_jobs(
    jobs: list[Job], workers: int, cluster: str | None, work: Work
) -> Generator[tuple[int, JobResult], None, None]:
    if cluster is not None:
        from .cluster import run_on_cluster  # imports asyncio

        yield from run_on_cluster(jobs, cluster, work)
    elif workers > 1:
        yield from run_on_processes(jobs, workers, work)
    else:
        for index, job in enumerate(jobs):
            yield index, _run_in_this_process(work, job)


def _run_in_this_process(work: Work, job: Job) -> JobResult:
    try:
        return work(job)
    except Exception as error:
        return failure(job, f"{job.source}: {failure_reason(error)}")
