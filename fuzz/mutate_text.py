"""Mutations of formats of lines and words: OBJ, ASCII PLY and STL, and headers."""

from __future__ import annotations

import re
from collections.abc import Sequence
from random import Random

__all__ = ["mutate_text"]

TOKENS = tuple(
    word.encode()
    for word in (
        "nan", "-nan", "inf", "1e999", "-1e308", "1e308", "1e-320", "1e-45", "0", "-0", "+0",
        "00", "-1", "1", "2", "4", "5", "-5", "255", "256", "65536", "2147483647", "2147483648",
        "-2147483649", "4294967296", "9223372036854775808", "99999999999999999999999", "1" * 500,
        "1_0", "0x10", "1,5", "1.5", "1.", ".5", "1e", "+1", "1-1", "\u0661", "1/2/3", "1//",
        "//1", "/", "1/0", "1/-1/1", "1/1/1/1", "-", "#", "\\", '"', "a", "f", "v", "vt", "vn",
        "end_header", "element", "property", "list", "uchar", "int64", "double", "facet",
        "vertex", "endsolid", "solid", "\x00", "\x1b[2J", "\u2028", "x" * 3000, "é",
    )
)  # fmt: skip
"""Words that take the position of a word."""
LINES = (
    b"", b"f 1 1 1", b"f 1 2 3 4", b"f -1 -2 -3", b"f 0 1 2", b"v 0 0 0", b"v 1e39 0 0",
    b"v 1e15 1e15 -1e15", b"vn 0 0 0", b"vt 1e300 0", b"g " + b"x" * 5000,
    b"mtllib ../secret.png", b"usemtl \xff\xfe", b"# " + b"#" * 5000, b"f" + b" 1 2 3" * 500,
    b"call ../secret.png", b"element vertex 4294967295", b"element face 99999999999",
    b"property list uint double z", b"comment unit_mm nan", b"# unit_mm 1e400", b"obj_info x",
    b"3 0 1 2",
)  # fmt: skip
"""Lines that are inserted."""
LINE_ENDS = (
    b"\n",
    b"\r\n",
    b"\r",
    b"\n\r",
    b"\n\n",
    b" \n",
    b"\x0b",
    b"\x0c",
    b"\\\n",
    b"\xe2\x80\xa8",
)
MARKS = (b"\xef\xbb\xbf", b"\xff\xfe", b"\n", b" ", b"\x1f\x8b", b"\0")
"""Bytes before the first line."""
WORD = re.compile(rb"[^\s]+")
LONGEST_SEARCH = 1 << 14
"""Bytes from the start in which words are replaced: later words are much like them."""


def mutate_text(data: bytes, random: Random, seeds: Sequence[bytes]) -> bytes:
    """Return a file with a change of a word, a line, its line ends or its first bytes."""
    kind = random.randrange(10)
    if kind <= 4:
        return _with_other_word(data, random)
    if kind == 5:
        return data.replace(b"\n", random.choice(LINE_ENDS))
    if kind == 6:
        return random.choice(MARKS) + data
    if kind == 7:
        return data.replace(
            b" ",
            random.choice((b"\t", b"  ", b"\xc2\xa0", b" +", b" -", b"")),
            random.choice((1, -1)),
        )
    lines = data.split(b"\n")
    row = random.randrange(len(lines))
    other = random.choice(random.choice(seeds).split(b"\n"))
    if kind == 8:
        lines[row:row] = [random.choice((*LINES, lines[row], other))]
    else:
        swap = random.randrange(len(lines))
        lines[row], lines[swap] = (
            lines[swap],
            random.choice((lines[row], b"", lines[row][: len(lines[row]) // 2])),
        )
    return b"\n".join(lines)


def _with_other_word(data: bytes, random: Random) -> bytes:
    words = list(WORD.finditer(data, 0, LONGEST_SEARCH))
    if not words:
        return random.choice(TOKENS)
    match = random.choice(words)
    word = random.choice(
        (random.choice(TOKENS), random.choice(words)[0], match[0] + random.choice(TOKENS))
    )
    if re.fullmatch(rb"-?[0-9]{1,8}", match[0]) and random.random() < 0.4:
        word = str(int(match[0]) + random.choice((1, -1, 2, 1000))).encode()
    return data[: match.start()] + word + data[match.end() :]
