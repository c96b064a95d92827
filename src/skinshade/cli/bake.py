"""``skinshade bake``: curvature, thickness and scale into a studio's own files."""

from __future__ import annotations

from pathlib import Path

import typer

from .._core.errors import ArgumentError, InputError, OutputError
from .._core.units import parse_unit_mm
from ..bake import BakeSettings, bake
from ..bake.jobs import JobResult, counted, plan
from ..bake.library import bake_library, write_report
from ..bake.report import write_page
from .progress import terminal_progress

__all__ = ["bake_command"]

REPORT, PAGE = "skinshade-bake.json", "skinshade-bake.html"


def bake_command(
    sources: list[Path] = typer.Argument(..., help="GLB, glTF, OBJ, PLY, STL, or folders of them."),
    output: Path = typer.Option(
        ..., "--output", "-o", help="File for one model, or folder for any number."
    ),
    unit_mm: str = typer.Option(
        None, help="Length of the models' unit in mm, or mm, cm, m, in, ft; glTF's is the metre."
    ),
    tensor: bool = typer.Option(
        False, "--tensor", help="The shape operator too, for skin that bends one way."
    ),
    thickness: bool = typer.Option(False, "--thickness", help="Thickness in mm too."),
    profile: str = typer.Option("skin-deon2007", help="Diffusion profile that is noted."),
    smoothing: int = typer.Option(2, help="Passes over the curvature, 0..100."),
    rays: int = typer.Option(64, help="Of thickness at each vertex, 1..4096."),
    tracing: str = typer.Option("auto", help="embree, builtin, or auto."),
    map_size: int = typer.Option(
        0, "--maps", help="Write texture maps of this many texels a side beside the model."
    ),
    map_format: str = typer.Option("exr", help="Of the maps: exr, or png of 16 bits."),
    suffix: str = typer.Option(
        None, "--format", help="glb, ply, usda or usdc; a folder's glTF files stay what they are."
    ),
    report: bool = typer.Option(
        False, "--report", help="Write a page with thumbnails and histograms too."
    ),
    jobs: int = typer.Option(1, help="Processes."),
    cluster: str = typer.Option(
        None, help="Address of a Dask scheduler, tcp://…, instead of processes."
    ),
) -> None:
    """Write models again with curvature, and thickness, at their vertices; all else stays."""
    settings = BakeSettings(
        unit_mm=None if unit_mm is None else parse_unit_mm(unit_mm),
        tensor=tensor,
        thickness=thickness,
        profile=profile,
        smoothing=smoothing,
        rays=rays,
        tracing=tracing,  # type: ignore[arg-type]  # checked by the class
        map_size=map_size,
        map_format=map_format,  # type: ignore[arg-type]  # checked by the class
    )
    if suffix is not None and suffix not in ("glb", "ply", "usda", "usdc"):
        raise ArgumentError(f"--format is {suffix!r}; it must be glb, ply, usda or usdc")
    one = (
        len(sources) == 1
        and not sources[0].is_dir()
        and output.suffix != ""
        and not output.is_dir()
        and not report
    )
    if one:
        _bake_one(sources[0], output, settings)
        return
    if output.exists() and not output.is_dir():
        raise OutputError(f"{output}: is a file; several models need a folder")
    missing = [each for each in sources if not each.exists()]
    if missing:
        raise ArgumentError(f"{missing[0]}: no such file or folder")
    ending = None if suffix is None else f".{suffix}"
    planned = plan(sources, output, settings, ending, pictured=report)
    with terminal_progress() as progress:
        results = bake_library(planned, workers=jobs, cluster=cluster, progress=progress)
    output.mkdir(parents=True, exist_ok=True)
    write_report(results, output / REPORT)
    if report:
        write_page(planned, results, output / PAGE)
        typer.echo(f"{output / PAGE}: open it in a browser")
    _tell(results, output)


def _bake_one(source: Path, output: Path, settings: BakeSettings) -> None:
    with terminal_progress() as progress:
        baked = bake(source, output, settings, progress=progress)
    for mesh in baked.meshes:
        curvature = mesh.analysed.attributes["curvature"]
        notes = {**mesh.notes, **mesh.analysed.notes}
        said = "".join(f"; {count} {what}" for what, count in notes.items())
        typer.echo(
            f"{output}: mesh {mesh.name}, one unit is {mesh.unit_mm:g} mm, curvature"
            f" {curvature.min():.3f} to {curvature.max():.3f} per mm{said}"
        )


def _tell(results: list[JobResult], output: Path) -> None:
    for each in results:
        if each.status == "failed":
            typer.echo(f"skinshade: error: {each.error}", err=True)
    count = counted(results)
    said = ", ".join(f"{number} {status}" for status, number in count.items())
    typer.echo(f"{output}: {said}; {output / REPORT}")
    if count["failed"]:
        raise InputError(f"{count['failed']} of {len(results)} models failed")
