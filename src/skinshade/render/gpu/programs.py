"""The passes' programs, as the compiler made them."""

from __future__ import annotations

from importlib.resources import files

import wgpu

from ...gpu.program import Program

__all__ = ["open_program"]

UNFILTERED = {
    "shadow_pass": (),
    "blur_pass": ("source",),
    "skin_pass": ("depths", "moments"),
    "present_pass": ("light_texels", "sum_texels", "sky_texels"),
}
"""Textures whose format no device need filter."""


def open_program(device: wgpu.GPUDevice, name: str) -> Program:
    """Return one of ``shaders/passes`` on a device."""
    place = files("skinshade.shaders").joinpath(f"generated/{name}.wgsl")
    return Program(device, place.read_text(encoding="utf-8"), unfiltered=UNFILTERED[name])
