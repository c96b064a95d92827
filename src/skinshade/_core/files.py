"""Checks before reading files, and atomic writes of one file or of a set of files.

Temporary files lie beside their targets. Their names begin with `TEMPORARY_MARK` and state the machine and
the process, so that a later run can remove those of processes that were killed.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path

from .errors import FileError, OutputError
from .processes import MACHINE, is_running

__all__ = [
    "TEMPORARY_MARK",
    "FileSet",
    "atomic_files",
    "atomic_write",
    "existing_file",
    "remove_dead_files",
]

TEMPORARY_MARK = ".skinshade-tmp-"
TEMPORARY_NAME = re.compile(
    re.escape(TEMPORARY_MARK)
    + r"(?P<machine>[0-9a-f]{8})-(?P<process>[0-9]{1,10})-[0-9a-f]{16}(\..*)?"
)
"""Names of temporary files: machine, process, random digits, and the suffix of the target."""


def existing_file(path: str | os.PathLike[str], error: type[FileError] = FileError) -> Path:
    """Return `path` if it is a readable, non-empty file.

    Raises
    ------
    FileError
        Of the type `error`, naming the file.
    """
    file = Path(path)
    try:
        if not file.exists():
            raise error(f"{file}: no such file")
        if not file.is_file():
            raise error(f"{file}: not a file")
        if not os.access(file, os.R_OK):
            raise error(f"{file}: no permission to read it")
        if file.stat().st_size == 0:
            raise error(f"{file}: the file is empty")
    except (OSError, ValueError) as reason:  # a name that is too long, or has a NUL
        raise error(f"{file}: not the name of a file ({reason})") from None
    return file


@dataclass(frozen=True)
class _Pending:
    """A file that is being written: its name, its temporary file, and the file that this one replaces."""

    name: Path
    temporary: Path
    target: Path


@dataclass
class FileSet:
    """Files that replace their targets together. `atomic_files` creates one.

    Attributes
    ----------
    written
        Targets in the order in which they were added, and files that were kept.
    """

    written: list[Path] = field(default_factory=list)
    _pending: list[_Pending] = field(default_factory=list)
    _folders: list[Path] = field(default_factory=list)

    def keep(self, path: Path) -> None:
        """Count a file as written that has the required content already."""
        self.written.append(path)

    def add(self, path: str | os.PathLike[str], *, make_folder: bool = False) -> Path:
        """Return the path of an empty temporary file that will replace `path`.

        The temporary file has the suffix of `path`, because libraries choose the format by the suffix. A
        symbolic link at `path` stays, and the file that it refers to is replaced.

        Parameters
        ----------
        path
            Target.
        make_folder
            Create the folder of the target if it does not exist.

        Raises
        ------
        OutputError
            If the folder does not exist or cannot be written, or `path` is a folder.
        """
        name = Path(path)
        try:
            target = Path(os.path.realpath(name))
            folder = target.parent
            if target.is_dir():
                raise OutputError(f"{name}: is a folder; give the name of a file")
            if make_folder:
                self._make(folder)
            if not folder.is_dir():
                raise OutputError(f"{name}: the folder {name.parent} does not exist")
            temporary = folder / _temporary_name(target.suffix)
            # The system applies the umask of the process to the permissions.
            os.close(os.open(temporary, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666))
        except OSError as error:
            raise OutputError(f"{name}: cannot write to its folder ({error.strerror})") from None
        except ValueError as error:
            raise OutputError(f"{name}: not the name of a file ({error})") from None
        self._pending.append(_Pending(name, temporary, target))
        self.written.append(name)
        return temporary

    def add_bytes(
        self, path: str | os.PathLike[str], content: bytes, *, make_folder: bool = False
    ) -> None:
        """Add a file with this content.

        Raises
        ------
        OutputError
            If the file cannot be written.
        """
        temporary = self.add(path, make_folder=make_folder)
        try:
            temporary.write_bytes(content)
        except OSError as error:
            raise OutputError(f"{path}: cannot write it ({error.strerror})") from error

    def replace_targets(self) -> None:
        """Flush all temporary files to the disk, then replace the targets in the order of `written`.

        `atomic_files` calls this method at its end; a second call does nothing.

        Raises
        ------
        OutputError
            If a file is empty or cannot be written; no target that comes later is replaced.
        """
        for pending in self._pending:
            with _writing(pending.name):
                _flush(pending.temporary, pending.name)
        for pending in self._pending:
            with _writing(pending.name):
                pending.temporary.replace(pending.target)
        self._pending.clear()
        self._folders.clear()

    def discard(self) -> None:
        """Remove the temporary files that are left, and the folders that were created for them."""
        for pending in self._pending:
            with suppress(OSError):
                pending.temporary.unlink(missing_ok=True)
        for folder in reversed(self._folders):
            with suppress(OSError):  # a folder that is not empty stays
                folder.rmdir()

    def _make(self, folder: Path) -> None:
        missing = []
        while not folder.exists():
            missing.append(folder)
            folder = folder.parent
        for path in reversed(missing):
            path.mkdir(exist_ok=True)
            self._folders.append(path)


@contextmanager
def atomic_files() -> Iterator[FileSet]:
    """Yield a set of files. On success, all of them replace their targets; otherwise none does.

    The targets are replaced when all files are complete and on the disk, in the order in which they were
    added. A document that refers to the other files is therefore added last.

    Raises
    ------
    OutputError
        If a file cannot be written.
    """
    files = FileSet()
    try:
        yield files
        files.replace_targets()
    finally:
        files.discard()


@contextmanager
def atomic_write(path: str | os.PathLike[str], files: FileSet | None = None) -> Iterator[Path]:
    """Yield a temporary path; it replaces `path` on success, else it is removed.

    Parameters
    ----------
    path
        Target.
    files
        Set of files that the file belongs to. The target is replaced together with the set, or at the end of
        the context if None.

    Raises
    ------
    OutputError
        If the folder does not exist or cannot be written, or the file cannot be written.
    """
    if files is not None:
        with _writing(path):
            yield files.add(path)
        return
    with atomic_files() as alone, _writing(path):
        yield alone.add(path)


def remove_dead_files(folders: Iterable[Path]) -> None:
    """Remove temporary files in folders that processes of this machine left when they were killed."""
    for folder in set(folders):
        with suppress(OSError):
            names = [entry.name for entry in os.scandir(folder)]
            for match in filter(None, map(TEMPORARY_NAME.fullmatch, names)):
                if match["machine"] == MACHINE and not is_running(int(match["process"])):
                    with suppress(OSError):
                        (folder / match.string).unlink()


def _temporary_name(suffix: str) -> str:
    return f"{TEMPORARY_MARK}{MACHINE}-{os.getpid()}-{os.urandom(8).hex()}{suffix}"


def _flush(temporary: Path, name: Path) -> None:
    """Flush a file to the disk, which fails if the disk is full; refuse an empty file."""
    with temporary.open("r+b") as stream:
        os.fsync(stream.fileno())
        if os.fstat(stream.fileno()).st_size == 0:
            raise OutputError(f"{name}: cannot write it (the result is empty)")


@contextmanager
def _writing(name: str | os.PathLike[str]) -> Iterator[None]:
    """Convert errors of the system into an OutputError that names the file."""
    try:
        yield
    except OSError as error:
        raise OutputError(
            f"{os.fspath(name)}: cannot write it ({error.strerror or error})"
        ) from error
