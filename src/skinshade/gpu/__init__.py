"""Runtime for wgpu renderers: device, bindings by reflection, textures, context."""

from .context import SkinContext
from .library import wgsl_library

__all__ = ["SkinContext", "wgsl_library"]
