"""Reading and writing files so that a failure names the file and loses nothing."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from .errors import FileError, OutputError

__all__ = ["atomic_write", "existing_file"]


def existing_file(path: str | os.PathLike[str], error: type[FileError] = FileError) -> Path:
    """Return `path` if it is a readable, non-empty file.

    Raises
    ------
    FileError
        Of the type given, naming the file.
    """
    file = Path(path)
    if not file.exists():
        raise error(f"{file}: no such file")
    if not file.is_file():
        raise error(f"{file}: not a file")
    if not os.access(file, os.R_OK):
        raise error(f"{file}: no permission to read it")
    if file.stat().st_size == 0:
        raise error(f"{file}: the file is empty")
    return file


@contextmanager
def atomic_write(path: str | os.PathLike[str]) -> Iterator[Path]:
    """Yield a temporary path in the same folder; on success it replaces `path`, else it is removed.

    The temporary file keeps the suffix, for libraries that choose a format by it.

    Raises
    ------
    OutputError
        If the folder does not exist or cannot be written.
    """
    target = Path(path)
    folder = target.parent
    if target.is_dir():
        raise OutputError(f"{target}: is a folder; name a file")
    if not folder.is_dir():
        raise OutputError(f"{target}: there is no folder {folder}")
    try:
        handle, name = tempfile.mkstemp(prefix=f".{target.stem}-", suffix=target.suffix, dir=folder)
    except OSError as error:
        raise OutputError(f"{target}: cannot write here ({error.strerror})") from None
    os.close(handle)
    temporary = Path(name)
    try:
        yield temporary
        umask = os.umask(0)
        os.umask(umask)
        temporary.chmod(0o666 & ~umask)
        temporary.replace(target)
    except OSError as error:
        raise OutputError(f"{target}: cannot write it ({error.strerror})") from error
    finally:
        temporary.unlink(missing_ok=True)
