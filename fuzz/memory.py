"""Memory of this process: its growth to a peak, and the limit of its address space."""

from __future__ import annotations

import resource
import sys
from pathlib import Path

__all__ = ["limit_address_space", "peak_growth", "reset_peak"]

STATUS, RESET = "/proc/self/status", "/proc/self/clear_refs"
RESET_PEAK = b"5"
"""Text that sets the peak of the resident memory to its present value."""
_start = 0


def reset_peak() -> None:
    """Begin a measurement of `peak_growth`."""
    global _start
    if sys.platform == "linux":
        with open(RESET, "wb", buffering=0) as file:  # noqa: PTH123 — as fast as possible
            file.write(RESET_PEAK)
    _start = _peak()


def peak_growth() -> int:
    """Return the bytes by which the resident memory has grown to its peak since `reset_peak`.

    Systems without ``/proc`` only report growth beyond the peak of all former measurements.
    """
    return max(_peak() - _start, 0)


def limit_address_space(more: int) -> None:
    """Make allocations fail beyond `more` bytes above the present address space, on Linux."""
    if sys.platform == "linux":
        pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
        limit = pages * resource.getpagesize() + more
        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))


def _peak() -> int:
    """Return the peak of the resident memory, bytes."""
    if sys.platform == "linux":
        with open(STATUS, "rb", buffering=0) as file:  # noqa: PTH123
            text = file.read(4096)
        start = text.index(b"VmHWM:") + 6
        return int(text[start : text.index(b"kB", start)]) << 10
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak if sys.platform == "darwin" else peak << 10
