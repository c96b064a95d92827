"""Choice of compiled kernels or their NumPy twins, and of the number of threads, in tests."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np
import pytest

from skinshade._core import native

needs_library = pytest.mark.skipif(not native.available(), reason=native.reason())


@contextmanager
def numpy_twins() -> Iterator[None]:
    """Use NumPy although the library is available."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(native, "_state", lambda: (None, "switched off by a test"))
        yield


@contextmanager
def threads(count: int) -> Iterator[None]:
    """Use a number of threads, and as many ranges."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(native, "thread_count", lambda: count)
        patch.setattr(native, "GRAIN", 16)
        patch.setattr(native, "blocks", lambda length, grain=16: native._bounds(length, 2 * count))
        patch.setattr(native, "parts", lambda length, grain=16: native._bounds(length, count))
        yield


@contextmanager
def level(name: str) -> Iterator[None]:
    """Use the kernels of a level of instructions: v2 or v3."""
    library = native.Library.load(native.library_path(), native.source_hash(), name)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(native, "_state", lambda: (library, name))
        yield


def both(function, *arguments):
    """Return the results of the compiled kernels and of NumPy."""
    compiled = function(*arguments)
    with numpy_twins():
        return compiled, function(*arguments)


def relative_gap(value: np.ndarray, expected: np.ndarray) -> float:
    """Return the greatest difference, relative to the greatest expected value."""
    scale = np.abs(expected).max(initial=0.0)
    return float(np.abs(value - expected).max(initial=0.0) / (scale or 1.0))
