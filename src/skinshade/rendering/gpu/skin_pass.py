"""Skin pass: pipelines and bind groups for each kind of picture."""

from __future__ import annotations

from typing import Any

from ...gpu.device import GPUBindGroup, GPURenderPipeline
from ...params.choices import MaterialMap, ShadowFilter
from ...scene import SpotLight
from ..settings import RenderSettings
from .programs import open_program
from .resources import VERTEX_FLOATS, PartResources
from .shadow_maps import DeviceShadowMaps

__all__ = ["SkinPass"]

ANISOTROPY = 16
"""Greatest anisotropy of lookups along the footprint of a pixel."""


class SkinPass:
    """Pipelines and bind groups of the skin pass, each created once.

    Parameters
    ----------
    resources
        Resources of the part that is drawn.
    shadow_maps
        Shadow maps of the scene's lights.
    """

    def __init__(self, resources: PartResources, shadow_maps: DeviceShadowMaps) -> None:
        self._resources, self._shadow_maps = resources, shadow_maps
        self._program = open_program(resources.shared.device, "skin_pass")
        self._groups: dict[RenderSettings, GPUBindGroup] = {}

    def depth_pipeline(self, samples: int) -> GPURenderPipeline:
        """Return the pipeline that draws only depth."""
        return self._program.pipeline(
            {}, targets=[], vertex_floats=VERTEX_FLOATS, depth="less", samples=samples
        )

    def pipeline(self, settings: RenderSettings, target: str, samples: int) -> GPURenderPipeline:
        """Return the pipeline that shades into a format where the depth test has passed.

        Parameters
        ----------
        settings
            Settings of the picture. The pipeline contains only the parts that they use.
        target
            Format of the colour target.
        samples
            Samples per pixel, 1 or 4.
        """
        part, prepared = self._resources.part, self._resources.shared.prepared
        textures = part.textures
        maps = [kind for kind in MaterialMap if kind in textures and textures[kind].size > 1]
        constants = {
            "SHADING": settings.shading.number,
            "TIER": settings.tier.number,
            "VIEW": settings.debug_view.number,
            "TAPS": settings.thickness_taps,
            "LIGHTS": len(prepared.lights),
            "ENVIRONMENT": int(prepared.environment is not None),
            "SHADOW_FILTER": settings.shadow_filter.number,
            "FETCHES": settings.normal_fetches if MaterialMap.NORMAL in textures else 1,
            "MULTISAMPLED": int(samples > 1),
            "MAPS": sum(kind.bit for kind in maps),
            "OPACITY_CUTOFF": round(255.0 * part.opacity_cutoff),
            "SPECULAR": part.skin.specular_model(settings.shading).number,
            "BOUNDARY": part.skin.boundary.number,
            "CONTACT": int(settings.has_contact),
            "SPOT_LIGHTS": int(any(isinstance(light, SpotLight) for light in prepared.lights)),
        }
        return self._program.pipeline(
            constants,
            targets=[target],
            vertex_floats=VERTEX_FLOATS,
            # Parts with opacity are not in the depth that was drawn before.
            depth="none" if part.opacity is None else "less",
            samples=samples,
        )

    def group(self, settings: RenderSettings) -> GPUBindGroup:
        """Return the bind group for `settings`."""
        if settings not in self._groups:
            self._groups[settings] = self._program.bind(self._bindings(settings))
        return self._groups[settings]

    def _bindings(self, settings: RenderSettings) -> dict[str, Any]:
        """Return every resource of the pass by name."""
        resources, shadow_maps = self._resources, self._shadow_maps
        shared = resources.shared
        device = shared.device
        lut_names = [name for name in self._program.points if name.endswith("_lut")]
        textures = {name: resources.lut(name.removesuffix("_lut"), settings) for name in lut_names}
        textures |= {**resources.maps, "preconvolved": shared.preconvolved}
        buffers = {
            "skin_block": resources.skin_block,
            "scatter_block": resources.scatter_block(settings),
            "frame_block": resources.frame_block,
            "lights": shadow_maps.lights,
            "taps": shared.taps(settings.thickness_taps),
        }
        variance = settings.shadow_filter == ShadowFilter.VARIANCE
        moments = shadow_maps.moments if variance else shared.placeholder_layers
        layers = {"depths": shadow_maps.depths, "moments": moments}
        linear = {"mag_filter": "linear", "min_filter": "linear"}
        mips = {**linear, "mipmap_filter": "linear"}
        repeat = {"address_mode_u": "repeat", "address_mode_v": "repeat"}
        return {
            **{name: {"buffer": buffer} for name, buffer in buffers.items()},
            **{name: texture.create_view() for name, texture in textures.items()},
            **{name: layer.create_view(dimension="2d-array") for name, layer in layers.items()},
            "lut_sampler": device.create_sampler(**linear),
            "map_sampler": device.create_sampler(**mips, **repeat),
            "footprint_sampler": device.create_sampler(**mips, **repeat, max_anisotropy=ANISOTROPY),
            "depth_sampler": device.create_sampler(),
            "sky_sampler": device.create_sampler(**linear, address_mode_u="repeat"),
        }
