"""Texture maps of the built-in head, generated at run time.

Patterns are functions of the position on the skin, so that they continue across the seams of the texture.
Only hairs are drawn in the texture itself.

The tangent frame has T along ∂P/∂u and B = N × T. B is the direction of decreasing v (v of glTF increases
downwards), so that +Y of the normal map points up in the image. No chart of the built-in head is mirrored:
the frame is right-handed everywhere (w of glTF's tangent is +1).
"""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..._core.errors import ArgumentError
from .albedo import HAIR, scattered_moles, skin_colours
from .gloss import skin_gloss
from .hair import eyebrows, lashes
from .noise import smooth_volume
from .regions import SkinTexels, skin_texels
from .relief import height_normals, relief_mm, relief_strengths, skin_cells
from .texels import Float32, fill, map_bands, rasterise, texel_frame

__all__ = ["HeadMaps", "head_maps"]

EDGE_TEXELS = 14
"""Width of the band around the charts to which maps are continued, texels."""


@dataclass(frozen=True)
class HeadMaps:
    """Texture maps of the built-in head, (H, W, ...), top row first.

    Attributes
    ----------
    albedo
        (H, W, 3) diffuse reflectance, linear Rec.709, 0..1.
    normal
        (H, W, 3) unit normals in tangent space, −1..1, with the slopes of the skin's relief.
    specular
        (H/2, W/2, 2) ratio of the reflectance at normal incidence to that of plain skin (0.028), and gloss
        0..1. The Blinn-Phong power is ``2**(13 * gloss)``.
    deep_scatter
        (H/2, W/2, 3) tint of light that passes through the body, linear Rec.709, 0..1.
    """

    albedo: Float32
    normal: Float32
    specular: Float32
    deep_scatter: Float32


def head_maps(
    positions_mm: NDArray[np.floating],
    normals: NDArray[np.floating],
    uvs: NDArray[np.floating],
    faces: NDArray[np.integer],
    regions: NDArray[np.floating],
    *,
    size: int = 2048,
    seed: int = 0,
) -> HeadMaps:
    """Generate the texture maps of the built-in head.

    Parameters
    ----------
    positions_mm, normals
        (V, 3) vertices in mm, in the built-in head's coordinates, and unit normals.
    uvs
        (V, 2) texture coordinates, 0..1, v down.
    faces
        (F, 3) triangles.
    regions
        (V, 4) weights 0..1: lips, brow, thin cartilage, redness.
    size
        Texels along a side, even, 16 or more.
    seed
        Seed of freckles, pores and hairs, ≥ 0; the same seed gives the same bytes.

    Returns
    -------
    HeadMaps
        Maps are continued 14 texels past the borders of the charts. Beyond them they are constant.

    Raises
    ------
    ArgumentError
        If size or seed is out of range.
    """
    if size < 16 or size % 2:
        raise ArgumentError(f"size is {size}; it must be even and at least 16")
    if not isinstance(seed, (int, np.integer)) or seed < 0:
        raise ArgumentError(f"seed is {seed!r}; it must be a whole number, 0 or more")
    rng = np.random.default_rng(seed)
    triangles = np.ascontiguousarray(faces, dtype=np.int32)
    points = np.asarray(positions_mm, dtype=np.float32)
    coordinates = np.asarray(uvs, dtype=np.float32)
    directions = np.asarray(normals, dtype=np.float32)
    weights = np.asarray(regions, dtype=np.float32)
    noise = smooth_volume(rng)
    half = size // 2
    frame = texel_frame(points, coordinates, triangles, half)
    inner = rasterise(coordinates, triangles, half)
    rings = (EDGE_TEXELS + 3) // 2 + 1
    skin, wide = skin_texels(inner, rings, points, directions, weights, triangles, frame)

    moles = scattered_moles(skin, rng)

    def layers(part: SkinTexels) -> tuple[Float32, ...]:
        colours, strengths = skin_colours(part, moles, noise), relief_strengths(part, noise)
        return *colours, *strengths, skin_gloss(part, noise)

    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        parts = list(pool.map(layers, skin.chunks()))
    colour, deep, depths, broad, gloss = (
        np.concatenate(arrays) for arrays in zip(*parts, strict=True)
    )
    shape = np.stack([frame.right_mm, frame.shear_mm, frame.up_mm], axis=1)[wide.face] * 0.5
    ground = np.concatenate([skin.p, depths, broad[:, None], skin.lips[:, None]], axis=1)
    covered = np.zeros((half, half), dtype=bool)
    covered.ravel()[wide.index] = True
    covered = covered.repeat(2, axis=0).repeat(2, axis=1)
    cells = skin_cells(rng)
    height = np.zeros((size, size), dtype=np.float32)

    def write_height(rows: slice, band: Float32) -> None:
        covered_band = covered[rows]
        height[rows][covered_band] = relief_mm(band[covered_band], cells, noise)

    map_bands(fill(ground, wide), write_height)

    hairs = np.zeros((size, size), dtype=np.float32)
    owner = np.full((half, half), -1, dtype=np.int32)
    owner.ravel()[inner.index] = inner.face
    count = len(inner.index)
    eyebrows(hairs, inner.index, skin.p[:count], skin.brow[:count], owner, frame, rng)
    lashes(hairs, inner.index, skin.p[:count], owner, frame, rng)
    height += np.float32(0.03) * hairs

    normal = np.zeros((size, size, 3), dtype=np.float32)
    normal[:, :, 2] = 1.0

    def write_normals(rows: slice, band: Float32) -> None:
        covered_band = covered[rows]
        index = np.flatnonzero(covered_band) + rows.start * size
        normal[rows][covered_band] = height_normals(height, index, band[covered_band])

    map_bands(fill(shape, wide), write_normals)
    albedo = np.empty((size, size, 3), dtype=np.float32)

    def write_albedo(rows: slice, band: Float32) -> None:
        albedo[rows] = band
        hairy = hairs[rows] > 0.0
        albedo[rows][hairy] += hairs[rows][hairy][:, None] * (HAIR - band[hairy])

    map_bands(fill(colour, wide), write_albedo)
    return HeadMaps(
        albedo=albedo,
        normal=normal,
        specular=fill(gloss, wide),
        deep_scatter=fill(deep, wide),
    )
