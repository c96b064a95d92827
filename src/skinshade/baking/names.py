"""Names of files in records and reports: relative to their folders, and safe to display."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

__all__ = ["is_local_name", "printable", "without_folders"]

UNSAFE = re.compile(
    "[\x00-\x1f\x7f-\x9f\u2028\u2029"  # control characters and line separators
    "\u202a-\u202e\u2066-\u2069"  # embeddings, overrides and isolates of bidirectional text
    "\ud800-\udfff\ufdd0-\ufdef\ufffe\uffff]"  # lone surrogates and noncharacters
)
"""Characters that are invisible, change the order of other characters, or cannot be written."""
REPLACEMENT = "\ufffd"


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
        # Errors of the operating system quote their file.
        for form in (str(path), repr(str(path))[1:-1])
    }
    for form in sorted(forms, key=len, reverse=True):
        start = r"(?<![\w.~-])" if Path(form).is_absolute() else r"(?<![\w.~/\\-])"
        message = re.sub(rf"{start}{re.escape(form)}[/\\]+", "", message)
        # In a replacement, a backslash starts an escape.
        name = Path(form).name.replace("\\", r"\\")
        message = re.sub(rf"{start}{re.escape(form)}(?![\w.~-])", name, message)
    return message


def printable(text: str) -> str:
    r"""Return a text with visible replacements for characters that are unsafe to display.

    Control characters and characters that reorder text become escapes. Lone surrogates, which stand for
    bytes that are not UTF-8, become U+FFFD. Every result can be written as UTF-8.

    Examples
    --------
    >>> print(printable("two\nlines \udcff"))
    two\nlines �
    """
    return UNSAFE.sub(_replacement, text)


def _replacement(match: re.Match[str]) -> str:
    character = match[0]
    is_text = not 0xD800 <= ord(character) < 0xE000
    return character.encode("unicode_escape").decode("ascii") if is_text else REPLACEMENT
