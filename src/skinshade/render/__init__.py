"""Pictures of scenes, by whichever backend there is."""

from .renderer import DEBUG_VIEWS, RenderSettings, render

__all__ = ["DEBUG_VIEWS", "RenderSettings", "render"]
