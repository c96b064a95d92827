"""Dataclass fields with unit, range and meaning, and a check of the ranges."""

from __future__ import annotations

from dataclasses import Field, dataclass, field, fields
from typing import Any, TypeVar

from .._core.choice import Choice
from .._core.errors import ArgumentError

__all__ = [
    "ChoiceMeaning",
    "Meaning",
    "checked_fields",
    "choice",
    "choice_fields",
    "meaning",
    "number",
    "number_fields",
]

C = TypeVar("C", bound=Choice)


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


@dataclass(frozen=True)
class ChoiceMeaning:
    """Enumeration and description of a parameter that is not a number.

    Attributes
    ----------
    kind
        Enumeration of the allowed values.
    about
        Description in one sentence.
    """

    kind: type[Choice]
    about: str


def number(default: Any, unit: str, low: float, high: float, about: str, source: str = "") -> Any:
    """Return a dataclass field with its `Meaning`."""
    return field(default=default, metadata={"meaning": Meaning(unit, low, high, about, source)})


def choice(default: Any, kind: type[C], about: str) -> Any:
    """Return a dataclass field of an enumeration, with its `ChoiceMeaning`.

    The field also accepts the text of a member, and None if this is its default.
    """
    return field(default=default, metadata={"choice": ChoiceMeaning(kind, about)})


def number_fields(block: Any) -> list[Field[Any]]:
    """Return the fields of a dataclass or its instance that hold numbers: those of its constant block."""
    return [parameter for parameter in fields(block) if "meaning" in parameter.metadata]


def choice_fields(block: Any) -> list[Field[Any]]:
    """Return the fields of a dataclass or its instance that hold members of enumerations."""
    return [parameter for parameter in fields(block) if "choice" in parameter.metadata]


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
    """Check that every number of a dataclass lies in its range, and turn texts into members.

    Raises
    ------
    ArgumentError
        If a field lies outside; the message gives the field, its value, its range and its unit. If no
        member of an enumeration has a text; the message gives all members.
    """
    import numpy as np  # costs .2 s, and the help of the program only reads the ranges

    for parameter in choice_fields(instance):
        value = getattr(instance, parameter.name)
        if value is not None or parameter.default is not None:
            member = parameter.metadata["choice"].kind.of(value, parameter.name)
            object.__setattr__(instance, parameter.name, member)
    for parameter in number_fields(instance):
        m, value = meaning(parameter), getattr(instance, parameter.name)
        array = np.asarray(value, dtype=np.float64)
        if not np.isfinite(array).all() or (array < m.low).any() or (array > m.high).any():
            unit = "" if m.unit == "1" else f" {m.unit}"
            raise ArgumentError(
                f"{parameter.name} is {value}; it must lie in [{m.low:g}, {m.high:g}]{unit}"
            )
