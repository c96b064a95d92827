"""``skinshade assets``: public scans of heads."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from ..heads import SCANS, fetch_scan
from .terminal import echo

__all__ = ["app"]

app = typer.Typer(no_args_is_help=True)


@app.command("list")
def list_command() -> None:
    """List the scans."""
    for name, scan in SCANS.items():
        echo(f"{name}: {', '.join(scan.sha256)} (1 unit = {scan.unit_mm} mm; {scan.credit})")


@app.command("get")
def get_command(
    name: Annotated[str, typer.Argument(help="Name of a scan; see skinshade assets list.")],
    folder: Annotated[
        Path | None, typer.Option(help="Folder of the files; the user's cache by default.")
    ] = None,
    base_url: Annotated[
        str | None, typer.Option(help="Address of another server with the same files.")
    ] = None,
) -> None:
    """Download a scan and check its hash."""
    for path in fetch_scan(name, folder, base_url):
        echo(path)
    echo(f"credit: {SCANS[name].credit}")
