"""Pictures and tables that notebooks show for objects."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape
from io import BytesIO

import numpy as np

from .arrays import FloatArray

__all__ = ["curves_svg", "png_bytes", "table_html"]

CHANNEL_COLOURS = ("#c33", "#393", "#36c")
PLOT_SIZE = (320, 160)


def png_bytes(display: FloatArray) -> bytes:
    """Return display values (H, W, 3), 0..1, as a PNG file."""
    from PIL import Image  # costs .05 s, and only notebooks need it

    pixels = np.rint(np.clip(display, 0.0, 1.0) * 255.0).astype(np.uint8)
    file = BytesIO()
    Image.fromarray(pixels).save(file, "png")
    return file.getvalue()


def table_html(title: str, rows: Mapping[str, object]) -> str:
    """Return a table of names and values with a title, as HTML."""
    cells = "".join(
        f"<tr><th style='text-align:left'>{escape(name)}</th>"
        f"<td style='text-align:left'>{escape(str(value))}</td></tr>"
        for name, value in rows.items()
    )
    return f"<div><b>{escape(title)}</b><table>{cells}</table></div>"


def curves_svg(x: FloatArray, channels: FloatArray, caption: str) -> str:
    """Return the curves of three channels as SVG.

    Parameters
    ----------
    x
        (N,) increasing positions.
    channels
        (N, 3) values; the plot begins at 0 and ends at the greatest.
    caption
        Text below the plot.
    """
    width, height = PLOT_SIZE
    across = (x - x[0]) / (x[-1] - x[0]) * width
    up = height * (1.0 - channels / max(float(channels.max()), 1e-30))
    lines = "".join(
        f"<polyline fill='none' stroke='{colour}' stroke-width='1.5' points='"
        + " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(across, column, strict=True))
        + "'/>"
        for colour, column in zip(CHANNEL_COLOURS, up.T, strict=True)
    )
    return (
        f"<svg width='{width + 8}' height='{height + 24}' viewBox='-4 -4 {width + 8} {height + 24}'>"
        f"<path d='M0 0V{height}H{width}' fill='none' stroke='#888'/>{lines}"
        f"<text x='0' y='{height + 16}' font-size='11' fill='#888'>{escape(caption)}</text></svg>"
    )
