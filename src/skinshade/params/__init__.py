"""Parameters of shading: frozen, with unit, range, source and meaning in each field's metadata."""

from .scatter import ScatterParams
from .skin import SkinParams

__all__ = ["ScatterParams", "SkinParams"]
