"""Background of a picture."""

from __future__ import annotations

import numpy as np

from ..._core.arrays import FloatArray, unit_vectors
from ...scene import Camera, Scene

__all__ = ["background_light"]


def background_light(scene: Scene, camera: Camera, size: tuple[int, int]) -> FloatArray:
    """Return the light behind the body, (H·W, 3), or (3,) if all pixels have the same background."""
    environment = scene.environment
    if environment is None or not environment.visible:
        return scene.background
    width, height = size
    x = (2.0 * np.arange(width) + 1.0) / width - 1.0
    y = 1.0 - (2.0 * np.arange(height) + 1.0) / height
    screen = np.stack(np.broadcast_arrays(x[None, :], y[:, None], 1.0, 1.0), axis=-1)
    far_points = screen.reshape(-1, 4) @ np.linalg.inv(camera.view_projection(width / height)).T
    rays = unit_vectors(far_points[:, :3] / far_points[:, 3:] - camera.position_mm)
    return environment.sample(rays)
