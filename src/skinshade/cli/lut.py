"""``skinshade lut``: write the lookup tables."""

from __future__ import annotations

from pathlib import Path

import typer

from .._core.errors import ArgumentError
from ..lut import Lut, build_curvature_lut, build_shadow_lut
from ..lut.classic import CLASSIC_DIFFUSION_RADIUS_MM, classic_curvature_lut, classic_shadow_lut
from ..profile import Profile
from .parse import pair, size

__all__ = ["app"]

app = typer.Typer(help="Write a lookup table.", no_args_is_help=True)

LARGEST_RADIUS_MM = 1e6

OUTPUT = typer.Option(..., "--output", "-o", help="File: .exr, .png (16 bits) or .npz.")
PROFILE = typer.Option(
    "skin-deon2007", "--profile", help="Diffusion profile; see skinshade profile."
)
RADIUS = typer.Option(
    CLASSIC_DIFFUSION_RADIUS_MM,
    "--diffusion-radius-mm",
    help="Scales the profile: 2.7 is human skin as it is, 5.4 twice as wide.",
)
SIZE = typer.Option("512x512", "--size", help="WIDTHxHEIGHT in texels.")
CLASSIC = typer.Option(False, "--classic", help="The table of 2014, for comparison.")


@app.command("curvature")
def curvature_command(
    output: Path = OUTPUT,
    profile: str = PROFILE,
    diffusion_radius_mm: float = RADIUS,
    radius_mm: str = typer.Option("1,100", help="Least and greatest radius of curvature, mm."),
    kernel: str = typer.Option("sphere", help="sphere or ring."),
    energy_gain: bool = typer.Option(True, help="Multiply by the energy gain of a curved body."),
    texels: str = SIZE,
    classic: bool = CLASSIC,
) -> None:
    """Diffuse light over N·L (columns) and curvature (rows)."""
    scaled = _scaled(profile, diffusion_radius_mm)
    radii, extent = pair(radius_mm, "--radius-mm"), size(texels)
    if classic:
        table = classic_curvature_lut(scaled, size=extent, radius_mm=radii)
    elif kernel in ("sphere", "ring"):
        table = build_curvature_lut(
            scaled,
            size=extent,
            radius_mm=radii,
            kernel="sphere" if kernel == "sphere" else "ring",
            energy_gain=energy_gain,
        )
    else:
        raise ArgumentError(f"--kernel is {kernel!r}; it must be sphere or ring")
    _write(table, output)


@app.command("shadow")
def shadow_command(
    output: Path = OUTPUT,
    profile: str = PROFILE,
    diffusion_radius_mm: float = RADIUS,
    width_mm: str = typer.Option("8,100", help="Least and greatest width of the filter, mm."),
    sharpening: float = typer.Option(10.0, help="How much narrower than the filter the edge is."),
    texels: str = SIZE,
    classic: bool = CLASSIC,
) -> None:
    """Shadow over the value of a wide filter (columns) and 1/width (rows)."""
    scaled = _scaled(profile, diffusion_radius_mm)
    build = classic_shadow_lut if classic else build_shadow_lut
    widths = pair(width_mm, "--width-mm")
    _write(build(scaled, size=size(texels), width_mm=widths, sharpening=sharpening), output)


def _scaled(profile: str, diffusion_radius_mm: float) -> Profile:
    if not 0.0 < diffusion_radius_mm <= LARGEST_RADIUS_MM:
        raise ArgumentError(
            f"--diffusion-radius-mm is {diffusion_radius_mm}; it must be positive, "
            f"{LARGEST_RADIUS_MM:g} at most"
        )
    return Profile.preset(profile).scaled(diffusion_radius_mm / CLASSIC_DIFFUSION_RADIUS_MM)


def _write(table: Lut, output: Path) -> None:
    table.save(output)
    low, high = table.value_range
    height, width, _ = table.values.shape
    typer.echo(f"{output}: {width}×{height}, values {low:.4f} to {high:.4f}")
