"""The shader library: commented sources, and what the compiler made of them."""

from __future__ import annotations

from importlib.resources import files

__all__ = ["generated_text"]


def generated_text(name: str) -> str:
    """Return a file of ``generated``, which is committed: no user needs the compiler."""
    return files(__name__).joinpath(f"generated/{name}").read_text(encoding="utf-8")
