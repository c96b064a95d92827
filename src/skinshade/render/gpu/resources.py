"""A prepared scene on a device: attributes, maps, tables, depths and blocks, uploaded once."""

from __future__ import annotations

from functools import cached_property

import numpy as np
import wgpu

from ..._core.arrays import FloatArray, ImageArray
from ...gpu.textures import array_texture, buffer, mip_texture, table_texture
from ...lut import Lut
from ...params import ScatterParams
from ...scene import DirectionalLight, Light
from ..cpu.shadow_map import ShadowMap
from ..cpu.texture import Texture
from ..prepared import PreparedScene

__all__ = ["ATTRIBUTES", "Resources"]

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
TRANSFER_SIZE = 2048
WIDEST_K_PER_MM = 16.0
NOWHERE_MM = 1e30
"""Depth of nothing: infinity cannot be filtered, nor compared on every driver."""


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

    @cached_property
    def scatter_block(self) -> wgpu.GPUBuffer:
        """The profile's numbers."""
        skin = self.prepared.skin
        profile, blend = skin.profile, skin.blend
        weights = np.zeros((3, 3))
        weights[:, : blend.weights.shape[1]] = blend.weights
        sigmas = np.zeros(2)
        sigmas[: blend.sigmas_mm.size] = blend.sigmas_mm
        block = ScatterParams(
            albedo=_three(profile.albedo),
            rms_radius_mm=_three(profile.rms_radius_mm),
            sigma_per_mm=_three(skin.sigma_per_mm),
            blend_red=_three(weights[0]),
            blend_green=_three(weights[1]),
            blend_blue=_three(weights[2]),
            ring_axes=_axes(skin.ring),
            sphere_axes=_axes(skin.sphere),
            transfer_axes=(0.0, float(1.0 / np.sqrt(WIDEST_K_PER_MM)), 0.0, 1.0),
            shadow_axes=_axes(skin.shadow),
            classic_axes=_axes(skin.classic_curvature),
            classic_shadow_axes=_axes(skin.classic_shadow),
            normal_sigmas_mm=(float(sigmas[0]), float(sigmas[1])),
        )
        return buffer(self.device, block.pack(), wgpu.BufferUsage.UNIFORM)

    @cached_property
    def tables(self) -> dict[str, wgpu.GPUTexture]:
        """Lookup tables by the pass's names."""
        skin = self.prepared.skin
        root = (np.arange(TRANSFER_SIZE) + 0.5) / TRANSFER_SIZE * np.sqrt(WIDEST_K_PER_MM)
        transfer = skin.transfer(np.square(root))[None].astype(np.float32)
        values = {
            "ring": skin.ring.values,
            "sphere": skin.sphere.values,
            "transfer": transfer,
            "shadow_table": skin.shadow.values,
            "classic_table": skin.classic_curvature.values,
            "classic_shadow_table": skin.classic_shadow.values,
        }
        return {name: table_texture(self.device, each) for name, each in values.items()}

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
        """Levels of the environment's reflection."""
        environment = self.prepared.scene.environment
        levels = (
            np.zeros((5, 2, 2, 3), dtype=np.float32)
            if environment is None
            else np.asarray(environment.preconvolved.levels, dtype=np.float32)
        )
        return array_texture(self.device, levels, filtered=True)

    @cached_property
    def depths(self) -> wgpu.GPUTexture:
        """Two layers a light: what shadows, and the nearest surface."""
        layers = [
            each
            for _, found in self.prepared.shadow_maps
            for each in (found.occluders, found.first)
        ]
        stack = np.stack(layers) if layers else np.zeros((2, 1, 1))
        finite = np.where(np.isfinite(stack), stack, NOWHERE_MM).astype(np.float32)
        return array_texture(self.device, finite, filtered=False)

    @cached_property
    def lights(self) -> wgpu.GPUBuffer:
        """One record a light, as the pass declares it."""
        records = [_light(*each) for each in self.prepared.shadow_maps] or [np.zeros((10, 4))]
        data = np.concatenate(records).astype(np.float32)
        return buffer(self.device, data.tobytes(), wgpu.BufferUsage.STORAGE)

    def taps(self, count: int) -> wgpu.GPUBuffer:
        """Points of the wide filter, then those of thickness."""
        data = self.prepared.disks(count).astype(np.float32)
        return buffer(self.device, data.tobytes(), wgpu.BufferUsage.STORAGE)


def _three(values: FloatArray) -> tuple[float, float, float]:
    red, green, blue = (float(each) for each in values)
    return red, green, blue


def _axes(lut: Lut) -> tuple[float, float, float, float]:
    (left, right), (top, bottom) = lut.columns.warped_ends, lut.rows.warped_ends
    return left, 1.0 / (right - left), top, 1.0 / (bottom - top)


def _levels(texture: Texture) -> list[ImageArray]:
    sizes = zip(texture.starts, texture.heights, texture.widths, strict=True)
    return [
        texture.texels[start : start + h * w].reshape(h, w, texture.texels.shape[1])
        for start, h, w in sizes
    ]


def _light(light: Light, found: ShadowMap) -> FloatArray:
    record = np.zeros((10, 4))
    record[0:3] = found.view[:3]
    record[3:6] = found.projection[[0, 1, 3]]
    record[9, :3] = light.irradiance
    if isinstance(light, DirectionalLight):
        record[6, :3] = light.to_light
        return record
    away = light.position_mm - light.target_mm
    distance = float(np.linalg.norm(away))
    record[6] = [*light.position_mm, 1.0]
    record[7] = [*(away / distance), distance**2]
    record[8, :2] = np.cos(np.radians([light.cone_deg, 0.8 * light.cone_deg]))
    return record
