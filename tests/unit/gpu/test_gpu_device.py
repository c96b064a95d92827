"""The order and choice of adapters, the errors of a machine without one, and the times of passes."""

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
def install(monkeypatch):
    """Function that replaces the adapters of this machine."""

    def replace_adapters(*adapters):
        device.adapters.cache_clear()
        monkeypatch.setattr(device.wgpu.gpu, "enumerate_adapters_sync", lambda: list(adapters))

    yield replace_adapters
    device.adapters.cache_clear()


SOFTWARE, HARDWARE = adapter("llvmpipe", "CPU"), adapter("A Fast One", "DiscreteGPU")


def test_hardware_comes_before_software(install):
    install(SOFTWARE, adapter("small", "IntegratedGPU"), HARDWARE)
    names = [usable.info["device"] for usable in device.adapters()]
    assert names == ["A Fast One", "small", "llvmpipe"]
    assert device.open_device() == "A Fast One"


def test_an_adapter_is_selected_by_part_of_its_name_in_any_case(install):
    install(SOFTWARE, HARDWARE)
    assert device.open_device("LLVM") == "llvmpipe"
    with pytest.raises(BackendError, match="'voodoo'; there are A Fast One, llvmpipe"):
        device.open_device("voodoo")


def test_without_an_adapter_the_error_says_what_to_install(install):
    install()
    with pytest.raises(BackendError, match="no adapter was found; install a GPU driver"):
        device.open_device()


def test_a_device_that_was_opened_ahead_is_returned_once(install, monkeypatch):
    install(adapter("llvmpipe", "CPU"))
    opened = []
    monkeypatch.setattr(device, "_request", lambda chosen: opened.append(chosen) or len(opened))
    device.open_device_ahead()
    device.open_device_ahead()
    assert device.open_device("llvm") in (1, 2)
    first, second = device.open_device(), device.open_device()
    assert {first, second} <= {1, 2, 3}
    assert first != second
    assert len(opened) == 3


def test_an_error_ahead_is_raised_by_the_call_that_needs_the_device(install):
    install()
    device.open_device_ahead(software=False)
    with pytest.raises(BackendError, match="no adapter"):
        device.open_device(software=False)


def test_software_adapters_do_not_count_where_hardware_is_required(install):
    install(SOFTWARE)
    with pytest.raises(BackendError, match="no adapter was found"):
        device.open_device(software=False)


def test_opengl_adapters_are_not_used(install):
    install(adapter("old", "DiscreteGPU", "OpenGL"))
    assert device.adapters() == []


def test_without_a_working_loader_there_are_no_adapters(install, monkeypatch):
    def broken():
        raise RuntimeError("no loader")

    device.adapters.cache_clear()
    monkeypatch.setattr(device.wgpu.gpu, "enumerate_adapters_sync", broken)
    assert device.adapters() == []


def test_an_adapter_that_gives_no_device_is_named(install):
    def refuse(**_):
        raise RuntimeError("it is busy")

    stubborn = adapter("stubborn", "DiscreteGPU")
    stubborn.request_device_sync = refuse
    install(stubborn)
    with pytest.raises(BackendError, match=r"stubborn: gives no device \(it is busy\)"):
        device.open_device()


def test_an_empty_pass_takes_less_than_a_second():
    adapter_or_skip()
    opened = device.open_device()
    watch = Stopwatch(opened)
    if not watch.enabled:
        assert watch.around("nothing") == {}
        assert watch.read_ms() == {}
        return
    encoder = opened.create_command_encoder()
    for name in ("one", "two", "one"):
        encoder.begin_compute_pass(**watch.around(name)).end()
    opened.queue.submit([encoder.finish()])
    times_ms = watch.read_ms()
    assert {name: len(times) for name, times in times_ms.items()} == {"one": 2, "two": 1}
    assert all(0.0 <= time_ms < 1000.0 for times in times_ms.values() for time_ms in times)
    assert watch.read_ms() == {}
