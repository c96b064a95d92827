"""``skinshade bake``: models with curvature, shape operator and thickness at their vertices."""

from __future__ import annotations

import os
import sys
from dataclasses import dataclass
from pathlib import Path
from time import monotonic
from typing import Annotated

import typer

from .._core.errors import ArgumentError, InputError, OutputError
from .._core.units import parse_unit_mm
from ..baking import BakeSettings, bake
from ..baking.jobs import JobResult, plan_jobs, status_counts
from ..baking.library import bake_library
from ..baking.settings import MapFormat, OutputFormat
from ..mesh.axes import UpAxis
from ..mesh.rays import RayTracing
from ..mesh.readers import SUFFIXES
from .limits import LimitOptions
from .options import expand_options
from .progress import has_bar, terminal_progress
from .terminal import echo, printable
from .values import check_output

__all__ = ["bake_command"]

REPORT, PAGE = "skinshade-bake.json", "skinshade-bake.html"


@dataclass(frozen=True)
class AnalysisOptions:
    """Analysis of the meshes."""

    unit_mm: Annotated[
        str | None,
        typer.Option(
            help="Unit of the models: a length in mm, or mm, cm, m, in or ft. glTF is in metres."
        ),
    ] = None
    up: Annotated[
        UpAxis, typer.Option(help="Up axis of OBJ, PLY and STL models; the output has y up.")
    ] = UpAxis.Y
    tensor: Annotated[
        bool, typer.Option("--tensor", help="Also bake the shape operator, for the tensor tier.")
    ] = False
    thickness: Annotated[bool, typer.Option("--thickness", help="Also bake the thickness, mm.")] = (
        False
    )
    ambient_transfer: Annotated[
        bool,
        typer.Option(
            "--ambient-transfer",
            help="Also bake occlusion, bounces and diffusion of the sky's light, as nine harmonics.",
        ),
    ] = False
    profile: Annotated[
        str, typer.Option(help="Diffusion profile; its name is written to the file.")
    ] = "skin-deon2007"
    smoothing: Annotated[int, typer.Option(help="Smoothing passes over the curvature, 0..100.")] = 2
    rays: Annotated[int, typer.Option(help="Rays at every vertex for the thickness, 1..4096.")] = 64
    tracing: Annotated[
        RayTracing,
        typer.Option(help="Ray caster; auto is the compiled one, else Embree if installed."),
    ] = RayTracing.AUTO
    map_size: Annotated[
        int,
        typer.Option(
            "--maps",
            help="Also write texture maps beside the model; number of texels along a side.",
        ),
    ] = 0
    map_format: Annotated[MapFormat, typer.Option(help="Format of the maps.")] = MapFormat.EXR

    def settings(self) -> BakeSettings:
        """Return the settings that the options describe.

        Raises
        ------
        ArgumentError
            If a value is out of range.
        """
        return BakeSettings(
            unit_mm=None if self.unit_mm is None else parse_unit_mm(self.unit_mm),
            up=self.up,
            tensor=self.tensor,
            thickness=self.thickness,
            ambient_transfer=self.ambient_transfer,
            profile=self.profile,
            smoothing=self.smoothing,
            rays=self.rays,
            tracing=self.tracing,
            map_size=self.map_size,
            map_format=self.map_format,
        )


@dataclass(frozen=True)
class LibraryOptions:
    """Several models."""

    suffix: Annotated[
        OutputFormat | None,
        typer.Option(
            "--format", help="Format of the outputs; by default, glTF files keep their format."
        ),
    ] = None
    report: Annotated[
        bool, typer.Option("--report", help="Also write a page with thumbnails and histograms.")
    ] = False
    jobs: Annotated[int, typer.Option(help="Number of processes, 1..1024.")] = 1
    cluster: Annotated[
        str | None,
        typer.Option(help="Address of a Dask scheduler, tcp://…, instead of processes."),
    ] = None


@expand_options
def bake_command(
    *,
    sources: Annotated[
        list[Path], typer.Argument(help="GLB, glTF, OBJ, PLY or STL files, or folders of them.")
    ],
    output: Annotated[
        Path | None,
        typer.Option(
            "--output",
            "-o",
            callback=check_output,
            help="File for one model, or folder for several models.",
        ),
    ] = None,
    in_place: Annotated[
        bool,
        typer.Option("--in-place", help="Replace the model by its baked copy; one GLB or glTF."),
    ] = False,
    analysis: AnalysisOptions,
    library: LibraryOptions,
    limits: LimitOptions,
) -> None:
    """Write copies of models that have curvature, and on request thickness, at their vertices."""
    settings = analysis.settings()
    with limits.in_force():
        if in_place:
            _bake_in_place(sources, output, settings)
        elif output is None:
            raise ArgumentError("--output is missing; give it, or --in-place")
        elif _is_single(sources, output, library):
            _bake_one(sources[0], output, settings)
        else:
            _bake_many(sources, output, settings, library)


def _is_single(sources: list[Path], output: Path, library: LibraryOptions) -> bool:
    """Return whether the output is one file for one model; otherwise it is a folder."""
    if len(sources) != 1 or sources[0].is_dir() or library.report:
        return False
    return output.suffix != "" and not output.is_dir()


def _bake_in_place(sources: list[Path], output: Path | None, settings: BakeSettings) -> None:
    if len(sources) != 1 or sources[0].is_dir():
        raise ArgumentError("--in-place needs one model")
    if output is not None and not (output.exists() and output.samefile(sources[0])):
        raise ArgumentError(f"--in-place replaces {sources[0]}; {output} is another file")
    _bake_one(sources[0], sources[0], settings, in_place=True)


def _bake_one(
    source: Path, output: Path, settings: BakeSettings, *, in_place: bool = False
) -> None:
    with terminal_progress() as progress:
        baked = bake(source, output, settings, in_place=in_place, progress=progress)
    for mesh in baked.meshes:
        curvature = mesh.analysis.attributes["curvature"]
        notes = "".join(f"; {count} {note}" for note, count in mesh.all_notes.items())
        echo(
            f"{output}: mesh {mesh.name}, one unit is {mesh.mesh.unit_mm:g} mm, curvature"
            f" {curvature.min():.3f} to {curvature.max():.3f} per mm{notes}"
        )


def _bake_many(
    sources: list[Path], output: Path, settings: BakeSettings, library: LibraryOptions
) -> None:
    _check_folder(output)
    jobs = plan_jobs(sources, output, settings, library.suffix, with_thumbnails=library.report)
    _create_folder(output)
    start = monotonic()
    with terminal_progress() as progress:
        results = bake_library(
            jobs,
            workers=library.jobs,
            cluster=library.cluster,
            progress=progress,
            report=_print_result,
        )
    seconds = monotonic() - start
    from ..baking.report import write_page, write_report  # imports the renderer, which costs .2 s

    write_report(jobs, results, output / REPORT)
    if library.report:
        write_page(jobs, results, output / PAGE, seconds=seconds)
        echo(f"{output / PAGE}: open it in a browser")
    counts = status_counts(results)
    summary = ", ".join(f"{number} {status}" for status, number in counts.items())
    echo(f"{output}: {summary}; {output / REPORT}")
    if counts["failed"]:
        raise InputError(f"{counts['failed']} of {len(results)} models failed")


def _check_folder(output: Path) -> None:
    if output.is_dir():
        return
    if output.exists():
        raise OutputError(f"{output}: is a file; several models need a folder")
    if output.suffix.lower() in {*SUFFIXES, *(f".{name}" for name in OutputFormat)}:
        raise OutputError(
            f"{output}: is the name of a file; a folder of models, several models and --report need"
            " the name of a folder"
        )


def _create_folder(output: Path) -> None:
    try:
        output.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OutputError(f"{output}: cannot create this folder ({error.strerror})") from None
    if not os.access(output, os.W_OK | os.X_OK):
        raise OutputError(f"{output}: no permission to write into this folder")


def _print_result(result: JobResult) -> None:
    """Print the result of a model in one line, except of a valid one if a terminal shows a bar."""
    name = printable(result.source)
    if result.status == "failed":
        reason = result.error.removeprefix(f"{result.source}: ")
        echo(f"{name}: failed: {printable(reason)}", err=True)
    elif not (has_bar() and sys.stdout is not None and sys.stdout.isatty()):
        echo(f"{name}: {result.status}")
    for text in result.warnings:
        echo(f"skinshade: warning: {name}: {printable(text)}", err=True)
