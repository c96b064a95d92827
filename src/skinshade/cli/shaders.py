"""``skinshade shaders``: the shader library for engines."""

from __future__ import annotations

from pathlib import Path

import typer

from ..params import SkinParams
from ..profile import Profile
from ..sdk import LANGUAGES, export_shaders
from .progress import terminal_progress

__all__ = ["app"]

app = typer.Typer(help="The shader library for engines.", no_args_is_help=True)

DEFAULTS = SkinParams()


@app.command("export")
def export_command(
    language: str = typer.Option(..., help=f"One of {', '.join(LANGUAGES)}."),
    output: Path = typer.Option(..., "--output", "-o", help="Folder; made if it is not there."),
    profile: str = typer.Option("skin-deon2007", help="Diffusion profile; see skinshade profile."),
    scatter_scale: float = typer.Option(
        DEFAULTS.scatter_scale, help="Multiplies every length of the profile."
    ),
    shadow_filter_width_mm: float = typer.Option(
        DEFAULTS.shadow_filter_width_mm, help="Width across the light of the wide shadow filter."
    ),
    shadow_sharpening: float = typer.Option(
        DEFAULTS.shadow_sharpening, help="How much narrower than the filter the shadow's edge is."
    ),
) -> None:
    """Write functions, constant blocks, tables, a C header and a guide into a folder."""
    params = SkinParams(
        scatter_scale=scatter_scale,
        shadow_filter_width_mm=shadow_filter_width_mm,
        shadow_sharpening=shadow_sharpening,
    )
    with terminal_progress() as progress:
        written = export_shaders(
            language, output, profile=Profile.preset(profile), params=params, progress=progress
        )
    typer.echo(
        f"{output}: {len(written)} files for {LANGUAGES[language].title}; begin with README.md"
    )
