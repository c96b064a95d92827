"""The shader library as WGSL."""

from __future__ import annotations

from .._core.generated import generated_text

__all__ = ["wgsl_library"]


def wgsl_library() -> str:
    """Return the structs of the constant blocks and all functions ``skin_…``, to prepend to a shader."""
    return generated_text("blocks.wgsl") + "\n" + generated_text("skin.wgsl")
