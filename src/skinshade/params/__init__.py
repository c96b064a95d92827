"""Parameters of shading: frozen, with unit, range, source and meaning in each field's metadata."""

from .skin import SkinParams

__all__ = ["SkinParams"]
