"""``skinshade render``: pictures of a head."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from .._core.choice import Choice
from ..params.choices import AmbientForm
from ..rendering.choices import Backend
from .limits import LimitOptions
from .options import expand_options
from .picture import ShadingOptions
from .scene_options import LightOptions, MaterialOptions, ModelOptions
from .terminal import echo
from .values import check_output

__all__ = ["render_command"]


class TimingForm(Choice):
    """Form of the report of pass times."""

    TABLE = "table"
    JSON = "json"


@expand_options
def render_command(
    *,
    model: ModelOptions,
    output: Annotated[
        Path,
        typer.Option(
            "--output", "-o", callback=check_output, help="PNG, or EXR with linear light."
        ),
    ] = Path("skin.png"),
    size: Annotated[
        str, typer.Option(help="WIDTHxHEIGHT in pixels; with --compare, of every picture.")
    ] = "1280x720",
    samples: Annotated[int, typer.Option(help="Samples per pixel, 1..256.")] = 4,
    backend: Annotated[
        Backend,
        typer.Option(
            help="gpu also accepts software drivers; auto is a hardware GPU, else the CPU."
        ),
    ] = Backend.AUTO,
    adapter: Annotated[
        str | None, typer.Option(help="Part of the GPU's name; see skinshade doctor.")
    ] = None,
    ambient: Annotated[
        AmbientForm,
        typer.Option(help="Ambient light at the vertices: of the sky, or of its harmonics."),
    ] = AmbientForm.STATIC,
    compare: Annotated[
        str | None,
        typer.Option(help="Pictures side by side, such as lambert,classic,transfer,transfer+deep."),
    ] = None,
    turntable: Annotated[
        int, typer.Option(help="Number of frames of a turn around the head; every frame is a file.")
    ] = 0,
    timings: Annotated[
        TimingForm | None, typer.Option(help="Report the time of every pass on the GPU.")
    ] = None,
    shading: ShadingOptions,
    light: LightOptions,
    material: MaterialOptions,
    limits: LimitOptions,
) -> None:
    """Draw a head, as PNG or EXR."""
    from .draw import (
        Request,
        draw_pictures,
    )  # NumPy and the renderer cost .5 s, and the help needs neither

    request = Request(output, size, samples, backend, adapter, ambient, compare, turntable)
    with limits.in_force() as most:
        renderer = draw_pictures(request, most, shading, model, material, light)
        if timings is not None:
            from .timings import timing_report

            echo(timing_report(renderer, as_json=timings == TimingForm.JSON))
