"""Millimetres are canonical; the only unit factors of the house live here."""

from __future__ import annotations

import math

from .errors import UnitError

__all__ = ["GLTF_UNIT_MM", "MM_PER_UNIT", "checked_unit_mm", "parse_unit_mm"]

MM_PER_UNIT = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4, "ft": 304.8}
"""Millimetres in one of each named unit (the inch and the foot by definition of 1959)."""
GLTF_UNIT_MM = MM_PER_UNIT["m"]
"""The format prescribes metres."""
UNIT_RANGE_MM = (1e-6, 1e9)
"""A nanometre to a thousand kilometres: beyond it no unit is meant."""


def checked_unit_mm(unit_mm: float, what: str) -> float:
    """Return `unit_mm` if it can be the length of a unit, in mm.

    Raises
    ------
    UnitError
        If it is zero, negative, NaN or infinite.
    """
    try:
        value = float(unit_mm)
    except (TypeError, ValueError):
        value = math.nan
    least, most = UNIT_RANGE_MM
    if not least <= value <= most:  # NaN is not in a range either
        raise UnitError(
            f"{what}: unit_mm is {unit_mm}; it must be a positive number of millimetres, "
            f"{least:g} to {most:g}"
        )
    return value


def parse_unit_mm(text: str) -> float:
    """Return the millimetres of one unit, written as a number or as a name such as ``cm``.

    Raises
    ------
    UnitError
        If the text is neither.
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
