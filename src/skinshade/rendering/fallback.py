"""A renderer that changes to another one when its device fails."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import ImageArray
from .._core.errors import BackendError
from ..scene import Camera
from .backend import Renderer
from .settings import RenderSettings

__all__ = ["FallbackRenderer"]

Result = TypeVar("Result")


class FallbackRenderer(Renderer):
    """Renderer that draws with a first renderer until its device fails, and then with a second one.

    Parameters
    ----------
    first
        Renderer that draws until its device is lost or out of memory.
    make_second
        Function that opens the second renderer; it is called when the first one fails.
    """

    def __init__(self, first: Renderer, make_second: Callable[[], Renderer]) -> None:
        self._current, self._make_second = first, make_second
        self.scene = first.scene

    @property
    def device_name(self) -> str:
        """Name of the device of the current renderer."""
        return self._current.device_name

    @property
    def timings_ms(self) -> dict[str, list[float]]:
        """Times of the passes of the current renderer, ms."""
        return self._current.timings_ms

    def draw_many(
        self,
        camera: Camera,
        size: tuple[int, int],
        samples: int,
        settings: Sequence[RenderSettings],
    ) -> list[ImageArray]:
        """Draw one view with several settings."""
        return self._run(lambda renderer: renderer.draw_many(camera, size, samples, settings))

    def draw_display(
        self,
        camera: Camera,
        size: tuple[int, int],
        samples: int,
        settings: RenderSettings,
    ) -> NDArray[np.uint8]:
        """Return display values (H, W, 3) in eight bits."""
        return self._run(lambda renderer: renderer.draw_display(camera, size, samples, settings))

    def _run(self, work: Callable[[Renderer], Result]) -> Result:
        try:
            return work(self._current)
        except BackendError:
            self._current = self._make_second()
            return work(self._current)
