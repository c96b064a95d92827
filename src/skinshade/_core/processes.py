"""Processes of this machine: whether one is running, and locks that name their holder."""

from __future__ import annotations

import hashlib
import os
import socket
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from .errors import OutputError

__all__ = ["LOCK_MARK", "MACHINE", "is_running", "output_lock"]

MACHINE = hashlib.sha256(socket.gethostname().encode("utf-8", "surrogateescape")).hexdigest()[:8]
"""Short hash of the machine's name. Machines that share a folder have unrelated process numbers."""
LOCK_MARK = ".skinshade-lock-"
"""Beginning of the names of lock files."""


def is_running(process: int) -> bool:
    """Return whether a process of this machine is running, given its number; True if unknown."""
    if sys.platform == "win32":
        import ctypes

        synchronize, timeout = 0x00100000, 0x102
        kernel = ctypes.windll.kernel32
        handle = kernel.OpenProcess(synchronize, 0, process)
        if not handle:
            return False
        running = kernel.WaitForSingleObject(handle, 0) == timeout
        kernel.CloseHandle(handle)
        return bool(running)
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except (PermissionError, OverflowError):
        return True
    return True


@contextmanager
def output_lock(target: Path) -> Iterator[None]:
    """Hold a lock on an output, so that no second process writes it at the same time.

    The lock is a file beside the output that the operating system locks, and which contains the number of the
    process. It is released when the process ends, however it ends.

    Parameters
    ----------
    target
        Output file; its folder exists.

    Raises
    ------
    OutputError
        If another process, or another thread, holds the lock: the message names the process. Also if the
        folder cannot be written.
    """
    name = hashlib.sha256(os.fsencode(os.path.realpath(target))).hexdigest()[:16]
    lock = Path(os.path.realpath(target)).parent / f"{LOCK_MARK}{name}"
    handle = _locked(lock, target)
    try:
        os.ftruncate(handle, 0)
        os.write(
            handle, f"process {os.getpid()} on {socket.gethostname()}".encode("utf-8", "replace")
        )
        yield
    finally:
        if sys.platform != "win32":  # Windows cannot remove an open file
            lock.unlink(missing_ok=True)
        os.close(handle)
        if sys.platform == "win32":
            with suppress(OSError):
                lock.unlink(missing_ok=True)


def _locked(lock: Path, target: Path) -> int:
    """Return the handle of the open and locked file `lock`."""
    while True:
        try:
            handle = os.open(lock, os.O_CREAT | os.O_RDWR, 0o666)
        except OSError as error:
            raise OutputError(f"{target}: cannot write to its folder ({error.strerror})") from None
        try:
            _lock(handle)
        except OSError:
            holder = os.read(handle, 200).decode("utf-8", "replace") or "another process"
            os.close(handle)
            raise OutputError(
                f"{target}: {holder} is writing it; wait for it to end, or choose another output"
            ) from None
        try:
            if os.path.samestat(os.fstat(handle), os.stat(lock)):  # noqa: PTH116 — samestat needs os.stat
                return handle
        except FileNotFoundError:
            pass
        os.close(handle)  # the former holder removed the file after it was opened here


def _lock(handle: int) -> None:
    """Lock an open file for this handle alone.

    Raises
    ------
    OSError
        If it is locked by another handle.
    """
    if sys.platform == "win32":
        import msvcrt

        os.lseek(handle, 1 << 20, os.SEEK_SET)  # a byte beyond the text, which others may read
        msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
        os.lseek(handle, 0, os.SEEK_SET)
    else:
        import fcntl

        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
