"""Names of files in records and reports, relative to their folders."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

from .._core.text import printable

__all__ = ["is_local_name", "without_folders"]


def is_local_name(name: str) -> bool:
    """Return whether a name is relative and has no part ``..``.

    Examples
    --------
    >>> [is_local_name(name) for name in ("shelf/a.glb", "/a.glb", "../a.glb", "")]
    [True, False, False, False]
    """
    path = Path(name)
    return bool(path.parts) and not path.anchor and ".." not in path.parts


def without_folders(message: str, folders: Iterable[Path]) -> str:
    """Return a message in which the paths below some folders are relative to them.

    A folder itself becomes its own name. Paths elsewhere in the message do not change.

    Parameters
    ----------
    message
        Error message.
    folders
        Folders, in the form in which messages may name them or relative to the current folder.

    Examples
    --------
    >>> without_folders("/models/a.glb: cut short; see /models", [Path("/models")])
    'a.glb: cut short; see models'
    """
    forms = {
        form
        for folder in folders
        for path in (folder, folder.resolve())
        if path.name not in ("", "..")
        # Errors of the operating system quote their file; other errors replace unsafe characters.
        for form in (str(path), repr(str(path))[1:-1], printable(str(path)))
    }
    for form in sorted(forms, key=len, reverse=True):
        start = r"(?<![\w.~-])" if Path(form).is_absolute() else r"(?<![\w.~/\\-])"
        message = re.sub(rf"{start}{re.escape(form)}[/\\]+", "", message)
        # In a replacement, a backslash starts an escape.
        name = Path(form).name.replace("\\", r"\\")
        message = re.sub(rf"{start}{re.escape(form)}(?![\w.~-])", name, message)
    return message
