"""The disks of taps that thickness is averaged over, as constants."""

from __future__ import annotations

from ..shading.deep_scatter import poisson_disk

__all__ = ["TAPS", "poisson_source"]

TAPS = (8, 32)


def poisson_source() -> str:
    """Return the disks as Slang arrays."""
    lines = [
        "// Generated from skinshade.shading.deep_scatter.poisson_disk by `python -m skinshade.codegen`.",
        "#ifndef SKIN_POISSON_SLANG",
        "#define SKIN_POISSON_SLANG",
    ]
    for taps in TAPS:
        points = [f"    float2({x:.8f}, {y:.8f})," for x, y in poisson_disk(taps)]
        points[-1] = points[-1].rstrip(",")
        lines += ["", f"static const float2 SKIN_POISSON_{taps}[{taps}] =", "{", *points, "};"]
    return "\n".join([*lines, "", "#endif", ""])
