"""Units of length. Lengths are in mm everywhere else."""

from __future__ import annotations

import math

from .errors import UnitError

__all__ = ["GLTF_UNIT_MM", "MM_PER_UNIT", "checked_unit_mm", "parse_unit_mm"]

MM_PER_UNIT = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4, "ft": 304.8}
"""Length of the named units, mm (inch and foot as defined in 1959)."""
GLTF_UNIT_MM = MM_PER_UNIT["m"]
"""Unit of glTF files, mm: the format prescribes metres."""
UNIT_RANGE_MM = (1e-6, 1e9)
"""Plausible units: a nanometre to a thousand kilometres."""


def checked_unit_mm(unit_mm: float, name: str) -> float:
    """Return the length of a unit in mm, after a check. `name` begins the error message.

    Raises
    ------
    UnitError
        If the length is outside `UNIT_RANGE_MM`, or not a number.
    """
    try:
        value = float(unit_mm)
    except (TypeError, ValueError):
        value = math.nan
    least, most = UNIT_RANGE_MM
    if not least <= value <= most:  # false for NaN
        raise UnitError(
            f"{name}: unit_mm is {unit_mm}; it must be a positive number of millimetres, "
            f"{least:g} to {most:g}"
        )
    return value


def parse_unit_mm(text: str) -> float:
    """Return the length in mm of a unit: a number of mm, or a name such as ``cm``.

    Raises
    ------
    UnitError
        If the text is neither a length in range nor a name.
    """
    name = text.strip().lower()
    if name in MM_PER_UNIT:
        return MM_PER_UNIT[name]
    try:
        value = float(name)
    except ValueError:
        names = ", ".join(MM_PER_UNIT)
        raise UnitError(
            f"unit {text!r} is neither a number of millimetres nor one of {names}"
        ) from None
    return checked_unit_mm(value, "unit")
