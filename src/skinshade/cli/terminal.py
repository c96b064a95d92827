"""Output of the program: one function that prints, and streams that accept every text."""

from __future__ import annotations

import os
import sys
from io import TextIOWrapper
from typing import TextIO

from .._core.errors import OutputError

__all__ = ["drop_unwritable", "echo", "prepare_streams", "printable"]


def prepare_streams() -> None:
    """Let both streams write characters that their encoding lacks as escapes, and open closed streams.

    Otherwise the next file would get the number of a closed stream, and messages would be written into it.
    """
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # returns the lowest number that is free
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")


def drop_unwritable() -> None:
    """Drop what cannot be written to a full disk or a closed pipe; the interpreter would try it once more."""
    for stream in (sys.stdout, sys.stderr):
        try:
            if stream is not None:
                stream.flush()
        except OSError:
            _discard(stream)


def printable(text: str) -> str:
    r"""Return a text with escapes for all characters that are not printable, such as ``\n``.

    File names and names of meshes can contain control codes of terminals, and bytes that are not UTF-8.

    Examples
    --------
    >>> from skinshade.cli.terminal import printable
    >>> print(printable("head\x1b[31m\r\udcff ä"))
    head\x1b[31m\r\udcff ä
    """
    if text.isprintable():
        return text
    return "".join(
        character if character.isprintable() else character.encode("unicode_escape").decode()
        for character in text
    )


def echo(message: object, *, err: bool = False) -> None:
    """Print a message of one or more `printable` lines, on standard output or standard error.

    If the reader of a pipe has ended, the program ends, too, with exit code 1.

    Raises
    ------
    OutputError
        If standard output cannot be written, for example because a disk is full.
    """
    stream = sys.stderr if err else sys.stdout
    if stream is None:  # closed before the start
        return
    try:
        stream.write("".join(f"{printable(line)}\n" for line in str(message).split("\n")))
        stream.flush()
    except OSError as error:
        _discard(stream)
        if err:
            return
        if isinstance(error, BrokenPipeError):
            sys.exit(1)
        raise OutputError(f"standard output: cannot be written ({error.strerror})") from None


def _discard(stream: TextIO) -> None:
    """Drop what a stream has buffered and what it gets from now on."""
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, stream.fileno())
    os.close(null)
