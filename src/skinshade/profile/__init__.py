"""Diffusion profiles: transfer functions over spatial frequency (MODEL §1)."""

from .gaussians import GaussianMixture
from .presets import presets
from .transfer import Profile

__all__ = ["GaussianMixture", "Profile", "presets"]
