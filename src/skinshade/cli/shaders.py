"""``skinshade shaders``: the shader package for engines."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from ..params import SkinParams
from ..profile import Profile
from ..sdk import LANGUAGES, Language, export_shaders
from .progress import terminal_progress
from .terminal import echo
from .values import check_output

__all__ = ["app"]

app = typer.Typer(no_args_is_help=True)

DEFAULTS = SkinParams()


@app.command("export")
def export_command(
    language: Annotated[Language, typer.Option(help="Shading language.")],
    output: Annotated[
        Path,
        typer.Option(
            "--output",
            "-o",
            callback=check_output,
            help="Folder; it is created if it does not exist.",
        ),
    ],
    profile: Annotated[
        str, typer.Option(help="Diffusion profile; see skinshade profile.")
    ] = "skin-deon2007",
    scatter_scale: Annotated[
        float, typer.Option(help="Factor of every length of the profile.")
    ] = DEFAULTS.scatter_scale,
    shadow_filter_width_mm: Annotated[
        float, typer.Option(help="Width of the wide shadow filter across the light.")
    ] = DEFAULTS.shadow_filter_width_mm,
    shadow_sharpening: Annotated[
        float,
        typer.Option(help="Ratio of the width of the filter to the width of the shadow's edge."),
    ] = DEFAULTS.shadow_sharpening,
) -> None:
    """Write functions, constant blocks, tables, a C header and a guide into a folder."""
    params = SkinParams(
        scatter_scale=scatter_scale,
        shadow_filter_width_mm=shadow_filter_width_mm,
        shadow_sharpening=shadow_sharpening,
    )
    with terminal_progress() as progress:
        paths = export_shaders(
            language, output, profile=Profile.preset(profile), params=params, progress=progress
        )
    echo(f"{output}: {len(paths)} files for {LANGUAGES[language].title}; begin with README.md")
