"""Dataclass fields with unit, range and meaning, and a check of the ranges."""

from __future__ import annotations

from dataclasses import Field, dataclass, field, fields
from typing import Any

from .._core.errors import ArgumentError

__all__ = ["Meaning", "checked_fields", "meaning", "number"]


@dataclass(frozen=True)
class Meaning:
    """Unit, range, description and source of a parameter.

    Attributes
    ----------
    unit
        Unit; ``1`` if the parameter has none.
    low, high
        Ends of the closed range.
    about
        Description in one sentence.
    source
        Key in ``REFERENCES.bib`` of the source of the default; empty if there is none.
    """

    unit: str
    low: float
    high: float
    about: str
    source: str = ""


def number(default: Any, unit: str, low: float, high: float, about: str, source: str = "") -> Any:
    """Return a dataclass field with its `Meaning`."""
    return field(default=default, metadata={"meaning": Meaning(unit, low, high, about, source)})


def meaning(field: Field[Any]) -> Meaning:
    """Return the `Meaning` of a field made by `number`.

    Examples
    --------
    >>> from dataclasses import fields
    >>> import skinshade as sk
    >>> from skinshade.params.fields import meaning
    >>> gloss = next(field for field in fields(sk.SkinParams) if field.name == "gloss")
    >>> meaning(gloss).low, meaning(gloss).high, meaning(gloss).source
    (0.0, 1.0, 'Lagarde2011')
    """
    result: Meaning = field.metadata["meaning"]
    return result


def checked_fields(instance: Any) -> None:
    """Check that every field of a dataclass lies in its range.

    Raises
    ------
    ArgumentError
        If a field lies outside; the message gives the field, its value, its range and its unit.
    """
    import numpy as np  # costs .2 s, and the help of the program only reads the ranges

    for parameter in fields(instance):
        m, value = meaning(parameter), getattr(instance, parameter.name)
        array = np.asarray(value, dtype=np.float64)
        if not np.isfinite(array).all() or (array < m.low).any() or (array > m.high).any():
            unit = "" if m.unit == "1" else f" {m.unit}"
            raise ArgumentError(
                f"{parameter.name} is {value}; it must lie in [{m.low:g}, {m.high:g}]{unit}"
            )
