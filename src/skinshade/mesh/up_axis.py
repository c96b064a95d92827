"""Up axis of a file."""

from __future__ import annotations

from .._core.choice import Choice

__all__ = ["UpAxis"]


class UpAxis(Choice):
    """Axis of a file that points up; meshes have y up, as glTF has."""

    Y = "y"
    Z = "z"
