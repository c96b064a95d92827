"""Which backend draws, and what happens when its device goes."""

from __future__ import annotations

import json

import numpy as np
import pytest
import wgpu

from gpu_device import adapter_or_skip
from shapes import unit_icosphere
from skinshade._core.errors import BackendError
from skinshade.cli.timings import timing_report
from skinshade.gpu import device
from skinshade.mesh import Mesh
from skinshade.rendering import RenderSettings, open_renderer
from skinshade.rendering.fallback import FallbackRenderer
from skinshade.scene import Camera, DirectionalLight, Material, Scene

SIZE = (24, 16)


@pytest.fixture(scope="module")
def scene():
    points, faces = unit_icosphere(2)
    ball = Mesh.checked(80.0 * points, faces, unit_mm=1.0, normals=points)
    camera = Camera((0.0, 0.0, 600.0), (0.0, 0.0, 0.0), 20.0)
    light = DirectionalLight.from_angles(30.0, 20.0, 1.0)
    return Scene(ball, camera, Material(), (light,))


@pytest.fixture
def no_adapter(monkeypatch):
    device.adapters.cache_clear()
    monkeypatch.setattr(device.wgpu.gpu, "enumerate_adapters_sync", list)
    yield
    device.adapters.cache_clear()


def test_auto_without_an_adapter_draws_on_the_cpu_and_says_so(scene, no_adapter):
    renderer = open_renderer(scene, "auto")
    assert renderer.device_name == "the CPU"
    assert renderer.draw(scene.camera, SIZE, 1, RenderSettings())[..., 3].max() == 1.0


def test_gpu_without_an_adapter_is_an_error(scene, no_adapter):
    with pytest.raises(BackendError, match="no adapter was found"):
        open_renderer(scene, "gpu")


def test_an_adapter_that_was_named_is_not_silently_another(scene, no_adapter):
    with pytest.raises(BackendError, match="no adapter was found"):
        open_renderer(scene, "auto", adapter="A Fast One")


def failing(scene, monkeypatch, error):
    adapter_or_skip()
    renderer = open_renderer(scene, "gpu")

    def fails(*_):
        raise error

    monkeypatch.setattr(renderer, "_draw_sample", fails)
    return renderer


@pytest.mark.parametrize(
    "error", [wgpu.GPUError("Device lost\nby its driver"), MemoryError()], ids=["lost", "memory"]
)
def test_a_device_that_goes_is_an_error_in_one_line(scene, monkeypatch, error):
    renderer = failing(scene, monkeypatch, error)
    with pytest.raises(BackendError, match=r"failed \((Device lost|out of memory)\); use cpu$"):
        renderer.draw(scene.camera, SIZE, 1, RenderSettings())


def test_auto_goes_on_with_the_cpu_when_the_device_goes(scene, monkeypatch):
    lost = failing(scene, monkeypatch, wgpu.GPUError("Device lost"))
    renderer = FallbackRenderer(lost, lambda: open_renderer(scene, "cpu"))
    assert renderer.device_name == lost.device_name
    found = renderer.draw(scene.camera, SIZE, 1, RenderSettings())
    want = open_renderer(scene, "cpu").draw(scene.camera, SIZE, 1, RenderSettings())
    assert np.array_equal(found, want)
    assert renderer.device_name == "the CPU"
    assert renderer.timings_ms == {}


def test_each_sample_is_one_timed_pass(scene):
    adapter_or_skip()
    renderer = open_renderer(scene, "gpu")
    renderer.draw(scene.camera, SIZE, 3, RenderSettings())
    if not renderer.timings_ms["skin"]:
        assert "no pass was timed" in timing_report(renderer)
        return
    assert len(renderer.timings_ms["skin"]) == 3
    report = json.loads(timing_report(renderer, as_json=True))
    found = report["passes"]["skin"]
    assert report["adapter"] == renderer.device_name
    assert 0.0 < found["least_ms"] <= found["median_ms"] <= found["greatest_ms"]
    assert f"{found['median_ms']:.2f} ms" in timing_report(renderer)


def test_the_cpu_times_no_pass(scene):
    renderer = open_renderer(scene, "cpu")
    assert timing_report(renderer) == "the CPU: no pass was timed"
