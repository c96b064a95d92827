"""Command line program ``skinshade``: commands, error messages and exit codes."""

from __future__ import annotations

import os
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from typing import Annotated, Any, NamedTuple, NoReturn

import typer
from typer.core import TyperGroup

from .._core.errors import SkinshadeError, SkinshadeWarning
from .._core.version import __version__
from .signals import is_interrupted, raise_at_next
from .terminal import drop_unwritable, echo, printable

__all__ = ["command_line", "run"]


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


class Program(TyperGroup):
    """Commands whose usage errors have escapes for control codes in their arguments."""

    def make_context(self, *arguments: Any, **options: Any) -> Any:
        """Parse the arguments of the program."""
        with _printable_errors():
            return super().make_context(*arguments, **options)

    def invoke(self, ctx: Any) -> Any:
        """Parse the arguments of the command, and run it."""
        with _printable_errors():
            return super().invoke(ctx)


@contextmanager
def _printable_errors() -> Iterator[None]:
    try:
        yield
    except Exception as error:
        # Errors of the parser have their text in this attribute.
        if isinstance(message := getattr(error, "message", None), str):
            vars(error)["message"] = printable(message)
        raise


def command_line(*imported: str, with_help: bool = True) -> typer.Typer:
    """Return the program. Commands that are not `imported` have a help text only.

    The modules of commands import NumPy and SciPy. The list of commands appears without these imports.

    Parameters
    ----------
    imported
        Names of commands.
    with_help
        Whether the program has the option ``--help`` in front of a command. Where it is not given, Typer
        reads its value with pydantic, which takes .1 s.
    """
    app = typer.Typer(
        name="skinshade",
        cls=Program,
        help="Film-like skin for any renderer.",
        no_args_is_help=True,
        add_help_option=with_help,
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


def run() -> None:
    """Run the command that the arguments name, and exit.

    Exit codes: 0 success, 2 faulty input or request, 1 any other error.
    """
    warnings.showwarning = _show_warning  # type: ignore[assignment]  # accepts any further arguments
    requested = next((word for word in sys.argv[1:] if not word.startswith("-")), "")
    try:
        program = command_line(requested, with_help=sys.argv[1:2] != [requested])
        raise_at_next()
        program()
    except SkinshadeError as error:
        _fail(str(error), error.exit_code)
    except MemoryError:
        _fail("out of memory; a smaller --size or fewer --samples need less", 1)
    except OSError as error:
        # A name that is too long, or a folder without permission.
        if error.filename is not None:
            _fail(f"{os.fsdecode(error.filename)}: {error.strerror}", 2)
        _fail(f"internal error: {type(error).__name__}: {error}", 1)
    except Exception as error:
        _fail(f"internal error: {type(error).__name__}: {error}", 1)
    finally:
        drop_unwritable()


def _show_version(requested: bool) -> None:
    if requested:
        echo(f"skinshade {__version__}")
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


def _fail(message: str, code: int) -> NoReturn:
    """Exit with an error message, except after a signal, which has its own."""
    if not is_interrupted():
        echo(f"skinshade: error: {message}", err=True)
    sys.exit(code)


def _show_warning(message: Warning | str, category: type[Warning], *_: object) -> None:
    if issubclass(category, SkinshadeWarning):
        echo(f"skinshade: warning: {message}", err=True)
