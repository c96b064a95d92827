"""``skinshade doctor``: versions, cores and GPUs of this machine."""

from __future__ import annotations

import os
import platform
from importlib.metadata import version

from .._core import native
from .._core.version import __version__
from .terminal import echo

__all__ = ["doctor_command"]


def doctor_command() -> None:
    """Print versions, cores and backends."""
    echo(f"skinshade {__version__}, Python {platform.python_version()}, {platform.platform()}")
    for package in ("numpy", "scipy", "OpenImageIO"):
        echo(f"{package} {version(package)}")
    echo(f"backend cpu: {os.cpu_count()} cores")
    echo(f"mesh analysis: {_kernels()}")
    for line in _gpus():
        echo(f"backend gpu: {line}")


def _kernels() -> str:
    """Return whether mesh analysis uses compiled kernels, and why."""
    used = "compiled kernels" if native.available() else "NumPy"
    return f"{used} ({native.reason()})"


def _gpus() -> list[str]:
    try:
        from ..gpu.device import adapters
    except ImportError as error:
        return [f"wgpu cannot be loaded ({error})"]
    lines = [
        f"{info['device']} ({info['adapter_type']}, {info['backend_type']}, {info['description']})"
        for info in (adapter.info for adapter in adapters())
    ]
    return lines or ["no adapter; install a GPU driver, or Mesa's lavapipe to draw in software"]
