"""Cameras, and matrices of views and projections."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import FloatArray, FloatRows, FloatVector, as_floats, unit_vectors
from .._core.errors import ArgumentError

__all__ = ["Camera", "look_at", "parallel", "perspective"]


def look_at(eye: FloatArray, target: FloatArray, up: FloatArray) -> FloatRows:
    """Return the (4, 4) view matrix for column vectors; the view looks along −z, with y up."""
    backward = unit_vectors(eye - target)
    side = np.cross(up, backward)
    if np.linalg.norm(side) < 1e-9:  # the view is parallel to `up`: any side is valid
        side = np.cross(np.roll(np.abs(backward), 1) + 0.1, backward)
    right = unit_vectors(side)
    rotation = np.stack([right, np.cross(backward, right), backward])
    view = np.eye(4)
    view[:3, :3], view[:3, 3] = rotation, -rotation @ eye
    return view


def perspective(vertical_fov_deg: float, aspect: float, near: float, far: float) -> FloatRows:
    """Return the (4, 4) perspective projection, right-handed, depth 0..1, for column vectors."""
    f = 1.0 / np.tan(np.radians(vertical_fov_deg) / 2.0)
    return np.array(
        [
            [f / aspect, 0.0, 0.0, 0.0],
            [0.0, f, 0.0, 0.0],
            [0.0, 0.0, far / (near - far), near * far / (near - far)],
            [0.0, 0.0, -1.0, 0.0],
        ]
    )


def parallel(half_width: float, near: float, far: float) -> FloatRows:
    """Return the (4, 4) parallel projection of a square, right-handed, depth 0..1, for column vectors."""
    return np.array(
        [
            [1.0 / half_width, 0.0, 0.0, 0.0],
            [0.0, 1.0 / half_width, 0.0, 0.0],
            [0.0, 0.0, 1.0 / (near - far), near / (near - far)],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )


@dataclass(frozen=True, repr=False)
class Camera:
    """Perspective camera.

    Attributes
    ----------
    position_mm, target_mm
        (3,) mm.
    vertical_fov_deg
        Vertical field of view, degrees, 1..150.
    up
        (3,) direction that is up in the picture.

    Examples
    --------
    >>> import skinshade as sk
    >>> sk.Camera((0, 0, 900), (0, 0, 0))
    Camera([  0.   0. 900.] to [0. 0. 0.] mm, 20°)
    """

    position_mm: FloatVector
    target_mm: FloatVector
    vertical_fov_deg: float = 20.0
    up: FloatVector = (0.0, 1.0, 0.0)  # type: ignore[assignment]  # converted in __post_init__

    def __post_init__(self) -> None:
        for name in ("position_mm", "target_mm", "up"):
            object.__setattr__(self, name, as_floats(f"camera {name}", getattr(self, name), (3,)))
        if np.array_equal(self.position_mm, self.target_mm):
            raise ArgumentError(f"camera: position and target are both {self.position_mm} mm")
        if not self.up.any():
            raise ArgumentError("camera up is 0, 0, 0; it must be a direction")
        as_floats("camera vertical_fov_deg", self.vertical_fov_deg, (), low=1.0, high=150.0)

    @classmethod
    def orbit(
        cls,
        target_mm: ArrayLike,
        distance_mm: float,
        *,
        yaw_deg: float = 0.0,
        pitch_deg: float = 0.0,
        vertical_fov_deg: float = 20.0,
    ) -> Camera:
        """Return a camera on a sphere around a target.

        Parameters
        ----------
        target_mm
            (3,) mm.
        distance_mm
            Radius of the sphere, mm, > 0.
        yaw_deg
            Degrees; 0 shows the front of a head that faces +z, 90 its left side.
        pitch_deg
            Degrees, −90..90; 90 shows the head from above.
        vertical_fov_deg
            Vertical field of view, degrees, 1..150.

        Raises
        ------
        ArgumentError
            If a value is out of range.
        """
        target = as_floats("target_mm", target_mm, (3,))
        return cls(
            target + distance_mm * direction_of(yaw_deg, pitch_deg), target, vertical_fov_deg
        )

    def __repr__(self) -> str:
        position, target = self.position_mm.round(3), self.target_mm.round(3)
        return f"Camera({position} to {target} mm, {self.vertical_fov_deg:g}°)"

    def orbited(self, yaw_deg: float) -> Camera:
        """Return the camera, rotated by a yaw in degrees around the vertical axis through its target."""
        a = np.radians(yaw_deg)
        x, y, z = self.position_mm - self.target_mm
        rotated = np.array([x * np.cos(a) + z * np.sin(a), y, z * np.cos(a) - x * np.sin(a)])
        return replace(self, position_mm=self.target_mm + rotated)

    def view_projection(self, aspect: float) -> FloatRows:
        """Return the (4, 4) matrix from mm to clip coordinates; `aspect` is width over height."""
        distance = float(np.linalg.norm(self.position_mm - self.target_mm))
        projection = perspective(self.vertical_fov_deg, aspect, 0.01 * distance, 100.0 * distance)
        return projection @ look_at(self.position_mm, self.target_mm, self.up)


def direction_of(yaw_deg: float, pitch_deg: float) -> FloatVector:
    """Return the unit vector (3,) of a yaw from +z towards +x and a pitch towards +y, degrees."""
    yaw, pitch = np.radians(yaw_deg), np.radians(pitch_deg)
    return np.array([np.sin(yaw) * np.cos(pitch), np.sin(pitch), np.cos(yaw) * np.cos(pitch)])
