"""How long work tells that it goes on: a callable, so that no layer knows the terminal."""

from __future__ import annotations

from typing import Protocol

__all__ = ["Progress", "silent"]


class Progress(Protocol):
    """Called with what is being done and the fraction of it that is done (0..1)."""

    def __call__(self, what: str, fraction: float) -> None:
        """Report."""


def silent(what: str, fraction: float) -> None:
    """Report nothing."""
