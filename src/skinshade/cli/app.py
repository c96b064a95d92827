"""The command ``skinshade``, and what becomes of errors: one line, an exit code, no traceback."""

from __future__ import annotations

import sys
import warnings

import typer

from .._core.errors import SkinshadeError, UnitWarning
from .._core.version import __version__
from . import assets, bake, doctor, lut, profile, render, shaders

__all__ = ["app", "main"]

app = typer.Typer(
    name="skinshade",
    help="Film-like skin for any renderer.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)
app.command("render")(render.render_command)
app.command("bake")(bake.bake_command)
app.command("profile")(profile.profile_command)
app.add_typer(lut.app, name="lut")
app.add_typer(shaders.app, name="shaders")
app.add_typer(assets.app, name="assets")
app.command("doctor")(doctor.doctor_command)


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"skinshade {__version__}")
        raise typer.Exit


@app.callback()
def _options(
    version: bool = typer.Option(
        False, "--version", callback=_version, is_eager=True, help="Print the version."
    ),
) -> None:
    """Film-like skin for any renderer."""


def main() -> None:
    """Run the command line; exit 0 done, 2 the input is at fault, 1 anything else."""
    warnings.showwarning = _show_warning  # type: ignore[assignment]  # ours takes any further arguments
    try:
        app()
    except SkinshadeError as error:
        _complain(str(error))
        sys.exit(error.exit_code)
    except KeyboardInterrupt:
        _complain("interrupted")
        sys.exit(1)
    except MemoryError:
        _complain("out of memory; a smaller --size or fewer --samples need less")
        sys.exit(1)
    except Exception as error:
        _complain(f"internal error: {type(error).__name__}: {error}")
        sys.exit(1)


def _complain(message: str) -> None:
    typer.echo(f"skinshade: error: {message}", err=True)


def _show_warning(message: Warning | str, category: type[Warning], *_: object) -> None:
    if issubclass(category, UnitWarning):
        typer.echo(f"skinshade: warning: {message}", err=True)
