"""Labelled pictures side by side."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import FloatArray
from .._core.errors import ArgumentError
from ..rendering.settings import RenderSettings

__all__ = ["parse_variant", "side_by_side"]

DEEP = "+deep"


def parse_variant(text: str, settings: RenderSettings) -> tuple[str, RenderSettings]:
    """Return the label and the settings of an entry of ``--compare``.

    An entry is a lighting model (``lambert``, ``classic`` or ``transfer``), optionally followed by a tier,
    such as ``@scalar``, and by ``+deep``. Deep scatter is off without ``+deep``.

    Raises
    ------
    ArgumentError
        If the lighting model or the tier is unknown.
    """
    entry = text.strip()
    deep = entry.endswith(DEEP)
    shading, _, tier = entry.removesuffix(DEEP).partition("@")
    taps = (settings.deep_scatter_taps or 8) if deep else 0
    changes: dict[str, Any] = {"shading": shading, "deep_scatter_taps": taps}
    if tier:
        changes["tier"] = tier
    try:
        variant = replace(settings, **changes)
    except ArgumentError as error:
        raise ArgumentError(f"--compare {text!r}: {error}") from None
    return entry.replace("@", ", ").replace(DEEP, " + deep scatter"), variant


def side_by_side(pictures: list[FloatArray], labels: list[str]) -> NDArray[np.uint8]:
    """Return a row of n labelled pictures: display values (H, W, 3), 0..1, as (H, n·W, 3) in 8 bits."""
    from PIL import Image, ImageDraw, ImageFont  # costs .05 s, and only rows of pictures need it

    row = Image.fromarray(np.rint(np.concatenate(pictures, axis=1) * 255.0).astype(np.uint8))
    height, width = pictures[0].shape[:2]
    draw = ImageDraw.Draw(row)
    font = ImageFont.load_default(max(12, height // 34))
    for index, label in enumerate(labels):
        draw.text(
            (index * width + width // 2, height - height // 28),
            label,
            fill=(235, 235, 235),
            font=font,
            anchor="ms",
            stroke_width=2,
            stroke_fill=(0, 0, 0),
        )
        if index:
            draw.line([(index * width, 0), (index * width, height)], fill=(90, 90, 90))
    return np.asarray(row)
