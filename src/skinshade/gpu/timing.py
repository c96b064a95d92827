"""How long a pass takes on the device itself."""

from __future__ import annotations

from typing import Any

import numpy as np
import wgpu

__all__ = ["Stopwatch"]

NS_PER_MS = 1e6


class Stopwatch:
    """Timestamps around one pass; without the feature it measures nothing.

    Parameters
    ----------
    device
        With the feature ``timestamp-query``, if it is to measure.
    """

    def __init__(self, device: wgpu.GPUDevice) -> None:
        self.device = device
        self.measures = "timestamp-query" in device.features
        if self.measures:
            self._times = device.create_query_set(type="timestamp", count=2)
            usage = wgpu.BufferUsage.QUERY_RESOLVE | wgpu.BufferUsage.COPY_SRC
            self._ticks = device.create_buffer(size=16, usage=usage)

    def around(self) -> dict[str, Any]:
        """Return what a pass's descriptor needs."""
        if not self.measures:
            return {}
        ends = {"beginning_of_pass_write_index": 0, "end_of_pass_write_index": 1}
        return {"timestamp_writes": {"query_set": self._times, **ends}}

    def resolve(self, encoder: wgpu.GPUCommandEncoder) -> None:
        """Copy the times out, after the pass and before submission."""
        if self.measures:
            encoder.resolve_query_set(self._times, 0, 2, self._ticks, 0)

    def read_ms(self) -> list[float]:
        """Return the pass's time, ms, after submission; nothing where it cannot be measured."""
        if not self.measures:
            return []
        begin, end = np.frombuffer(self.device.queue.read_buffer(self._ticks), dtype=np.uint64)
        return [(int(end) - int(begin)) / NS_PER_MS]
