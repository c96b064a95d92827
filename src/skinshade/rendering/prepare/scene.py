"""Scene data that does not depend on the camera."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

from ..._core.arrays import FloatArray
from ..._core.progress import Progress, silent
from ...mesh import Mesh, mesh_uv_scale
from ...params.choices import MaterialMap, ShadowFilter
from ...scene import Material, Scene
from ...scene.maps import scale_slopes
from ...shading.image_light import PreconvolvedRadiance
from ...shading.skin import Skin
from .ambient_light import gather_ambient_light
from .attributes import VertexTable, build_vertex_table
from .light_view import LightView
from .mips import Texture, build_texture
from .shadow_filter import WideFilter, build_filter
from .shadow_map import ShadowMap, rasterize_shadow_map

__all__ = ["PreparedScene", "Rasterize", "prepare_scene"]

Rasterize = Callable[[Mesh, Sequence[LightView]], Sequence[ShadowMap]]
"""Function that draws the shadow maps of a mesh, one for each light."""


@dataclass(frozen=True)
class PreparedScene:
    """Scene data that all pictures of a scene share and that never changes.

    Attributes
    ----------
    scene
        The scene.
    skin
        Material without lookup tables. A backend adds the tables that its settings need.
    vertices
        Vertex attributes.
    textures
        Mip-mapped textures of the maps that the material has.
    uv_scale_mm
        Length of one unit of UV on the surface, mm; 1 if the material has no normal map.
    shadow_maps
        Shadow map of each light.
    closer_filters
        Percentage-closer filter of each light; empty without an environment.
    radiance_sh
        (9, 3) spherical harmonics of the environment; None without an environment.
    preconvolved
        Preconvolved reflections of the environment; None without an environment.
    """

    scene: Scene
    skin: Skin
    vertices: VertexTable
    textures: Mapping[MaterialMap, Texture]
    uv_scale_mm: float
    shadow_maps: Sequence[ShadowMap]
    closer_filters: Sequence[WideFilter]
    radiance_sh: FloatArray | None
    preconvolved: PreconvolvedRadiance | None


def rasterize_all(mesh: Mesh, views: Sequence[LightView]) -> list[ShadowMap]:
    """Draw the shadow maps of a mesh on the CPU."""
    return [rasterize_shadow_map(view, mesh) for view in views]


def prepare_scene(
    scene: Scene, progress: Progress = silent, rasterize: Rasterize = rasterize_all
) -> PreparedScene:
    """Compute all data of a scene that does not depend on the camera.

    Parameters
    ----------
    scene
        The scene.
    progress
        Called with the name of the work and the fraction that is done.
    rasterize
        Function that draws the shadow maps.
    """
    material, environment = scene.material, scene.environment
    progress("tables", 0.0)
    skin = Skin.of(material.profile, material.params, luts=())
    progress("shadow maps", 0.0)
    views = [LightView.of(light, scene.mesh) for light in scene.lights]
    shadow_maps = rasterize(scene.mesh, views)
    closer_filters: list[WideFilter] = []
    ambient, radiance_sh, preconvolved = None, None, None
    if environment is not None:
        width = skin.params.shadow_filter_width_mm
        kind = ShadowFilter.PERCENTAGE_CLOSER
        closer_filters = [build_filter(kind, shadow_map, width) for shadow_map in shadow_maps]
        radiance_sh = environment.radiance_sh()
        preconvolved = environment.preconvolved()
        ambient = gather_ambient_light(
            scene.mesh,
            radiance_sh,
            preconvolved,
            list(zip(scene.lights, closer_filters, strict=True)),
            skin,
            material.albedo.reshape(-1, 3).mean(axis=0),
            progress,
        )
    progress("vertex attributes", 0.0)
    vertices = build_vertex_table(scene.mesh, skin, ambient)
    progress("textures", 0.0)
    return PreparedScene(
        scene,
        skin,
        vertices,
        _textures(material),
        _uv_scale_mm(scene.mesh, material),
        shadow_maps,
        closer_filters,
        radiance_sh,
        preconvolved,
    )


def _textures(material: Material) -> dict[MaterialMap, Texture]:
    """Return the textures of a material; slopes of the normal map are scaled by its strength."""
    maps = {kind: getattr(material, kind.value) for kind in MaterialMap}
    images = {kind: image for kind, image in maps.items() if image is not None}
    if MaterialMap.NORMAL in images:
        strength = material.params.normal_strength
        images[MaterialMap.NORMAL] = scale_slopes(images[MaterialMap.NORMAL], strength)
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        return dict(zip(images, pool.map(build_texture, images.values()), strict=True))


def _uv_scale_mm(mesh: Mesh, material: Material) -> float:
    if material.normal is None or mesh.uvs is None:
        return 1.0
    return mesh_uv_scale(mesh.positions_mm, mesh.uvs, mesh.faces)
