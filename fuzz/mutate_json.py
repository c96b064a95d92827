"""Mutations of JSON: values, keys, entries and numbers, and forms that only a text can have."""

from __future__ import annotations

import copy
import json
from collections.abc import Sequence
from random import Random
from typing import Any

__all__ = ["json_span", "mutate_json_bytes", "mutate_json_text"]

TOKENS = (
    "NaN", "Infinity", "-Infinity", "1e308", "-1e308", "1e309", "1e-320", "-0", "-0.0", "1e5",
    "1.0", "007", "0x10", "1" * 400, "1" * 5000, "true", "null", "[", "}", "",
    "[" * 100 + "]" * 100, "[" * 127 + "]" * 127, "[" * 1000 + "]" * 1000, "[" * 50_000,
    '{"a":' * 126 + "0" + "}" * 126, '{"a":1,"a":2}', '"\\ud800"', '"\\u0000"',
    '"\\udfff\\ud800x"', '"\\u001b[31mred"', '"\\u202etxt"', '"\n"', "'a'",
)  # fmt: skip
"""Texts that take the position of a value."""
VALUES: tuple[Any, ...] = (
    None, True, False, 0, 1, -1, 2, 3, 4, 7, 11, 12, 13, 255, 256, 65535, 65536, 2**31 - 1, 2**31,
    2**32, 2**53, 2**63, 2**64, -(2**63), 10**30, 0.5, 1.5, 1e-300, 1e15, 1e16, 1e38, 1e39, -1e30,
    5120, 5121, 5122, 5123, 5125, 5126, 34962, "", "0", " ", "SCALAR", "VEC2", "VEC3", "VEC4",
    "MAT4", "MAT2", "MASK", "BLEND", "2.0", "../secret.png", "..%2Fsecret.bin",
    "a/../../secret.png", "/dev/zero", "texture.png", "buffer.bin", ".",
    "https://localhost/x.png", "file:///etc/hostname", "data:;base64,AAAA", "data:,x", "a%00b",
    "x" * 300, "y" * 3000, "é☃" * 50, "z" * 100_000, "<script>alert(1)</script>",
    "' onerror=alert(1) x='", "*", "[a", "\n", [], {}, [[]], [0], [0, 0], [0, 0, 0], [1e308] * 3,
    [None] * 4, [1] * 16, {"a": {}}, {"": 0}, {"index": 0},
)  # fmt: skip
"""Values that take the position of a value."""
DEEPEST = 64
"""Nesting at which the search for entries stops: mutations of a deep value must not exhaust the stack."""


def mutate_json_bytes(data: bytes, random: Random, seeds: Sequence[bytes]) -> bytes:
    """Return a JSON file with one change; a file that is not JSON gets a change of one character."""
    texts = [seed.decode("utf-8", "replace") for seed in random.choices(seeds, k=1)]
    text = mutate_json_text(data.decode("utf-8", "surrogateescape"), random, texts)
    if random.random() < 0.02:
        text = random.choice(("\ufeff", "\n", "//\n", "\x1f\x8b")) + text
    if random.random() < 0.01:
        return text.encode(random.choice(("utf-16", "utf-32-le", "utf-8")), "ignore")
    return text.encode("utf-8", "surrogateescape")


def mutate_json_text(text: str, random: Random, others: Sequence[str]) -> str:
    """Return a JSON text with one change.

    Parameters
    ----------
    text
        JSON; any other text gets a change of one character.
    random
        Source of all choices.
    others
        Texts from which entries are taken.
    """
    try:
        document = json.loads(text)
    except (ValueError, RecursionError):
        return _with_other_character(text, random)
    entries = _entries(document)
    if not entries:
        return json.dumps(random.choice(VALUES))
    container, key = random.choice(entries)
    kind = random.randrange(12)
    token = ""
    if kind <= 2:
        container[key] = copy.deepcopy(random.choice(VALUES))
    elif kind == 3:
        container[key], token = MARK, random.choice(TOKENS)
    elif kind == 4:
        container[key] = _nudged(container[key], random)
    elif kind == 5:
        del container[key]
    elif kind == 6:
        _duplicate(container, key, random)
    elif kind == 7:
        other, name = random.choice(entries)
        container[key], other[name] = copy.deepcopy(other[name]), copy.deepcopy(container[key])
    elif kind == 8:
        container[key] = random.choice(
            ([container[key]], {"a": container[key]}, str(container[key]))
        )
    elif kind == 9 and isinstance(container, dict):
        name = random.choice(
            ("", "\ud800", "__class__", "extras", "A" * 300, "\x1b[2J", random.choice(entries)[1])
        )
        container[str(name)] = container.pop(key)
    elif kind == 10:
        _graft(container, key, random, others)
    else:
        _number_in(document, random)
    written = json.dumps(document)
    return written.replace(json.dumps(MARK), token) if kind == 3 else written


MARK = "\ue000token\ue000"
"""Text that marks the position of a token, and which no file contains."""


def json_span(data: bytes) -> tuple[int, int] | None:
    """Return the start and end of the first JSON object inside other bytes, or None."""
    start = data.find(b'{"')
    if start < 0:
        return None
    try:
        _, length = json.JSONDecoder().raw_decode(data[start:].decode("latin-1"))
    except (ValueError, RecursionError):
        return None
    return start, start + length


def _entries(document: Any) -> list[tuple[Any, Any]]:
    """Return every container of a document with each of its keys."""
    pairs: list[tuple[Any, Any]] = []
    level = [document]
    for _ in range(DEEPEST):
        inner: list[Any] = []
        for container in level:
            if isinstance(container, dict):
                pairs += [(container, key) for key in container]
                inner += container.values()
            elif isinstance(container, list):
                pairs += [(container, index) for index in range(len(container))]
                inner += container
        level = inner
    return pairs


def _nudged(value: Any, random: Random) -> Any:
    """Return a value near another: indices off by one, lists and texts of another length."""
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        number: Any = random.choice((1, -1, 1, -1, 2, 3, -2, 0.5, 65535))
        return (
            value + number
            if random.random() < 0.7
            else value * random.choice((-1, 2, 1000, 10**6, 0.1))
        )
    if isinstance(value, str):
        return random.choice((value + "x", value[:-1], value.upper(), value * 2, value[::-1]))
    if isinstance(value, list):
        return random.choice((value[:-1], value + value[-1:], value[::-1], value[1:], value * 3))
    return value


def _number_in(document: Any, random: Random) -> None:
    """Change one number of a document."""
    entries = [(c, k) for c, k in _entries(document) if isinstance(c[k], (int, float))]
    if entries:
        container, key = random.choice(entries)
        container[key] = _nudged(container[key], random)


def _duplicate(container: Any, key: Any, random: Random) -> None:
    if isinstance(container, list):
        container[key:key] = [
            copy.deepcopy(container[key]) for _ in range(random.choice((1, 1, 2, 40)))
        ]
    else:
        container[f"{key}{random.randrange(2)}"] = copy.deepcopy(container[key])


def _graft(container: Any, key: Any, random: Random, others: Sequence[str]) -> None:
    """Add an entry of another document."""
    try:
        entries = _entries(json.loads(random.choice(others)))
    except (ValueError, RecursionError):
        return
    if not entries:
        return
    source, name = random.choice(entries)
    if isinstance(container, dict):
        container[name if isinstance(name, str) else key] = source[name]
    else:
        container[key] = source[name]


def _with_other_character(text: str, random: Random) -> str:
    if not text:
        return "{}"
    position = random.randrange(len(text))
    return (
        text[:position] + random.choice(("", '"', "{", "]", ",", "0", "\\")) + text[position + 1 :]
    )
