"""The skin pass for each way to shade: what its pipeline leaves out, and what it binds."""

from __future__ import annotations

from typing import Any

import wgpu

from ...scene import SpotLight
from ..renderer import DEBUG_VIEWS, SHADINGS, SHADOW_FILTERS, TIERS, RenderSettings
from .programs import open_program
from .resources import ATTRIBUTES, Resources, luts_of
from .shadows import Shadows

__all__ = ["SkinPass"]

ANISOTROPY = 16
MAPS = {"albedo": 1, "specular": 2, "deep_scatter": 4, "normal": 8}
"""As the pass counts what a material has."""


class SkinPass:
    """Pipelines and groups of the skin pass, made once for each way.

    Parameters
    ----------
    resources
        What it binds.
    shadows
        What lights see.
    """

    def __init__(self, resources: Resources, shadows: Shadows) -> None:
        self._resources, self._shadows = resources, shadows
        self._program = open_program(resources.device, "skin_pass")
        self._groups: dict[RenderSettings, wgpu.GPUBindGroup] = {}

    def depth_pipeline(self, samples: int) -> wgpu.GPURenderPipeline:
        """Return what draws depth alone."""
        return self._program.pipeline(
            {}, targets=[], vertex_floats=4 * ATTRIBUTES, depth="less", samples=samples
        )

    def pipeline(self, way: RenderSettings, target: str, samples: int) -> wgpu.GPURenderPipeline:
        """Return what shades a way into a target's format, where depth has been drawn."""
        scene = self._resources.prepared.scene
        textures = self._resources.prepared.textures
        mapped = "normal" in textures
        there = [name for name in MAPS if name in textures and textures[name].size > 1]
        constants = {
            "SHADING": SHADINGS.index(way.shading),
            "TIER": TIERS.index(way.tier),
            "VIEW": 0 if way.debug_view is None else 1 + DEBUG_VIEWS.index(way.debug_view),
            "TAPS": way.thickness_taps,
            "LIGHTS": len(scene.lights),
            "ENVIRONMENT": int(scene.environment is not None),
            "SHADOW_FILTER": SHADOW_FILTERS.index(way.shadow_filter),
            "FETCHES": way.normal_fetches if mapped else 1,
            "MULTISAMPLED": int(samples > 1),
            "MAPS": sum(MAPS[name] for name in there),
            "LAMPS": int(any(isinstance(light, SpotLight) for light in scene.lights)),
        }
        return self._program.pipeline(
            constants,
            targets=[target],
            vertex_floats=4 * ATTRIBUTES,
            depth="none",
            samples=samples,
        )

    def group(self, way: RenderSettings) -> wgpu.GPUBindGroup:
        """Return what a way binds."""
        if way not in self._groups:
            self._groups[way] = self._program.bind(self._bound(way))
        return self._groups[way]

    def _bound(self, way: RenderSettings) -> dict[str, Any]:
        made, seen = self._resources, self._shadows
        device, wanted = made.device, luts_of(way)
        luts = {
            name: made.luts[name.removesuffix("_lut")]
            if name.removesuffix("_lut") in wanted
            else made.nothing
            for name in self._program.points
            if name.endswith("_lut")
        }
        buffers = {
            "skin_block": made.skin_block,
            "scatter_block": made.scatter_block(way),
            "frame_block": made.frame_block,
            "lights": made.lights,
            "taps": made.taps(way.thickness_taps),
        }
        variance = way.shadow_filter == "variance"
        layers = {"depths": seen.depths, "moments": seen.moments if variance else made.no_layer}
        linear = {"mag_filter": "linear", "min_filter": "linear"}
        mips = {**linear, "mipmap_filter": "linear"}
        repeat = {"address_mode_u": "repeat", "address_mode_v": "repeat"}
        return {
            **{name: {"buffer": each} for name, each in buffers.items()},
            **{name: each.create_view() for name, each in (luts | made.maps).items()},
            **{name: each.create_view(dimension="2d-array") for name, each in layers.items()},
            "preconvolved": made.preconvolved.create_view(),
            "lut_sampler": device.create_sampler(**linear),
            "map_sampler": device.create_sampler(**mips, **repeat),
            "footprint_sampler": device.create_sampler(**mips, **repeat, max_anisotropy=ANISOTROPY),
            "depth_sampler": device.create_sampler(),
            "sky_sampler": device.create_sampler(**linear, address_mode_u="repeat"),
        }
