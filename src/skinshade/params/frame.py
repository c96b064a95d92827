"""What a frame and a light are to the renderer's own passes; matrices as rows, for column vectors."""

from __future__ import annotations

from dataclasses import dataclass

from .fields import checked_fields, number
from .packing import pack

__all__ = ["FrameParams", "LightParams"]

WIDE = 1e30
ZERO3: tuple[float, float, float] = (0.0, 0.0, 0.0)
ZERO4: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True)
class FrameParams:
    """One frame: camera, surroundings, and the way to a screen."""

    clip_x: tuple[float, float, float, float] = number(
        ZERO4, "1", -WIDE, WIDE, "Row x of the matrix from mm to clip space."
    )
    clip_y: tuple[float, float, float, float] = number(ZERO4, "1", -WIDE, WIDE, "Row y of it.")
    clip_z: tuple[float, float, float, float] = number(ZERO4, "1", -WIDE, WIDE, "Row z of it.")
    clip_w: tuple[float, float, float, float] = number(ZERO4, "1", -WIDE, WIDE, "Row w of it.")
    radiance_sh: tuple[tuple[float, float, float], ...] = number(
        (ZERO3,) * 9, "1", -WIDE, WIDE, "Harmonics of the surroundings, a channel in each column."
    )
    eye_mm: tuple[float, float, float] = number(ZERO3, "mm", -WIDE, WIDE, "Position of the eye.")
    ray_across: tuple[float, float, float] = number(
        ZERO3, "1", -WIDE, WIDE, "Ray of a pixel, part of its x, -1..1."
    )
    ray_up: tuple[float, float, float] = number(
        ZERO3, "1", -WIDE, WIDE, "Ray of a pixel, part of its y, -1..1 upwards."
    )
    ray_ahead: tuple[float, float, float] = number(
        (0.0, 0.0, -1.0), "1", -WIDE, WIDE, "Ray of the middle."
    )
    background: tuple[float, float, float] = number(
        ZERO3, "1", 0.0, WIDE, "Radiance behind the body."
    )
    footprint: float = number(1.0, "1", 0.0, 1.0, "Share of a pixel's side that a sample covers.")
    sample_weight: float = number(1.0, "1", 0.0, 1.0, "Share of a pixel's light that it adds.")
    uv_scale_mm: float = number(1.0, "mm", 0.0, WIDE, "Length of the unit of UV on the surface.")
    environment_scale: float = number(1.0, "1", 0.0, WIDE, "Multiplies the surroundings.")
    exposure: float = number(1.0, "1", 0.0, WIDE, "Multiplies light before the tone curve.")

    def __post_init__(self) -> None:
        checked_fields(self)

    def pack(self) -> bytes:
        """Return the bytes of ``FrameBlock``, as ``shaders/generated/layout.json`` lays them out."""
        return pack("FrameBlock", self)


@dataclass(frozen=True)
class LightParams:
    """One light and its map of depths."""

    view_x: tuple[float, float, float, float] = number(
        ZERO4, "1", -WIDE, WIDE, "Row x of the matrix from mm to its view."
    )
    view_y: tuple[float, float, float, float] = number(ZERO4, "1", -WIDE, WIDE, "Row y of it.")
    view_z: tuple[float, float, float, float] = number(ZERO4, "1", -WIDE, WIDE, "Row z of it.")
    clip_x: tuple[float, float, float, float] = number(
        ZERO4, "1", -WIDE, WIDE, "Row x of its projection, from view space."
    )
    clip_y: tuple[float, float, float, float] = number(ZERO4, "1", -WIDE, WIDE, "Row y of it.")
    clip_w: tuple[float, float, float, float] = number(ZERO4, "1", -WIDE, WIDE, "Row w of it.")
    direction: tuple[float, float, float] = number(
        (0.0, 0.0, 1.0), "1", -1.0, 1.0, "Towards it, or from its target."
    )
    position_mm: tuple[float, float, float] = number(
        ZERO3, "mm", -WIDE, WIDE, "Of a lamp that is near."
    )
    irradiance: tuple[float, float, float] = number(
        ZERO3, "1", 0.0, WIDE, "On a surface that faces it."
    )
    cone_cosines: tuple[float, float] = number(
        (0.0, 1.0), "1", -1.0, 1.0, "Where a lamp's light has gone, and where it is full."
    )
    depth_mm: tuple[float, float] = number(
        (0.0, 1.0), "mm", -WIDE, WIDE, "Of the body's middle, and how far it reaches from there."
    )
    near: float = number(0.0, "1", 0.0, 1.0, "1 for a lamp at a position, 0 for a direction.")
    target_distance_mm: float = number(0.0, "mm", 0.0, WIDE, "From a lamp to its target.")
    blur_texels: float = number(1.0, "1", 0.0, WIDE, "Standard deviation of the variance filter.")

    def __post_init__(self) -> None:
        checked_fields(self)

    def pack(self) -> bytes:
        """Return the bytes of ``LightBlock``, as ``shaders/generated/layout.json`` lays them out."""
        return pack("LightBlock", self)
