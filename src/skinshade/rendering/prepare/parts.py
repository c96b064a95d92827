"""Parts of a body in the order in which they are drawn, with their textures."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace

import numpy as np

from ..._core.arrays import FloatArray, ImageArray, IntArray
from ..._core.errors import MeshError
from ...mesh import Mesh, mesh_uv_scale
from ...params.choices import MaterialMap, Shading, SpecularModel
from ...scene import Material, Part, Scene
from ...scene.maps import scale_slopes
from ...shading.skin import Skin
from ..settings import RenderSettings
from .mips import Texture, build_texture

__all__ = [
    "PreparedPart",
    "arrange_parts",
    "casting_faces",
    "opaque_count",
    "vertex_albedo",
    "with_textures",
]

ALBEDO_TEXELS = 128
"""Texels along the albedo map that light which bounces sees: some millimetres each on a head."""


@dataclass(frozen=True)
class PreparedPart:
    """Faces with one material.

    Attributes
    ----------
    first_face, face_count
        Range of the faces in the vertex table.
    material
        Maps and parameters.
    skin
        Material without lookup tables. A backend adds the tables that its settings need.
    is_skin
        Whether light scatters in the part.
    opacity
        (H, W, 1) opacity of the texels of the albedo map; None for an opaque part.
    opacity_cutoff
        Opacity below which nothing is drawn; 0 for an opaque part.
    textures
        Mip-mapped textures of the maps that the material has. The fourth channel of the albedo is opacity.
    uv_scale_mm
        Length of one unit of UV on the surface, mm; 1 if the material has no normal map.
    """

    first_face: int
    face_count: int
    material: Material
    skin: Skin
    is_skin: bool = True
    opacity: ImageArray | None = None
    opacity_cutoff: float = 0.0
    textures: Mapping[MaterialMap, Texture] = field(default_factory=dict)
    uv_scale_mm: float = 1.0

    def settings(self, settings: RenderSettings) -> RenderSettings:
        """Return the settings for this part: parts that are not skin have no scattering."""
        return settings if self.is_skin else replace(settings, shading=Shading.LAMBERT)

    def luts(self, settings: RenderSettings) -> tuple[str, ...]:
        """Return the names of the lookup tables that this part reads under its own settings."""
        model = self.skin.specular_model(settings.shading)
        return settings.luts if model == SpecularModel.BLINN_PHONG else (*settings.luts, "coat")


def arrange_parts(scene: Scene, skin: Skin) -> tuple[list[PreparedPart], IntArray]:
    """Return the parts of a scene that have faces, and all faces in their order.

    Skin comes first, beginning with the material of the scene; parts with opacity come last.

    Parameters
    ----------
    scene
        The scene.
    skin
        Material of the scene, without lookup tables.
    """
    mesh = scene.mesh
    if not scene.parts or mesh.materials is None:
        return [PreparedPart(0, len(mesh.faces), scene.material, skin)], mesh.faces
    numbers = {part.number for part in scene.parts}
    own = np.flatnonzero(~np.isin(mesh.materials, sorted(numbers)))
    first = Part(-2, scene.material)
    groups = [(first, own)]
    groups += [(part, np.flatnonzero(mesh.materials == part.number)) for part in scene.parts]
    groups = [(part, faces) for part, faces in groups if faces.size]
    groups.sort(key=lambda group: (not group[0].is_skin, group[0].opacity is not None))
    parts: list[PreparedPart] = []
    start = 0
    for part, faces in groups:
        material = part.material
        own_skin = skin if part is first else Skin.of(material.profile, material.params, luts=())
        parts.append(
            PreparedPart(
                start,
                faces.size,
                material,
                own_skin,
                part.is_skin,
                part.opacity,
                0.0 if part.opacity is None else part.opacity_cutoff,
            )
        )
        start += faces.size
    return parts, mesh.faces[np.concatenate([faces for _, faces in groups])]


def opaque_count(parts: Sequence[PreparedPart]) -> int:
    """Return the number of faces of opaque parts, which come first."""
    return sum(part.face_count for part in parts if part.opacity is None)


def casting_faces(parts: Sequence[PreparedPart], faces: IntArray) -> IntArray:
    """Return the faces (F, 3) that cast shadows: those of opaque parts; all if no part is opaque."""
    opaque = opaque_count(parts)
    return faces[:opaque] if opaque else faces


def vertex_albedo(mesh: Mesh, parts: Sequence[PreparedPart], faces: IntArray) -> FloatArray:
    """Return the albedo (V, 3) at the vertices, averaged over texels of 1/128 of the map."""
    albedo = np.zeros((len(mesh.positions), 3))
    for part in parts:
        own = np.unique(faces[part.first_face : part.first_face + part.face_count])
        texture = part.textures[MaterialMap.ALBEDO]
        uv = np.zeros((own.size, 2)) if mesh.uvs is None else mesh.uvs[own]
        level = max(0.0, np.log2(texture.size / ALBEDO_TEXELS))
        albedo[own] = texture.sample(uv, np.full(own.size, level))[:, :3]
    return albedo


def with_textures(mesh: Mesh, parts: Sequence[PreparedPart], faces: IntArray) -> list[PreparedPart]:
    """Return the parts with textures and UV scales; slopes of normal maps are scaled by their strength."""
    images = [_images(part) for part in parts]
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        textures = [
            dict(zip(maps, pool.map(build_texture, maps.values()), strict=True)) for maps in images
        ]
    return [
        replace(part, textures=maps, uv_scale_mm=_uv_scale_mm(mesh, part, faces))
        for part, maps in zip(parts, textures, strict=True)
    ]


def _images(part: PreparedPart) -> dict[MaterialMap, ImageArray]:
    material = part.material
    maps = {kind: getattr(material, kind.value) for kind in MaterialMap}
    images = {kind: image for kind, image in maps.items() if image is not None}
    if MaterialMap.NORMAL in images:
        strength = material.params.normal_strength
        images[MaterialMap.NORMAL] = scale_slopes(images[MaterialMap.NORMAL], strength)
    if part.opacity is not None:
        albedo = images[MaterialMap.ALBEDO]
        images[MaterialMap.ALBEDO] = np.concatenate([albedo, part.opacity], axis=2)
    return images


def _uv_scale_mm(mesh: Mesh, part: PreparedPart, faces: IntArray) -> float:
    if part.material.normal is None or mesh.uvs is None:
        return 1.0
    own = faces[part.first_face : part.first_face + part.face_count]
    try:
        return mesh_uv_scale(mesh.positions_mm, mesh.uvs, own)
    except MeshError:
        if part.is_skin:
            raise
        return 1.0  # without scattering, no map is blurred by a length
