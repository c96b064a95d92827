"""Every language of the shader library where something here can run it.

Devices are real: any adapter will do, lavapipe where there is no other. Metal has no driver outside
its own machines.
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
"""By language, its runner and the fixtures that it takes."""


@pytest.fixture(scope="session")
def device():
    adapter_or_skip()
    return open_device()


@pytest.fixture(scope="session")
def browser():
    opened = Browser()
    yield opened
    opened.close()


@pytest.fixture(scope="session", params=LANGUAGES)
def runner(request):
    kind, *fixtures = LANGUAGES[request.param]
    opened = kind(*map(request.getfixturevalue, fixtures))
    yield opened
    opened.close()
