"""A WGSL program on a device: bound by the names in its text, specialised by its constants."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any

import wgpu

from .bindings import bind_points, override_ids

__all__ = ["Program"]

DEPTH_FORMAT = "depth32float"


class Program:
    """A program with one group of bindings.

    Parameters
    ----------
    device
        It runs on.
    text
        WGSL with ``vertex_main`` and ``fragment_main``.
    unfiltered
        Names of textures that are read texel by texel, and of samplers that do.
    """

    def __init__(
        self, device: wgpu.GPUDevice, text: str, *, unfiltered: Sequence[str] = ()
    ) -> None:
        self.device = device
        self.points = bind_points(text)
        self._text = text
        self._unfiltered = unfiltered
        self._pipelines: dict[Any, wgpu.GPURenderPipeline] = {}

    def pipeline(
        self,
        constants: Mapping[str, int],
        *,
        targets: Sequence[str],
        vertex_floats: int = 0,
        depth: str | None = None,
        cull: str = "none",
        samples: int = 1,
    ) -> wgpu.GPURenderPipeline:
        """Return the pipeline of these constants; made once.

        Parameters
        ----------
        constants
            Override constants by name.
        targets
            Formats drawn to; without any the fragment's stage is left out.
        vertex_floats
            Floats of a vertex, a multiple of 4.
        depth
            How fragments pass, such as ``less``; ``none`` writes no depth but needs it less or equal.
        cull
            Faces that are left out.
        samples
            1 or 4 a pixel.
        """
        key = (*constants.items(), *targets, vertex_floats, depth, cull, samples)
        if key not in self._pipelines:
            self._pipelines[key] = self._made(
                constants, targets, vertex_floats, depth, cull, samples
            )
        return self._pipelines[key]

    def bind(self, resources: Mapping[str, Any]) -> wgpu.GPUBindGroup:
        """Return a group of these resources by name."""
        entries = [
            {"binding": point.binding, "resource": resources[name]}
            for name, point in self.points.items()
        ]
        return self.device.create_bind_group(layout=self._layout, entries=entries)

    @cached_property
    def _module(self) -> wgpu.GPUShaderModule:
        return self.device.create_shader_module(code=self._text)

    @cached_property
    def _layout(self) -> wgpu.GPUBindGroupLayout:
        """Every bind point of the text, whether a variant uses it or not."""
        stages = wgpu.ShaderStage.FRAGMENT | wgpu.ShaderStage.VERTEX
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

    def _made(
        self,
        constants: Mapping[str, int],
        targets: Sequence[str],
        vertex_floats: int,
        depth: str | None,
        cull: str,
        samples: int,
    ) -> wgpu.GPURenderPipeline:
        ids = override_ids(self._text)
        values = {ids[name]: value for name, value in constants.items()}
        stage = {"module": self._module, "constants": values}
        attributes = [
            {"shader_location": index, "offset": 16 * index, "format": "float32x4"}
            for index in range(vertex_floats // 4)
        ]
        buffers = [{"array_stride": 4 * vertex_floats, "attributes": attributes}]
        described: dict[str, Any] = {
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
            formats = [{"format": each} for each in targets]
            described["fragment"] = {**stage, "entry_point": "fragment_main", "targets": formats}
        if depth is not None:
            described["depth_stencil"] = {
                "format": DEPTH_FORMAT,
                "depth_write_enabled": depth != "none",
                "depth_compare": "less-equal" if depth == "none" else depth,
            }
        return self.device.create_render_pipeline(**described)
