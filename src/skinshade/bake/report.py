"""One page about a run: pictures, histograms, units, repairs, what failed."""

from __future__ import annotations

import base64
from html import escape
from pathlib import Path
from typing import Any

from .._core.files import atomic_write
from .._core.version import __version__
from .jobs import Job, JobResult, counted

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
    """Write a page that needs no other file.

    Parameters
    ----------
    jobs, results
        In the same order.
    path
        ``.html``.

    Raises
    ------
    OutputError
        If the place cannot be written.
    """
    said = ", ".join(f"{number} {status}" for status, number in counted(results).items())
    rows = [_row(job, result, path.parent) for job, result in zip(jobs, results, strict=True)]
    page = [
        "<!doctype html>",
        '<html lang="en"><meta charset="utf-8"><title>skinshade bake</title>',
        f"<style>{STYLE}</style>",
        f"<h1>skinshade bake</h1><p>{said}. <small>skinshade {__version__}</small></p>",
        "<p>Curvature: red bulges, blue is hollow, full at ±0.2 per mm. Thickness: white at 30 mm.</p>",
        "<table><tr><th>asset</th><th>pictures</th><th>meshes</th></tr>",
        *rows,
        "</table></html>",
    ]
    with atomic_write(path) as temporary:
        temporary.write_text("\n".join(page) + "\n", encoding="utf-8")


def _row(job: Job, result: JobResult, folder: Path) -> str:
    name = escape(str(Path(result.output).relative_to(folder)))
    if result.status == "failed":
        told = f'<td></td><td class="failed">{escape(result.error)}</td>'
        return f"<tr><td>{name}<br><small>failed</small></td>{told}</tr>"
    picture = ""
    if job.picture.is_file():
        data = base64.b64encode(job.picture.read_bytes()).decode()
        picture = f'<img alt="" src="data:image/png;base64,{data}">'
    meshes = "".join(_mesh(each) for each in result.meshes)
    return f"<tr><td>{name}<br><small>{result.status}</small></td><td>{picture}</td><td>{meshes}</td></tr>"


def _mesh(mesh: dict[str, Any]) -> str:
    size = " × ".join(f"{each:.4g}" for each in mesh["size_mm"])
    scale = mesh["uv_scale_mm"]
    lines = [
        f"<b>{escape(str(mesh['name']))}</b>: {mesh['vertices']} vertices, {mesh['triangles']} triangles",
        f"one unit is {mesh['unit_mm']:.6g} mm; {size} mm",
        "no UVs" if scale is None else f"one unit of UV is {scale:.4g} mm",
        *(f"<b>{count}</b> {escape(what)}" for what, count in mesh["notes"].items()),
    ]
    charts = "".join(
        f"<small>{escape(name)} {mesh['ranges'][name][0]:.3g} to {mesh['ranges'][name][1]:.3g}</small>"
        + _histogram(counts)
        for name, counts in mesh["histograms"].items()
        if name in ("curvature", "thickness")
    )
    return "<p>" + "<br>".join(lines) + "</p>" + charts


def _histogram(counts: list[int]) -> str:
    most = max(max(counts), 1)
    bars = "".join(
        f'<rect x="{index * BAR}" y="{HEIGHT * (1 - count / most):.1f}" width="{BAR - 1}"'
        f' height="{HEIGHT * count / most:.1f}" fill="#b5654a"/>'
        for index, count in enumerate(counts)
    )
    return f'<svg width="{BAR * len(counts)}" height="{HEIGHT}">{bars}</svg>'
