"""Option ``--limit`` of commands that read files."""

from __future__ import annotations

from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import Annotated

import typer

from .._core.limits import Limits, use_limits
from .values import parse_limits

__all__ = ["LimitOptions"]


@dataclass(frozen=True)
class LimitOptions:
    """Limits."""

    limit: Annotated[
        list[str] | None,
        typer.Option(
            help="NAME=VALUE of a limit that a file or request exceeds, such as image_pixels=600000000;"
            " repeat it for several limits. docs/limits.md lists them."
        ),
    ] = None

    def in_force(self) -> AbstractContextManager[Limits]:
        """Return a context in which the limits of the option apply.

        Raises
        ------
        ArgumentError
            If a text is not NAME=VALUE; on entry, if there is no such limit or its value is out of range.
        """
        return use_limits(**parse_limits(self.limit or ()))
