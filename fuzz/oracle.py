"""Judgement of one case: a result of finite arrays, or a short error about the input, and nothing else."""

from __future__ import annotations

import os
import re
import sys
import time
import traceback
import unicodedata
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from types import TracebackType
from typing import Any

import numpy as np

import skinshade
from skinshade._core.errors import InputError, SkinshadeWarning

from .case import Fault, Outcome, Result

__all__ = ["Folders", "Sandbox", "judged", "location"]

LONGEST_MESSAGE = 2000
"""Most characters of an error message: it must fit on a screen."""
PACKAGE = os.path.join(os.path.dirname(skinshade.__file__), "")  # noqa: PTH118, PTH120 — a prefix of texts
"""Folder of the package, with a separator at its end."""
WORDS = 6
"""Words at the beginning of a message that tell errors of different reasons apart."""
SECRET = "secret"
"""Beginning of the names of the files that no reader of an asset may open."""
CHANGING = frozenset(
    f"os.{name}"
    for name in (
        "mkdir",
        "rename",
        "remove",
        "rmdir",
        "link",
        "symlink",
        "truncate",
        "chmod",
        "chown",
        "utime",
    )
)
"""Audit events of changes of the file system; the first argument is a path."""
FORBIDDEN = frozenset(
    ("subprocess.Popen", "os.system", "os.exec", "os.posix_spawn", "os.fork", "os.putenv", "webbrowser.open",
     "socket.connect", "socket.getaddrinfo", "pickle.find_class")
)  # fmt: skip
"""Audit events that no reader may cause."""


@dataclass(frozen=True)
class Folders:
    """Folders of a worker, all below one.

    Attributes
    ----------
    base
        The folder of all others, with a file that no case may read.
    """

    base: Path

    @cached_property
    def case(self) -> Path:
        """Folder of the file of a case and its companions."""
        return self.base / "case"

    @cached_property
    def output(self) -> Path:
        """Folder in which a target may write."""
        return self.base / "output"

    @cached_property
    def empty(self) -> list[Path]:
        """Current folder, home, and folder of temporary files; empty before and after a case."""
        return [self.base / name for name in ("current", "home", "temporary")]

    def create(self) -> None:
        """Create all folders and the file that no case may read."""
        for folder in (self.case, self.output, *self.empty):
            folder.mkdir(parents=True, exist_ok=True)
        for suffix in (".png", ".bin"):
            (self.base / f"{SECRET}{suffix}").write_bytes(b"secret")


class Sandbox:
    """Watch over the file system during cases, through the audit events of Python."""

    def __init__(self, folders: Folders) -> None:
        self.folders = folders
        self.confined = True
        self.faults: list[str] = []
        self._allowed = tuple(f"{path}{os.sep}" for path in (folders.output, *folders.empty))
        self._active = False
        sys.addaudithook(self._hook)

    @contextmanager
    def watching(self, confined: bool) -> Iterator[None]:
        """Collect faults; a confined reader must not read files outside the folder of the case."""
        self.confined, self.faults, self._active = confined, [], True
        try:
            yield
        finally:
            self._active = False

    def _hook(self, event: str, arguments: tuple[Any, ...]) -> None:
        if not self._active:
            return
        if event == "open":
            path, mode, flags = arguments
            writing = flags & (os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC) if flags else 0
            if writing or (mode and set(mode) & set("wax+")):
                self._check_target(event, path)
            elif self.confined and _is_path(path) and SECRET in Path(os.fsdecode(path)).name:
                self.faults.append(f"reads {os.fsdecode(path)}")
        elif event in CHANGING:
            folder = arguments[
                -1
            ]  # of a name that is relative to an open folder, which rmtree uses
            if event == "os.truncate" or not isinstance(folder, int) or folder < 0:
                self._check_target(event, arguments[0])
        elif event in FORBIDDEN:
            self.faults.append(f"{event} {arguments!r:.200}")

    def _check_target(self, event: str, path: Any) -> None:
        if _is_path(path):
            name = os.path.abspath(os.fsdecode(path))  # noqa: PTH100 — Path is too slow for every event
            if name != os.devnull and not name.startswith(self._allowed):
                self.faults.append(f"{event} {name}")


def _is_displayable(text: str) -> bool:
    """Return whether a text has no controls, line breaks, lone surrogates, and marks that reorder text."""
    return text.isprintable() or not any(
        unicodedata.category(c) in ("Cc", "Cs", "Zl", "Zp")
        or unicodedata.bidirectional(c)
        in ("LRE", "RLE", "LRO", "RLO", "PDF", "LRI", "RLI", "FSI", "PDI")
        for c in text
    )


def _is_path(value: Any) -> bool:
    return isinstance(value, (str, bytes, os.PathLike))


# -- judgement -------------------------------------------------------------------------------------


def judged(
    run: Callable[[Path, Path], Result], file: Path, sandbox: Sandbox, *, confined: bool, name: str
) -> Outcome:
    """Return the outcome of a reader for one file.

    Parameters
    ----------
    run
        Reader of a file, with a folder in which it may write.
    file
        File to read.
    sandbox
        Watch over the file system.
    confined
        Whether the reader must not read files outside the folder of the file.
    name
        Name of the target, as the location of faults that have no other.
    """
    result, error = Result(), None
    inputs = _tree(sandbox.folders.case)
    started = time.process_time()
    with warnings.catch_warnings(record=True) as caught, sandbox.watching(confined):
        warnings.simplefilter("always")
        try:
            result = run(file, sandbox.folders.output)
        except Exception as raised:
            error = raised
    seconds = time.process_time() - started
    fault = _fault_of_error(error) if error is not None else _fault_of_arrays(result, name)
    fault = fault or _fault_of_warnings(caught)
    fault = fault or next((Fault("forbidden", name, text) for text in sandbox.faults), None)
    fault = fault or _fault_of_files(sandbox.folders, inputs, result.written, name)
    kind = "" if error is None else type(error).__name__
    signature = result.label if error is None else _signature(error, file)
    return Outcome(kind, signature, fault, seconds)


def _fault_of_error(error: Exception) -> Fault | None:
    """Return the fault of an error that is not about the input, or whose message is no message."""
    kind, text = type(error).__name__, str(error)
    if isinstance(error, InputError):
        if len(text) > LONGEST_MESSAGE:
            kind = f"long message of {kind}"
        elif not _is_displayable(text):
            kind = f"unprintable message of {kind}"
        else:
            return None
    details = "".join(traceback.format_exception(error))
    return Fault(
        kind, location(_calls(error.__traceback__), ""), f"{text!r:.500}", details[-20_000:]
    )


def location(frames: Sequence[tuple[str, int | None]], name: str) -> str:
    """Return file and line of the first call in the package, or else of the first call.

    Parameters
    ----------
    frames
        Files and lines of calls, the innermost call first.
    name
        Result if there are no calls.
    """
    own = [frame for frame in frames if frame[0].startswith(PACKAGE)]
    if not frames:
        return name
    file, line = (own or frames)[0]
    return f"{_short(file)}:{line}"


def _calls(trace: TracebackType | None) -> list[tuple[str, int | None]]:
    """Return files and lines of the calls of a traceback, the innermost call first."""
    return [(frame.filename, frame.lineno) for frame in reversed(traceback.extract_tb(trace))]


def _short(name: str) -> str:
    """Return a file name without the folders of the machine."""
    if name.startswith(PACKAGE):
        return f"skinshade/{Path(name[len(PACKAGE) :]).as_posix()}"
    library = name.rpartition(f"{os.sep}site-packages{os.sep}")[2]
    return library if library != name else Path(name).name


def _fault_of_arrays(result: Result, name: str) -> Fault | None:
    for number, array in enumerate(result.arrays):
        values = np.asarray(array)
        if values.dtype.kind == "f" and not np.isfinite(values).all():
            index = tuple(int(i) for i in np.argwhere(~np.isfinite(values))[0])
            return Fault("not finite", name, f"array {number}{list(index)} is {values[index]}")
    return None


def _fault_of_warnings(caught: list[warnings.WarningMessage]) -> Fault | None:
    for warning in caught:
        text = str(warning.message)
        line = f"{_short(warning.filename)}:{warning.lineno}"
        if not issubclass(warning.category, SkinshadeWarning):
            return Fault(warning.category.__name__, line, text[:500])
        if len(text) > LONGEST_MESSAGE or not _is_displayable(text):
            return Fault(f"message of {warning.category.__name__}", line, f"{text!r:.500}")
    return None


def _fault_of_files(
    folders: Folders, inputs: dict[str, tuple[int, int]], written: list[Path], name: str
) -> Fault | None:
    """Return the fault of files that were created, changed or left; remove what the case wrote."""
    fault = None
    for folder in folders.empty:
        if left := _tree(folder):
            fault = Fault("file", name, f"leaves {min(left)} in the folder {folder.name}")
            _clear(folder)
    outputs = _tree(folders.output)
    extra = outputs.keys() - {str(path) for path in written}
    if extra:
        fault = Fault("file", name, f"leaves {min(extra)} beside its output")
    _clear(folders.output)
    if _tree(folders.case) != inputs:
        fault = Fault("file", name, "changes the files that it reads")
    return fault


def _tree(folder: Path) -> dict[str, tuple[int, int]]:
    """Return size and time of change of every file below a folder, by path."""
    found: dict[str, tuple[int, int]] = {}
    with os.scandir(folder) as entries:
        for entry in entries:
            if entry.is_dir(follow_symlinks=False):
                found |= _tree(Path(entry.path)) or {entry.path: (0, 0)}
            else:
                status = entry.stat(follow_symlinks=False)
                found[entry.path] = status.st_size, status.st_mtime_ns
    return found


def _clear(folder: Path) -> None:
    with os.scandir(folder) as entries:
        for entry in entries:
            if entry.is_dir(follow_symlinks=False):
                _clear(Path(entry.path))
                os.rmdir(entry.path)  # noqa: PTH106 — as fast as the rest of a case
            else:
                os.unlink(entry.path)  # noqa: PTH108


def _signature(error: Exception, file: Path) -> str:
    """Return the type of an error and the first words of its message, without names and values."""
    text = str(error)[:1000].replace(str(file), "").replace(str(file.parent), "")
    text = re.sub(r"'[^']*'|\"[^\"]*\"|[-+\d.:,()\[\]]+", " ", text)
    return " ".join([type(error).__name__, *text.split()[:WORDS]])
