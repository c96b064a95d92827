"""Scene data that does not depend on the camera."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from ..._core.arrays import FloatArray
from ..._core.harmonics import MOST_ORDER
from ..._core.limits import limits
from ..._core.progress import Progress, silent
from ...mesh import Mesh
from ...params.choices import AmbientForm, ShadowFilter
from ...scene import Environment, Light, Scene, split_sun
from ...shading.image_light import PreconvolvedRadiance
from ...shading.skin import Skin
from .ambient_light import gather_ambient_light
from .attributes import VertexTable, build_vertex_table
from .light_view import LightView
from .parts import PreparedPart, arrange_parts, casting_faces, vertex_albedo, with_textures
from .shadow_filter import WideFilter, build_filter
from .shadow_map import ShadowMap, rasterize_shadow_map

__all__ = ["PreparedScene", "Rasterize", "prepare_scene"]

Rasterize = Callable[[Mesh, Sequence[Light]], Sequence[ShadowMap]]
"""Function that draws the shadow maps of a mesh, one for each light."""


@dataclass(frozen=True)
class PreparedScene:
    """Scene data that all pictures of a scene share and that never changes.

    Attributes
    ----------
    scene
        The scene.
    lights
        Lights that are drawn: those of the scene, then the sun of the environment if it is extracted.
    environment
        Environment that lights the body, without an extracted sun; the background shows `scene.environment`.
    parts
        Parts of the body, in the order of the faces in `vertices`; the first is skin.
    vertices
        Vertex attributes.
    shadow_maps
        Shadow map of each of the `lights`.
    closer_filters
        Percentage-closer filter of each of the `lights`; empty without an environment.
    radiance_sh
        (9, 3) spherical harmonics of `environment`; None without an environment.
    preconvolved
        Preconvolved reflections of `environment`; None without an environment.
    """

    scene: Scene
    lights: Sequence[Light]
    environment: Environment | None
    parts: Sequence[PreparedPart]
    vertices: VertexTable
    shadow_maps: Sequence[ShadowMap]
    closer_filters: Sequence[WideFilter]
    radiance_sh: FloatArray | None
    preconvolved: PreconvolvedRadiance | None


def rasterize_all(mesh: Mesh, lights: Sequence[Light]) -> list[ShadowMap]:
    """Draw the shadow maps of a mesh on the CPU, one for each light."""
    return [rasterize_shadow_map(LightView.of(light, mesh), mesh) for light in lights]


def prepare_scene(
    scene: Scene,
    progress: Progress = silent,
    rasterize: Rasterize = rasterize_all,
    form: AmbientForm = AmbientForm.STATIC,
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
    form
        Form of the ambient light at the vertices.
    """
    material = scene.material
    lights, environment = _lights_and_environment(scene)
    progress("tables", 0.0)
    skin = Skin.of(material.profile, material.params, luts=())
    progress("shadow maps", 0.0)
    parts, faces = arrange_parts(scene, skin)
    casting = replace(scene.mesh, faces=casting_faces(parts, faces), materials=None)
    shadow_maps = rasterize(casting, lights)
    progress("textures", 0.0)
    parts = with_textures(scene.mesh, parts, faces)
    closer_filters: list[WideFilter] = []
    ambient, radiance_sh, preconvolved = None, None, None
    if environment is not None:
        width = skin.params.shadow_filter_width_mm
        kind = ShadowFilter.PERCENTAGE_CLOSER
        closer_filters = [build_filter(kind, shadow_map, width) for shadow_map in shadow_maps]
        bands = environment.radiance_sh(MOST_ORDER)
        radiance_sh = bands[:9]
        preconvolved = environment.preconvolved()
        ambient = gather_ambient_light(
            casting,
            environment,
            bands,
            list(zip(lights, closer_filters, strict=True)),
            skin,
            vertex_albedo(scene.mesh, parts, faces),
            form,
            progress,
        )
    progress("vertex attributes", 0.0)
    skin_faces = sum(part.face_count for part in parts if part.is_skin)
    vertices = build_vertex_table(scene.mesh, skin, ambient, faces, skin_faces)
    return PreparedScene(
        scene,
        lights,
        environment,
        parts,
        vertices,
        shadow_maps,
        closer_filters,
        radiance_sh,
        preconvolved,
    )


def _lights_and_environment(scene: Scene) -> tuple[tuple[Light, ...], Environment | None]:
    """Return the lights that are drawn, and the environment that lights the body beside them.

    The sun stays in an environment that does not extract it, and where the scene already has as many lights
    as the limit ``lights`` allows.
    """
    environment = scene.environment
    if environment is None or not environment.extract_sun:
        return scene.lights, environment
    if len(scene.lights) >= limits().lights:
        return scene.lights, environment
    sun, sky = split_sun(environment)
    return scene.lights if sun is None else (*scene.lights, sun), sky
