"""Signals that end the program: it removes its temporary files, prints one line and exits with 128 + number.

During a command, the first signal raises KeyboardInterrupt in the main thread; later ones are ignored,
because they would interrupt the removal of temporary files. If the main thread does not finish in time, for
example because a library runs C code for long, another thread ends the process. Before and after the command
there are no temporary files, and a signal ends the process at once.
"""

from __future__ import annotations

import atexit
import os
import signal
import sys
import time
from _thread import allocate_lock, get_ident, interrupt_main, start_new_thread
from types import FrameType
from typing import Any, NoReturn

__all__ = ["exit_at_next", "exit_interrupted", "handle", "is_interrupted", "raise_at_next"]

LINES = {"SIGINT": "interrupted", "SIGTERM": "terminated", "SIGHUP": "terminated"}
"""Line for each signal. SIGHUP comes from a terminal that is closed; Windows does not have it."""
SECONDS_TO_STOP = 4.0
"""Time from the signal to the end of the process, s. Worker processes take up to 2.5 s of it."""
STEP_SECONDS = 0.05
"""Time between repetitions of a signal, s. A signal does not end a wait that begins right after it."""
CLEARED_LINE = "\r\x1b[2K\x1b[?25h"
"""Control codes that erase the line of a progress bar and show the cursor again."""

_received: list[int] = []
_handled: list[int] = []
_exiting = allocate_lock()


def handle() -> None:
    """Exit at a signal, with one line."""
    try:
        for name in LINES:
            number = getattr(signal, name, None)
            # A parent such as nohup, or a shell that starts a background job, ignores signals on purpose.
            if number is not None and signal.getsignal(number) != signal.SIG_IGN:
                signal.signal(number, _exit)
                _handled.append(number)
    except ValueError:  # not the main thread, which alone can handle signals
        return
    atexit.register(_ignore)  # as the first function, it runs last
    sys.unraisablehook = _interrupt_again
    reading, writing = os.pipe()
    if hasattr(os, "set_blocking"):  # always except on Windows before Python 3.12
        os.set_blocking(writing, False)
    signal.set_wakeup_fd(writing, warn_on_full_buffer=False)
    start_new_thread(_watch, (reading, get_ident()))


def is_interrupted() -> bool:
    """Return whether a signal was received; errors are then results of the interruption."""
    return bool(_received)


def raise_at_next() -> None:
    """Raise KeyboardInterrupt in the main thread at the next signal."""
    for number in _handled:
        signal.signal(number, _interrupt)


def exit_at_next() -> None:
    """Exit if a signal was received; otherwise exit at the next one."""
    for number in _handled:
        signal.signal(number, _exit)
    if _received:
        exit_interrupted()


def exit_interrupted() -> NoReturn:
    """Print one line and exit, without the interpreter's shutdown, which could print more."""
    number = _received[0] if _received else int(signal.SIGINT)
    if _exiting.acquire(blocking=False):
        _print_line(LINES[signal.Signals(number).name])
        for stream in (sys.stdout, sys.stderr):
            try:
                stream.flush()
            except Exception:  # a closed pipe or a full disk changes nothing
                continue
    else:
        time.sleep(1.0)  # another thread is about to exit
    os._exit(128 + number)


def _print_line(text: str) -> None:
    stream = sys.__stderr__
    if stream is None:
        return
    try:
        is_terminal = stream.isatty() and os.environ.get("TERM", "dumb") != "dumb"
        start = CLEARED_LINE if is_terminal else ""
        os.write(stream.fileno(), f"{start}skinshade: {text}\n".encode())
    except (OSError, ValueError):  # a closed stream
        return


def _interrupt(number: int, frame: FrameType | None) -> None:
    if not _received and not _is_import(frame):
        _received.append(number)
        signal.default_int_handler(number, frame)


def _is_import(frame: FrameType | None) -> bool:
    """Return whether a module is being imported. Some modules in C abort the process at an error then."""
    while frame is not None:
        if frame.f_code.co_filename.startswith("<frozen importlib"):
            return True
        frame = frame.f_back
    return False


def _exit(number: int, frame: FrameType | None) -> None:
    if not _received:
        _received.append(number)
        exit_interrupted()


def _ignore() -> None:
    """Ignore signals in the last milliseconds, when the interpreter has removed the handlers."""
    for number in _handled:
        signal.signal(number, signal.SIG_IGN)


def _interrupt_again(unraisable: Any) -> None:
    """Raise KeyboardInterrupt once more if it came in a destructor, where Python drops errors."""
    if not issubclass(unraisable.exc_type, KeyboardInterrupt):
        sys.__unraisablehook__(unraisable)
    else:
        _received.clear()  # `_watch` repeats the signal


def _watch(reading: int, main_thread: int) -> None:
    """Wait for a signal, repeat it until its handler has run, and end the process in time."""
    while (number := os.read(reading, 1)[0]) not in _handled:
        pass
    end = time.monotonic() + SECONDS_TO_STOP
    while time.monotonic() < end:
        time.sleep(STEP_SECONDS)
        if not _received:
            _send(signal.Signals(number), main_thread)
    _received.append(number)  # the first entry counts
    exit_interrupted()


def _send(number: signal.Signals, main_thread: int) -> None:
    if hasattr(signal, "pthread_kill"):
        signal.pthread_kill(main_thread, number)  # also ends a wait
    else:
        interrupt_main(number)
