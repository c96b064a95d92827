"""The interface of a backend."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import ImageArray
from ..scene import Camera, Scene
from .settings import RenderSettings
from .tone import display_values

__all__ = ["Renderer"]


class Renderer(Protocol):
    """A scene prepared for drawing: everything that does not depend on the camera is computed once.

    Attributes
    ----------
    scene
        The scene that is drawn.
    """

    scene: Scene

    @property
    def device_name(self) -> str:
        """Name of the device that draws."""

    @property
    def timings_ms(self) -> dict[str, list[float]]:
        """Times of all passes so far, ms, by the name of the pass; empty where passes are not timed."""

    def draw_many(
        self,
        camera: Camera,
        size: tuple[int, int],
        samples: int,
        settings: Sequence[RenderSettings],
    ) -> list[ImageArray]:
        """Draw one view with several settings.

        Parameters
        ----------
        camera
            Camera of the view.
        size
            (width, height) in pixels, 1..16384 each.
        samples
            Samples per pixel, 1..256.
        settings
            Settings of each picture. All pictures use the seed of the first settings.

        Returns
        -------
        list of (H, W, 4) float32
            One image for each of the settings: linear light over the background, and coverage.
        """

    def draw(
        self,
        camera: Camera,
        size: tuple[int, int],
        samples: int,
        settings: RenderSettings,
    ) -> ImageArray:
        """Return linear light over the background, and coverage, (H, W, 4) float32."""
        return self.draw_many(camera, size, samples, [settings])[0]

    def draw_display(
        self,
        camera: Camera,
        size: tuple[int, int],
        samples: int,
        settings: RenderSettings,
    ) -> NDArray[np.uint8]:
        """Return display values (H, W, 3) in eight bits, through the scene's tone curve."""
        image = self.draw(camera, size, samples, settings)
        display = display_values(image, self.scene, settings)
        return np.rint(display * 255.0).astype(np.uint8)
