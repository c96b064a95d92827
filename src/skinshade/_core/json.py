"""Strict reader of JSON from untrusted files."""

from __future__ import annotations

import json
import math
import sys
from collections import Counter
from typing import Any

from .errors import ArgumentError
from .limits import check_limit, limit_advice, limits

__all__ = ["parse_json"]


def parse_json(text: str) -> Any:
    """Return the value of a JSON text.

    Raises
    ------
    ArgumentError
        If the text is not JSON, an object has a key twice, a number is not finite, or the text is beyond
        the limits `json_bytes`, `json_values` or `json_depth`.
    """
    check_limit("json_bytes", len(text), "its JSON")
    check_limit("json_values", sum(map(text.count, ",[{")), "its JSON")
    try:
        value = json.loads(
            text, parse_constant=_no_number, parse_float=_finite, object_pairs_hook=_object
        )
    except ArgumentError:
        raise
    except RecursionError:
        advice = limit_advice("json_depth", sys.getrecursionlimit())
        raise ArgumentError(f"it nests too deep to be read; {advice}") from None
    except ValueError as error:
        # For a number of thousands of digits, the message goes on with advice for programmers.
        reason = str(error).partition("; use ")[0]
        raise ArgumentError(f"not JSON ({reason})") from None
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
    depth, level = 0, [value]
    while level := [inner for inner in level if isinstance(inner, (dict, list))]:
        depth += 1
        groups = [node.values() if isinstance(node, dict) else node for node in level]
        level = [child for group in groups for child in group]
    if depth > limits().json_depth:
        raise ArgumentError(f"it nests {depth} levels deep; {limit_advice('json_depth', depth)}")
