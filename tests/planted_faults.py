"""Targets with one fault each, which the fuzzer must find; they read any changed file."""

import ctypes
import os
import time
import warnings
from pathlib import Path

import numpy as np

from fuzz.case import Result, Target
from skinshade._core.errors import ArgumentError, FileError, MeshFileError

HONEST = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


class LongError(MeshFileError):
    """An error that does not shorten its message."""

    def __str__(self) -> str:
        return "x" * 3000


class ControlError(MeshFileError):
    """An error that commands the terminal."""

    def __str__(self) -> str:
        return "\x1b[2J"


def other_error(file: Path, output: Path) -> Result:
    raise ValueError(f"{file}: not handled")


def refused(file: Path, output: Path) -> Result:
    raise MeshFileError(f"{file}: is refused")


def argument(file: Path, output: Path) -> Result:
    raise ArgumentError(f"{file}: number {len(file.read_bytes())} is wrong")


def long_message(file: Path, output: Path) -> Result:
    raise LongError


def control_characters(file: Path, output: Path) -> Result:
    raise ControlError


def not_finite(file: Path, output: Path) -> Result:
    return Result([np.array([0.0, 1.0]), np.array([[0.0, np.nan]])])


def numpy_warning(file: Path, output: Path) -> Result:
    return Result([np.float32(1e38) * np.array([1.0, 2.0]) + np.array([1e308]) * 0.0 + overflow()])


def overflow() -> np.ndarray:
    return np.zeros(1) * (np.array([1e300]) * np.array([1e300]) < 0)


def own_warning(file: Path, output: Path) -> Result:
    warnings.warn("a library is old", DeprecationWarning, stacklevel=1)
    return Result()


def text(file: Path, output: Path) -> Result:
    print("read the file")
    return Result()


def text_of_a_library(file: Path, output: Path) -> Result:
    ctypes.CDLL(None).puts(b"text of C")
    return Result()


def file_elsewhere(file: Path, output: Path) -> Result:
    (file.parent.parent / "elsewhere.txt").write_text("x")
    (file.parent.parent / "elsewhere.txt").unlink()
    return Result()


def file_at_home(file: Path, output: Path) -> Result:
    Path("~/cache.txt").expanduser().write_text("x")
    return Result()


def file_after_an_error(file: Path, output: Path) -> Result:
    (output / "half.glb").write_bytes(b"x")
    raise FileError(f"{file}: is refused, too late")


def changed_input(file: Path, output: Path) -> Result:
    os.utime(file, (1.0, 1.0))
    return Result()


def secret(file: Path, output: Path) -> Result:
    (file.parent / "../secret.bin").read_bytes()
    return Result()


def sleep(file: Path, output: Path) -> Result:
    time.sleep(60.0)
    return Result()


def endless_loop(file: Path, output: Path) -> Result:
    while True:
        pass


def death(file: Path, output: Path) -> Result:
    ctypes.string_at(0)
    return Result()


def end(file: Path, output: Path) -> Result:
    os._exit(0)


def memory(file: Path, output: Path) -> Result:
    return Result([float(np.ones(20_000_000).sum())])


def address_space(file: Path, output: Path) -> Result:
    np.empty(1 << 40)
    return Result()


def after_a_change(fault):
    """Return a target that is at fault for every file but the honest one."""

    def run(file: Path, output: Path) -> Result:
        return Result(label="honest") if file.read_bytes() == HONEST else fault(file, output)

    return run


FAULTS = {
    other_error: "ValueError",
    long_message: "long message of LongError",
    control_characters: "unprintable message of ControlError",
    not_finite: "not finite",
    numpy_warning: "RuntimeWarning",
    own_warning: "DeprecationWarning",
    text: "text",
    text_of_a_library: "text",
    file_elsewhere: "forbidden",
    file_at_home: "file",
    file_after_an_error: "file",
    changed_input: "forbidden",
    secret: "forbidden",
    sleep: "hang",
    endless_loop: "hang",
    death: "SIGSEGV",
    end: "exit",
    memory: "memory",
    address_space: "MemoryError",
}
"""Faults, and the kinds of their findings."""
HARMLESS = (refused, argument)
TARGETS = {
    run.__name__: Target(after_a_change(run), ("obj",), weight=1) for run in (*FAULTS, *HARMLESS)
}
