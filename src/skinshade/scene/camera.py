"""Cameras, and matrices of views and projections."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import (
    LARGEST_POSITION,
    FloatArray,
    FloatRows,
    FloatVector,
    as_direction,
    as_floats,
    as_position,
    unit_vectors,
)
from .._core.errors import ArgumentError

__all__ = ["Camera", "check_apart", "look_at", "parallel", "perspective"]

LEAST_DISTANCE_MM = 1e-9
"""Least distance of a position from its target, mm: a thousandth of the least unit of length."""
LEAST_RELATIVE_DISTANCE = 1e-9
"""Least ratio of this distance to the greatest coordinate; rays lose their direction to rounding below it."""


def check_apart(name: str, position_mm: FloatVector, target_mm: FloatVector) -> None:
    """Raise if a position (3,) and its target (3,) are so close that no direction is defined; mm.

    Raises
    ------
    ArgumentError
        With `name`, the position and the distance.
    """
    distance = float(np.abs(position_mm - target_mm).max())
    if distance == 0.0:
        raise ArgumentError(f"{name}: position and target are both {position_mm} mm")
    largest = float(max(np.abs(position_mm).max(), np.abs(target_mm).max()))
    least = max(LEAST_DISTANCE_MM, LEAST_RELATIVE_DISTANCE * largest)
    if distance < least:
        raise ArgumentError(
            f"{name}: position and target are {distance:g} mm apart at coordinates up to"
            f" {largest:g} mm; the distance must be {least:g} mm or more"
        )


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
        (3,) mm, each number within ±1e15; apart by 1e-9 mm and 1e-9 of the greatest number, or more.
    vertical_fov_deg
        Vertical field of view, degrees, 1..150.
    up
        (3,) direction that is up in the picture; it is normalised.

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
        for name in ("position_mm", "target_mm"):
            object.__setattr__(self, name, as_position(f"camera {name}", getattr(self, name)))
        check_apart("camera", self.position_mm, self.target_mm)
        object.__setattr__(self, "up", as_direction("camera up", self.up))
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
            (3,) mm, each number within ±1e15.
        distance_mm
            Radius of the sphere, mm, 1e-9..1e15.
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
        target = as_position("target_mm", target_mm)
        distance = as_floats(
            "distance_mm", distance_mm, (), low=LEAST_DISTANCE_MM, high=LARGEST_POSITION
        )
        return cls(target + distance * direction_of(yaw_deg, pitch_deg), target, vertical_fov_deg)

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
    """Return the unit vector (3,) of a yaw from +z towards +x and a pitch towards +y, degrees.

    Raises
    ------
    ArgumentError
        If an angle is not a finite number.
    """
    yaw = np.radians(as_floats("yaw_deg", yaw_deg, ()))
    pitch = np.radians(as_floats("pitch_deg", pitch_deg, ()))
    return np.array([np.sin(yaw) * np.cos(pitch), np.sin(pitch), np.cos(yaw) * np.cos(pitch)])
