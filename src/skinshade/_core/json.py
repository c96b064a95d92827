"""Strict reader of JSON from untrusted files."""

from __future__ import annotations

import json
import math
from collections import Counter
from typing import Any

from .errors import ArgumentError

__all__ = ["parse_json"]

DEEPEST = 128
"""Greatest nesting of arrays and objects: ten times that of any exporter, and safe for recursive readers."""


def parse_json(text: str) -> Any:
    """Return the value of a JSON text.

    Raises
    ------
    ArgumentError
        If the text is not JSON, an object has a key twice, a number is not finite, or the nesting is
        deeper than `DEEPEST`.
    """
    try:
        value = json.loads(
            text, parse_constant=_no_number, parse_float=_finite, object_pairs_hook=_object
        )
    except ArgumentError:
        raise
    except (ValueError, RecursionError) as error:
        raise ArgumentError(f"not JSON ({error})") from None
    _check_depth(value)
    return value


def _no_number(name: str) -> float:
    raise ArgumentError(f"not JSON ({name} is not a JSON number)")


def _finite(text: str) -> float:
    value = float(text)
    if not math.isfinite(value):
        raise ArgumentError(f"the number {text[:40]} is too large")
    return value


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    result = dict(pairs)
    if len(result) < len(pairs):
        key, _ = Counter(key for key, _ in pairs).most_common(1)[0]
        raise ArgumentError(f"an object has the key {key[:40]!r} twice")
    return result


def _check_depth(value: Any) -> None:
    level = [value] if isinstance(value, (dict, list)) else []
    for _ in range(DEEPEST):
        children = [node.values() if isinstance(node, dict) else node for node in level]
        level = [child for group in children for child in group if isinstance(child, (dict, list))]
        if not level:
            return
    raise ArgumentError(f"it nests deeper than {DEEPEST} levels")
