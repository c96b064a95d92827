"""HTML report of a library: thumbnails, histograms, units, repairs and failures."""

from __future__ import annotations

import base64
from html import escape
from pathlib import Path
from typing import Any

from .._core.files import atomic_write
from .._core.version import __version__
from .jobs import Job, JobResult, status_counts

__all__ = ["write_page"]

STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; margin: 2rem; color: #222; background: #fbfaf8; }
table { border-collapse: collapse; }
td, th { padding: .5rem .8rem; border-top: 1px solid #ddd; text-align: left; vertical-align: top; }
img { border-radius: 4px; }
.failed { color: #a11; }
svg { display: block; }
small { color: #666; }
"""
BAR = 4
HEIGHT = 48


def write_page(jobs: list[Job], results: list[JobResult], path: Path) -> None:
    """Write the report as one self-contained file.

    Parameters
    ----------
    jobs, results
        Jobs and their results, in the same order.
    path
        Output file, ``.html``.

    Raises
    ------
    OutputError
        If the file cannot be written.
    """
    counts = ", ".join(f"{count} {status}" for status, count in status_counts(results).items())
    rows = [_row(job, result, path.parent) for job, result in zip(jobs, results, strict=True)]
    page = [
        "<!doctype html>",
        '<html lang="en"><meta charset="utf-8"><title>skinshade bake</title>',
        f"<style>{STYLE}</style>",
        f"<h1>skinshade bake</h1><p>{counts}. <small>skinshade {__version__}</small></p>",
        "<p>Curvature: red is convex, blue is concave, with full colour at ±0.2 per mm."
        " Thickness: white is 30 mm.</p>",
        "<table><tr><th>asset</th><th>thumbnails</th><th>meshes</th></tr>",
        *rows,
        "</table></html>",
    ]
    with atomic_write(path) as temporary:
        temporary.write_text("\n".join(page) + "\n", encoding="utf-8")


def _row(job: Job, result: JobResult, folder: Path) -> str:
    name = escape(str(Path(result.output).relative_to(folder)))
    if result.status == "failed":
        cells = f'<td></td><td class="failed">{escape(result.error)}</td>'
        return f"<tr><td>{name}<br><small>failed</small></td>{cells}</tr>"
    image = ""
    if job.thumbnail.is_file():
        data = base64.b64encode(job.thumbnail.read_bytes()).decode()
        image = f'<img alt="" src="data:image/png;base64,{data}">'
    meshes = "".join(_mesh(mesh) for mesh in result.meshes)
    return f"<tr><td>{name}<br><small>{result.status}</small></td><td>{image}</td><td>{meshes}</td></tr>"


def _mesh(mesh: dict[str, Any]) -> str:
    size = " × ".join(f"{side:.4g}" for side in mesh["size_mm"])
    scale = mesh["uv_scale_mm"]
    lines = [
        f"<b>{escape(str(mesh['name']))}</b>: {mesh['vertices']} vertices, {mesh['triangles']} triangles",
        f"one unit is {mesh['unit_mm']:.6g} mm; {size} mm",
        "no UVs" if scale is None else f"one unit of UV is {scale:.4g} mm",
        *(f"<b>{count}</b> {escape(note)}" for note, count in mesh["notes"].items()),
    ]
    charts = "".join(
        f"<small>{escape(name)} {mesh['ranges'][name][0]:.3g} to {mesh['ranges'][name][1]:.3g}</small>"
        + _histogram(counts)
        for name, counts in mesh["histograms"].items()
        if name in ("curvature", "thickness")
    )
    return "<p>" + "<br>".join(lines) + "</p>" + charts


def _histogram(counts: list[int]) -> str:
    highest = max(max(counts), 1)
    bars = "".join(
        f'<rect x="{index * BAR}" y="{HEIGHT * (1 - count / highest):.1f}" width="{BAR - 1}"'
        f' height="{HEIGHT * count / highest:.1f}" fill="#b5654a"/>'
        for index, count in enumerate(counts)
    )
    return f'<svg width="{BAR * len(counts)}" height="{HEIGHT}">{bars}</svg>'
