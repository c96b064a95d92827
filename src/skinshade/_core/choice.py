"""Arguments with a small set of named values."""

from __future__ import annotations

from enum import StrEnum
from typing import Self

from .errors import ArgumentError

__all__ = ["Choice"]


class Choice(StrEnum):
    """One of several named values; equal to its text."""

    @classmethod
    def of(cls, value: str, name: str) -> Self:
        """Return the member that a text names.

        Parameters
        ----------
        value
            Text of a member, or a member.
        name
            Name of the argument, for the error message.

        Raises
        ------
        ArgumentError
            If no member has this text.
        """
        try:
            return cls(value)
        except ValueError:
            allowed = ", ".join(member.value for member in cls)
            raise ArgumentError(f"{name} is {value!r}; it must be one of {allowed}") from None

    @property
    def number(self) -> int:
        """Number of the member in shaders: its position in the enumeration."""
        return list(type(self)).index(self)
