"""A prepared scene on a device: attributes, maps, tables, depths and blocks, uploaded once."""

from __future__ import annotations

from functools import cached_property

import numpy as np
import wgpu

from ..._core.arrays import ImageArray
from ...gpu.luts import LutTextures
from ...gpu.textures import buffer, filtered_texture, loaded_texture
from ...params import FrameParams, LightParams
from ..cpu.texture import Texture
from ..prepared import PreparedScene
from ..renderer import RenderSettings
from .records import light_params

__all__ = ["ATTRIBUTES", "Resources", "luts_of"]

Key = tuple[int | str, ...]

COLUMNS = {
    "position": 3,
    "normal": 3,
    "tangent": 4,
    "uv": 2,
    "curvature": 1,
    "tensor": 6,
    "diffused": 9,
    "diffused_curvature": 3,
    "visibility": 3,
    "through": 3,
    "bounced": 3,
    "unexplained": 3,
}
"""Numbers of each; what the scene has none of stays 0."""
ATTRIBUTES = -(-sum(COLUMNS.values()) // 4)
"""Vectors of four a vertex, which hold them."""


class Resources:
    """What the pass binds; each is made when it is first asked for, and once.

    Parameters
    ----------
    device
        It lives on.
    prepared
        The scene.
    """

    def __init__(self, device: wgpu.GPUDevice, prepared: PreparedScene) -> None:
        self.device = device
        self.prepared = prepared
        self._scatter_blocks: dict[Key, wgpu.GPUBuffer] = {}
        self._taps: dict[int, wgpu.GPUBuffer] = {}

    @cached_property
    def vertices(self) -> wgpu.GPUBuffer:
        """Attributes, interleaved."""
        geometry = self.prepared.geometry
        table = np.zeros((geometry.table.shape[0], 4 * ATTRIBUTES), dtype=np.float32)
        at = 0
        for name, width in COLUMNS.items():
            if name in geometry.slices:
                table[:, at : at + width] = geometry.table[:, geometry.slices[name]]
            at += width
        return buffer(self.device, table.tobytes(), wgpu.BufferUsage.VERTEX)

    @cached_property
    def indices(self) -> wgpu.GPUBuffer:
        """Corners of the faces, uint32."""
        faces = np.ascontiguousarray(self.prepared.geometry.faces, dtype=np.uint32)
        return buffer(self.device, faces.tobytes(), wgpu.BufferUsage.INDEX)

    @property
    def corner_count(self) -> int:
        """Three times the number of faces."""
        return int(self.prepared.geometry.faces.size)

    @cached_property
    def skin_block(self) -> wgpu.GPUBuffer:
        """The material's parameters."""
        return buffer(self.device, self.prepared.skin.params.pack(), wgpu.BufferUsage.UNIFORM)

    def scatter_block(self, way: RenderSettings) -> wgpu.GPUBuffer:
        """Return the profile's numbers for a way to shade."""
        key: Key = (way.normal_fetches, *luts_of(way))
        if key not in self._scatter_blocks:
            params = self.prepared.skin.scatter_params(way.normal_fetches, luts_of(way))
            data = params.pack()
            self._scatter_blocks[key] = buffer(self.device, data, wgpu.BufferUsage.UNIFORM)
        return self._scatter_blocks[key]

    @cached_property
    def luts(self) -> LutTextures:
        """Lookup tables."""
        return LutTextures(self.device, self.prepared.skin)

    @cached_property
    def frame_block(self) -> wgpu.GPUBuffer:
        """The record of the frame; `write_frame` fills it."""
        return buffer(self.device, FrameParams().pack(), wgpu.BufferUsage.UNIFORM)

    def write_frame(self, frame: FrameParams) -> None:
        """Fill the record of the frame."""
        self.device.queue.write_buffer(self.frame_block, 0, frame.pack())

    @cached_property
    def nothing(self) -> wgpu.GPUTexture:
        """What stands where a picture needs no texture."""
        return filtered_texture(self.device, [np.zeros((1, 1, 3), dtype=np.float32)])

    @cached_property
    def no_layer(self) -> wgpu.GPUTexture:
        """What stands where a picture needs no layers."""
        return loaded_texture(self.device, np.zeros((1, 1, 3), dtype=np.float32))

    @cached_property
    def maps(self) -> dict[str, wgpu.GPUTexture]:
        """The material's maps; one texel where it has none."""
        params = self.prepared.skin.params
        flat: dict[str, ImageArray] = {
            "albedo": np.ones((1, 1, 3), dtype=np.float32),
            "normal": np.array([[[0.0, 0.0, 1.0]]], dtype=np.float32),
            "specular": np.array([[[1.0, params.gloss]]], dtype=np.float32),
            "deep_scatter": np.ones((1, 1, 3), dtype=np.float32),
        }
        textures = self.prepared.textures
        made = {
            name: filtered_texture(
                self.device, _levels(textures[name]) if name in textures else [default]
            )
            for name, default in flat.items()
        }
        made["tint"] = made.pop("deep_scatter")
        return {f"{name}_map": texture for name, texture in made.items()}

    @cached_property
    def preconvolved(self) -> wgpu.GPUTexture:
        """Levels of the environment's reflection, one below the other."""
        environment = self.prepared.scene.environment
        if environment is None:
            return self.nothing
        return filtered_texture(self.device, [environment.preconvolved.atlas])

    @cached_property
    def sky(self) -> wgpu.GPUTexture:
        """What is seen behind the body, unscaled."""
        environment = self.prepared.scene.environment
        if environment is None or not environment.visible:
            return self.nothing
        return loaded_texture(self.device, environment.radiance)

    @property
    def light_count(self) -> int:
        """Number of lights."""
        return len(self.prepared.scene.lights)

    @cached_property
    def lights(self) -> wgpu.GPUBuffer:
        """One record a light; one that is never read where there is none."""
        width = self.prepared.skin.params.shadow_filter_width_mm
        records = [light_params(*each, width).pack() for each in self.prepared.light_views]
        data = b"".join(records) or LightParams().pack()
        return buffer(self.device, data, wgpu.BufferUsage.STORAGE)

    def taps(self, count: int) -> wgpu.GPUBuffer:
        """Return the points of the wide filter, then those of thickness."""
        if count not in self._taps:
            data = self.prepared.disks(count).astype(np.float32).tobytes()
            self._taps[count] = buffer(self.device, data, wgpu.BufferUsage.STORAGE)
        return self._taps[count]


def luts_of(way: RenderSettings) -> tuple[str, ...]:
    """Return the tables that a way to shade reads; no other need be made."""
    if way.shading == "lambert":
        return ()
    if way.shading == "classic":
        return ("classic", "classic_shadow")
    return ("transfer", "shadow", "sphere" if way.tier == "scalar" else "ring")


def _levels(texture: Texture) -> list[ImageArray]:
    sizes = zip(texture.starts, texture.heights, texture.widths, strict=True)
    return [
        texture.texels[start : start + h * w].reshape(h, w, texture.texels.shape[1])
        for start, h, w in sizes
    ]
