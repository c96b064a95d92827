"""Renderers: one interface, a backend on the CPU and one on the GPU.

``api`` opens a backend and draws. ``prepare`` computes the data that both backends need. ``cpu``
evaluates the specification in NumPy; ``gpu`` runs the shader library.
"""

from typing import TYPE_CHECKING

from .._core.lazy import names_on_demand

if TYPE_CHECKING:
    from .api import open_renderer, render
    from .backend import Renderer
    from .images import RenderedImage, save_image
    from .settings import Backend, RenderSettings

__all__ = [
    "Backend",
    "RenderSettings",
    "RenderedImage",
    "Renderer",
    "open_renderer",
    "render",
    "save_image",
]

__getattr__ = names_on_demand(
    __name__,
    {
        ".api": (
            "open_renderer",
            "render",
        ),
        ".backend": ("Renderer",),
        ".images": (
            "RenderedImage",
            "save_image",
        ),
        ".settings": (
            "Backend",
            "RenderSettings",
        ),
    },
)
