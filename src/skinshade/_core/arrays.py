"""Checks of shape, type and finiteness, at the border where arrays come in."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import ArgumentError

__all__ = [
    "FloatArray",
    "ImageArray",
    "IntArray",
    "as_faces",
    "as_floats",
    "as_positions",
    "as_rgb",
    "as_triple",
    "bounding_sphere",
    "dot",
    "unit_vectors",
]

LARGEST_POSITION = 1e15
"""Coordinates beyond it are no lengths of a body in any unit, and their fourth powers overflow."""

FloatArray = NDArray[np.float64]
ImageArray = NDArray[np.float32]
IntArray = NDArray[np.int64]


def as_floats(
    name: str,
    value: ArrayLike,
    shape: Sequence[int | None] | None = None,
    *,
    low: float = -np.inf,
    high: float = np.inf,
) -> FloatArray:
    """Return `value` as finite float64 of a given shape and range.

    Parameters
    ----------
    name
        What the caller calls it; stands in the message.
    shape
        One entry an axis, ``None`` where any length will do; ``None`` for any shape.
    low, high
        The closed range that every element must lie in.

    Raises
    ------
    ArgumentError
        Names the argument, the first index at fault and its value.
    """
    try:
        raw = np.asarray(value)
        if raw.dtype.kind == "c":
            raise TypeError("complex numbers")
        array = raw.astype(np.float64)
    except (TypeError, ValueError, OverflowError) as error:
        raise ArgumentError(f"{name}: not an array of numbers ({error})") from None
    if shape is not None:
        fits = array.ndim == len(shape) and all(
            want is None or have == want for have, want in zip(array.shape, shape, strict=True)
        )
        if not fits:
            wanted = ", ".join("any" if want is None else str(want) for want in shape)
            raise ArgumentError(f"{name}: shape is {array.shape}; it must be ({wanted})")
    bad = ~np.isfinite(array)
    if bad.any():
        raise ArgumentError(f"{name}{_first(array, bad)}; it must be finite")
    bad = (array < low) | (array > high)
    if bad.any():
        raise ArgumentError(f"{name}{_first(array, bad)}; it must lie in [{low:g}, {high:g}]")
    return array


def as_positions(name: str, value: ArrayLike) -> FloatArray:
    """Return `value` as (V, 3) positions whose squares and products stay within float64.

    Raises
    ------
    ArgumentError
        As `as_floats`; beyond ±`LARGEST_POSITION` too.
    """
    return as_floats(name, value, (None, 3), low=-LARGEST_POSITION, high=LARGEST_POSITION)


def as_rgb(
    name: str, value: ArrayLike, *, low: float = -np.inf, high: float = np.inf
) -> FloatArray:
    """Return `value` as three channels, repeating a scalar."""
    array = as_floats(name, value, low=low, high=high)
    if array.shape not in ((), (3,)):
        raise ArgumentError(
            f"{name}: shape is {array.shape}; it must be one number or three (R, G, B)"
        )
    return np.array(np.broadcast_to(array, (3,)))


def as_faces(name: str, value: ArrayLike, vertex_count: int) -> IntArray:
    """Return `value` as (F, 3) int64 whose every index is that of a vertex.

    Raises
    ------
    ArgumentError
        If the shape is another, or an index is out of range.
    """
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise ArgumentError(f"{name}: not an array of indices ({error})") from None
    if array.ndim != 2 or array.shape[1] != 3:
        raise ArgumentError(f"{name}: shape is {array.shape}; it must be (any, 3)")
    if array.dtype.kind not in "iu":
        raise ArgumentError(f"{name}: type is {array.dtype}; it must be an integer type")
    bad = (array < 0) | (array >= vertex_count)
    if bad.any():
        raise ArgumentError(f"{name}{_first(array, bad)}; there are {vertex_count} vertices")
    return array.astype(np.int64, copy=False)


def dot(a: FloatArray, b: FloatArray) -> FloatArray:
    """Return the scalar product over the last axis, without a temporary of the product."""
    result: FloatArray = np.einsum("...i,...i->...", a, b)
    return result


def bounding_sphere(points: FloatArray) -> tuple[FloatArray, float]:
    """Return the middle (3,) of the box about `points` (N, 3), and the distance of the farthest of them."""
    middle: FloatArray = 0.5 * (points.min(axis=0) + points.max(axis=0))
    return middle, float(np.sqrt(dot(points - middle, points - middle).max()))


def unit_vectors(vectors: FloatArray) -> FloatArray:
    """Return `vectors` (..., 3) at length 1; a zero vector stays zero."""
    length = np.sqrt(dot(vectors, vectors))[..., None]
    result: FloatArray = vectors / np.where(length > 0.0, length, 1.0)
    return result


def _first(array: NDArray[np.generic], bad: NDArray[np.bool_]) -> str:
    index = tuple(int(i) for i in np.argwhere(bad)[0])
    place = "[" + ", ".join(map(str, index)) + "]" if index else ""
    return f"{place} is {array[index]}"


def as_triple(values: FloatArray) -> tuple[float, float, float]:
    """Return three numbers as a tuple; no check."""
    x, y, z = (float(each) for each in values)
    return x, y, z
