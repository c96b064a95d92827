"""Thumbnails of baked meshes: curvature, thickness and shading."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from PIL import Image

from .._core.arrays import FloatArray, bounding_sphere, unit_vectors
from .._core.files import atomic_write
from ..mesh.topology import face_normals
from ..params import SkinParams
from ..profile import Profile
from ..rendering.prepare.colours import curvature_colour
from ..rendering.prepare.rasterizer import rasterize
from ..rendering.settings import THICKNESS_RANGE_MM
from ..scene import Camera
from ..shading.direct import direct_scalar
from ..shading.skin import Skin
from ..shading.tonemap import filmic, srgb_from_linear
from .analysis import BakedMesh

__all__ = ["SIZE", "thumbnails", "write_thumbnails"]

SIZE = 192
"""Pixels along a side: three thumbnails fit side by side into a narrow window."""
PAPER = 0.97
"""Display value of the background."""
TO_LIGHT = np.array([-0.5, 0.55, 0.67])
ALBEDO = np.array([0.55, 0.36, 0.28])
AMBIENT = 0.12


def write_thumbnails(path: Path, meshes: Sequence[BakedMesh], profile: Profile) -> None:
    """Write the thumbnails of an asset as PNG.

    Parameters
    ----------
    path
        Output file; its name may hold bytes that are not UTF-8, which OpenImageIO refuses.
    meshes, profile
        As in `thumbnails`.

    Raises
    ------
    OutputError
        If the file cannot be written.
    """
    pixels = np.rint(np.clip(thumbnails(meshes, profile), 0.0, 1.0) * 255.0).astype(np.uint8)
    with atomic_write(path) as temporary:
        Image.fromarray(pixels).save(temporary, "PNG")


def thumbnails(meshes: Sequence[BakedMesh], profile: Profile) -> FloatArray:
    """Return a row of n images (192, 192·n, 3), display values: each attribute, then the shaded body.

    Parameters
    ----------
    meshes
        Meshes of one asset, drawn in their own axes.
    profile
        Profile of the skin.
    """
    attributes = meshes[0].analysis.attributes
    names = [name for name in ("curvature", "thickness") if name in attributes]
    points = np.concatenate([baked.mesh.positions_mm for baked in meshes])
    starts = np.cumsum([0] + [len(baked.mesh.positions) for baked in meshes[:-1]])
    faces = np.concatenate(
        [baked.mesh.faces + start for baked, start in zip(meshes, starts, strict=True)]
    )
    columns = {
        name: np.concatenate([baked.analysis.attributes[name][:, 0] for baked in meshes])
        for name in names
    }
    middle, radius = bounding_sphere(points)
    camera = Camera.orbit(
        middle, 6.0 * max(radius, 1e-9), yaw_deg=25.0, pitch_deg=8.0, vertical_fov_deg=20.0
    )
    matrix = camera.view_projection(1.0)
    fragments = rasterize(points @ matrix[:, :3].T + matrix[:, 3], faces, (SIZE, SIZE))
    corners = faces[fragments.face]
    values = {
        name: np.einsum("nk,nk->n", column[corners], fragments.barycentric)
        for name, column in columns.items()
    }
    normal = unit_vectors(face_normals(points, corners))
    images = [_colour(name, values[name]) for name in names]
    images.append(_shaded(normal, values["curvature"], profile))
    strip = np.full((SIZE * SIZE, len(images), 3), PAPER)
    for index, image in enumerate(images):
        strip[fragments.pixel, index] = image
    return strip.reshape(SIZE, SIZE, len(images), 3).swapaxes(1, 2).reshape(SIZE, -1, 3)


def _colour(name: str, values: FloatArray) -> FloatArray:
    if name == "curvature":
        return srgb_from_linear(curvature_colour(values))
    share = np.clip(values / THICKNESS_RANGE_MM, 0.0, 1.0)
    return np.repeat(share[:, None], 3, axis=1)


def _shaded(normal: FloatArray, curvature_per_mm: FloatArray, profile: Profile) -> FloatArray:
    sphere = Skin.of(profile, SkinParams(), luts=("sphere",), fetches=()).lut("sphere")
    light = np.broadcast_to(unit_vectors(TO_LIGHT), normal.shape)
    channel_normals = np.repeat(normal[:, None], 3, axis=1)
    gain = np.ones_like(normal)
    diffuse = direct_scalar(sphere, channel_normals, light, curvature_per_mm, gain)
    return filmic(ALBEDO * (diffuse + AMBIENT))
