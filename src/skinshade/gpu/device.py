"""Adapters and devices: which GPU, and what it can do."""

from __future__ import annotations

import os
import tempfile
from functools import cache

import wgpu

from .._core.errors import BackendError

__all__ = ["adapters", "open_device"]

WANTED = ("float32-filterable", "timestamp-query")
"""The first is for tables in full, with which the parity of the library is measured."""
PREFERENCE = ("DiscreteGPU", "IntegratedGPU", "VirtualGPU", "CPU", "Unknown")


@cache
def adapters() -> list[wgpu.GPUAdapter]:
    """Return the adapters that can draw, real hardware first, software last."""
    # Without it Mesa's software driver complains on standard error.
    os.environ.setdefault("XDG_RUNTIME_DIR", tempfile.gettempdir())
    try:
        found = wgpu.gpu.enumerate_adapters_sync()
    except Exception:  # the library raises whatever its loader met
        return []
    # OpenGL cannot read a storage buffer in a vertex shader everywhere.
    usable = [each for each in found if each.info["backend_type"] != "OpenGL"]
    return sorted(usable, key=lambda each: PREFERENCE.index(_kind(each)))


def _kind(adapter: wgpu.GPUAdapter) -> str:
    kind = str(adapter.info["adapter_type"])
    return kind if kind in PREFERENCE else "Unknown"


def open_device(name: str | None = None, *, software: bool = True) -> wgpu.GPUDevice:
    """Open the best adapter.

    Parameters
    ----------
    name
        Part of the adapter's name, in any case; any adapter if None.
    software
        Whether an adapter that is no hardware will do.

    Raises
    ------
    BackendError
        If there is none, or it refuses.
    """
    found = [each for each in adapters() if software or _kind(each) != "CPU"]
    if not found:
        asked = f" where {name!r} was asked for" if name else ""
        raise BackendError(
            f"backend gpu: no adapter was found{asked}; install a GPU driver or Mesa's lavapipe,"
            " or use --backend cpu"
        )
    chosen = [each for each in found if name is None or name.lower() in each.info["device"].lower()]
    if not chosen:
        there = ", ".join(each.info["device"] for each in found)
        raise BackendError(f"no adapter is called {name!r}; there are {there}")
    adapter = chosen[0]
    try:
        return adapter.request_device_sync(
            required_features=[each for each in WANTED if each in adapter.features]
        )
    except Exception as error:  # a driver's own words
        raise BackendError(f"{adapter.info['device']}: gives no device ({error})") from None
