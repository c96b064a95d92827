"""Text of mesh files: line ends, comments, lines and words."""

from __future__ import annotations

import re
from array import array
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from .._core.arrays import IntArray
from .._core.errors import MeshFileError
from .decimals import Bytes, Flags, floats

__all__ = ["BYTE_ORDER_MARK", "Lines", "PlainText", "is_space"]

PIECE = 1 << 20
"""Bytes of a piece of text: its arrays take little memory beside the file, and NumPy's calls little time."""
LONGEST_EXCERPT = 60
"""Characters of a line that an error message repeats."""
BYTE_ORDER_MARK = b"\xef\xbb\xbf"
UTF_16_MARKS = (b"\xff\xfe", b"\xfe\xff")
CONTINUATION = re.compile(rb"\\[ \t]*\n")


@dataclass(frozen=True)
class PlainText:
    """Text of a file, whose lines end with LF.

    Attributes
    ----------
    file
        Name of the file, for error messages.
    data
        The text in ASCII or UTF-8. Other line ends and a byte-order mark are replaced by as many bytes.
    joined
        Offsets of line ends that were replaced by a space, increasing.
    """

    file: Path
    data: bytes
    joined: IntArray = field(default_factory=lambda: np.zeros(0, dtype=np.int64))

    @classmethod
    def of(cls, file: Path, content: bytes) -> PlainText:
        """Return the text of a file's content.

        Raises
        ------
        MeshFileError
            If the text has the mark of UTF-16, but is not.
        """
        if content.startswith(UTF_16_MARKS):
            try:
                content = content.decode("utf-16").encode()
            except UnicodeDecodeError as error:
                raise MeshFileError(f"{file}: cannot be read as UTF-16 ({error.reason})") from None
        if content.startswith(BYTE_ORDER_MARK):
            content = b"   " + content[3:]
        if b"\r" in content:
            content = content.replace(b"\r\n", b" \n").replace(b"\r", b"\n")
        return cls(file, content)

    def with_lines_joined(self) -> PlainText:
        """Return the text with spaces for a backslash at the end of a line and for that line end.

        A backslash in a comment, which begins with ``#``, does not continue the line.
        """
        if not any(mark in self.data for mark in (b"\\\n", b"\\ ", b"\\\t")):
            return self
        data, joined, done = bytearray(), array("q"), 0
        for match in CONTINUATION.finditer(self.data):
            line = self.data.rfind(b"\n", 0, match.start()) + 1
            if self.data.find(b"#", line, match.start()) < 0:
                data += self.data[done : match.start()] + b" " * len(match[0])
                done = match.end()
                joined.append(done - 1)
        return replace(self, data=bytes(data + self.data[done:]), joined=np.array(joined))

    def pieces(self, start: int = 0, *, comments: bool = False) -> Iterator[Lines]:
        """Yield the lines of every piece of the text from an offset on; a piece ends with a line.

        Parameters
        ----------
        start
            The offset.
        comments
            Whether ``#`` begins a comment, which is replaced by spaces.
        """
        size = len(self.data)
        while start < size:
            stop = size
            if start + PIECE < size:
                stop = self.data.find(b"\n", start + PIECE) + 1 or size
            piece = self.data[start:stop]
            yield Lines.of(_without_comments(piece) if comments and b"#" in piece else piece, start)
            start = stop

    def at_line(self, offset: int, message: str) -> str:
        """Return an error message: the file, the number of the line at an offset, and what is wrong."""
        number = 1 + self.data.count(b"\n", 0, offset) + int(np.searchsorted(self.joined, offset))
        return f"{self.file}: line {number} {message}"

    def word(self, offset: int) -> str:
        """Return the word that begins at an offset, quoted, for an error message."""
        words = self.data[offset : offset + 2 * LONGEST_EXCERPT].split(maxsplit=1)
        return _excerpt(words[0] if words else b"")

    def no_number(self, lines: Lines, words: Flags) -> str:
        """Return the error message for the first of some words that is no number.

        Parameters
        ----------
        lines
            Lines of a piece.
        words
            (W,) which words should be numbers; at least one is not.
        """
        chosen = np.flatnonzero(words)
        low, high = 0, chosen.size - 1
        while low < high:  # the first of chosen[low : high + 1] that is no number
            middle = (low + high) // 2
            part = chosen[low : middle + 1]
            if floats(lines.characters, lines.words[part], lines.word_ends[part]) is None:
                high = middle
            else:
                low = middle + 1
        line = int(np.searchsorted(lines.first, chosen[low], side="right")) - 1
        text = bytes(lines.characters[lines.starts[line] : lines.stops[line]])
        offset = lines.offset + int(lines.words[chosen[low]])
        return self.at_line(offset, f"cannot be read as numbers: {_excerpt(text)}")


@dataclass(frozen=True)
class Lines:
    """Lines and words of a piece of text. Words are separated by white space.

    Attributes
    ----------
    offset
        Offset of the piece in the text.
    characters
        (n,) of the piece; the last one is LF.
    starts, stops
        (L,) offsets of the lines' first characters, and past their line ends.
    words, word_ends
        (W,) offsets of the words' first characters, and past their last ones.
    first
        (L + 1,) index of the first word of every line.
    """

    offset: int
    characters: Bytes
    starts: IntArray
    stops: IntArray
    words: IntArray
    word_ends: IntArray
    first: IntArray

    @classmethod
    def of(cls, piece: bytes, offset: int) -> Lines:
        """Return the lines of a piece of text."""
        if not piece.endswith(b"\n"):
            piece += b"\n"
        characters = np.frombuffer(piece, dtype=np.uint8)
        space = is_space(characters)
        changes = np.flatnonzero(space[1:] != space[:-1]) + 1
        if not space[0]:
            changes = np.concatenate([[0], changes])
        words, word_ends = changes[0::2].copy(), changes[1::2].copy()
        stops = np.flatnonzero(characters == ord("\n")) + 1
        starts = np.concatenate([[0], stops[:-1]])
        first = np.append(np.searchsorted(words, starts), words.size)
        return cls(offset, characters, starts, stops, words, word_ends, first)

    @property
    def word_counts(self) -> IntArray:
        """(L,) number of words of every line."""
        return np.diff(self.first)

    def words_after_first(self, chosen: IntArray) -> Flags:
        """Return which words (W,) are on the chosen lines (indices) and are not the first of their line."""
        on_line = np.zeros(self.starts.size, dtype=bool)
        on_line[chosen] = True
        which = np.repeat(on_line, self.word_counts)
        which[self.first[chosen]] = False
        return which


def _without_comments(piece: bytes) -> bytes:
    """Return a piece of text with spaces from every ``#`` to the end of its line."""
    characters = np.frombuffer(piece, dtype=np.uint8).copy()
    marks = np.flatnonzero(characters == ord("#"))
    stops = np.append(np.flatnonzero(characters == ord("\n")), characters.size)
    line = np.searchsorted(stops, marks)
    first = np.append(True, line[1:] != line[:-1])  # of its line
    steps = np.zeros(characters.size + 1, dtype=np.int8)
    steps[marks[first]] = 1
    steps[stops[line[first]]] = -1
    characters[np.cumsum(steps[:-1], dtype=np.int8).view(np.bool_)] = ord(" ")
    return characters.tobytes()


def is_space(characters: Bytes) -> Flags:
    """Return whether each character is white space, as `bytes.split` defines it."""
    return (characters == ord(" ")) | (characters - np.uint8(9) < 5)  # tab, LF, VT, FF, CR


def _excerpt(text: bytes) -> str:
    """Return a text in quotes for an error message, cut if it is long."""
    line = text.decode("utf-8", "replace").strip()
    return repr(line if len(line) <= LONGEST_EXCERPT else line[: LONGEST_EXCERPT - 1] + "…")
