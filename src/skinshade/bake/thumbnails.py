"""Small pictures of what was baked: curvature, thickness, and the body shaded."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, bounding_sphere, unit_vectors
from ..params import SkinParams
from ..profile import Profile
from ..render.cpu.debug import THICKNESS_RANGE_MM, curvature_colour
from ..render.cpu.raster import rasterize
from ..scene import Camera
from ..shading.direct import direct_scalar
from ..shading.skin import Skin
from ..shading.tonemap import filmic, srgb_from_linear
from .gltf_bake import BakedMesh

__all__ = ["thumbnails"]

SIZE = 192
PAPER = 0.97
"""Display value behind the body."""
TO_LIGHT = np.array([-0.5, 0.55, 0.67])
ALBEDO = np.array([0.55, 0.36, 0.28])
AMBIENT = 0.12


def thumbnails(meshes: list[BakedMesh], profile: Profile) -> FloatArray:
    """Return pictures side by side (192, 192·n, 3), display values: each attribute, then the light.

    Parameters
    ----------
    meshes
        Of one asset; those that have every attribute are drawn as they lie in their own axes.
    profile
        Of the skin.
    """
    names = [name for name in ("curvature", "thickness") if name in meshes[0].analysed.attributes]
    points = np.concatenate([each.body.positions_mm for each in meshes])
    starts = np.cumsum([0] + [len(each.body.positions_mm) for each in meshes])
    faces = np.concatenate(
        [each.body.faces + start for each, start in zip(meshes, starts[:-1], strict=True)]
    )
    columns = {
        name: np.concatenate([each.analysed.attributes[name][:, 0] for each in meshes])
        for name in names
    }
    middle, reach = bounding_sphere(points)
    camera = Camera.orbit(
        middle, 6.0 * max(reach, 1e-9), yaw_deg=25.0, pitch_deg=8.0, vertical_fov_deg=20.0
    )
    clip = (
        np.concatenate([points, np.ones((len(points), 1))], axis=1) @ camera.view_projection(1.0).T
    )
    seen = rasterize(clip, faces, (SIZE, SIZE))
    corners = faces[seen.face]

    def at(values: FloatArray) -> FloatArray:
        return np.einsum("nk,nk->n", values[corners], seen.barycentric)

    pictures = [_colour(name, at(columns[name])) for name in names]
    p = points[corners]
    normal = unit_vectors(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]))
    pictures.append(_shaded(normal, at(columns["curvature"]), profile))
    strip = np.full((SIZE * SIZE, len(pictures), 3), PAPER)
    for index, picture in enumerate(pictures):
        strip[seen.pixel, index] = picture
    tiled = strip.reshape(SIZE, SIZE, len(pictures), 3).swapaxes(1, 2)
    return tiled.reshape(SIZE, -1, 3)


def _colour(name: str, values: FloatArray) -> FloatArray:
    if name == "curvature":
        return srgb_from_linear(curvature_colour(values))
    share = np.clip(values / THICKNESS_RANGE_MM, 0.0, 1.0)
    return np.repeat(share[:, None], 3, axis=1)


def _shaded(normal: FloatArray, curvature_per_mm: FloatArray, profile: Profile) -> FloatArray:
    skin = Skin.of(profile, SkinParams())
    light = np.broadcast_to(unit_vectors(TO_LIGHT), normal.shape)
    each_channel = np.repeat(normal[:, None], 3, axis=1)
    gain = np.ones_like(normal)
    diffuse = direct_scalar(skin.sphere, each_channel, light, curvature_per_mm, gain)
    return filmic(ALBEDO * (diffuse + AMBIENT))
