"""Report of the times of GPU passes."""

from __future__ import annotations

import json

import numpy as np

from ..rendering import Renderer

__all__ = ["timing_report"]


def timing_report(renderer: Renderer, *, as_json: bool = False) -> str:
    """Return the median, least and greatest time of each pass, ms, as a table or as JSON."""
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
    if as_json:
        return json.dumps({"adapter": renderer.device_name, "passes": passes}, indent=1)
    if not passes:
        return f"{renderer.device_name}: no pass was timed"
    lines = [
        renderer.device_name,
        f"{'pass':12s} {'runs':>5s} {'median':>9s} {'least':>9s} {'greatest':>9s}",
    ]
    for name, entry in passes.items():
        times = (entry["median_ms"], entry["least_ms"], entry["greatest_ms"])
        lines.append(f"{name:12s} {entry['runs']:5d} " + " ".join(f"{t:6.2f} ms" for t in times))
    return "\n".join(lines)
