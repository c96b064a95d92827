"""Adapters in order, and what is said where there is none."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from gpu_device import adapter_or_skip
from skinshade._core.errors import BackendError
from skinshade.gpu import device
from skinshade.gpu.timing import Stopwatch


def adapter(name, kind, backend="Vulkan"):
    info = {"device": name, "adapter_type": kind, "backend_type": backend, "description": ""}
    return SimpleNamespace(info=info, features=set(), request_device_sync=lambda **_: name)


@pytest.fixture
def machine(monkeypatch):
    """A machine with the adapters given."""

    def has(*found):
        device.adapters.cache_clear()
        monkeypatch.setattr(device.wgpu.gpu, "enumerate_adapters_sync", lambda: list(found))

    yield has
    device.adapters.cache_clear()


SOFTWARE, HARDWARE = adapter("llvmpipe", "CPU"), adapter("A Fast One", "DiscreteGPU")


def test_hardware_comes_before_software(machine):
    machine(SOFTWARE, adapter("small", "IntegratedGPU"), HARDWARE)
    names = [each.info["device"] for each in device.adapters()]
    assert names == ["A Fast One", "small", "llvmpipe"]
    assert device.open_device() == "A Fast One"


def test_an_adapter_is_found_by_part_of_its_name_in_any_case(machine):
    machine(SOFTWARE, HARDWARE)
    assert device.open_device("LLVM") == "llvmpipe"
    with pytest.raises(BackendError, match="'voodoo'; there are A Fast One, llvmpipe"):
        device.open_device("voodoo")


def test_without_an_adapter_the_error_says_what_to_install(machine):
    machine()
    with pytest.raises(BackendError, match="no adapter was found; install a GPU driver"):
        device.open_device()


def test_software_alone_is_none_where_hardware_is_asked_for(machine):
    machine(SOFTWARE)
    with pytest.raises(BackendError, match="no adapter was found"):
        device.open_device(software=False)


def test_opengl_is_left_out(machine):
    machine(adapter("old", "DiscreteGPU", "OpenGL"))
    assert device.adapters() == []


def test_a_loader_that_fails_is_no_adapter(machine, monkeypatch):
    def broken():
        raise RuntimeError("no loader")

    device.adapters.cache_clear()
    monkeypatch.setattr(device.wgpu.gpu, "enumerate_adapters_sync", broken)
    assert device.adapters() == []
    device.adapters.cache_clear()


def test_an_adapter_that_refuses_is_named(machine):
    def refuses(**_):
        raise RuntimeError("it is busy")

    stubborn = adapter("stubborn", "DiscreteGPU")
    stubborn.request_device_sync = refuses
    machine(stubborn)
    with pytest.raises(BackendError, match=r"stubborn: gives no device \(it is busy\)"):
        device.open_device()


def test_an_empty_pass_takes_some_time_and_no_second():
    adapter_or_skip()
    opened = device.open_device()
    watch = Stopwatch(opened)
    if not watch.measures:
        assert watch.around("nothing") == {}
        assert watch.read_ms() == {}
        return
    encoder = opened.create_command_encoder()
    for name in ("one", "two", "one"):
        encoder.begin_compute_pass(**watch.around(name)).end()
    opened.queue.submit([encoder.finish()])
    found = watch.read_ms()
    assert {name: len(times) for name, times in found.items()} == {"one": 2, "two": 1}
    assert all(0.0 <= time_ms < 1000.0 for times in found.values() for time_ms in times)
    assert watch.read_ms() == {}
