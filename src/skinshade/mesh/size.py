"""Check of the size of a body: a wrong unit makes it implausibly small or large."""

from __future__ import annotations

import inspect
import math
import os
import warnings
from typing import Literal

from .._core.arrays import FloatArray
from .._core.errors import UnitWarning

__all__ = ["PLAUSIBLE_MM", "UnitSource", "warn_of_size"]

PLAUSIBLE_MM = (80.0, 3000.0)
"""Plausible diagonals of a body: larger than an ear, and up to a tall person. A head in centimetres that is
read in millimetres is 25 to 65 mm across, the latter with its shoulders."""

UnitSource = Literal["given", "baked", "format"]
"""Source of a unit: the caller, the note of a bake in the file, or the format, whose unit is the metre."""
PHRASES: dict[UnitSource, str] = {
    "given": "with the given unit of {unit:g} mm",
    "baked": "in the unit of its bake, {unit:g} mm",
    "format": "in metres, the unit of glTF",
}


def warn_of_size(
    extent_mm: FloatArray,
    file: str | os.PathLike[str],
    unit_mm: float,
    source: UnitSource,
) -> None:
    """Warn the caller of the package if the diagonal of a body is outside `PLAUSIBLE_MM`.

    Parameters
    ----------
    extent_mm
        (3,) size of the body along the axes, mm.
    file
        File of the body.
    unit_mm, source
        Length of one unit of the file, mm, and its source.

    Warns
    -----
    UnitWarning
        Names the file, the size and what to do.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.mesh.size import warn_of_size
    >>> warn_of_size(np.array([170.0, 320.0, 210.0]), "head.obj", 10.0, "given")
    """
    diagonal = math.hypot(*extent_mm.tolist())  # does not overflow
    least, greatest = PLAUSIBLE_MM
    if least <= diagonal <= greatest:
        return
    warnings.warn(
        f"{file}: {PHRASES[source].format(unit=unit_mm)}, the object is {_length(diagonal)} across;"
        f" skin is on bodies of {_length(least)} to {_length(greatest)}. If this is wrong, give unit_mm,"
        " the length of one unit of the file in mm",
        UnitWarning,
        stacklevel=_frames_of_package(),
    )


def _frames_of_package() -> int:
    """Return the level, for `warnings.warn` in the calling function, of the caller of the package."""
    package = __name__.partition(".")[0]
    level, frame = 0, inspect.currentframe()
    while frame is not None and frame.f_globals.get("__name__", "").partition(".")[0] == package:
        level, frame = level + 1, frame.f_back
    return level


def _length(length_mm: float) -> str:
    return f"{length_mm:.3g} mm" if length_mm < 1000.0 else f"{length_mm / 1000.0:.3g} m"
