"""How long each pass took on the device, as a table or as JSON."""

from __future__ import annotations

import json

import numpy as np

from ..render.renderer import Renderer

__all__ = ["timing_report"]


def timing_report(renderer: Renderer, form: str) -> str:
    """Return median, least and greatest time of each pass, ms; ``table`` or ``json``."""
    passes = {
        name: {
            "runs": len(times),
            "median_ms": float(np.median(times)),
            "least_ms": float(np.min(times)),
            "greatest_ms": float(np.max(times)),
        }
        for name, times in renderer.timings_ms.items()
        if times
    }
    if form == "json":
        return json.dumps({"adapter": renderer.place, "passes": passes}, indent=1)
    if not passes:
        return f"{renderer.place}: no pass was timed"
    lines = [
        renderer.place,
        f"{'pass':12s} {'runs':>5s} {'median':>9s} {'least':>9s} {'greatest':>9s}",
    ]
    for name, found in passes.items():
        times = (found["median_ms"], found["least_ms"], found["greatest_ms"])
        lines.append(f"{name:12s} {found['runs']:5d} " + " ".join(f"{t:6.2f} ms" for t in times))
    return "\n".join(lines)
