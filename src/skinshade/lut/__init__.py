"""Lookup tables of light, shadow, contrast and reflection, over the quantities that a shader knows."""

from .coat import build_coat_lut
from .curvature import curvature_lut
from .shadow import build_shadow_lut
from .spectral import DiffusionGeometry
from .table import Axis, Lut
from .transfer import build_transfer_lut

__all__ = [
    "Axis",
    "DiffusionGeometry",
    "Lut",
    "build_coat_lut",
    "build_shadow_lut",
    "build_transfer_lut",
    "curvature_lut",
]
