"""Times of passes on a device."""

from __future__ import annotations

from typing import Any

import numpy as np

from .device import BufferUsage, GPUDevice

__all__ = ["Stopwatch"]

NS_PER_MS = 1e6
PASS_LIMIT = 64
"""Greatest number of passes between two readings; further passes are not timed."""


class Stopwatch:
    """Timer of passes, by timestamps on the device.

    Parameters
    ----------
    device
        Device of the passes. Without its feature ``timestamp-query``, no pass is timed.
    """

    def __init__(self, device: GPUDevice) -> None:
        self.device = device
        self.enabled = "timestamp-query" in device.features
        self._names: list[str] = []
        if self.enabled:
            count = 2 * PASS_LIMIT
            self._queries = device.create_query_set(type="timestamp", count=count)
            usage = BufferUsage.QUERY_RESOLVE | BufferUsage.COPY_SRC
            self._ticks = device.create_buffer(size=8 * count, usage=usage)

    def around(self, name: str) -> dict[str, Any]:
        """Return entries for the descriptor of the next pass, which time the pass under a `name`."""
        if not self.enabled or len(self._names) == PASS_LIMIT:
            return {}
        first = 2 * len(self._names)
        self._names.append(name)
        ends = {"beginning_of_pass_write_index": first, "end_of_pass_write_index": first + 1}
        return {"timestamp_writes": {"query_set": self._queries, **ends}}

    def read_ms(self) -> dict[str, list[float]]:
        """Wait for all passes since the last reading, and return their times, ms, by name."""
        if not self._names:
            return {}
        encoder = self.device.create_command_encoder()
        encoder.resolve_query_set(self._queries, 0, 2 * len(self._names), self._ticks, 0)
        self.device.queue.submit([encoder.finish()])
        ticks = np.frombuffer(self.device.queue.read_buffer(self._ticks), dtype=np.uint64)
        times: dict[str, list[float]] = {}
        for name, begin, end in zip(self._names, ticks[0::2], ticks[1::2], strict=False):
            times.setdefault(name, []).append((int(end) - int(begin)) / NS_PER_MS)
        self._names = []
        return times
