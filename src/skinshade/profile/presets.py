"""Named profiles from ``presets.json``, which states the source, kind and unit of every entry."""

from __future__ import annotations

import json
from functools import cache
from importlib.resources import files
from typing import Any

from .._core.errors import ArgumentError

__all__ = ["preset_record", "presets"]


@cache
def _records() -> dict[str, dict[str, Any]]:
    text = files(__package__).joinpath("presets.json").read_text(encoding="utf-8")
    records: dict[str, dict[str, Any]] = json.loads(text)
    return records


def presets() -> list[str]:
    """Return the names of the profiles that skinshade contains, the default first.

    Examples
    --------
    >>> import skinshade as sk
    >>> sk.presets()[0]
    'skin-deon2007'
    """
    return list(_records())


def preset_record(name: str) -> dict[str, Any]:
    """Return the entry of a preset in the file.

    Raises
    ------
    ArgumentError
        If there is no preset of this name.
    """
    try:
        return _records()[name]
    except KeyError:
        raise ArgumentError(
            f"there is no profile {name!r}; there are {', '.join(presets())}"
        ) from None
