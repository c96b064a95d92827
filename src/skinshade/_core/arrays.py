"""Array types, and checks of shape, type and range for arguments."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import native
from .errors import ArgumentError

__all__ = [
    "FloatArray",
    "FloatRows",
    "FloatVector",
    "ImageArray",
    "ImageStack",
    "IndexRows",
    "IntArray",
    "as_direction",
    "as_faces",
    "as_floats",
    "as_position",
    "as_positions",
    "as_rgb",
    "as_triple",
    "bounding_sphere",
    "dot",
    "unit_vectors",
]

LARGEST_POSITION = 1e15
"""Greatest coordinate: greater ones are implausible in any unit, and their fourth powers overflow."""

LARGE = 1 << 15
"""Elements from which a compiled check is faster than several passes of NumPy."""

LARGEST_LIGHT = 1e6
"""Greatest irradiance, radiance of a background, and factor on light. Sunlight is 1e5 lux. Products of light,
factors and materials stay below 1e35, which is finite in float32."""
LARGEST_RADIANCE = 1e9
"""Greatest radiance of an environment: that of the sun's disk in cd/m²."""

FloatArray = NDArray[np.float64]
"""Floats of any shape."""
FloatVector = np.ndarray[tuple[int], np.dtype[np.float64]]
"""Floats (n,)."""
FloatRows = np.ndarray[tuple[int, int], np.dtype[np.float64]]
"""Floats (n, m): a row for every vertex, point or texel."""
IntArray = NDArray[np.int64]
"""Indices of any shape."""
IndexRows = np.ndarray[tuple[int, int], np.dtype[np.int64]]
"""Indices (n, m), such as the faces of a mesh."""
ImageArray = np.ndarray[tuple[int, int, int], np.dtype[np.float32]]
"""Images (H, W, channels)."""
ImageStack = np.ndarray[tuple[int, int, int, int], np.dtype[np.float32]]
"""Images of one size (n, H, W, channels)."""


def as_floats(
    name: str,
    value: ArrayLike,
    shape: Sequence[int | None] | None = None,
    *,
    low: float = -np.inf,
    high: float = np.inf,
    copy: bool = True,
) -> FloatArray:
    """Return an argument as finite float64 array, after checks.

    Parameters
    ----------
    name
        Name of the argument, for the error message.
    value
        The argument.
    shape
        Required length of each axis, ``None`` for any length; ``None`` for any shape.
    low, high
        Closed range of the elements.
    copy
        Return a new array in any case. Without it, an array of float64 is returned itself.

    Raises
    ------
    ArgumentError
        Names the argument, the first index at fault and its value.
    """
    try:
        raw = np.asarray(value)
        if raw.dtype.kind == "c":
            raise TypeError("complex numbers")
        array = raw.astype(np.float64, copy=copy)
    except (TypeError, ValueError, OverflowError) as error:
        raise ArgumentError(f"{name}: not an array of numbers ({error})") from None
    if shape is not None:
        fits = array.ndim == len(shape) and all(
            required is None or length == required
            for length, required in zip(array.shape, shape, strict=True)
        )
        if not fits:
            text = ", ".join("any" if length is None else str(length) for length in shape)
            raise ArgumentError(f"{name}: shape is {array.shape}; it must be ({text})")
    if _large_and_inside(array, low, high):
        return array
    bad = ~np.isfinite(array)
    if bad.any():
        raise ArgumentError(f"{name}{_first(array, bad)}; it must be finite")
    bad = (array < low) | (array > high)
    if bad.any():
        raise ArgumentError(f"{name}{_first(array, bad)}; it must lie in [{low:g}, {high:g}]")
    return array


def as_positions(name: str, value: ArrayLike, *, copy: bool = True) -> FloatArray:
    """Return `value` as (V, 3) positions whose squares and products do not overflow float64.

    Raises
    ------
    ArgumentError
        As `as_floats`, with the range ±`LARGEST_POSITION`.
    """
    return as_floats(
        name, value, (None, 3), low=-LARGEST_POSITION, high=LARGEST_POSITION, copy=copy
    )


def as_position(name: str, value: ArrayLike) -> FloatVector:
    """Return `value` as one position (3,), after checks as in `as_positions`."""
    return as_positions(name, as_floats(name, value, (3,))[None])[0]


def as_direction(name: str, value: ArrayLike) -> FloatVector:
    """Return `value` (3,) as a unit vector.

    Raises
    ------
    ArgumentError
        If it is not three finite numbers, or all of them are zero.
    """
    direction = as_floats(name, value, (3,))
    greatest = np.abs(direction).max()
    if greatest == 0.0:
        raise ArgumentError(f"{name} is 0, 0, 0; it must be a direction")
    if not 1e-100 < greatest < 1e100:  # the squares would underflow or overflow
        direction = direction / greatest
    return unit_vectors(direction)


def as_rgb(
    name: str, value: ArrayLike, *, low: float = -np.inf, high: float = np.inf
) -> FloatArray:
    """Return one number or three (R, G, B) as an array (3,), after checks as in `as_floats`."""
    array = as_floats(name, value, low=low, high=high)
    if array.shape not in ((), (3,)):
        raise ArgumentError(
            f"{name}: shape is {array.shape}; it must be one number or three (R, G, B)"
        )
    return np.array(np.broadcast_to(array, (3,)))


def as_faces(name: str, value: ArrayLike, vertex_count: int) -> IntArray:
    """Return `value` as triangles (F, 3) int64, after a check of every index.

    Raises
    ------
    ArgumentError
        If the shape or the type is wrong, or an index is not 0..`vertex_count` − 1.
    """
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise ArgumentError(f"{name}: not an array of indices ({error})") from None
    if array.ndim != 2 or array.shape[1] != 3:
        raise ArgumentError(f"{name}: shape is {array.shape}; it must be (any, 3)")
    if array.dtype.kind not in "iu":
        raise ArgumentError(f"{name}: type is {array.dtype}; it must be an integer type")
    if not _large_and_inside(array, 0, vertex_count - 1):
        bad = (array < 0) | (array >= vertex_count)
        if bad.any():
            raise ArgumentError(f"{name}{_first(array, bad)}; there are {vertex_count} vertices")
    return array.astype(np.int64, copy=False)


def _large_and_inside(array: NDArray[Any], low: float, high: float) -> bool:
    """Return whether a large array is finite and in [low, high], by a compiled check in one pass.

    Small arrays, types without a kernel and arrays with a fault give False; NumPy checks them.
    """
    if array.size < LARGE or not array.flags.c_contiguous or not native.available():
        return False
    if array.dtype in native.FLOAT_KINDS:
        faults = native.run("first_outside", native.blocks(array.size), array, low, high)
    elif array.dtype in native.INDEX_KINDS:
        faults = native.run("first_bad_index", native.blocks(array.size), array, high + 1)
    else:
        return False
    return max(faults) < 0


def dot(a: FloatArray, b: FloatArray) -> FloatArray:
    """Return the scalar product over the last axis, which is short: a sum over its elements.

    A product beyond the range of the type is infinite, without a warning.
    """
    with np.errstate(over="ignore", invalid="ignore"):
        result: FloatArray = a[..., 0] * b[..., 0]
        for axis in range(1, a.shape[-1]):
            result = result + a[..., axis] * b[..., axis]
    return result


def bounding_sphere(points: FloatArray) -> tuple[FloatArray, float]:
    """Return the middle (3,) of the bounding box of `points` (N, 3), and the distance of the farthest one."""
    middle: FloatArray = 0.5 * (points.min(axis=0) + points.max(axis=0))
    return middle, float(np.sqrt(dot(points - middle, points - middle).max()))


def unit_vectors(vectors: FloatArray) -> FloatArray:
    """Return `vectors` (..., 3) at length 1; a zero vector stays zero."""
    length = np.sqrt(dot(vectors, vectors))[..., None]
    result: FloatArray = vectors / np.where(length > 0.0, length, 1.0)
    return result


def _first(array: NDArray[np.generic], bad: NDArray[np.bool_]) -> str:
    """Return the first index at fault and its value, as text."""
    index = tuple(int(i) for i in np.argwhere(bad)[0])
    text = "[" + ", ".join(map(str, index)) + "]" if index else ""
    return f"{text} is {array[index]}"


def as_triple(values: FloatArray) -> tuple[float, float, float]:
    """Return an array (3,) as a tuple."""
    x, y, z = values.tolist()
    return x, y, z
