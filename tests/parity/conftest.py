"""A real device for what runs on one: any adapter, lavapipe where there is no other."""

from __future__ import annotations

import os

import pytest
from rows import Runner


@pytest.fixture(scope="session")
def device(tmp_path_factory):
    os.environ.setdefault("XDG_RUNTIME_DIR", str(tmp_path_factory.mktemp("runtime")))
    import wgpu

    found = [a for a in wgpu.gpu.enumerate_adapters_sync() if a.info["backend_type"] != "OpenGL"]
    if not found:
        message = "no GPU adapter, not even a software one; see tools/software_driver.py"
        if os.environ.get("SKINSHADE_REQUIRE_GPU") == "1":
            pytest.fail(message)
        pytest.skip(message)
    wanted = {"float32-filterable"} & set(found[0].features)
    return found[0].request_device_sync(required_features=sorted(wanted))


@pytest.fixture(scope="session")
def runner(device):
    return Runner.on(device)
