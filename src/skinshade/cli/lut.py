"""``skinshade lut``: lookup tables as files."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from .._core.errors import ArgumentError
from ..lut import DiffusionGeometry, Lut, build_shadow_lut
from ..lut.classic import CLASSIC_DIFFUSION_RADIUS_MM, classic_curvature_lut, classic_shadow_lut
from ..profile import Profile
from ..shading.tables import build_curvature_lut
from .terminal import echo
from .values import check_output, parse_pair, parse_size

__all__ = ["app"]

app = typer.Typer(no_args_is_help=True)

LARGEST_RADIUS_MM = 1e6

Output = Annotated[
    Path,
    typer.Option(
        "--output",
        "-o",
        callback=check_output,
        help="File: .exr, .png (16 bits) or .npz.",
    ),
]
ProfileName = Annotated[
    str, typer.Option("--profile", help="Diffusion profile; see skinshade profile.")
]
Radius = Annotated[
    float,
    typer.Option(
        "--diffusion-radius-mm",
        help="Scale of the profile: 2.7 is human skin, 5.4 is twice as wide.",
    ),
]
Size = Annotated[str, typer.Option("--size", help="WIDTHxHEIGHT in texels.")]
Classic = Annotated[
    bool, typer.Option("--classic", help="Write the table of 2014, for comparison.")
]


@app.command("curvature")
def curvature_command(
    output: Output,
    profile: ProfileName = "skin-deon2007",
    diffusion_radius_mm: Radius = CLASSIC_DIFFUSION_RADIUS_MM,
    radius_mm: Annotated[
        str, typer.Option(help="Least and greatest radius of curvature, mm.")
    ] = "1,100",
    kernel: Annotated[
        DiffusionGeometry, typer.Option(help="Body over which light diffuses.")
    ] = DiffusionGeometry.SPHERE,
    energy_gain: Annotated[
        bool, typer.Option(help="Multiply by the energy gain of a curved body.")
    ] = True,
    size: Size = "512x512",
    classic: Classic = False,
) -> None:
    """Tabulate diffuse light over N·L (columns) and curvature (rows)."""
    scaled = _scaled_profile(profile, diffusion_radius_mm)
    radii, extent = parse_pair(radius_mm, "--radius-mm"), parse_size(size)
    if classic:
        table = classic_curvature_lut(scaled, size=extent, radius_mm=radii)
    else:
        table = build_curvature_lut(
            scaled, size=extent, radius_mm=radii, kernel=kernel, energy_gain=energy_gain
        )
    _save(table, output)


@app.command("shadow")
def shadow_command(
    output: Output,
    profile: ProfileName = "skin-deon2007",
    diffusion_radius_mm: Radius = CLASSIC_DIFFUSION_RADIUS_MM,
    width_mm: Annotated[
        str, typer.Option(help="Least and greatest width of the filter, mm.")
    ] = "8,100",
    sharpening: Annotated[
        float,
        typer.Option(help="Ratio of the width of the filter to the width of the shadow's edge."),
    ] = 10.0,
    size: Size = "512x512",
    classic: Classic = False,
) -> None:
    """Tabulate the shadow over the value of a wide filter (columns) and 1/width (rows)."""
    build = classic_shadow_lut if classic else build_shadow_lut
    table = build(
        _scaled_profile(profile, diffusion_radius_mm),
        size=parse_size(size),
        width_mm=parse_pair(width_mm, "--width-mm"),
        sharpening=sharpening,
    )
    _save(table, output)


def _scaled_profile(name: str, diffusion_radius_mm: float) -> Profile:
    if not 0.0 < diffusion_radius_mm <= LARGEST_RADIUS_MM:
        raise ArgumentError(
            f"--diffusion-radius-mm is {diffusion_radius_mm}; it must be above 0 and at most"
            f" {LARGEST_RADIUS_MM:g}"
        )
    return Profile.preset(name).scaled(diffusion_radius_mm / CLASSIC_DIFFUSION_RADIUS_MM)


def _save(table: Lut, output: Path) -> None:
    table.save(output)
    low, high = table.value_range
    height, width, _ = table.values.shape
    echo(f"{output}: {width}×{height}, values {low:.4f} to {high:.4f}")
