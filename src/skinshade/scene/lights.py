"""Directional and spot lights."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import (
    LARGEST_LIGHT,
    FloatArray,
    FloatVector,
    as_direction,
    as_floats,
    as_position,
    as_rgb,
    dot,
    unit_vectors,
)
from .._core.errors import ArgumentError
from .camera import check_apart, direction_of, look_at, parallel, perspective

__all__ = ["DirectionalLight", "Light", "SpotLight"]

MARGIN = 1.03
"""Extent of shadow maps relative to the body: a filter at the body's edge needs empty texels."""

FULL_SHARE = 0.8
"""Share of a spot light's cone, in angle, that has the full irradiance."""
LEAST_DISTANCE_MM = 1.0
"""Least distance of the inverse square law, mm: real lights are not points."""
LARGEST_AT_1_MM = 1e24
"""Greatest irradiance of a spot light at `LEAST_DISTANCE_MM`; its light stays finite in float32."""


@dataclass(frozen=True)
class DirectionalLight:
    """Light from an infinite distance.

    Attributes
    ----------
    to_light
        (3,) direction towards the light; it is normalised.
    irradiance
        (3,) irradiance on a surface that faces the light, 0..1e6; π gives a white Lambert surface radiance 1.

    Examples
    --------
    >>> import skinshade as sk
    >>> sk.DirectionalLight(to_light=(0, 0, 2), irradiance=3.0).to_light
    array([0., 0., 1.])
    """

    to_light: FloatVector
    irradiance: FloatVector

    def __post_init__(self) -> None:
        object.__setattr__(self, "to_light", as_direction("light to_light", self.to_light))
        object.__setattr__(self, "irradiance", _irradiance(self.irradiance))

    @classmethod
    def from_angles(cls, yaw_deg: float, pitch_deg: float, intensity: float) -> DirectionalLight:
        """Return a white light from a direction in angles.

        Parameters
        ----------
        yaw_deg
            Degrees from +z towards +x.
        pitch_deg
            Degrees towards +y, −90..90.
        intensity
            Irradiance over π, 0..1e6/π.

        Raises
        ------
        ArgumentError
            If a value is not finite, or the intensity is out of range.
        """
        value = as_floats("light intensity", intensity, ())
        with np.errstate(over="ignore"):  # the irradiance is checked
            irradiance = np.full(3, np.pi * value)
        return cls(direction_of(yaw_deg, pitch_deg), irradiance)

    def turned(self, yaw_deg: float, pitch_deg: float) -> DirectionalLight:
        """Return the light turned as a camera is turned from the front by a yaw and a pitch, degrees."""
        yaw, pitch = np.radians(yaw_deg), np.radians(pitch_deg)
        x, y, z = self.to_light
        y, z = y * np.cos(pitch) + z * np.sin(pitch), z * np.cos(pitch) - y * np.sin(pitch)
        x, z = x * np.cos(yaw) + z * np.sin(yaw), z * np.cos(yaw) - x * np.sin(yaw)
        return DirectionalLight(np.array([x, y, z]), self.irradiance)

    def at(self, position_mm: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return direction (..., 3) and irradiance (..., 3) at positions (..., 3)."""
        return (
            np.broadcast_to(self.to_light, position_mm.shape),
            np.broadcast_to(self.irradiance, position_mm.shape),
        )

    def view_and_projection(
        self, centre_mm: FloatArray, radius_mm: float
    ) -> tuple[FloatArray, FloatArray]:
        """Return view and projection (4, 4) of a shadow map of a sphere with a centre (3,) and radius, mm."""
        reach = MARGIN * radius_mm
        view = look_at(centre_mm + 2.0 * reach * self.to_light, centre_mm, _up(self.to_light))
        return view, parallel(reach, reach, 3.0 * reach)


@dataclass(frozen=True)
class SpotLight:
    """Light from a point, within a cone with a soft edge.

    Attributes
    ----------
    position_mm, target_mm
        (3,) mm, each number within ±1e15; apart by 1e-9 mm and 1e-9 of the greatest number, or more.
    irradiance
        (3,) irradiance at the target, on a surface that faces the light, 0..1e6. It decreases with the
        square of the distance, and is 1e24 or less at 1 mm from the light.
    cone_deg
        Half angle at which the irradiance is 0, degrees, 1..80; within .8 of it the irradiance is full.

    Examples
    --------
    >>> import skinshade as sk
    >>> light = sk.SpotLight((0, 0, 500), (0, 0, 0), irradiance=3.0)
    >>> light.at(light.target_mm + (0, 0, 250))[1]  # at half the distance
    array([12., 12., 12.])
    """

    position_mm: FloatVector
    target_mm: FloatVector
    irradiance: FloatVector
    cone_deg: float = 30.0

    def __post_init__(self) -> None:
        for name in ("position_mm", "target_mm"):
            object.__setattr__(self, name, as_position(f"light {name}", getattr(self, name)))
        check_apart("light", self.position_mm, self.target_mm)
        object.__setattr__(self, "irradiance", _irradiance(self.irradiance))
        axis = self.position_mm - self.target_mm
        close = float(self.irradiance.max() * dot(axis, axis) / LEAST_DISTANCE_MM**2)
        if close > LARGEST_AT_1_MM:
            raise ArgumentError(
                f"light: its irradiance is {close:g} at 1 mm, because the target is"
                f" {np.sqrt(dot(axis, axis)):g} mm away; it must be {LARGEST_AT_1_MM:g} or less"
            )
        as_floats("light cone_deg", self.cone_deg, (), low=1.0, high=80.0)

    @property
    def cone_cosines(self) -> tuple[float, float]:
        """Cosines of the angle at which the irradiance is 0, and of the angle within which it is full."""
        outer, inner = np.cos(np.radians([self.cone_deg, FULL_SHARE * self.cone_deg]))
        return float(outer), float(inner)

    def at(self, position_mm: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return direction (..., 3) and irradiance (..., 3) at positions (..., 3)."""
        to_light = self.position_mm - position_mm
        distance2 = np.maximum(dot(to_light, to_light), LEAST_DISTANCE_MM**2)[..., None]
        direction = unit_vectors(to_light)
        axis = self.position_mm - self.target_mm
        outer, inner = self.cone_cosines
        along = dot(direction, unit_vectors(axis))[..., None]
        t = np.clip((along - outer) / (inner - outer), 0.0, 1.0)
        falloff = dot(axis, axis) / distance2
        return direction, self.irradiance * falloff * t * t * (3.0 - 2.0 * t)

    def view_and_projection(
        self, centre_mm: FloatArray, radius_mm: float
    ) -> tuple[FloatArray, FloatArray]:
        """Return view and projection (4, 4) of a shadow map of the cone up to the far end of a sphere.

        The sphere has a centre (3,) and a radius in mm.
        """
        distance = float(np.linalg.norm(centre_mm - self.position_mm))
        near = max(distance - MARGIN * radius_mm, 1e-2 * distance, 1e-6 * radius_mm)
        axis = unit_vectors(self.position_mm - self.target_mm)
        view = look_at(self.position_mm, self.target_mm, _up(axis))
        return view, perspective(2.0 * self.cone_deg, 1.0, near, distance + MARGIN * radius_mm)


Light = DirectionalLight | SpotLight


def _irradiance(value: ArrayLike) -> FloatArray:
    return as_rgb("light irradiance", value, low=0.0, high=LARGEST_LIGHT)


def _up(direction: FloatArray) -> FloatArray:
    return np.array([0.0, 0.0, 1.0] if abs(direction[1]) > 0.9 else [0.0, 1.0, 0.0])
