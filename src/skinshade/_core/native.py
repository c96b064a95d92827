"""Compiled kernels: loads the library of ``native/`` and calls its functions.

Every kernel has a NumPy twin with the same results within a tolerance, which serves where `available` is
false. Only this file loads the library. A kernel works on a range of blocks, rows or vertices; `run` calls
it for all ranges, in several threads, because ctypes releases Python's lock.
"""

from __future__ import annotations

import ctypes
import os
from collections import deque
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from .errors import ArgumentError, SkinshadeError
from .native_sources import FOLDER, library_name, source_hash

__all__ = ["available", "blocks", "library_path", "parts", "reason", "run", "thread_count"]

Array = NDArray[Any]
Argument = Array | int | float | None
PerRange = list[Array] | list[int]
"""One argument for every range."""

SWITCH = "SKINSHADE_NATIVE"
"""Environment variable: 0 chooses NumPy; a folder is where another library lies."""
LEVEL_NAMES = {"v3": "x86-64-v3", "v2": "x86-64-v2", "base": "baseline"}
GRAIN = 1 << 14
"""Least elements of a range. The call of a kernel takes as long as its work on about a hundred."""
RANGES_PER_THREAD = 8
"""Ranges that every thread gets, so that all end at about the same time."""
MOST_PARTS = 8
"""Greatest number of parts with a table of their own."""

FLOAT_KINDS = {np.dtype(np.float32): 0, np.dtype(np.float64): 1}
INDEX_KINDS = {np.dtype(np.int32): 2, np.dtype(np.int64): 3}
ROW_KINDS = {"points": FLOAT_KINDS, "faces": INDEX_KINDS, "rows": FLOAT_KINDS | INDEX_KINDS}
"""Parameters whose type the kernel learns: a pointer, and the number of the type as in kernels.h."""
TABLES: dict[str, DTypeLike] = {
    "float*": np.float32,
    "double*": np.float64,
    "uint8*": np.uint8,
    "uint32*": np.uint32,
    "uint64*": np.uint64,
    "int64*": np.int64,
}
NUMBERS = {"int32": ctypes.c_int32, "int64": ctypes.c_int64, "double": ctypes.c_double}

KERNELS: dict[str, str] = {
    "first_outside": "int64: points range double double",
    "first_bad_index": "int64: faces range int64",
    "equal_count": "rows range int32 uint32*",
    "equal_scatter": "rows range int32 uint32* uint64* uint32*",
    "equal_match": "int64: rows uint64* uint32* range uint32* uint32*",
    "equal_firsts": "int64: uint32* range",
    "equal_number": "uint32* range int64 uint32* uint32*",
    "equal_group": "uint32* uint32* range uint32*",
    "bounds": "points range double*",
    "order_keys": "points uint32*? range double* uint64*",
    "radix_count": "uint64* range int32 int32 uint32*",
    "radix_scatter": "uint64* range int32 int32 uint32* uint64*",
    "order_ranks": "uint64* range uint32*",
    "order_sources": "uint64* uint32*? range uint32*",
    "look_up": "uint32* range uint32*",
    "faces_remap": "faces range uint32* int32 uint32* uint32*",
    "faces_scatter": "uint32* range int32 uint32* uint32*",
    "pack": "points uint32*? range int32 double*",
    "count_not_unit": "int64: double* range",
    "sum_normals": "points uint8* uint32* int64 range double*",
    "unpack": "double* int64 uint32* range double*",
    "project": "double* int64 points uint32*? range double*",
    "corner_count": "faces range uint32*? int64 uint32*",
    "corner_sum": "int64: uint32* int64 int64 range uint32*",
    "corner_starts": "uint32* int64 int64 uint32* range int64 uint32* uint32*",
    "corner_fill": "faces range uint32*? uint32* uint32*",
    "vertex_normals": "double* uint32* uint32* uint32* int64 range double* double*",
    "fit": "double* double* uint32* uint32* uint32* int64 range double* double* double*? uint8*?",
    "weigh_mean": "double* double* range double*",
    "weigh_world": "double* double* double* range double*",
    "smooth_mean": "double* uint32* uint32* uint32* int64 range int32 double*",
    "smooth_world": "double* uint32* uint32* uint32* int64 range int32 double*",
    "face_areas": "points faces range double*",
    "add_thirds": "double* faces int64 range double*",
    "mark_used": "faces range uint8*",
    "side_squares": "points faces int64 range double*",
    "edges_fill": (
        "double* uint32* uint32* uint32* int64 range double int64* uint32* double* uint32*"
        " double* double*"
    ),
    "edges_pack": "int64* uint32* double* range int64* uint32* double*",
    "chebyshev_step": "int64* uint32* double* double* range int32 double* double* double* double*",
    "edge_faults": "uint32* uint32* uint32* int64 range uint32* int64*",
    "bvh_boxes": "double* faces range float* uint64*",
    "bvh_subtrees": "float* uint64* int64* int64* range uint32* uint8* uint8* uint32* float*",
    "bvh_top": "float* uint32* range int64 uint32* uint8* uint32*",
    "bvh_corners": "double* faces uint32* uint8* range double*",
    "ray_exits": "uint8* double* uint32* int64 double* double* range double*",
    "ray_hits": "uint8* double* uint32* int64 double* double* range double* int64* double*",
    "ray_blocks": "uint8* double* uint32* int64 double* double* double* range uint8*",
    "ray_sums": "uint8* double* uint32* int64 double* double* int64 range double* int64 int64 double*",
    "sample_volume": "float* int64 float* range double float*",
    "uv_ratios": "points double* faces int64 range double*",
    "raster_nearest": "double* double* int64* int64 int64 double* range double* int64*",
    "raster_list": (
        "int64: double* double* int64* int64 int64 double* range double* int64*? int64*? double*?"
    ),
    "raster_depths": "double* double* int64* int64 double* range double* double*",
    "raster_resolve": "double* int64* int64* int64* double* range double* double* double*",
    "lit_share": "float* int64 int64 double* double* double* double* double* int64 range double*",
    "mean_thickness": "double* int64 int64 double* double* double* double* int64 range double*",
    "fetch_texture": "float* int64 int64* int64 double* double* double* int64 range double*",
    "fetch_panorama": "float* int64* int64* double* double* int64 range double*",
    "fetch_table": "float* int64 int64 double* int64 double* int64 range double*",
    "halve_image": "float* int64 int64 int64 range float*",
    "interpolate": "double* int64 int64* int64* double* int64 range double*",
}
"""Result and parameters of every kernel, as in kernels.h. "?" allows None; "range" is first, last."""


@dataclass(frozen=True)
class Library:
    """A loaded library.

    Attributes
    ----------
    functions
        The kernels by name.
    level
        Level of instructions: v2 or v3 of x86-64, or base.
    """

    functions: dict[str, Any]
    level: str

    @classmethod
    def load(cls, path: Path, expected_hash: str, level: str | None = None) -> Library:
        """Return a library from a file.

        Parameters
        ----------
        path
            File of the library.
        expected_hash
            Hash of the sources that the library must be compiled from.
        level
            Level of instructions; the highest of this processor if None.

        Raises
        ------
        OSError
            If the file cannot be loaded.
        SkinshadeError
            If the library is compiled from other sources, or lacks a kernel.
        """
        loaded = ctypes.CDLL(str(path))
        try:
            loaded.skn_source_hash.restype = ctypes.c_char_p
            loaded.skn_has_v3.restype = ctypes.c_int32
            found = loaded.skn_source_hash().decode()
            if found != expected_hash:
                raise SkinshadeError(
                    f"{path}: is compiled from other sources ({found}, not {expected_hash}); "
                    "run `make native`, or install skinshade again"
                )
            if level is None:
                level = "base" if not hasattr(loaded, "skn_fit_v2") else "v2"
                level = "v3" if level == "v2" and loaded.skn_has_v3() else level
            functions = {name: getattr(loaded, f"skn_{name}_{level}") for name in KERNELS}
        except AttributeError as error:
            raise SkinshadeError(f"{path}: lacks a function ({error})") from None
        for name, function in functions.items():
            function.restype = ctypes.c_int64 if KERNELS[name].startswith("int64:") else None
            function.argtypes = [kind for word in _parameters(name) for kind in _c_types(word)]
        return cls(functions, level)


def available() -> bool:
    """Return whether compiled kernels are in use."""
    return _state()[0] is not None


def reason() -> str:
    """Return which kernels are in use and why, such as "compiled, x86-64-v3" or "SKINSHADE_NATIVE=0"."""
    return _state()[1]


def thread_count() -> int:
    """Return the number of threads that kernels use: the cores that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0)) or 1
    return os.cpu_count() or 1


def blocks(count: int, grain: int = GRAIN) -> list[int]:
    """Return the bounds of ranges of 0..`count` − 1 for `run`: several for every thread."""
    return _bounds(count, min(-(-count // grain), thread_count() * RANGES_PER_THREAD))


def parts(count: int, grain: int = GRAIN) -> list[int]:
    """Return the bounds of few ranges of 0..`count` − 1, for kernels with a table for every range."""
    return _bounds(count, min(-(-count // grain), thread_count(), MOST_PARTS))


def run(name: str, bounds: Sequence[int], *arguments: Argument | PerRange) -> list[int]:
    """Call a kernel for all ranges, and return its results in the order of the ranges.

    Parameters
    ----------
    name
        Name of the kernel in `KERNELS`.
    bounds
        Increasing bounds of the ranges.
    arguments
        Arguments of the kernel without the range; a list has one argument for every range.

    Raises
    ------
    ArgumentError
        If an array has another type than the kernel needs, or is not contiguous.
    """
    library = _state()[0]
    if library is None:
        raise SkinshadeError(f"{name}: the compiled kernels are not in use ({reason()})")
    function = library.functions[name]
    words = _parameters(name)
    wanted = len(words) - words.count("range")
    if len(arguments) != wanted:
        raise ArgumentError(f"{name}: has {wanted} arguments, not {len(arguments)}")
    converted, index = [], 0
    for word in words:
        if word == "range":
            converted.append(list(pairwise(bounds)))
            continue
        argument = arguments[index]
        index += 1
        if isinstance(argument, list):
            converted.append([_converted(name, word, one) for one in argument])
        else:
            converted.append([_converted(name, word, argument)] * (len(bounds) - 1))
    calls = [sum(call, ()) for call in zip(*converted, strict=True)]
    return _in_threads(function, calls)


def _in_threads(function: Any, calls: list[tuple[Any, ...]]) -> list[int]:
    """Return the results of calls, in the order of the calls; the calling thread works too."""
    results: list[int] = [0] * len(calls)
    if len(calls) <= 1 or thread_count() == 1:
        return [function(*call) for call in calls]
    left = deque(enumerate(calls))

    def work() -> None:
        while True:
            try:
                index, call = left.popleft()
            except IndexError:
                return
            results[index] = function(*call)

    pool = _pool(os.getpid())
    helpers = [pool.submit(work) for _ in range(min(thread_count(), len(calls)) - 1)]
    work()
    for helper in helpers:
        if not helper.cancel():
            helper.result()
    return results


@cache
def _pool(process: int) -> ThreadPoolExecutor:
    """Return the helper threads of a process; a forked process starts its own."""
    return ThreadPoolExecutor(max(1, thread_count() - 1), "skinshade")


def _bounds(count: int, ranges: int) -> list[int]:
    ranges = max(1, ranges)
    return [count * i // ranges for i in range(ranges + 1)]


def library_path() -> Path:
    """Return the path of the library, which may not exist."""
    folder = os.environ.get(SWITCH)
    return Path(folder or FOLDER) / library_name(source_hash(FOLDER))


@cache
def _state() -> tuple[Library | None, str]:
    if os.environ.get(SWITCH) == "0":
        return None, f"{SWITCH}=0"
    path = library_path()
    if not path.is_file():
        stale = sorted(other.name for other in path.parent.glob("*skinshade_native-*"))
        detail = f" ({', '.join(stale)} is compiled from other sources)" if stale else ""
        return None, f"no library: {path.name} does not exist{detail}; run `make native`"
    try:
        library = Library.load(path, source_hash(FOLDER))
    except (OSError, SkinshadeError) as error:
        return None, f"no library: {error}"
    return library, f"compiled, {LEVEL_NAMES[library.level]}"


@cache
def _parameters(name: str) -> tuple[str, ...]:
    return tuple(KERNELS[name].removeprefix("int64:").split())


def _c_types(word: str) -> tuple[Any, ...]:
    if word == "range":
        return ctypes.c_int64, ctypes.c_int64
    if word in NUMBERS:
        return (NUMBERS[word],)
    return (
        (ctypes.c_void_p, ctypes.c_int32) if word.rstrip("?") in ROW_KINDS else (ctypes.c_void_p,)
    )


def _converted(name: str, word: str, argument: Argument) -> tuple[Any, ...]:
    """Return the C arguments of one argument, after checks of its type."""
    if word in NUMBERS:
        return (argument,)
    kind = word.rstrip("?")
    if argument is None and word.endswith("?"):
        return (None, 0) if kind in ROW_KINDS else (None,)
    if not isinstance(argument, np.ndarray) or not argument.flags.c_contiguous:
        raise ArgumentError(f"{name}: {kind} must be a contiguous array, not {type(argument)}")
    if kind in ROW_KINDS:
        number = ROW_KINDS[kind].get(argument.dtype)
        if number is None:
            raise ArgumentError(f"{name}: type of {kind} is {argument.dtype}")
        return argument.ctypes.data, number
    if argument.dtype != TABLES[kind]:
        raise ArgumentError(f"{name}: type is {argument.dtype}; it must be {kind}")
    return (argument.ctypes.data,)
