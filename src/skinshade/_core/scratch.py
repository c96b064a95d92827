"""Memory for intermediate arrays, from one block."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from math import prod
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

__all__ = ["Scratch"]

PAGE = 1 << 21
"""Size of a huge page. The first use of a page of 4 KiB can take longer than the work on its content."""
SMALL = 1 << 18
"""Size below which a block has small pages."""
LEAST = 1 << 22
"""Size from which NumPy asks the system for huge pages."""
LINE = 64
"""Bytes of a cache line, at whose start every array begins."""


class Scratch:
    """Block of memory from which arrays are taken in the manner of a stack.

    Parameters
    ----------
    size
        Bytes that all arrays take together at any time. Further arrays get memory of their own.
    """

    def __init__(self, size: int) -> None:
        huge = size >= SMALL
        length, alignment = (max(size, LEAST), PAGE) if huge else (size, LINE)
        block = np.empty(length + alignment, dtype=np.uint8)
        start = -block.ctypes.data % alignment
        self._block = block[start : start + length]
        self._used = 0

    def take(self, shape: int | tuple[int, ...], dtype: DTypeLike = np.float64) -> NDArray[Any]:
        """Return an array with arbitrary content, valid until the end of the enclosing `temporary`."""
        lengths = (shape,) if isinstance(shape, int) else shape
        kind = np.dtype(dtype)
        size = prod(lengths) * kind.itemsize
        if self._used + size > self._block.size:
            return np.empty(lengths, dtype=kind)
        array = self._block[self._used : self._used + size].view(kind).reshape(lengths)
        self._used += -(-size // LINE) * LINE
        return array

    def give_back(self, array: NDArray[Any]) -> None:
        """Free the array that was taken last."""
        if np.shares_memory(array, self._block):
            self._used -= -(-array.nbytes // LINE) * LINE

    @contextmanager
    def temporary(self) -> Iterator[None]:
        """Free the arrays that are taken in this context at its end."""
        used = self._used
        try:
            yield
        finally:
            self._used = used
