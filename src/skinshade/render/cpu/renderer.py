"""The specification on a G-buffer, in chunks, on every core."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np

from ..._core.arrays import FloatArray, ImageArray, dot, unit_vectors
from ..._core.progress import Progress, silent
from ...scene import Camera, Light, Scene
from ...shading import specular
from ...shading.compose import shade
from ...shading.image_light import reflected_radiance
from ...shading.normals import blur_level
from ...shading.pixel import Ambient, Incident, Surface
from ..prepared import PreparedScene
from ..renderer import Renderer, RenderSettings, sample_offsets
from .debug import debug_image
from .geometry import Columns
from .raster import Fragments, rasterize
from .shadow_map import ShadowFilter, ShadowMap

__all__ = ["CpuRenderer"]

CHUNK = 1 << 14
"""Pixels shaded at once: the arrays of a chunk stay in the caches of one core."""
DARK_BEYOND = -0.6
"""N·L below which no table holds light of its own, so that no shadow need be filtered."""


class CpuRenderer(Renderer):
    """A scene made ready for the CPU.

    Parameters
    ----------
    scene
        What is drawn.
    progress
        Called with what is being done and how far it is.
    """

    def __init__(self, scene: Scene, progress: Progress = silent) -> None:
        self.scene = scene
        self.prepared = PreparedScene(scene, progress)
        self._progress = progress

    @property
    def place(self) -> str:
        """The processor."""
        return "the CPU"

    @property
    def timings_ms(self) -> dict[str, list[float]]:
        """None: there are no passes on a device."""
        return {}

    def draw_each(
        self,
        camera: Camera,
        size: tuple[int, int],
        samples: int,
        ways: Sequence[RenderSettings],
    ) -> list[ImageArray]:
        """Return a picture for each way to shade; what they see is found once."""
        width, height = size
        clip = self._clip(camera, size)
        self._prepare(ways)
        totals = np.zeros((len(ways), height * width, 3))
        coverage = np.zeros(height * width)
        workers = max(1, os.cpu_count() or 1)
        with ThreadPoolExecutor(workers) as pool:
            offsets = sample_offsets(samples, ways[0].seed)
            for index, offset in enumerate(offsets):
                self._progress("shading", index / samples)
                fragments = rasterize(clip, self.scene.mesh.faces, size, offset)
                chunks = list(_chunks(fragments))
                shaded = pool.map(lambda chunk: self._shade(chunk, camera, samples, ways), chunks)
                for chunk, colours in zip(chunks, shaded, strict=True):
                    coverage[chunk.pixel] += 1.0
                    for total, colour in zip(totals, colours, strict=True):
                        total[chunk.pixel] += colour
        self._progress("shading", 1.0)
        coverage /= samples
        behind = (1.0 - coverage[:, None]) * self.prepared.background(camera, size)
        pictures = []
        for total in totals:
            picture = np.concatenate([total / samples + behind, coverage[:, None]], axis=1)
            pictures.append(picture.reshape(height, width, 4).astype(np.float32))
        return pictures

    def _prepare(self, ways: Sequence[RenderSettings]) -> None:
        """Make everything here, in one thread, so that no two chunks make it twice."""
        self.prepared.prepare()
        skin = self.prepared.skin
        _ = (skin.sphere, skin.ring, skin.shadow)
        for way in ways:
            skin.blend(way.normal_fetches)
            for _, shadow_map in self.prepared.shadow_maps:
                if way.shadow_filter == "variance":
                    shadow_map.moments(skin.params.shadow_filter_width_mm)

    def _clip(self, camera: Camera, size: tuple[int, int]) -> FloatArray:
        matrix = camera.view_projection(size[0] / size[1])
        return self.scene.mesh.positions_mm @ matrix[:, :3].T + matrix[:, 3]

    def _shade(
        self,
        chunk: Fragments,
        camera: Camera,
        samples: int,
        ways: Sequence[RenderSettings],
    ) -> list[FloatArray]:
        columns = self.prepared.geometry.interpolated(chunk.face, chunk.barycentric)
        surfaces = {
            fetches: self._surface(chunk, columns, camera, samples, fetches)
            for fetches in {way.normal_fetches for way in ways}
        }
        surface = next(iter(surfaces.values()))
        shadowed = {
            kind: [
                self._incident(light, shadow_map, columns, surface, kind)
                for light, shadow_map in self.prepared.shadow_maps
            ]
            for kind in {way.shadow_filter for way in ways}
        }
        thickness = {
            taps: [
                self._thickness(incident, shadow_map, columns, surface, taps)
                for incident, (_, shadow_map) in zip(
                    next(iter(shadowed.values())), self.prepared.shadow_maps, strict=True
                )
            ]
            for taps in {way.thickness_taps for way in ways}
        }
        surroundings = self._surroundings(columns, surface)
        pictures = []
        for way in ways:
            lights = [
                replace(incident, thickness_mm=thick)
                for incident, thick in zip(
                    shadowed[way.shadow_filter], thickness[way.thickness_taps], strict=True
                )
            ]
            pictures.append(self._shaded(surfaces[way.normal_fetches], lights, surroundings, way))
        return pictures

    def _shaded(
        self,
        surface: Surface,
        lights: list[Incident],
        surroundings: Ambient | None,
        way: RenderSettings,
    ) -> FloatArray:
        if way.debug_view is not None:
            view = debug_image(way.debug_view, surface, lights)
            if view is not None:
                return view
        if surroundings is not None and not way.deep_scatter_taps:
            surroundings = replace(surroundings, through=None)
        terms = shade(self.prepared.skin, surface, lights, surroundings, way.shading, way.tier)
        if way.debug_view is not None:
            return terms[way.debug_view.replace("-", "_")]
        total: FloatArray = np.sum(list(terms.values()), axis=0)
        return total

    def _surface(
        self, chunk: Fragments, columns: Columns, camera: Camera, samples: int, fetches: int
    ) -> Surface:
        params = self.prepared.skin.params
        # Between vertices that turn, interpolation shortens normals; that is no relief.
        length = np.maximum(np.sqrt(dot(columns["normal"], columns["normal"])), 1e-3)
        normal = unit_vectors(columns["normal"])
        uv = columns["uv"]
        geometry = self.prepared.geometry
        corner_uv = geometry.table[:, geometry.slices["uv"]][geometry.faces[chunk.face]]
        # Samples share a pixel: each stands for a smaller footprint.
        spread = 1.0 / np.sqrt(samples)
        along_x = spread * np.einsum("ni,nik->nk", chunk.along_x, corner_uv)
        along_y = spread * np.einsum("ni,nik->nk", chunk.along_y, corner_uv)

        def fetch(name: str) -> FloatArray:
            texture = self.prepared.textures[name]
            return texture.sample(uv, texture.level(along_x, along_y))

        ones = np.ones(chunk.pixel.size)
        gloss, reflectance = params.gloss * ones, params.reflectance * ones
        if "specular" in self.prepared.textures:
            factor, gloss = fetch("specular").T
            reflectance = params.reflectance * factor
        albedo = (
            fetch("albedo")
            if self.prepared.textures["albedo"].size > 1
            else np.repeat(
                self.scene.material.albedo.reshape(1, 3).astype(np.float64), ones.size, axis=0
            )
        )
        tint = (
            fetch("deep_scatter")
            if "deep_scatter" in self.prepared.textures
            else np.ones((ones.size, 3))
        )
        fetched = self._fetched_normals(columns, normal, uv, along_x, along_y, fetches)
        gloss = specular.gloss_of_relief(gloss, np.sqrt(dot(fetched[:, 0], fetched[:, 0])))
        return Surface(
            view=unit_vectors(camera.position_mm - columns["position"]),
            mesh_normal=normal,
            fetched=fetched,
            curvature_per_mm=columns["curvature"][:, 0],
            albedo=albedo,
            gloss=gloss,
            reflectance=reflectance,
            tint=tint,
            tensor_world=columns["tensor"],
            diffused_normals=columns["diffused"].reshape(-1, 3, 3) / length[:, None, None],
            diffused_curvature_per_mm=columns["diffused_curvature"],
            unexplained=columns["unexplained"],
        )

    def _fetched_normals(
        self,
        columns: Columns,
        normal: FloatArray,
        uv: FloatArray,
        along_x: FloatArray,
        along_y: FloatArray,
        fetches: int,
    ) -> FloatArray:
        sigmas = self.prepared.skin.blend(fetches).sigmas_mm
        if "normal" not in self.prepared.textures:
            return np.repeat(normal[:, None], sigmas.size + 1, axis=1)
        texture = self.prepared.textures["normal"]
        tangent = columns["tangent"][:, :3]
        tangent = unit_vectors(tangent - normal * dot(tangent, normal)[:, None])
        bitangent = np.cross(normal, tangent) * np.sign(columns["tangent"][:, 3:])
        level = texture.level(along_x, along_y)
        fetched = []
        for sigma in (None, *sigmas):
            at = (
                level
                if sigma is None
                else blur_level(sigma, self.prepared.uv_scale_mm, texture.size, level)
            )
            t = texture.sample(uv, at)
            fetched.append(tangent * t[:, :1] + bitangent * t[:, 1:2] + normal * t[:, 2:])
        return np.stack(fetched, axis=1)

    def _incident(
        self,
        light: Light,
        shadow_map: ShadowMap,
        columns: Columns,
        surface: Surface,
        kind: ShadowFilter,
    ) -> Incident:
        position, normal = columns["position"], surface.mesh_normal
        to_light, irradiance = light.at(position)
        cosine = dot(normal, to_light)
        lit = np.flatnonzero(cosine > DARK_BEYOND)
        shadow_filter = np.zeros(cosine.size)
        shadow_filter[lit] = shadow_map.shadow_filter(
            position[lit],
            normal[lit],
            to_light[lit],
            surface.curvature_per_mm[lit],
            self.prepared.skin.params.shadow_filter_width_mm,
            kind,
        )
        return Incident(to_light, irradiance / np.pi, shadow_filter)

    def _thickness(
        self,
        incident: Incident,
        shadow_map: ShadowMap,
        columns: Columns,
        surface: Surface,
        taps: int,
    ) -> FloatArray | None:
        if not taps:
            return None
        params = self.prepared.skin.params
        cosine = dot(surface.mesh_normal, incident.to_light)
        behind = np.flatnonzero(cosine < 0.5)
        thickness = np.full(cosine.size, 1e3)
        thickness[behind] = shadow_map.thickness(
            columns["position"][behind],
            surface.mesh_normal[behind],
            params.deep_scatter_offset_mm,
            params.deep_scatter_filter_mm,
            taps,
        )
        return thickness

    def _surroundings(self, columns: Columns, surface: Surface) -> Ambient | None:
        environment = self.scene.environment
        if environment is None:
            return None
        mirror = specular.reflected(surface.sharp, surface.view)
        return Ambient(
            environment.radiance_sh,
            columns["visibility"],
            columns["bounced"],
            reflected_radiance(environment.preconvolved, mirror, surface.gloss),
            columns["through"],
        )


def _chunks(fragments: Fragments) -> Iterator[Fragments]:
    for start in range(0, fragments.pixel.size, CHUNK):
        part = slice(start, start + CHUNK)
        yield Fragments(
            fragments.pixel[part],
            fragments.face[part],
            fragments.barycentric[part],
            fragments.along_x[part],
            fragments.along_y[part],
        )
