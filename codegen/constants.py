"""Constants and disks of taps that the specification and the shader library share."""

from __future__ import annotations

from types import ModuleType

import numpy as np

from skinshade._core.arrays import FloatArray
from skinshade.lut import coat as coat_table
from skinshade.shading import (
    ambient,
    contact,
    deep_scatter,
    direct,
    energy,
    eye,
    eye_lids,
    eye_light,
    image_light,
    shadow,
    specular,
    view_factor,
)

__all__ = ["constants_source", "definition"]

HEADER = "// Generated from the specification by `python -m codegen`."

LIBRARY: dict[ModuleType, tuple[str, ...]] = {
    ambient: ("COSINE_BANDS", "LEAST_HIDDEN"),
    coat_table: ("GREATEST_REFLECTANCE",),
    contact: (
        "CONTACT_BIAS_MM",
        "CONTACT_BIAS_PER_SLOPE_MM",
        "CONTACT_FADE_FROM",
        "CONTACT_FADE_TO",
        "CONTACT_RADIUS_MM",
        "CONTACT_TAPS",
    ),
    deep_scatter: ("CLASSIC_WRAP",),
    direct: ("SMOOTH_SHORTFALL",),
    energy: ("GAIN_SLOPE",),
    eye: ("LEAST_FACING", "LEAST_FORWARD", "LEAST_ROOT"),
    eye_lids: (
        "LEAST_MARGIN",
        "LEAST_NARROWED",
        "LID_CLEARANCE_MM",
        "LID_DISTANCE_MM",
        "LID_ENTRY_RISE",
        "LID_ENTRY_SHARE",
        "LID_NARROWING",
    ),
    eye_light: (
        "EYE_COLUMNS",
        "EYE_LAST_SINE",
        "EYE_LEAST_COSINE",
        "EYE_ROWS",
        "EYE_SLICES",
        "EYE_WARP",
        "GREATEST_LUMINANCE",
        "LEAST_LUMINANCE",
    ),
    image_light: ("LEAST_VIEW_COSINE", "REFLECTION_LEVELS", "REFLECTION_ROWS"),
    shadow: (
        "ATTACHED_MM",
        "DARK_BEYOND",
        "HOLLOW_PER_MM",
        "LEAST_COSINE",
        "LEAST_VARIANCE_MM2",
        "SHADOW_BIAS_MM",
        "STEEPEST_SLOPE",
        "TERMINATOR_REACH_MM",
    ),
    specular: ("POWER_OCTAVES", "SHARPEST_POWER", "SHARP_LOBE_SHARE"),
    view_factor: ("COSINE_NODES", "COSINE_WEIGHTS", "ROUGH_ENTRY"),
}
"""Names of the constants by the module of the specification that defines them."""


def constants_source() -> str:
    """Return the constants and the disks of taps as Slang."""
    lines = [HEADER, "#ifndef SKIN_CONSTANTS_SLANG", "#define SKIN_CONSTANTS_SLANG", ""]
    for module, names in LIBRARY.items():
        lines += [definition(f"SKIN_{name}", getattr(module, name)) for name in names]
    for taps in shadow.SHADOW_TAPS:
        lines += _disk(f"SKIN_SHADOW_DISK_{taps}", shadow.shadow_disk(taps))
    lines += _disk("SKIN_CONTACT_DISK", shadow.shadow_disk(contact.CONTACT_TAPS))
    for taps in deep_scatter.THICKNESS_TAPS:
        lines += _disk(f"SKIN_POISSON_{taps}", deep_scatter.poisson_disk(taps))
    return "\n".join([*lines, "", "#endif", ""])


def definition(name: str, value: float | FloatArray) -> str:
    """Return a Slang constant: an int, a float, or a vector of floats."""
    if isinstance(value, int):
        return f"static const int {name} = {value};"
    if np.ndim(value) == 0:
        return f"static const float {name} = {value!r};"
    numbers = ", ".join(f"{number:.9g}" for number in np.asarray(value))
    kind = f"float{np.size(value)}"
    return f"static const {kind} {name} = {kind}({numbers});"


def _disk(name: str, points: FloatArray) -> list[str]:
    rows = ",\n".join(f"    float2({x:.8f}, {y:.8f})" for x, y in points)
    return ["", f"static const float2 {name}[{len(points)}] =", "{", rows, "};"]
