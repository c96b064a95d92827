"""A prepared scene on a device: attributes, maps, tables, depths and blocks, uploaded once."""

from __future__ import annotations

from functools import cached_property

import numpy as np
import wgpu

from ..._core.arrays import ImageArray
from ...gpu.textures import buffer, loaded_texture, mip_texture, table_texture
from ...lut import Lut
from ...params import FrameParams, LightParams, ScatterParams
from ..cpu.texture import Texture
from ..prepared import PreparedScene
from ..renderer import RenderSettings
from .records import light_params, three

__all__ = ["ATTRIBUTES", "TABLES", "Resources", "tables_of"]

Key = tuple[int | str, ...]

ATTRIBUTES = 10
"""Vectors of four a vertex, in the order of `COLUMNS`."""
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
}
"""Numbers of each; what the scene has none of stays 0."""
LUTS = {
    "ring": "ring",
    "sphere": "sphere",
    "shadow_table": "shadow",
    "classic_table": "classic_curvature",
    "classic_shadow_table": "classic_shadow",
}
"""Tables of the pass, and what `Skin` calls them."""
TABLES = ("transfer", *LUTS)
TRANSFER_SIZE = 2048
WIDEST_K_PER_MM = 16.0


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
        self._tables: dict[str, wgpu.GPUTexture] = {}
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
        key: Key = (way.normal_fetches, *tables_of(way))
        if key not in self._scatter_blocks:
            data = self._scatter_params(way).pack()
            self._scatter_blocks[key] = buffer(self.device, data, wgpu.BufferUsage.UNIFORM)
        return self._scatter_blocks[key]

    def _scatter_params(self, way: RenderSettings) -> ScatterParams:
        skin = self.prepared.skin
        profile, blend = skin.profile, skin.blend(way.normal_fetches)
        weights = np.zeros((3, 3))
        weights[:, : blend.weights.shape[1]] = blend.weights
        sigmas = np.zeros(2)
        sigmas[: blend.sigmas_mm.size] = blend.sigmas_mm
        axes = {
            f"{name.removesuffix('_table')}_axes": _axes(self._lut(name))
            for name in tables_of(way)
            if name != "transfer"
        }
        return ScatterParams(
            albedo=three(profile.albedo),
            rms_radius_mm=three(profile.rms_radius_mm),
            sigma_per_mm=three(skin.sigma_per_mm),
            blend_red=three(weights[0]),
            blend_green=three(weights[1]),
            blend_blue=three(weights[2]),
            transfer_axes=(0.0, float(1.0 / np.sqrt(WIDEST_K_PER_MM)), 0.0, 1.0),
            normal_sigmas_mm=(float(sigmas[0]), float(sigmas[1])),
            **axes,
        )

    def table(self, name: str) -> wgpu.GPUTexture:
        """Return a lookup table by the pass's name of it."""
        if name not in self._tables:
            values = self._transfer_values() if name == "transfer" else self._lut(name).values
            self._tables[name] = table_texture(self.device, values)
        return self._tables[name]

    def _lut(self, name: str) -> Lut:
        skin = self.prepared.skin
        found: Lut = getattr(skin, LUTS[name])
        return found

    def _transfer_values(self) -> ImageArray:
        root = (np.arange(TRANSFER_SIZE) + 0.5) / TRANSFER_SIZE * np.sqrt(WIDEST_K_PER_MM)
        return self.prepared.skin.transfer(np.square(root))[None].astype(np.float32)

    @cached_property
    def frame_block(self) -> wgpu.GPUBuffer:
        """The record of the frame; `write_frame` fills it."""
        return buffer(self.device, FrameParams().pack(), wgpu.BufferUsage.UNIFORM)

    def write_frame(self, frame: FrameParams) -> None:
        """Fill the record of the frame."""
        self.device.queue.write_buffer(self.frame_block, 0, frame.pack())

    @cached_property
    def no_table(self) -> wgpu.GPUTexture:
        """What stands where a picture needs no table."""
        return table_texture(self.device, np.zeros((1, 1, 3), dtype=np.float32))

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
            name: mip_texture(
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
            return self.no_table
        return mip_texture(self.device, [environment.preconvolved.atlas])

    @cached_property
    def sky(self) -> wgpu.GPUTexture:
        """What is seen behind the body, unscaled."""
        environment = self.prepared.scene.environment
        if environment is None or not environment.visible:
            return self.no_table
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


def tables_of(way: RenderSettings) -> tuple[str, ...]:
    """Return the tables that a way to shade reads; no other need be made."""
    if way.shading == "lambert":
        return ()
    if way.shading == "classic":
        return ("classic_table", "classic_shadow_table")
    return ("transfer", "shadow_table", "sphere" if way.tier == "scalar" else "ring")


def _axes(lut: Lut) -> tuple[float, float, float, float]:
    (left, right), (top, bottom) = lut.columns.warped_ends, lut.rows.warped_ends
    return left, 1.0 / (right - left), top, 1.0 / (bottom - top)


def _levels(texture: Texture) -> list[ImageArray]:
    sizes = zip(texture.starts, texture.heights, texture.widths, strict=True)
    return [
        texture.texels[start : start + h * w].reshape(h, w, texture.texels.shape[1])
        for start, h, w in sizes
    ]
