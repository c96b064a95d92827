"""How long passes take on the device itself."""

from __future__ import annotations

from typing import Any

import numpy as np
import wgpu

__all__ = ["Stopwatch"]

NS_PER_MS = 1e6
MOST_PASSES = 64
"""Between two readings; what is beyond them goes untimed."""


class Stopwatch:
    """Timestamps around passes; without the feature it measures nothing.

    Parameters
    ----------
    device
        With the feature ``timestamp-query``, if it is to measure.
    """

    def __init__(self, device: wgpu.GPUDevice) -> None:
        self.device = device
        self.measures = "timestamp-query" in device.features
        self._names: list[str] = []
        if self.measures:
            count = 2 * MOST_PASSES
            self._times = device.create_query_set(type="timestamp", count=count)
            usage = wgpu.BufferUsage.QUERY_RESOLVE | wgpu.BufferUsage.COPY_SRC
            self._ticks = device.create_buffer(size=8 * count, usage=usage)

    def around(self, name: str) -> dict[str, Any]:
        """Return what the descriptor of the next pass needs."""
        if not self.measures or len(self._names) == MOST_PASSES:
            return {}
        at = 2 * len(self._names)
        self._names.append(name)
        ends = {"beginning_of_pass_write_index": at, "end_of_pass_write_index": at + 1}
        return {"timestamp_writes": {"query_set": self._times, **ends}}

    def read_ms(self) -> dict[str, list[float]]:
        """Return the times of all passes since the last reading, ms, by name; waits for them."""
        if not self._names:
            return {}
        encoder = self.device.create_command_encoder()
        encoder.resolve_query_set(self._times, 0, 2 * len(self._names), self._ticks, 0)
        self.device.queue.submit([encoder.finish()])
        ticks = np.frombuffer(self.device.queue.read_buffer(self._ticks), dtype=np.uint64)
        found: dict[str, list[float]] = {}
        for name, begin, end in zip(self._names, ticks[0::2], ticks[1::2], strict=False):
            found.setdefault(name, []).append((int(end) - int(begin)) / NS_PER_MS)
        self._names = []
        return found
