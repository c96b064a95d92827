"""Fields that know their unit, range and meaning, and the check that uses them."""

from __future__ import annotations

from dataclasses import Field, dataclass, field, fields
from typing import Any

import numpy as np

from .._core.errors import ArgumentError

__all__ = ["Meaning", "checked_fields", "meaning", "number"]


@dataclass(frozen=True)
class Meaning:
    """What a parameter is.

    Attributes
    ----------
    unit
        ``1`` where it has none.
    low, high
        Closed range.
    about
        One sentence.
    source
        Key in ``REFERENCES.bib``, where the default has one.
    """

    unit: str
    low: float
    high: float
    about: str
    source: str = ""


def number(default: Any, unit: str, low: float, high: float, about: str, source: str = "") -> Any:
    """Return a dataclass field with its `Meaning`."""
    return field(default=default, metadata={"meaning": Meaning(unit, low, high, about, source)})


def meaning(of: Field[Any]) -> Meaning:
    """Return the `Meaning` of a field made by `number`."""
    result: Meaning = of.metadata["meaning"]
    return result


def checked_fields(instance: Any) -> None:
    """Raise if any field of a dataclass lies outside its range.

    Raises
    ------
    ArgumentError
        Naming the field, its value and its range with the unit.
    """
    for of in fields(instance):
        m, value = meaning(of), getattr(instance, of.name)
        array = np.asarray(value, dtype=np.float64)
        if not np.isfinite(array).all() or (array < m.low).any() or (array > m.high).any():
            unit = "" if m.unit == "1" else f" {m.unit}"
            raise ArgumentError(
                f"{of.name} is {value}; it must lie in [{m.low:g}, {m.high:g}]{unit}"
            )
