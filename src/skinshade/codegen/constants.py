"""Numbers that the passes share with the CPU's renderer, as constants."""

from __future__ import annotations

from ..render import light_view
from ..render.cpu import debug, shadow_map
from ..render.cpu import renderer as cpu_renderer
from ..scene import lights

__all__ = ["constants_source"]

SHARED = {
    debug: ("CURVATURE_RANGE_PER_MM", "THICKNESS_RANGE_MM"),
    lights: ("LEAST_DISTANCE_MM",),
    cpu_renderer: ("DARK_BEYOND",),
    light_view: ("MAP_SIZE",),
    shadow_map: (
        "ATTACHED_MM",
        "BIAS_MM",
        "BLUR_REACH",
        "FILTER_TAPS",
        "HOLLOW_PER_MM",
        "NOWHERE_MM",
        "STEEPEST_SLOPE",
        "TERMINATOR_REACH_MM",
    ),
}


def constants_source() -> str:
    """Return them as Slang, each of its own type."""
    lines = ["// Generated from skinshade.render.cpu by `python -m skinshade.codegen`."]
    for module, names in SHARED.items():
        for name in names:
            value = getattr(module, name)
            kind = "int" if isinstance(value, int) else "float"
            lines.append(f"static const {kind} {name} = {value!r};")
    return "\n".join([*lines, ""])
