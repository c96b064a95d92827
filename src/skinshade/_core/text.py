"""Texts from files, made safe and short enough to display."""

from __future__ import annotations

import re

__all__ = ["printable", "shortened"]

UNSAFE = re.compile(
    "[\x00-\x1f\x7f-\x9f\u2028\u2029"  # control characters and line separators
    "\u202a-\u202e\u2066-\u2069"  # embeddings, overrides and isolates of bidirectional text
    "\ud800-\udfff\ufdd0-\ufdef\ufffe\uffff]"  # lone surrogates and noncharacters
)
"""Characters that are invisible, change the order of other characters, or cannot be written."""
REPLACEMENT = "\ufffd"
ELLIPSIS = " … "


def printable(text: str, keep: str = "") -> str:
    r"""Return a text with visible replacements for characters that are unsafe to display.

    Control characters and characters that reorder text become escapes. Lone surrogates, which stand for
    bytes that are not UTF-8, become U+FFFD. Every result can be written as UTF-8.

    Parameters
    ----------
    text
        Any text.
    keep
        Characters that stay, such as line breaks.

    Examples
    --------
    >>> print(printable("two\nlines \udcff"))
    two\nlines �
    """
    return UNSAFE.sub(lambda match: match[0] if match[0] in keep else _replacement(match), text)


def _replacement(match: re.Match[str]) -> str:
    character = match[0]
    is_text = not 0xD800 <= ord(character) < 0xE000
    return character.encode("unicode_escape").decode("ascii") if is_text else REPLACEMENT


def shortened(text: str, longest: int) -> str:
    """Return a text without its middle part if it has more than `longest` characters.

    The end of an error message often says what to do; it keeps a third of the characters.

    Examples
    --------
    >>> shortened("0123456789abcdefgh", 12)
    '012345 … fgh'
    """
    if len(text) <= longest:
        return text
    end = longest // 3 - 1
    return f"{text[: longest - end - len(ELLIPSIS)]}{ELLIPSIS}{text[-end:]}"
