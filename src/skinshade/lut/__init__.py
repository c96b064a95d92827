"""Lookup tables: light over (N·L, curvature), shadow over (filter, 1/width), contrast over frequency."""

from .curvature import build_curvature_lut
from .shadow import build_shadow_lut
from .table import Axis, Lut
from .transfer import build_transfer_lut

__all__ = ["Axis", "Lut", "build_curvature_lut", "build_shadow_lut", "build_transfer_lut"]
