"""Programs of the passes."""

from __future__ import annotations

from ..._core.generated import generated_text
from ...gpu.device import GPUDevice
from ...gpu.program import Program

__all__ = ["open_program"]

UNFILTERED = {
    "shadow_pass": (),
    "blur_pass": ("source",),
    "skin_pass": ("depths", "moments", "depth_sampler"),
    "present_pass": ("light_texels", "sum_texels", "sky_texels"),
}
"""Textures and samplers of each pass that are read without a filter, which some devices do not have for
their formats."""


def open_program(device: GPUDevice, name: str) -> Program:
    """Return the program of a pass on a device, by the name of the pass's file in ``passes``."""
    return Program(device, generated_text(f"{name}.wgsl"), unfiltered=UNFILTERED[name])
