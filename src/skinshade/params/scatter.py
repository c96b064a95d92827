"""Constants of a diffusion profile and of its tables, for shaders."""

from __future__ import annotations

from dataclasses import dataclass

from .fields import checked_fields, number
from .packing import pack

__all__ = ["ScatterParams"]

WIDEST_MM = 1e4
"""Limit of lengths of a profile, mm."""
AXES = "Axes of {}: low and 1/(high − low) of the columns, then of the rows."
"""Description of the axes of a table."""


@dataclass(frozen=True)
class ScatterParams:
    """Constants of a diffusion profile and of its tables; ranges are checked.

    The metadata of each field holds its `skinshade.params.fields.Meaning`.
    """

    albedo: tuple[float, float, float] = number(
        (0.436, 0.227, 0.131), "1", 1e-4, 0.9999, "Diffuse albedo of the profile."
    )
    rms_radius_mm: tuple[float, float, float] = number(
        (2.42, 1.06, 0.66), "mm", 0.0, WIDEST_MM, "Root mean square radius of the profile."
    )
    sigma_per_mm: tuple[float, float, float] = number(
        (0.5, 1.1, 1.8), "1/mm", 0.0, 1e6, "Decay of light that passes through the body."
    )
    blend_red: tuple[float, float, float] = number(
        (1.0, 0.0, 0.0),
        "1",
        0.0,
        1.0,
        "Weights of the sharp, narrow and wide normal for red light.",
    )
    blend_green: tuple[float, float, float] = number(
        (1.0, 0.0, 0.0),
        "1",
        0.0,
        1.0,
        "Weights of the sharp, narrow and wide normal for green light.",
    )
    blend_blue: tuple[float, float, float] = number(
        (1.0, 0.0, 0.0),
        "1",
        0.0,
        1.0,
        "Weights of the sharp, narrow and wide normal for blue light.",
    )
    ring_axes: tuple[float, float, float, float] = number(
        (-1.0, 0.5, 0.0, 1.0), "1", -1e6, 1e6, AXES.format("the ring's table, rows √(1/mm)")
    )
    sphere_axes: tuple[float, float, float, float] = number(
        (-1.0, 0.5, 0.0, 1.0), "1", -1e6, 1e6, AXES.format("the sphere's table, rows √(1/mm)")
    )
    transfer_axes: tuple[float, float, float, float] = number(
        (0.0, 1.0, 0.0, 1.0), "1", -1e6, 1e6, AXES.format("T(k), columns √(rad/mm)")
    )
    shadow_axes: tuple[float, float, float, float] = number(
        (0.0, 1.0, 0.0, 1.0), "1", -1e6, 1e6, AXES.format("the shadow table, rows 1/mm")
    )
    classic_axes: tuple[float, float, float, float] = number(
        (-1.0, 0.5, 0.0, 1.0), "1", -1e6, 1e6, AXES.format("the curvature table of 2014, rows 1/mm")
    )
    classic_shadow_axes: tuple[float, float, float, float] = number(
        (0.0, 1.0, 0.0, 1.0), "1", -1e6, 1e6, AXES.format("the shadow table of 2014, rows 1/mm")
    )
    coat_axes: tuple[float, float, float, float] = number(
        (0.0, 1.0, 0.0, 1.0),
        "1",
        -1e6,
        1e6,
        AXES.format("the coat's table, columns √(N·V), rows gloss"),
    )
    normal_sigmas_mm: tuple[float, float] = number(
        (0.0, 0.0),
        "mm",
        0.0,
        WIDEST_MM,
        "Standard deviations of the narrow and the wide blur of the normal map.",
    )
    coat_reflectance: float = number(
        0.028, "1", 0.0, 0.2, "Reflectance at normal incidence that the coat's table was built for."
    )

    def __post_init__(self) -> None:
        checked_fields(self)

    def pack(self) -> bytes:
        """Return the bytes of ``ScatterBlock`` in the layout of ``shading/generated/layout.json``."""
        return pack("ScatterBlock", self)
