"""Surface at each pixel, from interpolated attributes and fetched maps."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..._core.arrays import FloatArray, dot, unit_vectors
from ...params.choices import MaterialMap
from ...scene import Camera
from ...shading.normals import blur_level
from ...shading.pixel import Surface
from ...shading.skin import Skin
from ...shading.specular import gloss_of_relief
from ..prepare.attributes import VertexTable
from ..prepare.parts import PreparedPart
from ..prepare.rasterizer import Fragments

__all__ = ["pixel_surface"]


def pixel_surface(
    part: PreparedPart,
    vertices: VertexTable,
    skin: Skin,
    fragments: Fragments,
    columns: Mapping[str, FloatArray],
    camera: Camera,
    samples: int,
    fetches: int,
) -> Surface:
    """Return the surface at N fragments.

    Parameters
    ----------
    part
        Part of the body that the fragments belong to.
    vertices
        Vertex attributes.
    skin
        Material of the part, with the weights of the fetches.
    fragments
        Visible faces of the pixels.
    columns
        Interpolated vertex attributes.
    camera
        Camera of the view.
    samples
        Samples per pixel. The sides of a sample's footprint are those of the pixel, divided by the square
        root of this number.
    fetches
        Fetches of the normal map, 2 or 3.
    """
    footprint = _Footprint(part, vertices, fragments, columns["uv"], samples)
    params, count = skin.params, fragments.pixel.size
    # Interpolation between vertices shortens normals; this shortening is not relief.
    length = np.maximum(np.sqrt(dot(columns["normal"], columns["normal"])), 1e-3)
    normal = unit_vectors(columns["normal"])
    gloss, reflectance = np.full(count, params.gloss), np.full(count, params.reflectance)
    if MaterialMap.SPECULAR in part.textures:
        factor, gloss = footprint.fetch(MaterialMap.SPECULAR).T
        reflectance = params.reflectance * factor
    if part.textures[MaterialMap.ALBEDO].size > 1:
        colour = footprint.fetch(MaterialMap.ALBEDO)[:, :3]
    else:
        albedo = part.material.albedo.reshape(1, 3).astype(np.float64)
        colour = np.broadcast_to(albedo, (count, 3))
    tint: FloatArray = np.broadcast_to(1.0, (count, 3))
    if MaterialMap.DEEP_SCATTER in part.textures:
        tint = footprint.fetch(MaterialMap.DEEP_SCATTER)
    fetched = _fetched_normals(part, skin, footprint, columns["tangent"], normal, fetches)
    return Surface(
        view=unit_vectors(camera.position_mm - columns["position"]),
        mesh_normal=normal,
        fetched=fetched,
        curvature_per_mm=columns["curvature"][:, 0],
        albedo=colour,
        gloss=gloss_of_relief(gloss, np.sqrt(dot(fetched[:, 0], fetched[:, 0]))),
        reflectance=reflectance,
        tint=tint,
        tensor_world=columns["tensor"],
        diffused_normals=columns["diffused_normals"].reshape(-1, 3, 3) / length[:, None, None],
        diffused_curvature_per_mm=columns["diffused_curvature"],
        mesh_relief=columns["mesh_relief"],
    )


class _Footprint:
    """Texture coordinates of pixels and their change from one pixel to the next."""

    def __init__(
        self,
        part: PreparedPart,
        vertices: VertexTable,
        fragments: Fragments,
        uv: FloatArray,
        samples: int,
    ) -> None:
        self._textures, self.uv = part.textures, uv
        spread = 1.0 / np.sqrt(samples)
        self._along_x, self._along_y = (
            spread * vertices.mixed("uv", fragments.face, along)
            for along in (fragments.along_x, fragments.along_y)
        )

    def level(self, kind: MaterialMap) -> FloatArray:
        """Return the mip level (N,) of a map for the footprint."""
        return self._textures[kind].level(self._along_x, self._along_y)

    def fetch(self, kind: MaterialMap, level: FloatArray | None = None) -> FloatArray:
        """Return the values (N, C) of a map at a `level`, or at the level of the footprint."""
        level = self.level(kind) if level is None else level
        return self._textures[kind].sample(self.uv, level)


def _fetched_normals(
    part: PreparedPart,
    skin: Skin,
    footprint: _Footprint,
    vertex_tangent: FloatArray,
    normal: FloatArray,
    fetches: int,
) -> FloatArray:
    """Return the normals of the sharp and the blurred maps in world axes, (N, fetches, 3), sharp first."""
    sigmas = skin.blend(fetches).sigmas_mm
    if MaterialMap.NORMAL not in part.textures:
        return np.repeat(normal[:, None], sigmas.size + 1, axis=1)
    tangent = vertex_tangent[:, :3]
    tangent = unit_vectors(tangent - normal * dot(tangent, normal)[:, None])
    bitangent = np.cross(normal, tangent) * np.sign(vertex_tangent[:, 3:])
    sharp_level = footprint.level(MaterialMap.NORMAL)
    size = part.textures[MaterialMap.NORMAL].size
    levels = [sharp_level]
    levels += [blur_level(s, part.uv_scale_mm, size, sharp_level) for s in sigmas]
    fetched = []
    for level in levels:
        t = footprint.fetch(MaterialMap.NORMAL, level)
        fetched.append(tangent * t[:, :1] + bitangent * t[:, 1:2] + normal * t[:, 2:])
    return np.stack(fetched, axis=1)
