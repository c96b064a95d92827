"""Display values of pictures, through the scene's tone curve."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, ImageArray
from ..params.choices import ToneCurve
from ..scene import Scene
from ..shading.tonemap import tonemap
from .settings import RenderSettings

__all__ = ["display_values", "tone_of"]


def display_values(image: ImageArray, scene: Scene, settings: RenderSettings) -> FloatArray:
    """Return display values (H, W, 3), 0..1, of linear light (H, W, 3 or 4)."""
    return tonemap(image[..., :3].astype(np.float64), *tone_of(scene, settings))


def tone_of(scene: Scene, settings: RenderSettings) -> tuple[ToneCurve, float]:
    """Return tone curve and exposure: those of the scene for views of light, sRGB and 1 otherwise."""
    if settings.debug_view.is_light:
        return scene.tone, scene.exposure
    return ToneCurve.SRGB, 1.0
