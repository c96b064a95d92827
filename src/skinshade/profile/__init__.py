"""Diffusion profiles, each one a transfer function over spatial frequency (MODEL §1)."""

from .gaussians import GaussianMixture
from .presets import presets
from .transfer import Profile

__all__ = ["GaussianMixture", "Profile", "presets"]
