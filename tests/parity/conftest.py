"""A real device for what runs on one: any adapter, lavapipe where there is no other."""

from __future__ import annotations

import pytest
from rows import Runner

from gpu_device import adapter_or_skip
from skinshade.gpu.device import open_device


@pytest.fixture(scope="session")
def device():
    adapter_or_skip()
    return open_device()


@pytest.fixture(scope="session")
def runner(device):
    return Runner.on(device)
