"""Parameters of a skin material."""

from __future__ import annotations

from dataclasses import InitVar, dataclass

from .choices import Boundary, SpecularModel
from .fields import checked_fields, choice, number

__all__ = ["SkinParams"]


@dataclass(frozen=True)
class SkinParams:
    """Parameters of a skin material, besides its profile and its maps; ranges are checked.

    The metadata of each number holds its `skinshade.params.fields.Meaning`: unit, range, source. The
    metadata of ``specular`` and ``boundary`` holds a `skinshade.params.fields.ChoiceMeaning`.

    Parameters
    ----------
    roughness
        GGX roughness, 0..1. If it is given, it replaces ``gloss``.

    Examples
    --------
    >>> import skinshade as sk
    >>> round(sk.SkinParams(roughness=0.45).gloss, 3)
    0.427
    """

    scatter_scale: float = number(
        1.0, "1", 0.05, 20.0, "Factor on every length of the diffusion profile."
    )
    normal_strength: float = number(1.0, "1", 0.0, 2.0, "Factor on the slopes of the normal map.")
    gloss: float = number(
        0.35,
        "1",
        0.0,
        1.0,
        "Gloss of the first specular lobe, whose Blinn-Phong power is 2^(13 gloss).",
        "Lagarde2011",
    )
    reflectance: float = number(
        0.028,
        "1",
        0.0,
        0.2,
        "Specular reflectance at normal incidence; .028 for skin, whose refractive index is 1.4.",
    )
    shadow_filter_width_mm: float = number(
        8.0,
        "mm",
        1.0,
        100.0,
        "Width of the wide shadow filter, across the light.",
    )
    shadow_sharpening: float = number(
        8.0,
        "1",
        1.0,
        100.0,
        "Width of the wide shadow filter, divided by the width of the edge of a cast shadow.",
    )
    deep_scatter_strength: float = number(
        1.0,
        "1",
        0.0,
        10.0,
        "Factor on light that passes through the body; 1 is physically correct.",
    )
    deep_scatter_offset_mm: float = number(
        0.6,
        "mm",
        0.0,
        10.0,
        "Distance by which a point moves inwards before its depth is compared.",
    )
    deep_scatter_filter_mm: float = number(
        2.5, "mm", 0.0, 20.0, "Radius of the disk over which thickness is averaged."
    )
    deep_scatter_sigma_per_mm: tuple[float, float, float] = number(
        (0.0, 0.0, 0.0),
        "1/mm",
        0.0,
        50.0,
        "Decay of light that passes through the body; 0 means 1.2/rms radius.",
        "KubelkaMunk1931",
    )
    deep_scatter_tint: tuple[float, float, float] = number(
        (1.0, 1.0, 1.0),
        "1",
        0.0,
        1.0,
        "Colour of light that passes through the body, multiplied by the colour of its map.",
    )
    classic_deep_scatter_radius_mm: float = number(
        5.5,
        "mm",
        0.1,
        100.0,
        "Radius of the falloff of deep scatter in classic shading.",
        "Green2007",
    )

    specular: SpecularModel = choice(
        SpecularModel.GGX,
        SpecularModel,
        "Specular lobes; classic shading always has those of Blinn-Phong.",
    )
    boundary: Boundary | None = choice(
        None,
        Boundary,
        "Boundary through which scattered light leaves; by default, that of the profile.",
    )

    roughness: InitVar[float | None] = None

    def __post_init__(self, roughness: float | None) -> None:
        if roughness is not None:
            # Imported here because the help of the program reads the fields without NumPy.
            from .._core.arrays import as_floats
            from .gloss import gloss_from_roughness

            value = as_floats("roughness", roughness, (), low=0.0, high=1.0)
            object.__setattr__(self, "gloss", float(gloss_from_roughness(value)))
        checked_fields(self)

    def pack(self) -> bytes:
        """Return the bytes of ``SkinBlock`` in the layout of ``shading/generated/layout.json``."""
        from .packing import pack

        return pack("SkinBlock", self)
