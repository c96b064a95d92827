"""Progress callbacks for long operations."""

from __future__ import annotations

from typing import Protocol

__all__ = ["Progress", "silent"]


class Progress(Protocol):
    """Called with the name of the work and the fraction that is done (0..1)."""

    def __call__(self, work: str, fraction: float) -> None:
        """Report progress."""


def silent(work: str, fraction: float) -> None:
    """Report nothing."""
