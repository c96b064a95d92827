"""CPU renderer: evaluates the specification on a G-buffer, in chunks, on all cores."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..._core.arrays import FloatArray, ImageArray, IntArray, dot, unit_vectors
from ..._core.progress import Progress, silent
from ...mesh.topology import face_normals
from ...params.choices import TERM_VIEWS, AmbientForm, MaterialMap, Shading, ShadowFilter, View
from ...scene import Camera, Light, Scene
from ...shading.compose import shade
from ...shading.contact import CONTACT_FADE_FROM
from ...shading.lobes import reflected_sky
from ...shading.pixel import Ambient, Incident, Surface
from ...shading.shadow import DARK_BEYOND
from ...shading.skin import Skin
from ..backend import Renderer
from ..prepare.parts import PreparedPart, opaque_count
from ..prepare.rasterizer import Fragments, rasterize
from ..prepare.samples import sample_offsets
from ..prepare.scene import prepare_scene
from ..prepare.shadow_filter import WideFilter, build_filter
from ..prepare.shadow_map import ShadowMap, contact, thickness
from ..settings import RenderSettings
from .background import background_light
from .surface import pixel_surface
from .views import surface_view

__all__ = ["CpuRenderer"]

CHUNK = 1 << 14
"""Pixels shaded at once. The arrays of a chunk fit in the caches of one core."""
NO_WALL_MM = 1e3
"""Thickness where the surface faces the light and no taps are taken."""

Columns = Mapping[str, FloatArray]
Filters = Mapping[ShadowFilter, Sequence[WideFilter]]


@dataclass(frozen=True)
class _Request:
    """Request for several pictures of one view, with all tables and filters that they need.

    `skins` has the material of each part.
    """

    camera: Camera
    samples: int
    settings: Sequence[RenderSettings]
    skins: Sequence[Skin]
    filters: Filters


class CpuRenderer(Renderer):
    """A scene prepared for the CPU.

    Parameters
    ----------
    scene
        The scene to draw.
    progress
        Called with the name of the work and the fraction that is done.
    ambient
        Form of the ambient light at the vertices.
    """

    def __init__(
        self,
        scene: Scene,
        progress: Progress = silent,
        ambient: AmbientForm = AmbientForm.STATIC,
    ) -> None:
        self.scene = scene
        self.prepared = prepare_scene(scene, progress, form=ambient)
        self._progress = progress
        faces = self.prepared.vertices.faces
        self._face_normals = unit_vectors(face_normals(scene.mesh.positions_mm, faces))
        self._skins = [part.skin for part in self.prepared.parts]
        self._filters: Filters = {}
        if self.prepared.closer_filters:
            self._filters = {ShadowFilter.PERCENTAGE_CLOSER: self.prepared.closer_filters}

    @property
    def device_name(self) -> str:
        """Name of the device: the CPU."""
        return "the CPU"

    @property
    def timings_ms(self) -> dict[str, list[float]]:
        """Times of passes: empty, because the CPU has no passes."""
        return {}

    def draw_many(
        self,
        camera: Camera,
        size: tuple[int, int],
        samples: int,
        settings: Sequence[RenderSettings],
    ) -> list[ImageArray]:
        """Draw one view with several settings; each sample is rasterised once for all of them."""
        width, height = size
        vertices = self.prepared.vertices
        opaque = opaque_count(self.prepared.parts)
        hidden = self._hidden if opaque < len(vertices.faces) else None
        request = self._request(camera, samples, settings)
        totals = np.zeros((len(settings), height * width, 3))
        coverage = np.zeros(height * width)
        clip = self._clip(camera, size)
        with ThreadPoolExecutor(max(1, os.cpu_count() or 1)) as pool:
            for index, offset in enumerate(sample_offsets(samples, settings[0].seed)):
                self._progress("shading", index / samples)
                fragments = rasterize(clip, vertices.faces, size, offset, hidden, opaque)
                chunks = [
                    (index, chunk)
                    for index, part in enumerate(self.prepared.parts)
                    for chunk in _chunks(_of_part(fragments, part))
                ]
                shaded = pool.map(lambda pair: self._shade(pair[0], pair[1], request), chunks)
                for (_, chunk), colours in zip(chunks, shaded, strict=True):
                    coverage[chunk.pixel] += 1.0
                    for total, colour in zip(totals, colours, strict=True):
                        total[chunk.pixel] += colour
        self._progress("shading", 1.0)
        coverage /= samples
        background = (1.0 - coverage[:, None]) * background_light(self.scene, camera, size)
        images = np.empty((len(settings), height * width, 4), dtype=np.float32)
        for image, total in zip(images, totals, strict=True):
            total /= samples
            np.add(total, background, out=image[:, :3], casting="same_kind")
            image[:, 3] = coverage
        return [image.reshape(height, width, 4) for image in images]

    def _request(
        self, camera: Camera, samples: int, settings: Sequence[RenderSettings]
    ) -> _Request:
        """Return a request; its missing tables and filters are built here, before threads start."""
        fetches = {setting.normal_fetches for setting in settings}
        for index, part in enumerate(self.prepared.parts):
            luts = {name for setting in settings for name in part.luts(part.settings(setting))}
            self._skins[index] = self._skins[index].including(sorted(luts), sorted(fetches))
        width = self.scene.material.params.shadow_filter_width_mm
        for kind in {setting.shadow_filter for setting in settings} - set(self._filters):
            filters = [
                build_filter(kind, shadow_map, width) for shadow_map in self.prepared.shadow_maps
            ]
            self._filters = {**self._filters, kind: filters}
        return _Request(camera, samples, settings, tuple(self._skins), self._filters)

    def _clip(self, camera: Camera, size: tuple[int, int]) -> FloatArray:
        matrix = camera.view_projection(size[0] / size[1])
        return self.scene.mesh.positions_mm @ matrix[:, :3].T + matrix[:, 3]

    def _hidden(self, face: IntArray, barycentric: FloatArray) -> NDArray[np.bool_] | None:
        """Return which points on faces (N,) show nothing because of their opacity; None if all show."""
        hidden = None
        for part in self.prepared.parts:
            if part.opacity is None:
                continue
            own = np.flatnonzero(_within(part, face))
            if not own.size:
                continue
            uv = self.prepared.vertices.mixed("uv", face[own], barycentric[own])
            opacity = part.textures[MaterialMap.ALBEDO].sample(uv, np.zeros(own.size))[:, 3]
            hidden = np.zeros(face.size, dtype=bool) if hidden is None else hidden
            hidden[own] = opacity < part.opacity_cutoff
        return hidden

    def _shade(self, index: int, chunk: Fragments, request: _Request) -> list[FloatArray]:
        """Return the colours (N, 3) of a chunk of a part's pixels for each of the settings."""
        part, skin = self.prepared.parts[index], request.skins[index]
        settings = [part.settings(setting) for setting in request.settings]
        columns = self.prepared.vertices.interpolated(chunk.face, chunk.barycentric)
        surfaces = {
            fetches: pixel_surface(
                part,
                self.prepared.vertices,
                skin,
                chunk,
                columns,
                request.camera,
                request.samples,
                fetches,
            )
            for fetches in {setting.normal_fetches for setting in settings}
        }
        surface = next(iter(surfaces.values()))
        position = columns["position"]
        incident = {
            kind: [
                _incident(light, wide_filter, position, surface)
                for light, wide_filter in zip(
                    self.prepared.lights, request.filters[kind], strict=True
                )
            ]
            for kind in {setting.shadow_filter for setting in settings}
        }
        to_light = [light.to_light for light in next(iter(incident.values()))]
        thicknesses = {
            taps: [
                _thickness(shadow_map, direction, position, surface, skin, taps)
                for shadow_map, direction in zip(self.prepared.shadow_maps, to_light, strict=True)
            ]
            for taps in {setting.thickness_taps for setting in settings}
        }
        contacts: list[FloatArray | None] = [None] * len(to_light)
        if any(setting.has_contact for setting in settings):
            normal = self._face_normals[chunk.face]
            # The contact filter needs the side of the mesh's normals.
            normal = np.where(dot(normal, surface.mesh_normal)[:, None] < 0.0, -normal, normal)
            contacts = [
                _contact(shadow_map, direction, position, normal)
                for shadow_map, direction in zip(self.prepared.shadow_maps, to_light, strict=True)
            ]
        models = {skin.specular_model(setting.shading): setting.shading for setting in settings}
        ambient = {
            model: self._ambient(columns, surface, skin, shading)
            for model, shading in models.items()
        }
        colours = []
        for setting in settings:
            lights = [
                replace(light, thickness_mm=depth, contact=share if setting.has_contact else None)
                for light, depth, share in zip(
                    incident[setting.shadow_filter],
                    thicknesses[setting.thickness_taps],
                    contacts,
                    strict=True,
                )
            ]
            own = ambient[skin.specular_model(setting.shading)]
            colours.append(_colour(skin, surfaces[setting.normal_fetches], lights, own, setting))
        return colours

    def _ambient(
        self, columns: Columns, surface: Surface, skin: Skin, shading: Shading
    ) -> Ambient | None:
        prepared = self.prepared
        if prepared.radiance_sh is None or prepared.preconvolved is None:
            return None
        return Ambient(
            prepared.radiance_sh,
            columns["visibility"],
            columns["bounced"],
            reflected_sky(skin, surface, prepared.preconvolved, shading),
            columns["through"],
            columns["sky_harmonics"],
        )


def _incident(
    light: Light, wide_filter: WideFilter, position: FloatArray, surface: Surface
) -> Incident:
    """Return the incident light at N pixels, without thickness."""
    normal = surface.mesh_normal
    to_light, irradiance = light.at(position)
    cosine = dot(normal, to_light)
    lit = np.flatnonzero(cosine > DARK_BEYOND)
    shadow_filter = np.zeros(cosine.size)
    shadow_filter[lit] = wide_filter.lit(
        position[lit], normal[lit], to_light[lit], surface.curvature_per_mm[lit]
    )
    return Incident(to_light, irradiance / np.pi, shadow_filter)


def _contact(
    shadow_map: ShadowMap, to_light: FloatArray, position: FloatArray, face_normal: FloatArray
) -> FloatArray:
    """Return the unhidden share (N,) of the contact filter; 1 where a face does not look at the light."""
    lit = np.flatnonzero(dot(face_normal, to_light) > CONTACT_FADE_FROM)
    result = np.ones(len(position))
    result[lit] = contact(shadow_map, position[lit], face_normal[lit], to_light[lit])
    return result


def _thickness(
    shadow_map: ShadowMap,
    to_light: FloatArray,
    position: FloatArray,
    surface: Surface,
    skin: Skin,
    taps: int,
) -> FloatArray | None:
    """Return the thickness (N,) of the body towards a light, mm; None without taps."""
    if not taps:
        return None
    cosine = dot(surface.mesh_normal, to_light)
    behind = np.flatnonzero(cosine < 0.5)
    result = np.full(cosine.size, NO_WALL_MM)
    result[behind] = thickness(
        shadow_map,
        position[behind],
        surface.mesh_normal[behind],
        skin.params.deep_scatter_offset_mm,
        skin.params.deep_scatter_filter_mm,
        taps,
    )
    return result


def _colour(
    skin: Skin,
    surface: Surface,
    lights: list[Incident],
    ambient: Ambient | None,
    settings: RenderSettings,
) -> FloatArray:
    """Return the colours (N, 3) of N pixels."""
    view = surface_view(settings.debug_view, surface, lights)
    if view is not None:
        return view
    if ambient is not None and not settings.deep_scatter_taps:
        ambient = replace(ambient, through=None)
    terms = shade(skin, surface, lights, ambient, settings.shading, settings.tier)
    if settings.debug_view != View.PICTURE:
        return terms[TERM_VIEWS[settings.debug_view]]
    total: FloatArray = np.sum(list(terms.values()), axis=0)
    return total


def _within(part: PreparedPart, face: IntArray) -> NDArray[np.bool_]:
    """Return which faces (N,) belong to a part."""
    return (face >= part.first_face) & (face < part.first_face + part.face_count)


def _of_part(fragments: Fragments, part: PreparedPart) -> Fragments:
    """Return the fragments of a part."""
    own = _within(part, fragments.face)
    return fragments if own.all() else fragments.chosen(own)


def _chunks(fragments: Fragments) -> Iterator[Fragments]:
    for start in range(0, fragments.pixel.size, CHUNK):
        yield fragments.chosen(slice(start, start + CHUNK))
