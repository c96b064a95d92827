"""Options of a picture: lighting model, sampling and output."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

import typer

from ..params.choices import Antialiasing, Shading, ShadowFilter, Tier, View

if TYPE_CHECKING:
    from ..rendering.settings import RenderSettings

__all__ = ["ShadingOptions"]


@dataclass(frozen=True)
class ShadingOptions:
    """Lighting model and sampling."""

    shading: Annotated[
        Shading,
        typer.Option(help="Lighting model: classic is that of 2014, lambert has no scattering."),
    ] = Shading.TRANSFER
    no_sss: Annotated[bool, typer.Option("--no-sss", help="Same as --shading lambert.")] = False
    tier: Annotated[
        Tier, typer.Option(help="Geometry of the diffusion; only for --shading transfer.")
    ] = Tier.DIFFUSED_NORMALS
    deep_scatter_taps: Annotated[
        int,
        typer.Option(help="Taps of deep scatter, the light through thin parts: 0 (off), 8 or 32."),
    ] = 8
    normal_fetches: Annotated[
        int,
        typer.Option(
            help="Fetches of the normal map: 3 (sharp, two blurs) or 2 (sharp, one blur)."
        ),
    ] = 3
    shadow_filter: Annotated[ShadowFilter, typer.Option(help="Form of the wide shadow filter.")] = (
        ShadowFilter.PERCENTAGE_CLOSER
    )
    no_contact_shadow: Annotated[
        bool,
        typer.Option("--no-contact-shadow", help="Lids, nostril rims and lips cast no shadow."),
    ] = False
    antialiasing: Annotated[
        Antialiasing,
        typer.Option(
            help="With multisampling, a GPU shades once per pixel and finds edges from 4 samples."
        ),
    ] = Antialiasing.SUPERSAMPLING
    debug_view: Annotated[
        View, typer.Option(help="Show a property of the surface or a term of the light.")
    ] = View.PICTURE
    seed: Annotated[
        int, typer.Option(help="Seed of the sample positions; equal seeds give equal pictures.")
    ] = 0

    def settings(self) -> RenderSettings:
        """Return the settings that the options describe.

        Raises
        ------
        ArgumentError
            If a value is out of range.
        """
        # Imported here because the help of the program does without NumPy.
        from ..rendering.settings import RenderSettings

        return RenderSettings(
            shading=Shading.LAMBERT if self.no_sss else self.shading,
            tier=self.tier,
            deep_scatter_taps=self.deep_scatter_taps,
            normal_fetches=self.normal_fetches,
            shadow_filter=self.shadow_filter,
            contact_shadow=not self.no_contact_shadow,
            antialiasing=self.antialiasing,
            debug_view=self.debug_view,
            seed=self.seed,
        )
