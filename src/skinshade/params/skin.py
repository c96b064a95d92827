"""The parameters of one skin material."""

from __future__ import annotations

from dataclasses import dataclass

from .fields import checked_fields, number
from .packing import pack

__all__ = ["SkinParams"]


@dataclass(frozen=True)
class SkinParams:
    """Numbers that shading takes beside profile and maps; ranges are checked.

    Each field's metadata holds its `skinshade.params.fields.Meaning`.
    """

    scatter_scale: float = number(
        1.0, "1", 0.05, 20.0, "Multiplies every length of the diffusion profile."
    )
    normal_strength: float = number(1.0, "1", 0.0, 2.0, "Multiplies the slopes of the normal map.")
    gloss: float = number(
        0.35, "1", 0.0, 1.0, "Of the first specular lobe: its power is 2^(13 gloss).", "Lagarde2011"
    )
    reflectance: float = number(
        0.028, "1", 0.0, 0.2, "Specular at normal incidence; .028 is skin's index 1.4."
    )
    shadow_filter_width_mm: float = number(
        8.0,
        "mm",
        1.0,
        100.0,
        "Width across the light of the wide shadow filter, the same everywhere.",
    )
    shadow_sharpening: float = number(
        8.0, "1", 1.0, 100.0, "How many times narrower than the filter the cast shadow's edge is."
    )
    deep_scatter_strength: float = number(
        1.0, "1", 0.0, 10.0, "Multiplies light that comes through the body; 1 is physical."
    )
    deep_scatter_offset_mm: float = number(
        0.6, "mm", 0.0, 10.0, "How far inwards the point moves before its depth is compared."
    )
    deep_scatter_filter_mm: float = number(
        2.5, "mm", 0.0, 20.0, "Radius of the disk over which thickness is averaged."
    )
    deep_scatter_sigma_per_mm: tuple[float, float, float] = number(
        (0.0, 0.0, 0.0),
        "1/mm",
        0.0,
        50.0,
        "Decay of light that comes through; 0: 1.2/rms radius.",
        "KubelkaMunk1931",
    )
    deep_scatter_tint: tuple[float, float, float] = number(
        (1.0, 1.0, 1.0), "1", 0.0, 1.0, "Colour of light that comes through, beside its texture."
    )
    classic_deep_scatter_radius_mm: float = number(
        5.5, "mm", 0.1, 100.0, "Of the falloff of 2014, used by classic shading alone.", "Green2007"
    )

    def __post_init__(self) -> None:
        checked_fields(self)

    def pack(self) -> bytes:
        """Return the bytes of ``SkinBlock``, as ``shaders/generated/layout.json`` lays them out."""
        return pack("SkinBlock", self)
