"""Enumerations of renderers that shaders do not share."""

from __future__ import annotations

from .._core.choice import Choice

__all__ = ["Backend"]


class Backend(Choice):
    """Device that draws pictures; ``auto`` is a hardware GPU if there is one, else the CPU."""

    AUTO = "auto"
    GPU = "gpu"
    CPU = "cpu"
