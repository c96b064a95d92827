"""A lookup table that knows its axes, units, range and origin."""

from __future__ import annotations

import operator
import os
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import FloatArray, ImageArray, as_floats
from .._core.errors import ArgumentError

__all__ = ["Axis", "Lut", "LutKind", "checked_size"]

LutKind = Literal["curvature", "shadow", "transfer"]
Spacing = Literal["linear", "sqrt"]


@dataclass(frozen=True)
class Axis:
    """One axis of a table; its texel centres stand at (i + ½)/n of the way from low to high.

    Attributes
    ----------
    name, unit
        What is looked up, and in which unit (``1`` for none).
    low, high
        Its values at the outer edges of the first and last texel.
    spacing
        ``linear``, or ``sqrt`` where equal steps are equal steps of the square root.
    """

    name: str
    unit: str
    low: float
    high: float
    spacing: Spacing = "linear"

    def __post_init__(self) -> None:
        if self.spacing not in get_args(Spacing):
            raise ArgumentError(f"axis {self.name}: spacing is {self.spacing!r}; linear or sqrt")
        if not (np.isfinite(self.low) and np.isfinite(self.high) and self.low < self.high):
            raise ArgumentError(f"axis {self.name}: from {self.low} to {self.high} does not rise")
        if self.spacing == "sqrt" and self.low < 0.0:
            raise ArgumentError(
                f"axis {self.name}: from {self.low}; a sqrt axis starts at 0 or above"
            )

    @property
    def warped_ends(self) -> tuple[float, float]:
        """Low and high, as their square roots where the spacing is ``sqrt``."""
        low, high = self._warp(np.array([self.low, self.high]))
        return float(low), float(high)

    def centres(self, count: int) -> FloatArray:
        """Return the values (count,) at the texel centres."""
        low, high = self.warped_ends
        steps = low + (high - low) * (np.arange(count) + 0.5) / count
        return np.square(steps) if self.spacing == "sqrt" else steps

    def coordinate(self, value: FloatArray) -> FloatArray:
        """Return where values lie, 0 at the low edge, 1 at the high one, clamped."""
        low, high = self.warped_ends
        clamped = np.clip(value, self.low, self.high)
        result: FloatArray = (self._warp(clamped) - low) / (high - low)
        return result

    def _warp(self, value: FloatArray) -> FloatArray:
        return np.sqrt(value) if self.spacing == "sqrt" else value


@dataclass(frozen=True)
class Lut:
    """A table of RGB values.

    Attributes
    ----------
    values
        (H, W, 3) float32, physical: no encoding, no offset.
    kind
        ``curvature``, ``shadow`` or ``transfer``.
    columns, rows
        What runs along the width and the height.
    provenance
        Profile, parameters and version that made it; JSON types only.
    """

    values: ImageArray
    kind: LutKind
    columns: Axis
    rows: Axis
    provenance: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.values.ndim != 3 or self.values.shape[2] != 3 or min(self.values.shape) < 2:
            raise ArgumentError(
                f"values: shape is {self.values.shape}; it must be (H, W, 3), H and W 2 at least"
            )
        if not np.isfinite(self.values).all():
            raise ArgumentError("values: a table must be finite")
        if self.kind not in get_args(LutKind):
            raise ArgumentError(f"kind is {self.kind!r}; it must be curvature, shadow or transfer")

    @property
    def axes(self) -> tuple[float, float, float, float]:
        """What shaders take: low and 1/(high − low) of the columns, then of the rows, as they are warped."""
        (left, right), (top, bottom) = self.columns.warped_ends, self.rows.warped_ends
        return left, 1.0 / (right - left), top, 1.0 / (bottom - top)

    @property
    def value_range(self) -> tuple[float, float]:
        """The least and the greatest value."""
        return float(self.values.min()), float(self.values.max())

    def sample(self, column: ArrayLike, row: ArrayLike) -> FloatArray:
        """Look values up, bilinearly, clamped at the edges: what a GPU sampler does.

        Parameters
        ----------
        column
            (...) N·L (curvature), the value of the wide shadow filter (shadow), or a spatial frequency
            (transfer).
        row
            (...) curvature, or N·L over the filter's width, 1/mm; of no account for transfer.

        Returns
        -------
        (..., 3)
        """
        u = self.columns.coordinate(as_floats("column", column))
        v = self.rows.coordinate(as_floats("row", row))
        return self.sample_at(u, v)

    def sample_at(self, u: FloatArray, v: FloatArray) -> FloatArray:
        """Look all channels up (..., 3) at texture coordinates u and v (...), 0..1; no check."""
        return self._bilinear(u[..., None], v[..., None])

    def sample_channels(self, u: FloatArray, v: FloatArray) -> FloatArray:
        """Look each channel up in a column of its own: u (..., 3), v (...), in 0..1; no check."""
        return self._bilinear(u, v[..., None])

    def _bilinear(self, u: FloatArray, v: FloatArray) -> FloatArray:
        height, width, _ = self.values.shape
        x = np.clip(u * width - 0.5, 0.0, width - 1.0)
        y = np.clip(v * height - 0.5, 0.0, height - 1.0)
        x0 = np.minimum(x.astype(np.int64), width - 2)
        y0 = np.minimum(y.astype(np.int64), height - 2)
        fx, fy = x - x0, y - y0
        at = (y0 * width + x0) * 3 + np.arange(3)
        t = self.values.ravel()
        top = t[at] * (1.0 - fx) + t[at + 3] * fx
        at += 3 * width
        bottom = t[at] * (1.0 - fx) + t[at + 3] * fx
        result: FloatArray = top * (1.0 - fy) + bottom * fy
        return result

    def description(self) -> dict[str, Any]:
        """Return all but the values, as JSON types: what the files carry beside them."""
        return {
            "kind": self.kind,
            "columns": asdict(self.columns),
            "rows": asdict(self.rows),
            "provenance": dict(self.provenance),
        }

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write to a path: ``.exr`` (float), ``.png`` (16 bits, range in the metadata) or ``.npz``.

        EXR and npz load back equal; PNG to half a step of range/65535 per channel.

        Raises
        ------
        OutputError, ArgumentError
            If the place cannot be written, or the suffix is another.
        """
        from .files import save_lut

        save_lut(self, path)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Lut:
        """Read what `save` wrote.

        Parameters
        ----------
        path
            ``.exr``, ``.png`` or ``.npz``.

        Raises
        ------
        LutFileError
            If the file is missing, corrupt, or carries no description of its axes.
        """
        from .files import load_lut

        return load_lut(path)


def checked_size(size: tuple[int, int]) -> tuple[int, int]:
    """Return (width, height) if each is 2..16384.

    Raises
    ------
    ArgumentError
    """
    try:
        width, height = (operator.index(n) for n in size)
    except (TypeError, ValueError):
        raise ArgumentError(f"size is {size!r}; it must be (width, height) in texels") from None
    if not (2 <= width <= 16384 and 2 <= height <= 16384):
        raise ArgumentError(f"size is {width}×{height}; each side must be 2..16384 texels")
    return width, height
