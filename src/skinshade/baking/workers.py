"""Worker processes on this machine: a thread of the parent for each, which sends it one job at a time."""

from __future__ import annotations

import os
import pickle
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from queue import SimpleQueue
from threading import Lock, Thread

from .._core.errors import BackendError
from . import worker
from .jobs import Job, JobResult, failure

__all__ = ["MAX_CRASHES", "run_on_processes"]

MAX_CRASHES = 3
"""Crashes of its process after which a job counts as failed."""
SECONDS_TO_KILL = worker.SECONDS_TO_STOP + 0.5
"""Time after the end of its input at which a process that still runs is killed, s."""

Work = Callable[[Job], JobResult]


def run_on_processes(jobs: list[Job], count: int, work: Work) -> Iterator[tuple[int, JobResult]]:
    """Yield the index and the result of each job as it finishes. No process outlives the iterator.

    Parameters
    ----------
    jobs
        Jobs.
    count
        Number of processes.
    work
        Function of a module, which is found without the current folder.

    Raises
    ------
    BackendError
        If a process cannot be started.
    """
    pool = _Pool(jobs, work)
    try:
        pool.start(min(count, len(jobs)))
        for _ in jobs:
            yield pool.next_result()
    finally:
        pool.stop()


class _Pool:
    """Threads that take jobs from a common list, and their processes."""

    def __init__(self, jobs: list[Job], work: Work) -> None:
        self._jobs, self._work = jobs, work
        self._results = SimpleQueue[tuple[int, JobResult] | Exception]()
        self._threads: list[Thread] = []
        self._lock = Lock()  # of the members below
        self._waiting = iter(range(len(jobs)))
        self._processes: set[_Process] = set()
        self._is_stopping = False

    def start(self, count: int) -> None:
        """Start the threads, which start their processes."""
        for _ in range(count):
            thread = Thread(target=self._serve, daemon=True)
            self._threads.append(thread)
            thread.start()

    def next_result(self) -> tuple[int, JobResult]:
        """Return the index and the result of the next job that finishes."""
        match self._results.get():
            case Exception() as error:
                raise error
            case result:
                return result

    def stop(self) -> None:
        """End all processes, then all threads."""
        with self._lock:
            self._is_stopping = True
            processes = list(self._processes)
        _end(processes)
        for thread in self._threads:
            thread.join()

    def _serve(self) -> None:
        """Run jobs until none is waiting. A process that ends during a job is replaced."""
        if hasattr(signal, "pthread_sigmask"):
            # Inherited by processes: a terminal sends SIGINT to all of them, also while they start.
            signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        process: _Process | None = None
        try:
            while (index := self._next_index()) is not None:
                job, result = self._jobs[index], None
                for _ in range(MAX_CRASHES):
                    process = process or self._start_process()
                    if process is None:
                        return
                    result = process.run(self._work, job)
                    if result is not None:
                        break
                    self._remove_process(process)
                    process = None
                self._results.put((index, result or _crash(job)))
        except Exception as error:  # raised again by the thread that waits for results
            self._results.put(error)

    def _next_index(self) -> int | None:
        with self._lock:
            return None if self._is_stopping else next(self._waiting, None)

    def _start_process(self) -> _Process | None:
        """Return a new process, or None if the pool is stopping."""
        with self._lock:
            if self._is_stopping:
                return None
            process = _Process()
            self._processes.add(process)
            return process

    def _remove_process(self, process: _Process) -> None:
        with self._lock:
            if self._is_stopping:
                return  # `stop` ends the process
            self._processes.remove(process)
        _end([process])


class _Process:
    """Python process that runs ``worker.py``."""

    def __init__(self) -> None:
        if not sys.executable:
            raise BackendError(
                "the path of the Python interpreter is unknown (sys.executable is empty), so no"
                " process can be started; bake with 1 process"
            )
        # -P and the absence of the current folder: a file there must not be imported as a module.
        command = [sys.executable, "-P", worker.__file__, *_search_path()]
        try:
            popen = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        except OSError as error:
            raise BackendError(
                f"a process cannot be started ({error}); bake with fewer processes"
            ) from None
        assert popen.stdin and popen.stdout
        self.popen, self.input, self.output = popen, popen.stdin, popen.stdout

    def run(self, work: Work, job: Job) -> JobResult | None:
        """Return the result of a job, or None if the process ends before it answers."""
        message = pickle.dumps((work, job))
        try:
            worker.write_message(self.input, message)
            answer = worker.read_message(self.output)
        except (OSError, ValueError):  # the process is gone, or its input was closed
            return None
        if answer is None:
            return None
        result: JobResult | str = pickle.loads(answer)
        return failure(job, f"{job.source}: {result}") if isinstance(result, str) else result


def _end(processes: list[_Process]) -> None:
    """End the input of processes, wait until they have removed their temporary files, and kill the rest."""
    for process in processes:
        with suppress(OSError):  # the process is gone
            process.input.close()
    deadline = time.monotonic() + SECONDS_TO_KILL
    for process in processes:
        try:
            process.popen.wait(max(deadline - time.monotonic(), 0.0))
        except subprocess.TimeoutExpired:
            process.popen.kill()
            process.popen.wait()
    for process in processes:
        process.output.close()


def _search_path() -> list[str]:
    """Return the search path for modules without the current folder."""
    return [entry for entry in sys.path if entry and not _is_current_folder(entry)]


def _is_current_folder(entry: str) -> bool:
    try:
        return Path(entry).samefile(os.curdir)
    except OSError:  # an entry that does not exist
        return False


def _crash(job: Job) -> JobResult:
    reason = f"its process was killed {MAX_CRASHES} times; the machine may be short of memory"
    return failure(job, f"{job.source}: {reason}")
