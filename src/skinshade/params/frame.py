"""Constant blocks of a frame and of a light in the renderer's passes.

Matrices are stored by rows, for column vectors.
"""

from __future__ import annotations

from dataclasses import dataclass

from .fields import checked_fields, number
from .packing import pack

__all__ = ["FrameParams", "LightParams"]

WIDE = 1e30
"""Limit of values that have no natural range; finite in float32."""
ZERO3: tuple[float, float, float] = (0.0, 0.0, 0.0)
ZERO4: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True)
class FrameParams:
    """Camera, environment and exposure of a frame."""

    clip_x: tuple[float, float, float, float] = number(
        ZERO4, "1", -WIDE, WIDE, "Row x of the matrix from mm to clip space."
    )
    clip_y: tuple[float, float, float, float] = number(
        ZERO4, "1", -WIDE, WIDE, "Row y of the matrix from mm to clip space."
    )
    clip_z: tuple[float, float, float, float] = number(
        ZERO4, "1", -WIDE, WIDE, "Row z of the matrix from mm to clip space."
    )
    clip_w: tuple[float, float, float, float] = number(
        ZERO4, "1", -WIDE, WIDE, "Row w of the matrix from mm to clip space."
    )
    radiance_sh: tuple[tuple[float, float, float], ...] = number(
        (ZERO3,) * 9,
        "1",
        -WIDE,
        WIDE,
        "Harmonic coefficients of the environment's radiance, one column per channel.",
    )
    eye_mm: tuple[float, float, float] = number(ZERO3, "mm", -WIDE, WIDE, "Position of the eye.")
    ray_across: tuple[float, float, float] = number(
        ZERO3, "1", -WIDE, WIDE, "Change of a pixel's ray with x, -1..1."
    )
    ray_up: tuple[float, float, float] = number(
        ZERO3, "1", -WIDE, WIDE, "Change of a pixel's ray with y, -1..1, upwards."
    )
    ray_ahead: tuple[float, float, float] = number(
        (0.0, 0.0, -1.0), "1", -WIDE, WIDE, "Ray through the middle of the screen."
    )
    background: tuple[float, float, float] = number(
        ZERO3, "1", 0.0, WIDE, "Radiance behind the body."
    )
    footprint: float = number(1.0, "1", 0.0, 1.0, "Share of a pixel's side that a sample covers.")
    sample_weight: float = number(1.0, "1", 0.0, 1.0, "Weight of a sample in its pixel.")
    uv_scale_mm: float = number(1.0, "mm", 0.0, WIDE, "Length of the unit of UV on the surface.")
    environment_scale: float = number(
        1.0, "1", 0.0, WIDE, "Factor on the light of the environment."
    )
    exposure: float = number(1.0, "1", 0.0, WIDE, "Factor on the light before the tone curve.")

    def __post_init__(self) -> None:
        checked_fields(self)

    def pack(self) -> bytes:
        """Return the bytes of ``FrameBlock`` in the layout of ``shading/generated/layout.json``."""
        return pack("FrameBlock", self)


@dataclass(frozen=True)
class LightParams:
    """A light and its shadow map."""

    view_x: tuple[float, float, float, float] = number(
        ZERO4, "1", -WIDE, WIDE, "Row x of the matrix from mm to the light's view."
    )
    view_y: tuple[float, float, float, float] = number(
        ZERO4, "1", -WIDE, WIDE, "Row y of the matrix from mm to the light's view."
    )
    view_z: tuple[float, float, float, float] = number(
        ZERO4, "1", -WIDE, WIDE, "Row z of the matrix from mm to the light's view."
    )
    clip_x: tuple[float, float, float, float] = number(
        ZERO4, "1", -WIDE, WIDE, "Row x of the projection from view to clip space."
    )
    clip_y: tuple[float, float, float, float] = number(
        ZERO4, "1", -WIDE, WIDE, "Row y of the projection from view to clip space."
    )
    clip_w: tuple[float, float, float, float] = number(
        ZERO4, "1", -WIDE, WIDE, "Row w of the projection from view to clip space."
    )
    direction: tuple[float, float, float] = number(
        (0.0, 0.0, 1.0),
        "1",
        -1.0,
        1.0,
        "Unit vector towards the light; for a spot light, from its target.",
    )
    position_mm: tuple[float, float, float] = number(
        ZERO3, "mm", -WIDE, WIDE, "Position of a spot light."
    )
    irradiance: tuple[float, float, float] = number(
        ZERO3, "1", 0.0, WIDE, "Irradiance on a surface that faces the light."
    )
    cone_cosines: tuple[float, float] = number(
        (0.0, 1.0),
        "1",
        -1.0,
        1.0,
        "Cosines of a spot light's outer angle, with no light, and inner angle, with full light.",
    )
    depth_mm: tuple[float, float] = number(
        (0.0, 1.0), "mm", -WIDE, WIDE, "Depth of the middle of the body, and radius of the body."
    )
    near: float = number(0.0, "1", 0.0, 1.0, "1 for a spot light, 0 for a directional light.")
    target_distance_mm: float = number(
        0.0, "mm", 0.0, WIDE, "Distance from a spot light to its target."
    )
    blur_texels: float = number(1.0, "1", 0.0, WIDE, "Standard deviation of the variance filter.")

    def __post_init__(self) -> None:
        checked_fields(self)

    def pack(self) -> bytes:
        """Return the bytes of ``LightBlock`` in the layout of ``shading/generated/layout.json``."""
        return pack("LightBlock", self)
