"""Child process that runs cases: it is used for thousands of them, and replaced when it dies."""

from __future__ import annotations

import contextlib
import ctypes
import faulthandler
import gc
import importlib
import multiprocessing
import os
import re
import signal
import sys
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import replace
from multiprocessing.connection import Connection
from pathlib import Path
from types import TracebackType
from typing import Any

from .case import Case, Fault, Limits, Outcome
from .memory import limit_address_space, peak_growth, reset_peak
from .oracle import Folders, Sandbox, judged, location

__all__ = ["Worker", "child_runner", "sendable"]

THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "OPENIMAGEIO_THREADS")
WALL_FACTOR = 6.0
"""Wall time after which a case counts as hanging, in units of the limit of processor time. A machine with
other work gives the process a share of its processors only."""
STACK_FRAME = re.compile(r'File "([^"]+)", line (\d+)')
SMALLEST_STEP = 0.01
"""Shortest time of the timer, s."""


class Worker:
    """A child process and the connection to it.

    Parameters
    ----------
    folder
        Folder that the worker may use.
    module
        Module that defines the targets, as `fuzz.targets` does.
    honest
        Honest files, which the worker reads before the first case: they import all modules, and their memory
        is the measure for others.
    companions
        Files beside the file of a case, by format and name.
    limits
        Limits of a case.
    """

    def __init__(
        self,
        folder: Path,
        module: str,
        honest: Sequence[Case],
        companions: Mapping[str, Mapping[str, bytes]],
        limits: Limits,
    ) -> None:
        self.folder, self.module, self.companions, self.limits = folder, module, companions, limits
        self._arguments = folder, module, list(honest), companions, limits
        self._process: Any = None
        self._connection: Any = None
        self.starts = 0

    def __enter__(self) -> Worker:
        self.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.stop()

    def start(self) -> None:
        """Start the process, and wait until it has read the honest files.

        Raises
        ------
        RuntimeError
            If an honest file is refused or at fault, or the process ends.
        """
        self.stop()
        for name in THREADS:
            os.environ[name] = "1"
        context = multiprocessing.get_context("spawn")
        self._connection, other = context.Pipe()
        self._process = context.Process(target=_serve, args=(other, *self._arguments), daemon=True)
        self._process.start()
        other.close()
        self.starts += 1
        try:
            problem = self._connection.recv()
        except EOFError:
            problem = f"the worker ended: {self._output()}"
        if problem:
            self.stop()
            raise RuntimeError(problem)

    def stop(self) -> None:
        """End the process."""
        if self._process is not None:
            self._process.kill()
            self._process.join()
            self._connection.close()
            self._process = None

    def run(self, case: Case) -> Outcome:
        """Return the outcome of a case; the process is replaced if it dies."""
        hangs = False
        try:
            self._connection.send((case.target, case.form, case.suffix, case.data))
            if self._connection.poll(WALL_FACTOR * self.limits.seconds):
                outcome: Outcome = self._connection.recv()
                return outcome
            hangs = True
            os.kill(self._process.pid, signal.SIGABRT)  # it writes its stack, and ends
        except (EOFError, OSError):
            pass
        self._process.join(10.0)
        outcome = Outcome(fault=self._death(case.target, hangs), seconds=self.limits.seconds)
        self.start()
        return outcome

    def _death(self, target: str, hangs: bool) -> Fault:
        """Return the fault of the end of the process: a hang, a signal, or an exit."""
        code, text = self._process.exitcode, self._output()
        if hangs or code == -signal.SIGPROF:
            kind = "hang"
        else:
            kind = "exit" if code is None or code >= 0 else signal.Signals(-code).name
        frames = [(name, int(line)) for name, line in STACK_FRAME.findall(text)]
        return Fault(
            kind, location(frames, target), f"the process ended with {code}", text[-20_000:]
        )

    def _output(self) -> str:
        try:
            return (self.folder / "output.txt").read_text(encoding="utf-8", errors="replace")
        except OSError:
            return ""


# -- in the child ----------------------------------------------------------------------------------


def _serve(
    connection: Connection,
    base: Path,
    module: str,
    honest: list[Case],
    companions: Mapping[str, Mapping[str, bytes]],
    limits: Limits,
) -> None:
    """Run cases until the connection ends."""
    runner = child_runner(base, module, companions, limits)
    try:
        problem = runner.read_honest(honest)
    except Exception as error:
        problem = f"{type(error).__name__}: {error}"
    connection.send(problem)
    if problem:
        return
    with contextlib.suppress(EOFError, OSError):
        while True:
            target, form, suffix, data = connection.recv()
            connection.send(sendable(runner.run(target, form, suffix, data)))


def child_runner(
    base: Path, module: str, companions: Mapping[str, Mapping[str, bytes]], limits: Limits
) -> _Runner:
    """Return a runner of cases, after this process has been prepared for it.

    The process gets empty folders, and its standard output and error go to a file.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent ends the process
    sys.dont_write_bytecode = True
    folders = Folders(base)
    folders.create()
    os.chdir(folders.empty[0])
    os.environ["HOME"] = str(folders.empty[1])
    os.environ["TMPDIR"] = tempfile.tempdir = str(folders.empty[2])
    text = _redirected(base / "output.txt")
    targets = importlib.import_module(module).TARGETS
    return _Runner(folders, targets, companions, limits, text)


def sendable(outcome: Outcome) -> Outcome:
    """Return an outcome whose texts are ASCII: a broken text cannot be sent to the parent."""
    fault = outcome.fault
    if fault is not None:
        texts = (fault.kind, fault.location, fault.message, fault.details)
        fault = Fault(*(text if text.isascii() else ascii(text) for text in texts))
    signature = outcome.signature
    return replace(
        outcome, fault=fault, signature=signature if signature.isascii() else ascii(signature)
    )


def _redirected(path: Path) -> int:
    """Redirect standard output and error to a file; return its descriptor."""
    descriptor = os.open(path, os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND, 0o600)
    for stream in (sys.stdout, sys.stderr):
        stream.flush()
    os.dup2(descriptor, 1)
    os.dup2(descriptor, 2)
    faulthandler.enable(descriptor)
    faulthandler.register(
        signal.SIGPROF, descriptor, chain=True
    )  # chain: then the signal ends the process
    return descriptor


class _Runner:
    """Cases in this process."""

    def __init__(
        self,
        folders: Folders,
        targets: Mapping[str, Any],
        companions: Mapping[str, Mapping[str, bytes]],
        limits: Limits,
        text: int,
    ) -> None:
        self._folders, self._targets, self._companions = folders, targets, companions
        self._limits, self._text = limits, text
        self._sandbox = Sandbox(folders)
        self._form = ""
        self._growth: dict[str, int] = {}
        library = ctypes.CDLL(None)
        self._flush = library.fflush  # C libraries keep their text until the buffer is full

    def read_honest(self, honest: Sequence[Case]) -> str:
        """Read all honest files twice, and set the limits; return the reason if one is at fault.

        A target may refuse some files of a format, such as those without texture coordinates.
        """
        accepted = set()
        for attempt in range(2):
            for case in honest:
                outcome = self.run(case.target, case.form, case.suffix, case.data, limited=False)
                if attempt and outcome.fault:
                    return f"an honest file of {case.target} ({case.form}) is at fault: {outcome.fault}"
                if not outcome.error:
                    accepted.add((case.target, case.form))
                self._growth[case.target] = max(self._growth.get(case.target, 0), outcome.memory)
            if not attempt:
                self._growth.clear()  # the first files import modules
        for case in honest:
            if (case.target, case.form) not in accepted:
                return f"{case.target} refuses all honest files of the format {case.form}"
        gc.collect()
        gc.freeze()
        limit_address_space(self._limits.address_space)
        return ""

    def run(
        self, name: str, form: str, suffix: str, data: bytes, *, limited: bool = True
    ) -> Outcome:
        """Return the outcome of a case."""
        target = self._targets[name]
        file = self._written(form, suffix, data)
        reset_peak()
        if limited:
            signal.setitimer(signal.ITIMER_PROF, max(self._limits.seconds, SMALLEST_STEP))
        outcome = judged(target.run, file, self._sandbox, confined=target.confined, name=name)
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        memory = peak_growth()
        file.unlink()
        fault = outcome.fault or self._fault_of_text(name)
        most = self._limits.memory_factor * self._growth.get(name, 0) + self._limits.memory
        if limited and fault is None and memory > most:
            fault = Fault(
                "memory", name, f"{memory >> 20} MiB more; {most / 2**20:.0f} MiB are allowed"
            )
        return replace(outcome, fault=fault, memory=memory)

    def _written(self, form: str, suffix: str, data: bytes) -> Path:
        """Write the file of a case, and its companions if the format is another than before."""
        if form != self._form:
            for path in self._folders.case.iterdir():
                path.unlink()
            for name, content in self._companions.get(form, {}).items():
                (self._folders.case / name).write_bytes(content)
            self._form = form
        file = self._folders.case / f"case{suffix}"
        file.write_bytes(data)
        return file

    def _fault_of_text(self, name: str) -> Fault | None:
        self._flush(None)
        sys.stdout.flush()
        sys.stderr.flush()
        size = os.fstat(self._text).st_size
        if not size:
            return None
        text = os.pread(self._text, 2000, 0).decode("utf-8", "replace")
        os.ftruncate(self._text, 0)
        words = " ".join(re.sub(r"[^A-Za-z ]", " ", text).split()[:2])
        return Fault("text", f"{name}: {words}", f"writes {text!r:.500}", text)
