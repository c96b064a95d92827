"""The two lookup tables: light over (N·L, curvature), and shadow over (filter value, 1/width)."""

from .curvature import build_curvature_lut
from .shadow import build_shadow_lut
from .table import Axis, Lut

__all__ = ["Axis", "Lut", "build_curvature_lut", "build_shadow_lut"]
