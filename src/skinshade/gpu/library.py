"""The shader library as WGSL, for a user's own module."""

from __future__ import annotations

from importlib.resources import files

__all__ = ["wgsl_library"]


def wgsl_library() -> str:
    """Return the structs of the constant blocks and every function ``skin_…``, to stand before a shader."""
    generated = files("skinshade.shaders").joinpath("generated")
    return "\n".join(
        generated.joinpath(name).read_text("utf-8") for name in ("blocks.wgsl", "skin.wgsl")
    )
