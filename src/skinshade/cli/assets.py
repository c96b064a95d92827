"""``skinshade assets``: fetch public scans."""

from __future__ import annotations

from pathlib import Path

import typer

from ..scene.heads import SCANS, fetch_scan

__all__ = ["app"]

app = typer.Typer(help="Public scans.", no_args_is_help=True)


@app.command("list")
def list_command() -> None:
    """List the scans."""
    for name, scan in SCANS.items():
        typer.echo(f"{name}: {', '.join(scan.sha256)} (1 unit = {scan.unit_mm} mm; {scan.credit})")


@app.command("get")
def get_command(
    name: str = typer.Argument(..., help="Which; see skinshade assets list."),
    folder: Path = typer.Option(None, help="Where to keep it; the user's cache by default."),
    base_url: str = typer.Option(None, help="Another place that serves the same files."),
) -> None:
    """Fetch a scan, and refuse it if its hash is wrong."""
    for path in fetch_scan(name, folder, base_url):
        typer.echo(path)
    typer.echo(f"credit: {SCANS[name].credit}")
