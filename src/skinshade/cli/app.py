"""Command line program ``skinshade``: commands, error messages and exit codes."""

from __future__ import annotations

import sys
import warnings
from importlib import import_module
from typing import Annotated, NamedTuple

import typer

from .._core.errors import SkinshadeError, SkinshadeWarning
from .._core.version import __version__

__all__ = ["command_line", "main"]


class Entry(NamedTuple):
    """Command: its module, its function (or group ``app``), and its help."""

    module: str
    name: str
    help: str


COMMANDS = {
    "render": Entry(".render", "render_command", "Draw a head, as PNG or EXR."),
    "bake": Entry(
        ".bake",
        "bake_command",
        "Write copies of models that have curvature, and on request thickness, at their vertices.",
    ),
    "profile": Entry(
        ".profile",
        "profile_command",
        "List the diffusion profiles, print the numbers of one, or plot it.",
    ),
    "lut": Entry(".lut", "app", "Write a lookup table."),
    "shaders": Entry(".shaders", "app", "Write the shader package for an engine."),
    "assets": Entry(".assets", "app", "List and download public scans of heads."),
    "doctor": Entry(".doctor", "doctor_command", "Print versions, cores and backends."),
}


def command_line(*imported: str) -> typer.Typer:
    """Return the program. Commands that are not `imported` have a help text only.

    The modules of commands import NumPy and SciPy. The list of commands appears without these imports.
    """
    app = typer.Typer(
        name="skinshade",
        help="Film-like skin for any renderer.",
        no_args_is_help=True,
        add_completion=False,
        pretty_exceptions_enable=False,
    )
    app.callback()(_options)
    for command, entry in COMMANDS.items():
        if command not in imported:
            app.command(command, help=entry.help)(_placeholder)
            continue
        target = getattr(import_module(entry.module, __package__), entry.name)
        if isinstance(target, typer.Typer):
            app.add_typer(target, name=command, help=entry.help)
        else:
            app.command(command, help=entry.help)(target)
    return app


def main() -> None:
    """Run the program. Exit codes: 0 success, 2 faulty input or request, 1 any other error."""
    warnings.showwarning = _show_warning  # type: ignore[assignment]  # accepts any further arguments
    requested = next((word for word in sys.argv[1:] if not word.startswith("-")), "")
    try:
        command_line(requested)()
    except SkinshadeError as error:
        _show_error(str(error))
        sys.exit(error.exit_code)
    except KeyboardInterrupt:
        _show_error("interrupted")
        sys.exit(1)
    except MemoryError:
        _show_error("out of memory; a smaller --size or fewer --samples need less")
        sys.exit(1)
    except Exception as error:
        _show_error(f"internal error: {type(error).__name__}: {error}")
        sys.exit(1)


def _show_version(requested: bool) -> None:
    if requested:
        typer.echo(f"skinshade {__version__}")
        raise typer.Exit


def _options(
    version: Annotated[
        bool,
        typer.Option("--version", callback=_show_version, is_eager=True, help="Print the version."),
    ] = False,
) -> None:
    """Film-like skin for any renderer."""


def _placeholder() -> None:
    """Serve as the function of commands that are not imported; it never runs."""


def _show_error(message: str) -> None:
    typer.echo(f"skinshade: error: {message}", err=True)


def _show_warning(message: Warning | str, category: type[Warning], *_: object) -> None:
    if issubclass(category, SkinshadeWarning):
        typer.echo(f"skinshade: warning: {message}", err=True)
