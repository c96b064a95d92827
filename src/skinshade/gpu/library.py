"""The shader library as WGSL, for a user's own module."""

from __future__ import annotations

from ..shaders import generated_text

__all__ = ["wgsl_library"]


def wgsl_library() -> str:
    """Return the structs of the constant blocks and every function ``skin_…``, to stand before a shader."""
    return generated_text("blocks.wgsl") + "\n" + generated_text("skin.wgsl")
