"""WGSL programs on a device, bound by names and specialised by override constants."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any

from .bindings import bind_points, override_ids
from .device import (
    GPUBindGroup,
    GPUBindGroupLayout,
    GPUDevice,
    GPURenderPipeline,
    GPUShaderModule,
    ShaderStage,
)

__all__ = ["Program"]

DEPTH_FORMAT = "depth32float"


class Program:
    """WGSL program with one bind group.

    Parameters
    ----------
    device
        Device of the program.
    text
        WGSL with ``vertex_main`` and ``fragment_main``.
    unfiltered
        Names of textures and samplers that are read without a filter.
    """

    def __init__(self, device: GPUDevice, text: str, *, unfiltered: Sequence[str] = ()) -> None:
        self.device = device
        self.points = bind_points(text)
        self._text = text
        self._unfiltered = unfiltered
        self._pipelines: dict[Any, GPURenderPipeline] = {}

    def pipeline(
        self,
        constants: Mapping[str, int],
        *,
        targets: Sequence[str],
        vertex_floats: int = 0,
        depth: str | None = None,
        cull: str = "none",
        samples: int = 1,
    ) -> GPURenderPipeline:
        """Return the pipeline with the given properties; each pipeline is created once.

        Parameters
        ----------
        constants
            Override constants by name.
        targets
            Formats of the colour targets; if there are none, the pipeline has no fragment stage.
        vertex_floats
            Floats of a vertex, a multiple of 4; 0 if there is no vertex buffer.
        depth
            Depth test, such as ``less``, which writes depths; ``none``, which passes fragments at or before
            the stored depth and writes no depth; or None for no depth buffer.
        cull
            Faces that are not drawn: ``none``, ``front`` or ``back``.
        samples
            Samples per pixel, 1 or 4.
        """
        key = (*constants.items(), *targets, vertex_floats, depth, cull, samples)
        if key not in self._pipelines:
            self._pipelines[key] = self._create(
                constants, targets, vertex_floats, depth, cull, samples
            )
        return self._pipelines[key]

    def bind(self, resources: Mapping[str, Any]) -> GPUBindGroup:
        """Return a bind group of `resources`, given by name."""
        entries = [
            {"binding": point.binding, "resource": resources[name]}
            for name, point in self.points.items()
        ]
        return self.device.create_bind_group(layout=self._layout, entries=entries)

    @cached_property
    def _module(self) -> GPUShaderModule:
        return self.device.create_shader_module(code=self._text)

    @cached_property
    def _layout(self) -> GPUBindGroupLayout:
        """Layout of all bind points, including those that a pipeline does not use."""
        stages = ShaderStage.FRAGMENT | ShaderStage.VERTEX
        entries = []
        for name, point in self.points.items():
            entry: dict[str, Any] = {"binding": point.binding, "visibility": stages}
            if point.space:
                kind = "uniform" if point.space == "uniform" else "read-only-storage"
                entry["buffer"] = {"type": kind}
            elif point.kind == "sampler":
                kind = "non-filtering" if name in self._unfiltered else "filtering"
                entry["sampler"] = {"type": kind}
            else:
                kind = "unfilterable-float" if name in self._unfiltered else "float"
                layers = "2d-array" if "array" in point.kind else "2d"
                entry["texture"] = {"sample_type": kind, "view_dimension": layers}
            entries.append(entry)
        return self.device.create_bind_group_layout(entries=entries)

    def _create(
        self,
        constants: Mapping[str, int],
        targets: Sequence[str],
        vertex_floats: int,
        depth: str | None,
        cull: str,
        samples: int,
    ) -> GPURenderPipeline:
        ids = override_ids(self._text)
        values = {ids[name]: value for name, value in constants.items()}
        stage = {"module": self._module, "constants": values}
        attributes = [
            {"shader_location": index, "offset": 16 * index, "format": "float32x4"}
            for index in range(vertex_floats // 4)
        ]
        buffers = [{"array_stride": 4 * vertex_floats, "attributes": attributes}]
        descriptor: dict[str, Any] = {
            "layout": self.device.create_pipeline_layout(bind_group_layouts=[self._layout]),
            "vertex": {
                **stage,
                "entry_point": "vertex_main",
                "buffers": buffers if vertex_floats else [],
            },
            "primitive": {"topology": "triangle-list", "cull_mode": cull},
            "multisample": {"count": samples},
        }
        if targets:
            formats = [{"format": target} for target in targets]
            descriptor["fragment"] = {**stage, "entry_point": "fragment_main", "targets": formats}
        if depth is not None:
            descriptor["depth_stencil"] = {
                "format": DEPTH_FORMAT,
                "depth_write_enabled": depth != "none",
                "depth_compare": "less-equal" if depth == "none" else depth,
            }
        return self.device.create_render_pipeline(**descriptor)
