"""What every backend draws from, made once for a scene: tables, attributes, mips, depths."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from functools import cached_property

import numpy as np

from .._core.arrays import FloatArray, unit_vectors
from .._core.progress import Progress, silent
from ..mesh import mesh_uv_scale
from ..scene import Camera, Light, Scene
from ..scene.maps import steepened
from ..shading.deep_scatter import poisson_disk
from ..shading.skin import Skin
from .cpu.geometry import Geometry, build_geometry
from .cpu.shadow_map import FILTER_TAPS, ShadowMap, hemisphere_disk, render_shadow_map
from .cpu.sky import SkyLight, sky_light
from .cpu.texture import Texture, build_texture
from .light_view import LightView

__all__ = ["PreparedScene"]


class PreparedScene:
    """A scene and all that does not depend on the camera.

    Parameters
    ----------
    scene
        What is drawn.
    progress
        Called with what is being done and how far it is.
    """

    def __init__(self, scene: Scene, progress: Progress = silent) -> None:
        self.scene = scene
        self.skin = Skin.of(scene.material.profile, scene.material.params)
        self._progress = progress

    def prepare(self) -> None:
        """Make now what every backend needs."""
        for name in ("sky", "geometry", "textures"):
            self._progress("preparing", 0.0)
            getattr(self, name)

    @cached_property
    def sky(self) -> SkyLight | None:
        """Ambient light at the vertices, or None without an environment."""
        if self.scene.environment is None:
            return None
        return sky_light(
            self.scene.mesh,
            self.scene.environment,
            self.shadow_maps,
            self.skin,
            self.scene.material.albedo.reshape(-1, 3).mean(axis=0),
            self._progress,
        )

    @cached_property
    def geometry(self) -> Geometry:
        """Everything that shading interpolates."""
        return build_geometry(self.scene.mesh, self.skin, self.sky)

    @cached_property
    def light_views(self) -> list[tuple[Light, LightView]]:
        """Each light, and how it sees the body."""
        return [(light, LightView.of(light, self.scene.mesh)) for light in self.scene.lights]

    @cached_property
    def shadow_maps(self) -> list[tuple[Light, ShadowMap]]:
        """Each light, and the depths that it sees."""
        return [(light, render_shadow_map(light, self.scene.mesh)) for light in self.scene.lights]

    @staticmethod
    def disks(taps: int) -> FloatArray:
        """Return the points (n, 2) of the wide filter, then those of thickness by a number of taps."""
        return np.concatenate([hemisphere_disk(FILTER_TAPS), poisson_disk(max(taps, 1))])

    @cached_property
    def textures(self) -> dict[str, Texture]:
        """Mips of each map that the material has, by its name there."""
        material = self.scene.material
        maps = {
            "albedo": material.albedo,
            "normal": material.normal,
            "specular": material.specular,
            "deep_scatter": material.deep_scatter,
        }
        strength = self.skin.params.normal_strength
        if material.normal is not None:
            maps["normal"] = steepened(material.normal, strength)
        there = {name: picture for name, picture in maps.items() if picture is not None}
        with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
            return dict(zip(there, pool.map(build_texture, there.values()), strict=True))

    @cached_property
    def uv_scale_mm(self) -> float:
        """Length of the unit of UV on the surface, mm."""
        mesh = self.scene.mesh
        assert mesh.uvs is not None
        return mesh_uv_scale(mesh.positions_mm, mesh.uvs, mesh.faces)

    def background(self, camera: Camera, size: tuple[int, int]) -> FloatArray:
        """Return what lies behind the body, (H·W, 3) or (3,) for all pixels."""
        environment = self.scene.environment
        if environment is None or not environment.visible:
            return self.scene.background
        width, height = size
        x = (2.0 * np.arange(width) + 1.0) / width - 1.0
        y = 1.0 - (2.0 * np.arange(height) + 1.0) / height
        screen = np.stack(np.broadcast_arrays(x[None, :], y[:, None], 1.0, 1.0), axis=-1)
        far = screen.reshape(-1, 4) @ np.linalg.inv(camera.view_projection(width / height)).T
        rays = unit_vectors(far[:, :3] / far[:, 3:] - camera.position_mm)
        return environment.sample(rays)
