"""The runtime on a GPU, for any renderer; needs wgpu."""

from .context import SkinContext
from .library import wgsl_library

__all__ = ["SkinContext", "wgsl_library"]
