"""Processes of a run of the program, found on Linux by a variable in their environment."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
import uuid
from collections.abc import Callable
from pathlib import Path

import skinshade

VARIABLE = "SKINSHADE_TEST_RUN"
SOURCE = str(Path(skinshade.__file__).parents[1])


def program_environment() -> dict[str, str]:
    """Return the environment of users: output into pipes is buffered."""
    environment = os.environ | {"PYTHONPATH": SOURCE}
    environment.pop("PYTHONUNBUFFERED", None)
    return environment


class Started:
    """Python process in a session of its own, with pipes for its output.

    The session makes its group of processes that of a terminal, to which all processes of the run belong.
    """

    def __init__(
        self, folder: Path, *words: str, stderr: int = subprocess.PIPE, **variables: str
    ) -> None:
        self.mark = uuid.uuid4().hex
        environment = program_environment() | {VARIABLE: self.mark} | variables
        # A process ignores SIGINT if its parent does, such as tests in the background of a script.
        handler = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.process = subprocess.Popen(
            [sys.executable, *words],
            cwd=folder,
            env=environment,
            stdout=subprocess.PIPE,
            stderr=stderr,
            start_new_session=True,
        )
        signal.signal(signal.SIGINT, handler)

    def wait_for_handler(self, number: int = signal.SIGTERM) -> None:
        """Wait until the process handles a signal, or ends."""
        end = time.monotonic() + 60.0
        while time.monotonic() < end and self.process.poll() is None:
            status = Path(f"/proc/{self.process.pid}/status").read_text("utf-8")
            caught = next(line for line in status.splitlines() if line.startswith("SigCgt"))
            if int(caught.split()[1], 16) >> (number - 1) & 1:
                return
            time.sleep(0.002)

    def finish(self, seconds: float = 60.0) -> tuple[int, str, str]:
        """Return the exit code, the output and the errors when the process has ended."""
        out, err = self.process.communicate(timeout=seconds)
        texts = [data.decode("utf-8", "backslashreplace") for data in (out, err or b"")]
        return self.process.returncode, texts[0], texts[1]

    def others(self) -> list[int]:
        """Return the numbers of all other processes of the run that still run."""
        entry = f"{VARIABLE}={self.mark}".encode()
        numbers = []
        for folder in Path("/proc").glob("[0-9]*"):
            try:
                is_marked = entry in (folder / "environ").read_bytes().split(b"\0")
            except OSError:  # it has ended, or belongs to another user
                continue
            if is_marked and int(folder.name) != self.process.pid:
                numbers.append(int(folder.name))
        return numbers

    def others_after(self, seconds: float) -> list[int]:
        """Return the other processes that run at the end of a time; return at once if none is left."""
        end = time.monotonic() + seconds
        while (numbers := self.others()) and time.monotonic() < end:
            time.sleep(0.02)
        return numbers


def wait_until(condition: Callable[[], object], seconds: float = 60.0) -> None:
    """Wait until a function returns a true value; fail after a time."""
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "nothing happened in time"
        time.sleep(0.01)
