"""What a test that needs a GPU, or a tool that drives one, does where there is none."""

from __future__ import annotations

import os
import shutil
from typing import NoReturn

import pytest


def absent(message) -> NoReturn:
    """Skip, or fail where `SKINSHADE_REQUIRE_GPU` says that everything is there."""
    if os.environ.get("SKINSHADE_REQUIRE_GPU") == "1":
        pytest.fail(message)
    pytest.skip(message)


def adapter_or_skip():
    """Return the best adapter, hardware or software; skip, or fail where one is required."""
    from skinshade.gpu.device import adapters

    found = adapters()
    if not found:
        absent("no GPU adapter, not even a software one; see tools/software_driver.py")
    return found[0]


def tool_or_skip(name):
    """Return a program's path; skip, or fail where it is required."""
    found = shutil.which(name)
    if found is None:
        absent(f"{name} is not installed; see tools")
    return found
