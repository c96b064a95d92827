"""Settings of a picture, and their ranges."""

from __future__ import annotations

from dataclasses import dataclass

from .._core.choice import Choice
from .._core.errors import ArgumentError
from .._core.limits import limit_range, limits
from ..params.choices import Antialiasing, Shading, ShadowFilter, Tier, View
from ..shading.deep_scatter import THICKNESS_TAPS
from .choices import Backend

__all__ = [
    "CURVATURE_RANGE_PER_MM",
    "MULTISAMPLES",
    "NORMAL_FETCHES",
    "TAP_COUNTS",
    "THICKNESS_RANGE_MM",
    "Backend",
    "RenderSettings",
    "check_size",
]

TAP_COUNTS = (0, *THICKNESS_TAPS)
"""Allowed numbers of thickness taps; 0 turns deep scatter off."""
NORMAL_FETCHES = (2, 3)
"""Allowed numbers of fetches of the normal map."""
MULTISAMPLES = 4
"""Samples per pixel with multisampling."""
CURVATURE_RANGE_PER_MM = 0.2
"""Curvature at the ends of the colour range of `View.CURVATURE`, 1/mm."""
THICKNESS_RANGE_MM = 30.0
"""Thickness that `View.THICKNESS` shows as white, mm."""


@dataclass(frozen=True)
class RenderSettings:
    """Settings of a picture. Fields of an enumeration also accept the text of a member.

    Attributes
    ----------
    shading
        Lighting model: ``transfer`` (default), ``classic`` (2014) or ``lambert`` (no scattering).
    tier
        Geometry that ``transfer`` uses: ``scalar``, ``tensor`` or ``diffused-normals`` (default).
    deep_scatter_taps
        Taps that measure the thickness of thin parts for deep scatter: 0 (off), 8 (default) or 32.
    normal_fetches
        Fetches of the normal map: 3 (sharp and two blurs, default) or 2 (sharp and one blur).
    shadow_filter
        Form of the wide shadow filter: ``percentage-closer`` (default) or ``variance``, of equal width.
    contact_shadow
        Whether lids, nostril rims and lips cast a narrow shadow next to themselves (default). The formulas
        of 2014, ``classic``, have none.
    antialiasing
        ``supersampling`` (default) shades every sample. With ``multisampling``, a GPU shades once per
        pixel, filters maps along the pixel's footprint and finds edges from 4 samples, regardless of the
        number of samples that is requested; the CPU shades every sample.
    debug_view
        ``picture`` (default), or a property of the surface or a term of the light, see `View`. Curvature
        is blue where concave and red where convex, with full colour at ±0.2/mm; thickness is white at
        30 mm.
    seed
        Seed of the sample positions within the pixels, ≥ 0.

    Examples
    --------
    >>> import skinshade as sk
    >>> sk.RenderSettings(shading="classic").shading
    <Shading.CLASSIC: 'classic'>
    """

    shading: Shading = Shading.TRANSFER
    tier: Tier = Tier.DIFFUSED_NORMALS
    deep_scatter_taps: int = 8
    normal_fetches: int = 3
    shadow_filter: ShadowFilter = ShadowFilter.PERCENTAGE_CLOSER
    contact_shadow: bool = True
    antialiasing: Antialiasing = Antialiasing.SUPERSAMPLING
    debug_view: View = View.PICTURE
    seed: int = 0

    def __post_init__(self) -> None:
        choices: dict[str, type[Choice]] = {
            "shading": Shading,
            "tier": Tier,
            "shadow_filter": ShadowFilter,
            "antialiasing": Antialiasing,
            "debug_view": View,
        }
        for name, kind in choices.items():
            object.__setattr__(self, name, kind.of(getattr(self, name), name))
        for name, counts in (
            ("deep_scatter_taps", TAP_COUNTS),
            ("normal_fetches", NORMAL_FETCHES),
        ):
            value = getattr(self, name)
            if value not in counts:
                allowed = ", ".join(map(str, counts))
                raise ArgumentError(f"{name} is {value!r}; it must be one of {allowed}")
        if self.seed < 0:
            raise ArgumentError(f"seed is {self.seed}; it must not be negative")

    @property
    def thickness_taps(self) -> int:
        """Number of thickness taps in effect; 0 for ``lambert``, which has no deep scatter."""
        return 0 if self.shading == Shading.LAMBERT else self.deep_scatter_taps

    @property
    def has_contact(self) -> bool:
        """Whether the contact shadow is in effect; ``classic`` has none."""
        return self.contact_shadow and self.shading != Shading.CLASSIC

    @property
    def luts(self) -> tuple[str, ...]:
        """Names of the lookup tables that these settings read, besides that of a material's coat."""
        if self.shading == Shading.LAMBERT:
            return ()
        if self.shading == Shading.CLASSIC:
            return ("classic", "classic_shadow")
        return ("transfer", "shadow", "sphere" if self.tier == Tier.SCALAR else "ring")


def check_size(size: tuple[int, int], samples: int) -> None:
    """Raise if a picture of this size and number of samples per pixel cannot be drawn.

    Raises
    ------
    ArgumentError
        If a side is not 1..16384 pixels, or the number of samples is not 1..256: the limits
        ``picture_side`` and ``samples`` of `skinshade.Limits`.
    """
    width, height = size
    if not 1 <= min(width, height) <= max(width, height) <= limits().picture_side:
        allowed = limit_range("picture_side", 1, max(width, height))
        raise ArgumentError(f"size is {width}×{height}; each side must be {allowed}")
    if not 1 <= samples <= limits().samples:
        allowed = limit_range("samples", 1, samples)
        raise ArgumentError(f"samples is {samples}; it must be {allowed} per pixel")
