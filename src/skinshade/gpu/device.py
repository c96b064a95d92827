"""Adapters and devices. Only this file imports wgpu; other files import the names of wgpu from here."""

from __future__ import annotations

import os
import sys
import tempfile
from contextlib import suppress
from functools import cache
from importlib import import_module
from threading import Thread

import wgpu
from wgpu import (
    BufferUsage,
    GPUAdapter,
    GPUBindGroup,
    GPUBindGroupLayout,
    GPUBuffer,
    GPUCommandEncoder,
    GPUDevice,
    GPUError,
    GPURenderPassEncoder,
    GPURenderPipeline,
    GPUSampler,
    GPUShaderModule,
    GPUTexture,
    ShaderStage,
    TextureUsage,
)

from .._core.errors import BackendError
from .declarations import parse_used_names

__all__ = [
    "BufferUsage",
    "GPUAdapter",
    "GPUBindGroup",
    "GPUBindGroupLayout",
    "GPUBuffer",
    "GPUCommandEncoder",
    "GPUDevice",
    "GPUError",
    "GPURenderPassEncoder",
    "GPURenderPipeline",
    "GPUSampler",
    "GPUShaderModule",
    "GPUTexture",
    "ShaderStage",
    "TextureUsage",
    "adapters",
    "open_device",
    "open_device_ahead",
]

FEATURES = ("float32-filterable", "timestamp-query")
"""Optional features that are requested if an adapter has them: filters of float32 textures, for tables of
full precision in the parity tests, and times of passes."""
PREFERENCE = ("DiscreteGPU", "IntegratedGPU", "VirtualGPU", "CPU", "Unknown")
"""Types of adapters, in the order in which they are chosen."""


_AHEAD: dict[tuple[str | None, bool], Thread] = {}
_OPENED: dict[tuple[str | None, bool], GPUDevice] = {}
"""Threads that open devices ahead, and their devices, by the arguments of `open_device`."""


@cache
def adapters() -> list[GPUAdapter]:
    """Return the usable adapters, hardware first, software last."""
    # Mesa's software driver prints a warning if this variable is not set.
    os.environ.setdefault("XDG_RUNTIME_DIR", tempfile.gettempdir())
    try:
        import_module("wgpu.backends.auto")  # the binding; in browsers it has no interface of cffi
        parse_used_names(getattr(sys.modules.get("wgpu.backends.wgpu_native"), "ffi", None))
        candidates = wgpu.gpu.enumerate_adapters_sync()
    except Exception:  # wgpu raises many types, depending on the loader
        return []
    # Some OpenGL drivers cannot read a storage buffer in a vertex shader.
    usable = [adapter for adapter in candidates if adapter.info["backend_type"] != "OpenGL"]
    return sorted(usable, key=lambda adapter: PREFERENCE.index(_kind(adapter)))


def _kind(adapter: GPUAdapter) -> str:
    kind = str(adapter.info["adapter_type"])
    return kind if kind in PREFERENCE else "Unknown"


def open_device(name: str | None = None, *, software: bool = True) -> GPUDevice:
    """Open a device on the best adapter.

    Parameters
    ----------
    name
        Part of the adapter's name, in any case; any adapter if None.
    software
        Accept software adapters.

    Raises
    ------
    BackendError
        If there is no such adapter, or it cannot open a device.
    """
    if (thread := _AHEAD.pop((name, software), None)) is not None:
        thread.join()
        if (device := _OPENED.pop((name, software), None)) is not None:
            return device
    usable = [adapter for adapter in adapters() if software or _kind(adapter) != "CPU"]
    if not usable:
        requested = f" for {name!r}" if name else ""
        raise BackendError(
            f"backend gpu: no adapter was found{requested}; install a GPU driver or Mesa's lavapipe,"
            " or use --backend cpu"
        )
    names = [adapter.info["device"] for adapter in usable]
    for adapter, device_name in zip(usable, names, strict=True):
        if name is None or name.lower() in device_name.lower():
            return _request(adapter)
    raise BackendError(f"no adapter is called {name!r}; there are {', '.join(names)}")


def open_device_ahead(name: str | None = None, *, software: bool = True) -> None:
    """Start to open a device in a thread. The next `open_device` with these arguments returns it.

    Loading a driver takes up to a second, in which the caller can load a scene. Errors are those of
    `open_device`, which tries again.
    """

    def work() -> None:
        with suppress(BackendError):
            _OPENED[name, software] = open_device(name, software=software)

    if (name, software) not in _AHEAD:
        thread = Thread(target=work, name="skinshade-device")
        thread.start()
        _AHEAD[name, software] = thread


def _request(adapter: GPUAdapter) -> GPUDevice:
    try:
        return adapter.request_device_sync(
            required_features=[feature for feature in FEATURES if feature in adapter.features]
        )
    except Exception as error:  # drivers raise many types
        raise BackendError(f"{adapter.info['device']}: gives no device ({error})") from None
