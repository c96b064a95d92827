"""Report of a library: JSON, and an HTML page with thumbnails, histograms, units, repairs and failures."""

from __future__ import annotations

import base64
import hashlib
import json
import os
import re
from collections import defaultdict
from dataclasses import asdict
from html import escape
from importlib.resources import files
from pathlib import Path
from urllib.parse import quote

from .._core.files import atomic_write
from .._core.text import printable
from .._core.version import __version__
from ..rendering.settings import CURVATURE_RANGE_PER_MM, THICKNESS_RANGE_MM
from .jobs import Job, JobResult, status_counts
from .names import without_folders
from .records import MeshRecord
from .thumbnails import SIZE

__all__ = ["write_page", "write_report"]

MOST_MESHES = 24
"""Meshes of an asset that the page describes; a scene of thousands of meshes would fill it."""
LONGEST_ERROR = 1000
"""Characters of an error on the page: a message that quotes a file can have any length."""
BAR = 4
"""Width of a bar of a histogram, pixels: 48 bars are as wide as a thumbnail."""
HEIGHT = 48
"""Height of a histogram, pixels."""
CHARTS = {"curvature": "per mm", "thickness": "mm"}
"""Attributes that have a histogram on the page, and their units."""
VALUES = re.compile(r"'[^']*'|\"[^\"]*\"|\d+(?:[.,]\d+)*(?:e[+-]?\d+)?")
"""Quoted texts and numbers: the parts in which errors of one reason differ."""


def write_report(jobs: list[Job], results: list[JobResult], path: Path) -> None:
    """Write the results as JSON in ASCII. All names are relative to the folders of the jobs.

    Parameters
    ----------
    jobs, results
        Jobs and their results, in the same order.
    path
        Output file, ``.json``.

    Raises
    ------
    OutputError
        If the file cannot be written.
    """
    assets = [
        {
            "source": job.source_name,
            "output": job.output_name,
            "status": result.status,
            "error": _error(job, result),
            "warnings": result.warnings,
            "key": result.key,
            "files": result.files,
            "meshes": [asdict(mesh) for mesh in result.meshes],
        }
        for job, result in zip(jobs, results, strict=True)
    ]
    content = {"version": __version__, **status_counts(results), "assets": assets}
    with atomic_write(path) as temporary:
        temporary.write_text(json.dumps(content, indent=1) + "\n", encoding="ascii")


def write_page(
    jobs: list[Job], results: list[JobResult], path: Path, *, seconds: float | None = None
) -> None:
    """Write the report as a page that needs no other file than the thumbnails.

    Parameters
    ----------
    jobs, results
        Jobs and their results, in the same order.
    path
        Output file, ``.html``, in the output folder of the jobs: links to thumbnails start there.
    seconds
        Duration of the bake, s.

    Raises
    ------
    OutputError
        If the file cannot be written.
    """
    style, script = (_asset(name) for name in ("report.css", "report.js"))
    pairs = list(zip(jobs, results, strict=True))
    failures = [(job, result) for job, result in pairs if result.status == "failed"]
    assets = [(job, result) for job, result in pairs if result.status != "failed"]
    # No other script runs, not even one that an error in the escapes of a name would let in.
    policy = f"script-src {_source_hash(script)}; object-src 'none'; base-uri 'none'"
    page = [
        "<!doctype html>",
        '<html lang="en"><head><meta charset="utf-8">',
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        '<meta name="color-scheme" content="light dark">',
        f"<title>skinshade bake</title><style>{style}</style></head><body>",
        f"<header><h1>skinshade bake</h1><p>{_summary(results, seconds)}</p>",
        '<label hidden>Filter <input type="search" placeholder="name, note or error">'
        ' <output aria-live="polite"></output></label></header><main>',
        *_failure_section(failures),
        *_asset_section(assets),
        f"</main><script>{script}</script></body></html>",
    ]
    with atomic_write(path) as temporary:
        temporary.write_text("\n".join(page) + "\n", encoding="utf-8")


def _asset(name: str) -> str:
    return files(__package__).joinpath(name).read_text(encoding="utf-8")


def _source_hash(script: str) -> str:
    """Return the hash of an inline script in the form of a content security policy."""
    return f"'sha256-{base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()}'"


def _error(job: Job, result: JobResult) -> str:
    """Return the error of a result without the folders of the machine."""
    # The messages of errors of skinshade have replacements for unsafe characters already.
    source, name = printable(str(job.source)), printable(job.source_name)
    message = printable(result.error).replace(source, name)
    return without_folders(message, (job.source_folder, job.output_folder))


def _text(text: str) -> str:
    """Return a text as HTML; its letters do not change the direction of the texts around it."""
    return f'<bdi dir="ltr">{escape(printable(text))}</bdi>'


def _summary(results: list[JobResult], seconds: float | None) -> str:
    counts = [
        f'<b class="{status if count else "none"}">{count:,} {status}</b>'
        for status, count in status_counts(results).items()
    ]
    duration = [] if seconds is None else [_duration(seconds)]
    return " · ".join([*counts, *duration, f"<small>skinshade {__version__}</small>"])


def _duration(seconds: float) -> str:
    if seconds < 60.0:
        return f"{seconds:.1f} s"
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours} h {minutes} min" if hours else f"{minutes} min {rest} s"


# -- failures --------------------------------------------------------------------------------------


def _failure_section(failures: list[tuple[Job, JobResult]]) -> list[str]:
    """Return the failures in groups of one reason, the largest group first."""
    if not failures:
        return []
    groups: defaultdict[str, list[tuple[str, str]]] = defaultdict(list)
    for job, result in failures:
        reason = _error(job, result).removeprefix(f"{printable(job.source_name)}: ")
        if len(reason) > LONGEST_ERROR:
            reason = f"{reason[:LONGEST_ERROR]} …"
        groups[VALUES.sub("…", reason)].append((job.source_name, reason))
    lines = [f'<section class="failures"><h2>{len(failures):,} failed</h2>']
    for pattern, members in sorted(groups.items(), key=lambda group: (-len(group[1]), group[0])):
        is_same = len({reason for _, reason in members}) == 1
        heading = members[0][1] if is_same else pattern
        lines.append(
            f"<details open><summary><b>{len(members):,} ×</b> {_text(heading)}</summary><ul>"
        )
        for name, reason in members:
            detail = "" if is_same else f": {_text(reason)}"
            lines.append(f"<li>{_text(name)}{detail}</li>")
        lines.append("</ul></details>")
    return [*lines, "</section>"]


# -- assets ----------------------------------------------------------------------------------------


def _asset_section(assets: list[tuple[Job, JobResult]]) -> list[str]:
    if not assets:
        return []
    noun = "asset" if len(assets) == 1 else "assets"
    return [
        f'<section class="assets"><h2>{len(assets):,} {noun}</h2>',
        "<p><small>Curvature: red is convex, blue is concave, with full colour at"
        f" ±{CURVATURE_RANGE_PER_MM:g} per mm. Thickness: white is {THICKNESS_RANGE_MM:g} mm."
        "</small></p>",
        *(_article(job, result) for job, result in assets),
        "</section>",
    ]


def _article(job: Job, result: JobResult) -> str:
    meshes = "".join(f'<p class="note">{_text(text)}</p>' for text in result.warnings)
    meshes += "".join(map(_mesh, result.meshes[:MOST_MESHES]))
    hidden = len(result.meshes) - MOST_MESHES
    if hidden > 0:
        meshes += f"<p>and {hidden:,} more meshes; the JSON report lists them</p>"
    return (
        f"<article><h3>{_text(job.output_name)} <small>{result.status}</small></h3>"
        f'{_image(job, result)}<div class="meshes">{meshes}</div></article>'
    )


def _image(job: Job, result: JobResult) -> str:
    if not job.thumbnail.is_file():
        return ""
    name = job.thumbnail.relative_to(job.output_folder).as_posix()
    has_thickness = any("thickness" in mesh.histograms for mesh in result.meshes)
    kinds = ["curvature", *(["thickness"] if has_thickness else []), "shaded"]
    return (
        f'<figure><img loading="lazy" src="{quote(os.fsencode(name))}"'
        f' width="{SIZE * len(kinds)}" height="{SIZE}" alt="thumbnails">'
        f"<figcaption>{' · '.join(kinds)}</figcaption></figure>"
    )


def _mesh(mesh: MeshRecord) -> str:
    size = " × ".join(f"{side:.4g}" for side in mesh.size_mm)
    scale = mesh.uv_scale_mm
    lines = [
        f"mesh <b>{_text(mesh.name)}</b>",
        f"{mesh.vertices:,} vertices, {mesh.triangles:,} triangles",
        f"one unit is {mesh.unit_mm:.6g} mm; {size} mm",
        "no UVs" if scale is None else f"one unit of UV is {scale:.4g} mm",
        *(
            f'<span class="note">{count:,} {_text(note)}</span>'
            for note, count in mesh.notes.items()
        ),
    ]
    charts = "".join(
        _histogram(name, mesh.ranges[name], counts)
        for name, counts in mesh.histograms.items()
        if name in CHARTS
    )
    return f"<div><p>{'<br>'.join(lines)}</p>{charts}</div>"


def _histogram(name: str, limits: list[float], counts: list[int]) -> str:
    highest = max(*counts, 1)
    # Every bin that is not empty has a bar of at least one pixel.
    heights = [-(-HEIGHT * count // highest) for count in counts]
    bars = "".join(
        f"M{BAR * index} {HEIGHT}v-{height}h{BAR - 1}v{height}z"
        for index, height in enumerate(heights)
        if height
    )
    return (
        f"<figure><figcaption>{name} {limits[0]:.3g} to {limits[1]:.3g} {CHARTS[name]}</figcaption>"
        f'<svg width="{BAR * len(counts)}" height="{HEIGHT}" role="img" aria-label="histogram">'
        f'<path d="{bars}"/></svg></figure>'
    )
