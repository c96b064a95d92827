"""Portraits: scenes that frame and light a head."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from ..mesh import Mesh
from ..scene import Camera, DirectionalLight, Environment, Light, Scene
from .head import Head

__all__ = ["head_scene", "portrait_camera"]

DEFAULT_LIGHT = DirectionalLight.from_angles(-38.0, 26.0, 1.0)
"""Key light from the upper left."""
HEIGHT_PER_DEPTH = 1.25
"""Greatest ratio of height to depth that counts as head; the rest of a mesh is neck and shoulders."""
DISTANCE_PER_HEIGHT = 3.65
"""Ratio of the distance of the camera to the height of the head."""
FLATTEST = 1e-3
"""Least ratio of the height of a head to the extent of the mesh; a flatter mesh is a sheet without a head."""
VERTICAL_FOV_DEG = 19.0


def head_scene(
    head: Head,
    *,
    yaw_deg: float = 28.0,
    pitch_deg: float = 4.0,
    lights: Sequence[Light] = (DEFAULT_LIGHT,),
    environment: Environment | None = None,
    background: ArrayLike = (0.035, 0.037, 0.04),
) -> Scene:
    """Return a portrait: a camera that frames the head, in the light of a studio.

    Parameters
    ----------
    head
        Head, for instance from `builtin_head`.
    yaw_deg, pitch_deg
        Direction from the head to the camera, degrees; 0, 0 is in front.
    lights
        Lights; a key light from the upper left by default.
    environment
        Light from the surroundings; the built-in studio if None.
    background
        (3,) linear colour behind the head.

    Examples
    --------
    >>> import skinshade as sk
    >>> scene = sk.head_scene(sk.builtin_head(), yaw_deg=-30)
    >>> len(scene.lights), scene.camera.vertical_fov_deg
    (1, 19.0)
    """
    return Scene(
        head.mesh,
        portrait_camera(head.mesh, yaw_deg, pitch_deg),
        head.material,
        tuple(lights),
        Environment.studio(scale=0.55) if environment is None else environment,
        np.asarray(background, dtype=np.float64),
        parts=head.parts,
    )


def portrait_camera(mesh: Mesh, yaw_deg: float, pitch_deg: float) -> Camera:
    """Return a camera that frames the head at the top of a mesh; the angles are in degrees.

    A flat mesh is framed as a whole.
    """
    points = mesh.positions_mm
    low, high = points.min(axis=0), points.max(axis=0)
    extent = high - low
    height = min(extent[1], HEIGHT_PER_DEPTH * extent[2])
    if height < FLATTEST * extent.max():
        target, height = 0.5 * (low + high), extent.max()
    else:
        upper = points[points[:, 1] >= high[1] - 0.6 * height]
        centre = 0.5 * (upper.min(axis=0) + upper.max(axis=0))
        target = np.array([centre[0], high[1] - 0.5 * height, centre[2]])
    return Camera.orbit(
        target,
        DISTANCE_PER_HEIGHT * height,
        yaw_deg=yaw_deg,
        pitch_deg=pitch_deg,
        vertical_fov_deg=VERTICAL_FOV_DEG,
    )
