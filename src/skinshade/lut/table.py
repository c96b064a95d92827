"""Lookup tables with axes, units, range and provenance."""

from __future__ import annotations

import operator
import os
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import FloatArray, ImageArray, as_floats
from .._core.errors import ArgumentError, LutFileError
from .._core.limits import check_limit, limit_range, limits
from .._core.notebook import png_bytes
from .._core.srgb import srgb_from_linear
from . import compiled_fetch as compiled
from .files import read_table, write_table

__all__ = ["Axis", "Lut", "LutKind", "checked_range", "checked_size"]

LutKind = Literal["curvature", "shadow", "transfer", "coat", "eye-lamp", "eye-surroundings"]
Spacing = Literal["linear", "sqrt"]


@dataclass(frozen=True)
class Axis:
    """Axis of a table. Texel i of n has its centre at the fraction (i + ½)/n of the range.

    Attributes
    ----------
    name
        Name of the quantity.
    unit
        Unit of the quantity; ``1`` if it has none.
    low, high
        Values at the outer edges of the first and last texel.
    spacing
        ``linear``, or ``sqrt`` for equal steps of the square root.
    """

    name: str
    unit: str
    low: float
    high: float
    spacing: Spacing = "linear"

    def __post_init__(self) -> None:
        if not (isinstance(self.name, str) and isinstance(self.unit, str)):
            raise ArgumentError(f"axis {self.name!r}: name and unit must be text")
        if self.spacing not in get_args(Spacing):
            raise ArgumentError(
                f"axis {self.name}: spacing is {self.spacing!r}; it must be linear or sqrt"
            )
        if not (np.isfinite(self.low) and np.isfinite(self.high) and self.low < self.high):
            raise ArgumentError(
                f"axis {self.name}: low is {self.low} and high is {self.high}; low must be less than high"
            )
        if self.spacing == "sqrt" and self.low < 0.0:
            raise ArgumentError(
                f"axis {self.name}: low is {self.low}; it must be 0 or more with spacing sqrt"
            )

    @property
    def warped_ends(self) -> tuple[float, float]:
        """Low and high; their square roots where the spacing is ``sqrt``."""
        low, high = self._warp(np.array([self.low, self.high]))
        return float(low), float(high)

    def centres(self, count: int) -> FloatArray:
        """Return the values (count,) at the texel centres."""
        low, high = self.warped_ends
        steps = low + (high - low) * (np.arange(count) + 0.5) / count
        return np.square(steps) if self.spacing == "sqrt" else steps

    def coordinate(self, value: FloatArray) -> FloatArray:
        """Return the positions of values along the axis, 0 at the low edge, 1 at the high edge, clamped."""
        low, high = self.warped_ends
        clamped = np.clip(value, self.low, self.high)
        result: FloatArray = (self._warp(clamped) - low) / (high - low)
        return result

    def _warp(self, value: FloatArray) -> FloatArray:
        return np.sqrt(value) if self.spacing == "sqrt" else value


@dataclass(frozen=True)
class Lut:
    """Lookup table of RGB values.

    Attributes
    ----------
    values
        (H, W, 3) float32 physical values, without encoding or offset; read-only.
    kind
        ``curvature``, ``shadow``, ``transfer``, ``coat``, ``eye-lamp`` or ``eye-surroundings``.
    columns, rows
        Axes along the width and the height.
    provenance
        Profile, parameters and version that the table was built from; JSON types only.

    Examples
    --------
    >>> import skinshade as sk
    >>> sk.build_transfer_lut(sk.Profile.preset("marble")).save("transfer.exr")
    >>> sk.Lut.load("transfer.exr").kind
    'transfer'
    """

    values: ImageArray
    kind: LutKind
    columns: Axis
    rows: Axis
    provenance: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.values.ndim != 3 or self.values.shape[2] != 3 or min(self.values.shape) < 2:
            raise ArgumentError(
                f"values: shape is {self.values.shape}; it must be (H, W, 3) with H and W 2 or more"
            )
        if not isinstance(self.provenance, Mapping):
            raise ArgumentError(
                f"provenance is {self.provenance!r}; it must be a mapping of names to values"
            )
        if not np.isfinite(self.values).all():
            raise ArgumentError("values: all values must be finite")
        if self.kind not in get_args(LutKind):
            kinds = ", ".join(get_args(LutKind))
            raise ArgumentError(f"kind is {self.kind!r}; it must be one of {kinds}")
        values = np.array(self.values, dtype=np.float32)
        values.setflags(write=False)
        object.__setattr__(self, "values", values)

    @property
    def axes(self) -> tuple[float, float, float, float]:
        """Low and 1/(high − low) of the warped columns, then of the rows: the constants of a lookup."""
        (left, right), (top, bottom) = self.columns.warped_ends, self.rows.warped_ends
        return left, 1.0 / (right - left), top, 1.0 / (bottom - top)

    @property
    def value_range(self) -> tuple[float, float]:
        """Least and greatest value."""
        return float(self.values.min()), float(self.values.max())

    def sample(self, column: ArrayLike, row: ArrayLike) -> FloatArray:
        """Return bilinear lookups, clamped at the edges, as of a GPU sampler.

        Parameters
        ----------
        column
            (...) N·L (curvature), value of the wide shadow filter (shadow), spatial frequency, rad/mm
            (transfer), or square root of N·V (coat).
        row
            (...) curvature (curvature), or N·L over the filter's width (shadow), 1/mm; gloss (coat); ignored
            by a transfer table.

        Returns
        -------
        (..., 3)

        Raises
        ------
        ArgumentError
            If a value is not finite.
        """
        u = self.columns.coordinate(as_floats("column", column))
        v = self.rows.coordinate(as_floats("row", row))
        return self.sample_at(u, v)

    def sample_at(self, u: FloatArray, v: FloatArray) -> FloatArray:
        """Return all channels (..., 3) at texture coordinates u and v (...), 0..1, without checks."""
        return self._bilinear(u[..., None], v[..., None])

    def sample_channels(self, u: FloatArray, v: FloatArray) -> FloatArray:
        """Return channels (..., 3), looked up at columns u (..., 3) and row v (...), 0..1, without checks."""
        return self._bilinear(u, v[..., None])

    def _bilinear(self, u: FloatArray, v: FloatArray) -> FloatArray:
        if compiled.serves():
            return compiled.fetch_table(self.values, u, v)
        height, width, _ = self.values.shape
        x = np.clip(u * width - 0.5, 0.0, width - 1.0)
        y = np.clip(v * height - 0.5, 0.0, height - 1.0)
        x0 = np.minimum(x.astype(np.int64), width - 2)
        y0 = np.minimum(y.astype(np.int64), height - 2)
        fx, fy = x - x0, y - y0
        index = (y0 * width + x0) * 3 + np.arange(3)
        t = self.values.ravel()
        top = t[index] * (1.0 - fx) + t[index + 3] * fx
        index += 3 * width
        bottom = t[index] * (1.0 - fx) + t[index + 3] * fx
        result: FloatArray = top * (1.0 - fy) + bottom * fy
        return result

    def description(self) -> dict[str, Any]:
        """Return kind, axes and provenance as JSON types: the metadata of saved tables."""
        return {
            "kind": self.kind,
            "columns": asdict(self.columns),
            "rows": asdict(self.rows),
            "provenance": dict(self.provenance),
        }

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the table to a path: ``.exr`` (float), ``.png`` (16 bits) or ``.npz``.

        The range of the values of a PNG is in its metadata.

        EXR and npz are exact; PNG is within half a step of range/65535 per channel.

        Raises
        ------
        OutputError, ArgumentError
            If the file cannot be written, or has another suffix.
        """
        write_table(path, self.values, self.description())

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Lut:
        """Return the table of a file that `save` wrote.

        Parameters
        ----------
        path
            ``.exr``, ``.png`` or ``.npz`` file.

        Raises
        ------
        LutFileError
            If the file is missing or corrupt, or has no description of its axes.
        """
        values, record = read_table(path)
        try:
            axes = Axis(**record["columns"]), Axis(**record["rows"])
            provenance = record["provenance"]
            if not isinstance(provenance, dict):
                raise ArgumentError(f"provenance is {provenance!r:.80}; it must be an object")
            return cls(values, record["kind"], *axes, provenance)
        except (KeyError, TypeError, ValueError) as error:
            raise LutFileError(
                f"{path}: the description of its axes is incomplete or wrong: {error}"
            ) from None

    def __repr__(self) -> str:
        height, width, _ = self.values.shape
        low, high = self.value_range
        return f"Lut({self.kind!r}, {width}×{height}, values {low:.3g} to {high:.3g})"

    def _repr_png_(self) -> bytes:
        return png_bytes(srgb_from_linear(self.values.astype(np.float64)))


def checked_size(size: tuple[int, int]) -> tuple[int, int]:
    """Return (width, height) after a check.

    Raises
    ------
    ArgumentError
        If a side is not 2..16384, or there are more texels than 4096×4096: the limits ``table_side`` and
        ``table_texels`` of `skinshade.Limits`.
    """
    try:
        width, height = (operator.index(n) for n in size)
    except (TypeError, ValueError):
        raise ArgumentError(f"size is {size!r}; it must be (width, height) in texels") from None
    if not 2 <= min(width, height) <= max(width, height) <= limits().table_side:
        allowed = limit_range("table_side", 2, max(width, height))
        raise ArgumentError(f"size is {width}×{height}; each side must be {allowed}")
    check_limit("table_texels", width * height, f"size is {width}×{height}")
    return width, height


def checked_range(name: str, range_mm: tuple[float, float]) -> tuple[float, float]:
    """Return (least, greatest) after a check; `name` is the argument's name.

    Raises
    ------
    ArgumentError
        If the two are not finite, positive and increasing.
    """
    least, greatest = (float(value) for value in as_floats(name, range_mm, (2,)))
    if not 0.0 < least < greatest:
        raise ArgumentError(
            f"{name} is ({least:g}, {greatest:g}); the two must be positive and increase"
        )
    return least, greatest
