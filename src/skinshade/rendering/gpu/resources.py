"""Resources of a prepared scene on a device: vertices, maps, tables and blocks, each uploaded once."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

import numpy as np

from ..._core.arrays import ImageArray
from ...gpu.device import BufferUsage, GPUBuffer, GPUDevice, GPUTexture
from ...gpu.luts import LutTextures
from ...gpu.textures import buffer, filtered_texture, loaded_texture
from ...params import FrameParams
from ...params.choices import MaterialMap
from ...params.vertex import VERTEX_VECTORS
from ..prepare.parts import PreparedPart
from ..prepare.scene import PreparedScene
from ..prepare.shadow_map import tap_disks
from ..settings import RenderSettings

__all__ = ["VERTEX_FLOATS", "PartResources", "SceneResources"]

VERTEX_FLOATS = 4 * VERTEX_VECTORS
BINDINGS = {MaterialMap.DEEP_SCATTER: "tint_map"}
"""Names of maps in the pass that differ from ``<map>_map``."""


class SceneResources:
    """Resources that all parts of a scene share; each is created at its first use.

    Parameters
    ----------
    device
        Device of the resources.
    prepared
        The scene.
    """

    def __init__(self, device: GPUDevice, prepared: PreparedScene) -> None:
        self.device, self.prepared = device, prepared
        self._taps: dict[int, GPUBuffer] = {}

    @cached_property
    def vertices(self) -> GPUBuffer:
        """Vertex buffer with the columns of `skinshade.params.vertex.VERTEX_COLUMNS`."""
        values = self.prepared.vertices.values
        padded = np.zeros((len(values), VERTEX_FLOATS), dtype=np.float32)
        padded[:, : values.shape[1]] = values
        return buffer(self.device, padded.tobytes(), BufferUsage.VERTEX)

    @cached_property
    def indices(self) -> GPUBuffer:
        """Index buffer with the corners of the faces, uint32."""
        faces = np.ascontiguousarray(self.prepared.vertices.faces, dtype=np.uint32)
        return buffer(self.device, faces.tobytes(), BufferUsage.INDEX)

    @cached_property
    def placeholder(self) -> GPUTexture:
        """Placeholder texture for pictures that do not read one."""
        return filtered_texture(self.device, [np.zeros((1, 1, 3), dtype=np.float32)])

    @cached_property
    def placeholder_layers(self) -> GPUTexture:
        """Placeholder texture array for pictures that do not read one."""
        return loaded_texture(self.device, np.zeros((1, 1, 3), dtype=np.float32))

    @cached_property
    def preconvolved(self) -> GPUTexture:
        """Levels of the environment's preconvolved reflections, one below the other."""
        if self.prepared.preconvolved is None:
            return self.placeholder
        return filtered_texture(self.device, [self.prepared.preconvolved.atlas])

    @cached_property
    def sky(self) -> GPUTexture:
        """Radiance of the environment behind the body, before its scale."""
        environment = self.prepared.scene.environment
        if environment is None or not environment.visible:
            return self.placeholder
        return loaded_texture(self.device, environment.radiance)

    def taps(self, count: int) -> GPUBuffer:
        """Return the disk of the wide filter, followed by a thickness disk of `count` taps."""
        if count not in self._taps:
            data = tap_disks(count).astype(np.float32).tobytes()
            self._taps[count] = buffer(self.device, data, BufferUsage.STORAGE)
        return self._taps[count]


class PartResources:
    """Resources of one part of a scene; each is created at its first use.

    Parameters
    ----------
    shared
        Resources of the scene.
    part
        Part of the scene.
    """

    def __init__(self, shared: SceneResources, part: PreparedPart) -> None:
        self.shared, self.part = shared, part
        self._skin = part.skin
        self._luts = LutTextures(shared.device)
        self._scatter_blocks: dict[RenderSettings, GPUBuffer] = {}

    @cached_property
    def skin_block(self) -> GPUBuffer:
        """Uniform buffer with the parameters of the material."""
        return buffer(self.shared.device, self.part.skin.params.pack(), BufferUsage.UNIFORM)

    def scatter_block(self, settings: RenderSettings) -> GPUBuffer:
        """Return the profile's numbers with the axes and weights that `settings` need."""
        if settings not in self._scatter_blocks:
            fetches = settings.normal_fetches
            self._skin = self._skin.including(self.part.luts(settings), (fetches,))
            data = self._skin.scatter_params(fetches).pack()
            self._scatter_blocks[settings] = buffer(self.shared.device, data, BufferUsage.UNIFORM)
        return self._scatter_blocks[settings]

    def lut(self, name: str, settings: RenderSettings) -> GPUTexture:
        """Return the texture of the table `name`, or the placeholder if `settings` do not read it."""
        names = self.part.luts(settings)
        if name not in names:
            return self.shared.placeholder
        self._skin = self._skin.including(names)
        return self._luts.texture(name, self._skin)

    @cached_property
    def frame_block(self) -> GPUBuffer:
        """Uniform buffer of the frame, which `write_frame` fills."""
        return buffer(self.shared.device, FrameParams().pack(), BufferUsage.UNIFORM)

    def write_frame(self, frame: FrameParams) -> None:
        """Write the block of a `frame`."""
        self.shared.device.queue.write_buffer(self.frame_block, 0, frame.pack())

    @cached_property
    def maps(self) -> Mapping[str, GPUTexture]:
        """Maps of the material by their names in the pass; a map that it does not have is one texel."""
        gloss = self.part.skin.params.gloss
        constants: dict[MaterialMap, ImageArray] = {
            MaterialMap.ALBEDO: np.ones((1, 1, 3), dtype=np.float32),
            MaterialMap.NORMAL: np.array([[[0.0, 0.0, 1.0]]], dtype=np.float32),
            MaterialMap.SPECULAR: np.array([[[1.0, gloss]]], dtype=np.float32),
            MaterialMap.DEEP_SCATTER: np.ones((1, 1, 3), dtype=np.float32),
        }
        textures = self.part.textures
        return {
            BINDINGS.get(kind, f"{kind}_map"): filtered_texture(
                self.shared.device, textures[kind].images() if kind in textures else [constant]
            )
            for kind, constant in constants.items()
        }
