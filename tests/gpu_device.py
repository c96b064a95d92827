"""What a test that needs a GPU does where there is none."""

from __future__ import annotations

import os

import pytest


def adapter_or_skip():
    """Return the best adapter, hardware or software; skip, or fail where one is required."""
    from skinshade.gpu.device import adapters

    found = adapters()
    if not found:
        message = "no GPU adapter, not even a software one; see tools/software_driver.py"
        if os.environ.get("SKINSHADE_REQUIRE_GPU") == "1":
            pytest.fail(message)
        pytest.skip(message)
    return found[0]
