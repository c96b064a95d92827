"""Access to a GPU and to external tools; tests that need a missing one are skipped, or fail."""

from __future__ import annotations

import os
import shutil
from typing import NoReturn

import pytest


def absent(message) -> NoReturn:
    """Skip the test, or fail it if the variable `SKINSHADE_REQUIRE_GPU` is 1."""
    if os.environ.get("SKINSHADE_REQUIRE_GPU") == "1":
        pytest.fail(message)
    pytest.skip(message)


def adapter_or_skip():
    """Return the best adapter, hardware or software; call `absent` if there is none."""
    from skinshade.gpu.device import adapters

    usable = adapters()
    if not usable:
        absent("no GPU adapter, hardware or software, was found; see tools/software_driver.py")
    return usable[0]


def tool_or_skip(name):
    """Return the path of a program; call `absent` if it is not installed."""
    path = shutil.which(name)
    if path is None:
        absent(f"{name} is not installed; see the scripts in tools")
    return path
