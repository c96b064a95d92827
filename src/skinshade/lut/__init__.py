"""Lookup tables: light over N·L and curvature, shadow over filter and 1/width, contrast over frequency."""

from .curvature import curvature_lut
from .shadow import build_shadow_lut
from .spectral import DiffusionGeometry
from .table import Axis, Lut
from .transfer import build_transfer_lut

__all__ = [
    "Axis",
    "DiffusionGeometry",
    "Lut",
    "build_shadow_lut",
    "build_transfer_lut",
    "curvature_lut",
]
