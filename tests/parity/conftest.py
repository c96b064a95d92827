"""Runners of the shader library in every language that this machine can run.

The devices are real: any adapter will do, lavapipe if there is no other. Metal runs on Apple's machines
only, so it is not among the languages.
"""

from __future__ import annotations

import pytest
from in_browser import Browser, WebGL, WebGPU
from in_hlsl import Hlsl
from in_opengl import Compute, Fragments
from in_vulkan_glsl import VulkanGlsl
from on_wgpu import Wgsl

from gpu_device import adapter_or_skip
from skinshade.gpu.device import open_device

LANGUAGES = {
    "wgsl": (Wgsl, "device"),
    "vulkan-glsl": (VulkanGlsl, "device"),
    "hlsl-commented": (lambda device: Hlsl(device, "commented"), "device"),
    "hlsl-generated": (lambda device: Hlsl(device, "generated"), "device"),
    "opengl-3.3": (Fragments,),
    "opengl-4.3": (Compute,),
    "webgl-2": (WebGL, "browser"),
    "webgpu": (WebGPU, "browser"),
}
"""Runner of each language, and the fixtures that it takes."""


@pytest.fixture(scope="session")
def device():
    adapter_or_skip()
    return open_device()


@pytest.fixture(scope="session")
def browser():
    browser = Browser()
    yield browser
    browser.close()


@pytest.fixture(scope="session", params=LANGUAGES)
def runner(request):
    kind, *fixtures = LANGUAGES[request.param]
    runner = kind(*map(request.getfixturevalue, fixtures))
    yield runner
    runner.close()
