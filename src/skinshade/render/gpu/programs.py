"""The passes' programs, as the compiler made them."""

from __future__ import annotations

import wgpu

from ...gpu.program import Program
from ...shaders import generated_text

__all__ = ["open_program"]

UNFILTERED = {
    "shadow_pass": (),
    "blur_pass": ("source",),
    "skin_pass": ("depths", "moments", "depth_sampler"),
    "present_pass": ("light_texels", "sum_texels", "sky_texels"),
}
"""Textures whose format no device need filter, and their samplers."""


def open_program(device: wgpu.GPUDevice, name: str) -> Program:
    """Return one of ``shaders/passes`` on a device."""
    return Program(device, generated_text(f"{name}.wgsl"), unfiltered=UNFILTERED[name])
