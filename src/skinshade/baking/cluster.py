"""Baking of a library on the workers of a Dask cluster."""

from __future__ import annotations

import asyncio
import logging
import time
from collections.abc import AsyncIterator, Callable, Iterator
from concurrent.futures import CancelledError
from contextlib import suppress
from importlib.util import find_spec
from queue import SimpleQueue
from threading import Thread
from typing import Any

from .._core.errors import BackendError, DependencyError
from .jobs import Job, JobResult, failure

__all__ = ["run_on_cluster"]

RETRIES = 3
"""Number of times that the scheduler repeats a job."""
CONNECT_SECONDS = 5.0
"""Time in which a scheduler must answer, s."""
WORKER_SECONDS = 7.0
"""Time without a worker after which the remaining jobs fail, s. Dask replaces a killed worker in 3 s."""
POLL_SECONDS = 0.5
"""Time without a result after which the number of workers is checked, s."""
CLOSE_SECONDS = 2.0
"""Time for the end of the connection, s."""

Work = Callable[[Job], JobResult]
Outcome = JobResult | Exception | None
"""Result of a job; or the error with which the cluster gave it up; or None if the cluster is lost."""


def run_on_cluster(jobs: list[Job], address: str, work: Work) -> Iterator[tuple[int, JobResult]]:
    """Yield the index and the result of each job as it finishes.

    Without a scheduler or a worker, an error is raised. If they are lost later, the remaining jobs fail.

    Parameters
    ----------
    jobs
        Jobs.
    address
        Address of the scheduler, ``tcp://host:port``.
    work
        Function that bakes one job; the workers must be able to import it.

    Raises
    ------
    DependencyError, BackendError
        If Dask is not installed, the scheduler does not answer, or it has no worker.
    """
    if find_spec("distributed") is None:
        raise DependencyError('Dask is not installed: pip install "skinshade[dask]"')
    import distributed  # noqa: F401  # sets the level of its logger, which `_Session` changes

    session = _Session(jobs, address, work)
    try:
        session.thread.start()
        for _ in jobs:
            yield session.next_result()
    finally:
        session.stop()


class _Session:
    """Thread with an event loop, which limits the time of every step.

    The blocking client of Dask has no limit for some steps, such as the handshake with a server that is
    silent.
    """

    def __init__(self, jobs: list[Job], address: str, work: Work) -> None:
        self._jobs, self._address, self._work = jobs, address, work
        self._results = SimpleQueue[tuple[int, JobResult] | Exception]()
        self._task: asyncio.Task[None] | None = None
        self.thread = Thread(target=self._run, daemon=True)

    def next_result(self) -> tuple[int, JobResult]:
        """Return the index and the result of the next job that finishes."""
        match self._results.get():
            case Exception() as error:
                raise error
            case result:
                return result

    def stop(self) -> None:
        """Cancel what is running, and wait for the end of the connection."""
        if self._task is not None:
            with suppress(RuntimeError):  # the loop has ended
                self._task.get_loop().call_soon_threadsafe(self._task.cancel)
        self.thread.join(CLOSE_SECONDS)

    def _run(self) -> None:
        logger = logging.getLogger("distributed.client")
        level = logger.level
        logger.setLevel(logging.CRITICAL)  # the results say that the connection is lost
        try:
            asyncio.run(self._bake())
        except Exception as error:  # raised again by the thread that waits for results
            self._results.put(error)
        except asyncio.CancelledError:
            pass
        finally:
            logger.setLevel(level)

    async def _bake(self) -> None:
        self._task = asyncio.current_task()
        client = await _connect(self._address)
        try:
            await self._require_worker(client)
            await self._bake_with(client)
        finally:
            await _close(client)

    async def _require_worker(self, client: Any) -> None:
        end = time.monotonic() + WORKER_SECONDS
        while not await _worker_count(client):
            if time.monotonic() > end:
                raise BackendError(
                    f"{self._address}: the Dask scheduler has no worker; start one:"
                    f" dask worker {self._address}"
                )
            await asyncio.sleep(POLL_SECONDS)

    async def _bake_with(self, client: Any) -> None:
        suspects = []
        is_lost = False
        async for index, outcome in self._outcomes(client, range(len(self._jobs))):
            if isinstance(outcome, Exception):
                suspects.append(index)
            else:
                is_lost = is_lost or outcome is None
                self._put(index, outcome)
        # Failed jobs run again one at a time, because a job that kills its worker also fails the worker's
        # other jobs.
        for index in suspects:
            if is_lost:
                self._put(index, None)
                continue
            async for _, outcome in self._outcomes(client, [index]):
                is_lost = outcome is None
                self._put(index, outcome)

    def _put(self, index: int, outcome: Outcome) -> None:
        job = self._jobs[index]
        if outcome is None:
            reason = f"the Dask cluster {self._address} has lost its scheduler or its last worker"
            outcome = failure(
                job, f"{job.source}: {reason}; repeat the command for the remaining models"
            )
        elif isinstance(outcome, Exception):
            reason = f"the cluster cannot bake it ({type(outcome).__name__}: {outcome})"
            outcome = failure(job, f"{job.source}: {reason}")
        self._results.put((index, outcome))

    async def _outcomes(
        self, client: Any, indices: range | list[int]
    ) -> AsyncIterator[tuple[int, Outcome]]:
        tasks = {
            asyncio.create_task(_outcome(client, self._work, self._jobs[index])): index
            for index in indices
        }
        last = time.monotonic()
        while tasks and time.monotonic() < last + WORKER_SECONDS:
            done, _ = await asyncio.wait(
                tasks, timeout=POLL_SECONDS, return_when=asyncio.FIRST_COMPLETED
            )
            for task in done:
                yield tasks.pop(task), task.result()
            if done or await _worker_count(client):
                last = time.monotonic()
        for task, index in tasks.items():
            task.cancel()
            yield index, None


async def _connect(address: str) -> Any:
    """Return a client that is connected to a scheduler."""
    import distributed

    dask: Any = distributed
    client: Any = None
    try:
        client = dask.Client(
            address, timeout=CONNECT_SECONDS, asynchronous=True, set_as_default=False
        )
        await asyncio.wait_for(client, CONNECT_SECONDS)
    except Exception as error:  # another server's answer can raise any type
        await _close(client)
        reason = str(error) or f"no answer in {CONNECT_SECONDS:g} s"
        raise BackendError(f"{address}: no Dask scheduler answers ({reason})") from None
    return client


async def _close(client: Any) -> None:
    if client is not None:
        with suppress(Exception):
            await asyncio.wait_for(client.close(CLOSE_SECONDS), CLOSE_SECONDS)


async def _outcome(client: Any, work: Work, job: Job) -> Outcome:
    try:
        result: JobResult = await client.submit(work, job, retries=RETRIES, pure=False).result()
    except (asyncio.CancelledError, CancelledError):  # the connection to the scheduler is lost
        return None
    except Exception as error:  # killed workers and lost data raise many types
        return error
    return result


async def _worker_count(client: Any) -> int:
    if client.scheduler is None:  # closed, because the scheduler was lost
        return 0
    try:
        return len(await asyncio.wait_for(client.scheduler.ncores(), CLOSE_SECONDS))
    except OSError:  # no answer
        return 0
