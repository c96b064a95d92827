"""Pictures side by side, each with its name."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from .._core.arrays import FloatArray
from .._core.errors import ArgumentError
from ..render import RenderSettings

__all__ = ["parse_variant", "side_by_side"]

DEEP = "+deep"


def parse_variant(text: str, settings: RenderSettings) -> tuple[str, RenderSettings]:
    """Return the label and settings of one entry of ``--compare``.

    ``lambert``, ``classic`` or ``transfer``, with ``@scalar`` and the like for a tier; deep scatter is
    off unless ``+deep`` follows.

    Raises
    ------
    ArgumentError
        If there is no such shading or tier.
    """
    word = text.strip()
    deep = word.endswith(DEEP)
    shading, _, tier = word.removesuffix(DEEP).partition("@")
    taps = (settings.deep_scatter_taps or 8) if deep else 0
    changes = {"shading": shading, "deep_scatter_taps": taps} | ({"tier": tier} if tier else {})
    try:
        chosen = replace(settings, **changes)  # type: ignore[arg-type]  # checked by the class itself
    except ArgumentError as error:
        raise ArgumentError(f"--compare {text!r}: {error}") from None
    return word.replace("@", ", ").replace(DEEP, " + deep scatter"), chosen


def side_by_side(pictures: list[FloatArray], labels: list[str]) -> FloatArray:
    """Return display values (H, W, 3) of labelled pictures (H, w, 3) in a row."""
    row = Image.fromarray(np.rint(np.concatenate(pictures, axis=1) * 255.0).astype(np.uint8))
    height, width = pictures[0].shape[:2]
    draw = ImageDraw.Draw(row)
    font = ImageFont.load_default(max(12, height // 34))
    for index, label in enumerate(labels):
        at = (index * width + width // 2, height - height // 28)
        draw.text(
            at,
            label,
            fill=(235, 235, 235),
            font=font,
            anchor="ms",
            stroke_width=2,
            stroke_fill=(0, 0, 0),
        )
        if index:
            draw.line([(index * width, 0), (index * width, height)], fill=(90, 90, 90))
    return np.asarray(row, dtype=np.float64) / 255.0
