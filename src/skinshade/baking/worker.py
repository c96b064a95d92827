"""Worker process of a bake, run as a script; until its first job it imports the standard library only.

The parent writes jobs to the standard input and reads the answers from the standard output. A message is a
pickle after its length. The input also ends when the parent is killed; its end stops the worker.
"""

from __future__ import annotations

import os
import pickle
import signal
import sys
import threading
import time
from importlib.util import module_from_spec, spec_from_file_location
from io import TextIOWrapper
from pathlib import Path
from queue import SimpleQueue
from types import FrameType
from typing import IO, Any

__all__ = ["SECONDS_TO_STOP", "failure_reason", "read_message", "write_message"]

SECONDS_TO_STOP = 2.0
"""Time for the removal of temporary files between the end of the input and the end of the worker, s."""
LENGTH_BYTES = 8


def write_message(stream: IO[bytes], data: bytes) -> None:
    """Write a message, and flush the stream."""
    stream.write(len(data).to_bytes(LENGTH_BYTES, "little") + data)
    stream.flush()


def read_message(stream: IO[bytes]) -> bytes | None:
    """Return the next message, or None if the stream ends before the message is complete."""
    head = stream.read(LENGTH_BYTES)
    if len(head) < LENGTH_BYTES:
        return None
    length = int.from_bytes(head, "little")
    data = stream.read(length)
    return data if len(data) == length else None


def failure_reason(error: Exception) -> str:
    """Return the reason of a failure for an error that is not one of skinshade's."""
    if isinstance(error, MemoryError):
        return "out of memory"
    if isinstance(error, RecursionError):
        return "its content is nested too deeply"
    return f"internal error: {type(error).__name__}: {error}"


def main() -> None:
    """Answer jobs until the input ends. The arguments are the parent's search path for modules."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent receives it too, and decides
    sys.unraisablehook = lambda _: None  # an interruption within a destructor prints nothing
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what libraries print goes to the standard error, not between the answers
    if isinstance(sys.stdout, TextIOWrapper):
        sys.stdout.reconfigure(
            line_buffering=True
        )  # the end of the process does not write the rest
    sys.path[:] = [*sys.argv[1:], *(entry for entry in sys.path if entry not in sys.argv)]
    jobs = SimpleQueue[bytes | None]()
    code = 1
    try:
        signal.signal(signal.SIGTERM, _exit)
        threading.Thread(target=_receive, args=(jobs, threading.get_ident()), daemon=True).start()
        while (job := jobs.get()) is not None:
            write_message(answers, _answer(job))
        code = 0
    except (KeyboardInterrupt, OSError):  # the input ended, or nobody reads the answers
        code = 0
    finally:
        os._exit(code)  # the interpreter's shutdown could print an interruption


def _answer(message: bytes) -> bytes:
    """Return the pickle of the result of a job, or of the reason of its failure."""
    try:
        _import_package()
        work, job = pickle.loads(message)
        # Not before, because some modules in C abort the process if an error interrupts their import.
        signal.signal(signal.SIGTERM, _interrupt)
        return pickle.dumps(work(job))
    except Exception as error:
        return pickle.dumps(failure_reason(error))


def _receive(jobs: SimpleQueue[bytes | None], main_thread: int) -> None:
    """Pass on the jobs; after the last one, interrupt the main thread, and end the process in time."""
    try:
        while (message := read_message(sys.stdin.buffer)) is not None:
            jobs.put(message)
    finally:
        jobs.put(None)
        end = time.monotonic() + SECONDS_TO_STOP
        while time.monotonic() < end:
            # Repeated, because a signal does not end a wait that begins right after it.
            if hasattr(signal, "pthread_kill"):
                signal.pthread_kill(main_thread, signal.SIGTERM)
            else:
                signal.raise_signal(signal.SIGTERM)
            time.sleep(0.05)
        os._exit(1)


def _exit(number: int, frame: FrameType | None) -> None:
    os._exit(0)


def _interrupt(number: int, frame: FrameType | None) -> None:
    if signal.getsignal(number) != signal.SIG_IGN:
        signal.signal(number, signal.SIG_IGN)  # a second signal would interrupt the clean-up
        signal.default_int_handler(number, frame)


def _import_package() -> None:
    """Import skinshade from the folder of this file, which need not be on the search path."""
    if "skinshade" in sys.modules:
        return
    folder = Path(__file__).resolve().parents[1]
    spec: Any = spec_from_file_location(
        "skinshade", folder / "__init__.py", submodule_search_locations=[str(folder)]
    )
    package = module_from_spec(spec)
    spec.loader.exec_module(package)
    sys.modules["skinshade"] = package


if __name__ == "__main__":
    main()
