"""Checks before reading files, and atomic writes."""

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


@contextmanager
def atomic_write(path: str | os.PathLike[str]) -> Iterator[Path]:
    """Yield a temporary path in the same folder; it replaces `path` on success, else it is removed.

    The temporary file has the suffix of `path`, because libraries choose the format by the suffix.

    Raises
    ------
    OutputError
        If the folder does not exist or cannot be written.
    """
    target = Path(path)
    folder = target.parent
    try:
        if target.is_dir():
            raise OutputError(f"{target}: is a folder; give the name of a file")
        if not folder.is_dir():
            raise OutputError(f"{target}: the folder {folder} does not exist")
        handle, name = tempfile.mkstemp(prefix=f".{target.stem}-", suffix=target.suffix, dir=folder)
    except OSError as error:
        raise OutputError(f"{target}: cannot write to its folder ({error.strerror})") from None
    except ValueError as error:
        raise OutputError(f"{target}: not the name of a file ({error})") from None
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
