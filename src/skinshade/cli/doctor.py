"""``skinshade doctor``: what is here."""

from __future__ import annotations

import os
import platform
from importlib.metadata import version

import typer

from .._core.version import __version__

__all__ = ["doctor_command"]


def doctor_command() -> None:
    """Print versions, cores and backends."""
    typer.echo(
        f"skinshade {__version__}, Python {platform.python_version()}, {platform.platform()}"
    )
    for package in ("numpy", "scipy", "trimesh", "OpenImageIO"):
        typer.echo(f"{package} {version(package)}")
    typer.echo(f"backend cpu: {os.cpu_count()} cores")
    typer.echo("backend gpu: not in this version")
