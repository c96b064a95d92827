"""Colour, relief, gloss and deep tint of the built-in head, made up at run time.

Nothing is read from a picture.  Patterns are functions of the position on the skin, so that they
cross the seams of the texture unbroken; only hairs are drawn in the texture itself.

Tangent frame: T is the unit vector along ∂P/∂u, B = N × T, the direction of decreasing v (glTF's v
runs down), so that +Y of the normal map points up in the picture.  No chart of the built-in head is
mirrored: the frame is right-handed (glTF's tangent ``w`` is +1) everywhere.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .._core.errors import ArgumentError
from .head_hairs import eyebrows, lashes
from .head_noise import cellular_volume, sample_cells, sample_smooth, smooth_volume
from .head_texels import (
    TexelFrame,
    Texels,
    each_band,
    fill,
    rasterise,
    spread,
    texel_frame,
)

Float32 = NDArray[np.float32]

_EDGE_TEXELS = 14
_CELL_SAMPLES = 64
_CELLS_ACROSS = 6

# Where the shaved hair begins: depths z and the heights y of the hairline there, millimetres.
_HAIRLINE_MM = ((-100, -65, -38, -14, 14, 24, 48, 64, 80), (-52, -48, -28, 24, 14, 24, 50, 68, 76))

# Log-space steps: what one unit of blood, of melanin, of yellow fat under thin blood does.
_SKIN = np.array([0.505, 0.302, 0.219], dtype=np.float32)
_LIP = np.array([0.43, 0.175, 0.150], dtype=np.float32)
_HAIR = np.array([0.030, 0.019, 0.012], dtype=np.float32)
_BLOOD = np.array([-0.06, -0.46, -0.40], dtype=np.float32)
_MELANIN = np.array([-0.45, -0.72, -0.95], dtype=np.float32)
_YELLOW = np.array([0.01, 0.02, -0.16], dtype=np.float32)
_BLUE = np.array([-0.17, -0.14, -0.03], dtype=np.float32)


@dataclass(frozen=True)
class HeadMaps:
    """Textures of the built-in head, ``(H, W, ...)``, the top row first; those without detail at half size.

    Attributes
    ----------
    albedo
        ``(H, W, 3)`` diffuse reflectance, linear Rec.709, 0..1.
    normal
        ``(H, W, 3)`` unit normals in the tangent frame of this module, -1..1, slopes true to the
        skin's relief in millimetres.
    specular
        ``(H/2, W/2, 2)`` reflectance at normal incidence over that of plain skin (0.028), and gloss
        0..1, whose Blinn-Phong power is ``2**(13 * gloss)``.
    deep_scatter
        ``(H/2, W/2, 3)`` tint of the light that comes through, linear Rec.709, 0..1.
    """

    albedo: Float32
    normal: Float32
    specular: Float32
    deep_scatter: Float32


@dataclass(frozen=True)
class _Skin:
    """Where the texels are and what they are: positions, normals, weights, and places by name."""

    p: Float32
    n: Float32
    lips: Float32
    brow: Float32
    thin: Float32
    red: Float32
    front: Float32


def _ramp(value: Float32, low: float, high: float) -> Float32:
    t = np.clip((value - np.float32(low)) * np.float32(1.0 / (high - low)), 0.0, 1.0)
    return np.asarray(t * t * (3.0 - 2.0 * t), dtype=np.float32)


def _spot(
    p: Float32,
    centre_mm: tuple[float, float, float],
    size_mm: tuple[float, float, float],
    *,
    both: bool = True,
) -> Float32:
    """Gaussian around a place, by default mirrored to the other half of the head."""
    x = np.abs(p[:, 0]) if both else p[:, 0]
    d = ((x - centre_mm[0]) / size_mm[0]) ** 2
    d += ((p[:, 1] - centre_mm[1]) / size_mm[1]) ** 2
    d += ((p[:, 2] - centre_mm[2]) / size_mm[2]) ** 2
    return np.asarray(np.exp(-0.5 * d), dtype=np.float32)


def _widen(texels: Texels, rings: int) -> tuple[Texels, NDArray[np.int32], NDArray[np.int32]]:
    """Add the empty texels around the charts, each bound to its nearest texel inside.

    Also gives the steps ``(M,)`` to the right and upwards from there to every added texel.
    """
    covered = np.zeros(texels.size**2, dtype=bool)
    covered[texels.index] = True
    target, source = spread(covered.reshape(texels.size, texels.size), rings)
    slot = np.zeros(texels.size**2, dtype=np.int32)
    slot[texels.index] = np.arange(len(texels.index), dtype=np.int32)
    of = slot[source]
    wide = Texels(
        texels.size,
        np.concatenate([texels.index, target]),
        np.concatenate([texels.face, texels.face[of]]),
        np.concatenate([texels.weight, texels.weight[of]]),
    )
    right = target % texels.size - source % texels.size
    return wide, right, source // texels.size - target // texels.size


def _skin(
    inner: Texels,
    rings: int,
    points: Float32,
    normals: Float32,
    regions: Float32,
    faces: NDArray[np.int32],
    frame: TexelFrame,
) -> tuple[_Skin, Texels]:
    """Places and weights at the texels, carried on straight past the charts' borders."""
    wide, right, up = _widen(inner, rings)
    stacked = wide.interpolate(np.concatenate([points, normals, regions], axis=1), faces)
    p = np.ascontiguousarray(stacked[:, :3])
    steps = frame.steps_mm[wide.face[len(inner.index) :]]
    p[len(inner.index) :] += right[:, None] * steps[:, 0] + up[:, None] * steps[:, 1]
    w = stacked[:, 6:]
    front = _ramp(p[:, 2], 5.0, 60.0)
    return _Skin(p, stacked[:, 3:6], w[:, 0], w[:, 1], w[:, 2], w[:, 3], front), wide


def _colours(s: _Skin, rng: np.random.Generator, noise: Float32) -> tuple[Float32, Float32]:
    """Albedo without hairs and deep tint, ``(N, 3)`` each."""
    p = s.p
    coarse = sample_smooth(noise, p + 31.0, 26.0)
    medium = sample_smooth(noise, p - 57.0, 8.0)
    fine = sample_smooth(noise, p + 11.0, 2.6)
    finest = sample_smooth(noise, p + 77.0, 1.0)
    forehead = _ramp(p[:, 1], 22.0, 42.0) * s.front
    hairline = np.interp(p[:, 2], *_HAIRLINE_MM).astype(np.float32)
    scalp = _ramp(p[:, 1] - hairline + 2.5 * medium + 3.0 * coarse, -5.0, 9.0)
    under_eye = _spot(p, (29, -11, 74), (11, 4.5, 9))
    lid = _spot(p, (31, 3, 77), (12, 7, 8))
    neck = _ramp(p[:, 1], -108.0, -135.0)
    beard = _ramp(p[:, 1], -44.0, -60.0) * _ramp(p[:, 1], -128.0, -104.0)
    beard *= _ramp(p[:, 2], 5.0, 30.0)
    beard *= 1.0 - 0.75 * _spot(p, (30, -52, 80), (11, 13, 20))
    beard *= 1.0 - s.lips

    blood = 0.80 * s.red - 0.10 + 0.06 * coarse + 0.07 * medium * (0.7 + s.red) + 0.055 * fine
    blood += 0.22 * lid + 0.22 * under_eye - 0.10 * forehead - 0.10 * scalp + 0.05 * neck
    melanin = 0.030 * coarse + 0.025 * medium + 0.030 * fine + 0.018 * finest
    melanin += 0.16 * s.brow + 0.04 * forehead + 0.03 * scalp + 0.02 * neck + 0.06 * under_eye
    # freckles: the peaks of a fine noise, where a coarse one lets them
    freckles = _ramp(fine + 0.35 * finest, 2.05, 2.6) * _ramp(coarse + 1.6 * s.red, 0.1, 1.5)
    melanin += 0.22 * freckles * (1.0 - s.lips)
    plain = np.flatnonzero((np.abs(p[:, 0]) < 64.0) & (s.lips < 0.1) & (s.thin < 0.3))
    for _ in range(11):
        place = p[plain[int(rng.integers(len(plain)))]]
        radius = float(rng.uniform(0.5, 1.35))
        gap = np.sqrt(np.sum((p - place) ** 2, axis=1)) + 0.15 * finest
        melanin += float(rng.uniform(0.5, 0.95)) * _ramp(gap, radius * 1.35, radius * 0.6)
    yellow = 0.28 * forehead + 0.15 * scalp + 0.15 * neck + 0.30 * under_eye + 0.08 * coarse
    stubble = 0.8 + 0.14 * fine + 0.12 * finest
    blue = 0.50 * under_eye + 0.55 * beard * stubble + 0.55 * scalp * stubble
    blue += 0.35 * _spot(p, (15, 4, 78), (4.0, 8, 7))
    log = blood[:, None] * _BLOOD + melanin[:, None] * _MELANIN
    log += yellow[:, None] * _YELLOW + blue[:, None] * _BLUE
    albedo = _SKIN * np.exp(log)
    lip = _LIP * np.exp(0.10 * medium + 0.10 * fine + 0.05 * finest)[:, None]
    soft = np.clip(_ramp(s.lips, 0.12, 0.85) * (0.80 + 0.05 * fine), 0.0, 0.92)[:, None]
    albedo += soft * (lip - albedo)

    vein_field = np.abs(sample_smooth(noise, p * np.float32(1.0) + 203.0, 17.0) + 0.30 * medium)
    veins = _ramp(vein_field, 0.11, 0.02) * (0.25 + 0.75 * s.thin)
    deep = np.empty_like(albedo)
    warm = np.array([0.94, 0.27, 0.13], dtype=np.float32)
    cartilage = np.array([0.98, 0.42, 0.24], dtype=np.float32)
    deep[:] = warm
    deep += (0.75 * s.thin)[:, None] * (cartilage - warm)
    deep *= np.exp(-veins[:, None] * np.array([0.43, 0.93, 0.73], dtype=np.float32))
    deep *= np.exp(0.06 * medium + 0.05 * fine)[:, None]
    np.clip(albedo, 0.0, 1.0, out=albedo)
    np.clip(deep, 0.0, 1.0, out=deep)
    return albedo.astype(np.float32), deep.astype(np.float32)


def _gloss(s: _Skin, noise: Float32) -> Float32:
    """Reflectance scale and gloss, ``(N, 2)``: an oily T-zone, moist lips, dry ears and neck."""
    p = s.p
    medium = sample_smooth(noise, p + 143.0, 9.0)
    fine = sample_smooth(noise, p - 91.0, 2.0)
    oil = 0.85 * _spot(p, (0, -30, 106), (13, 26, 18)) + 0.6 * _spot(p, (0, 45, 93), (30, 24, 18))
    oil = oil + 0.35 * _spot(p, (0, -101, 93), (14, 9, 12))
    oil = oil + 0.3 * _spot(p, (44, -20, 68), (12, 9, 16))
    oil = np.minimum(oil + 0.35 * _spot(p, (31, 2, 78), (12, 8, 8)), 1.0)
    dry = np.maximum(_ramp(p[:, 1], -104.0, -130.0), 0.8 * _ramp(np.abs(p[:, 0]), 68.0, 78.0))
    scale = 1.0 + 0.28 * oil - 0.25 * dry + 0.06 * medium + 0.05 * fine
    gloss = 0.35 + 0.075 * oil - 0.05 * dry + 0.014 * medium + 0.010 * fine
    wet = _ramp(s.lips, 0.3, 0.9)
    scale += wet * (1.35 + 0.08 * fine - scale)
    gloss += wet * (0.46 + 0.015 * fine - gloss)
    both = np.stack([np.clip(scale, 0.3, 2.0), np.clip(gloss, 0.05, 0.95)], axis=1)
    return np.asarray(both, dtype=np.float32)


def _strengths(s: _Skin, noise: Float32) -> tuple[Float32, Float32]:
    """Depths of pores and furrows ``(N, 2)`` and the broad relief ``(N,)``, millimetres."""
    p = s.p
    coarse = sample_smooth(noise, p + 7.0, 14.0)
    lump = sample_smooth(noise, p - 23.0, 4.5)
    skin = 1.0 - _ramp(s.lips, 0.2, 0.7)
    nose = _spot(p, (0, -36, 104), (18, 14, 16))
    cheek = _spot(p, (30, -28, 76), (17, 20, 20))
    lids = _spot(p, (31, 1, 77), (13, 9, 9))
    ears = _ramp(np.abs(p[:, 0]), 66.0, 76.0) * _ramp(p[:, 1], -60.0, -40.0)
    pores = 0.022 + 0.036 * nose + 0.030 * cheek + 0.012 * _spot(p, (0, 45, 92), (32, 22, 20))
    pores = pores * (1.0 + 0.22 * coarse) * skin * (1.0 - 0.8 * lids) * (1.0 - 0.6 * ears)
    pores *= 0.35 + 0.65 * s.front
    furrows = (0.017 + 0.006 * lids) * (1.0 - 0.5 * nose) * skin * (1.0 - 0.5 * ears)
    broad = 0.030 * lump * (0.5 + 0.5 * s.front) * (1.0 - 0.5 * lids)
    # lines of the forehead: three shallow waves that wander and come and go
    y = p[:, 1] + 1.7 * coarse + 0.0035 * p[:, 0] ** 2
    there = _ramp(p[:, 2], 60.0, 84.0) * _ramp(coarse + lump * 0.3, -1.2, 0.8)
    for height, depth in ((42.0, 0.085), (52.5, 0.10), (63.0, 0.06)):
        broad -= depth * there * np.exp(-0.5 * ((y - height) / 0.75) ** 2)
    # folds of the lower lids and beside the eyes
    under = p[:, 1] + 0.5 * coarse + 12.0 - 0.012 * (np.abs(p[:, 0]) - 28.0) ** 2
    folds = 0.05 * _spot(p, (30, -10, 75), (10, 5, 9))
    for height in (0.0, 2.6):
        broad -= folds * np.exp(-0.5 * ((under - height) / 0.5) ** 2)
    return np.stack([pores, furrows], axis=1).astype(np.float32), broad.astype(np.float32)


def _cells(rng: np.random.Generator) -> tuple[Float32, Float32]:
    """Profiles 0..1 of pores and of the furrows between cells, as flat periodic volumes."""
    first, gap = cellular_volume(rng, _CELL_SAMPLES, _CELLS_ACROSS)
    pit = np.clip(1.0 - first * np.float32(1.0 / 0.52), 0.0, None)
    pit = pit * pit * (4.5 - 3.0 * pit)
    furrow = np.exp(-((gap * np.float32(1.0 / 0.13)) ** 2))
    return pit.astype(np.float32), furrow.astype(np.float32)


def _relief_mm(ground: Float32, cells: tuple[Float32, Float32], noise: Float32) -> Float32:
    """Height of the skin ``(N,)``: the broad relief with pores, furrows and creases of the lips.

    Columns of ``ground`` ``(N, 7)``: position in millimetres (3), depths of pores and furrows as
    from :func:`_strengths`, the broad relief, the weight of the lips.
    """
    p = ground[:, :3]
    height = ground[:, 5].copy()
    small = sample_cells(p, 0.82, _CELL_SAMPLES, _CELLS_ACROSS)
    height -= ground[:, 3] * cells[0].take(small)
    net = sample_cells(p[:, [2, 0, 1]], 1.05, _CELL_SAMPLES, _CELLS_ACROSS)
    height -= ground[:, 4] * cells[1].take(net)
    on = np.flatnonzero(ground[:, 6] > 0.25)
    lip = _ramp(ground[on, 6], 0.2, 0.7)
    stretched = p[on] * np.array([1.0, 0.16, 0.10], dtype=np.float32)
    crease = sample_smooth(noise, stretched, 1.25)
    crease += 0.6 * sample_smooth(noise, stretched + 9.0, 0.75)
    height[on] -= np.float32(0.055) * lip * np.maximum(np.abs(crease) * -0.9 + 0.8, 0.0)
    return height


def _normals(height_mm: Float32, index: NDArray[np.int64], shape: Float32) -> Float32:
    """Tangent-space unit normals ``(N, 3)`` at the texels ``index`` of a height field ``(H, W)``.

    ``shape`` ``(N, 3)``: a texel's ``right_mm``, ``shear_mm`` and ``up_mm``.
    """
    size = height_mm.shape[0]
    flat = height_mm.ravel()
    last = flat.size - 1
    right = flat.take(np.minimum(index + 1, last)) - flat.take(np.maximum(index - 1, 0))
    up = flat.take(np.maximum(index - size, 0)) - flat.take(np.minimum(index + size, last))
    along = 0.5 * right / shape[:, 0]
    across = (0.5 * up - shape[:, 1] * along) / shape[:, 2]
    scale = 1.0 / np.sqrt(1.0 + along * along + across * across)
    return np.stack([-along * scale, -across * scale, scale], axis=1).astype(np.float32)


def head_maps(
    positions_mm: NDArray[np.floating],
    normals: NDArray[np.floating],
    uvs: NDArray[np.floating],
    faces: NDArray[np.integer],
    regions: NDArray[np.floating] | NDArray[np.integer],
    *,
    size: int = 2048,
    seed: int = 0,
) -> HeadMaps:
    """Make the textures of the built-in head.

    Parameters
    ----------
    positions_mm, normals
        Vertices ``(V, 3)`` in millimetres, in the built-in head's coordinates, and unit normals.
    uvs
        Texture coordinates ``(V, 2)``, 0..1, v down.
    faces
        Triangles ``(F, 3)``.
    regions
        Weights ``(V, 4)``: lips, brow, thin cartilage, redness; floats in 0..1, or the integers in
        0..255 that the file stores.
    size
        Texels along a side, even.
    seed
        Not negative. Another gives other freckles, pores and hairs; the same one the same bytes.

    Returns
    -------
    HeadMaps
        Values run on 14 texels past the charts' borders, and are neutral beyond.
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
    if np.issubdtype(np.asarray(regions).dtype, np.integer):
        weights = weights * np.float32(1.0 / 255.0)
    noise = smooth_volume(rng)
    half = size // 2
    frame = texel_frame(points, coordinates, triangles, half)
    inner = rasterise(coordinates, triangles, half)
    rings = (_EDGE_TEXELS + 3) // 2 + 1
    skin, wide = _skin(inner, rings, points, directions, weights, triangles, frame)

    with ThreadPoolExecutor(1) as beside:  # what needs no random numbers
        gloss = beside.submit(_gloss, skin, noise)
        strengths = beside.submit(_strengths, skin, noise)
        colour, deep = _colours(skin, rng, noise)
    depths, broad = strengths.result()
    shape = np.stack([frame.right_mm, frame.shear_mm, frame.up_mm], axis=1)[wide.face] * 0.5
    ground = np.concatenate([skin.p, depths, broad[:, None], skin.lips[:, None]], axis=1)
    covered = np.zeros((half, half), dtype=bool)
    covered.ravel()[wide.index] = True
    covered = covered.repeat(2, axis=0).repeat(2, axis=1)
    cells = _cells(rng)
    height = np.zeros((size, size), dtype=np.float32)

    def carve(rows: slice, band: Float32) -> None:
        here = covered[rows]
        height[rows][here] = _relief_mm(band[here], cells, noise)

    each_band(fill(ground, wide), carve)

    hairs = np.zeros((size, size), dtype=np.float32)
    owner = np.full((half, half), -1, dtype=np.int32)
    owner.ravel()[inner.index] = inner.face
    count = len(inner.index)
    eyebrows(hairs, inner.index, skin.p[:count], skin.brow[:count], owner, frame, rng)
    lashes(hairs, inner.index, skin.p[:count], owner, frame, rng)
    height += np.float32(0.03) * hairs

    normal = np.zeros((size, size, 3), dtype=np.float32)
    normal[:, :, 2] = 1.0

    def tilt(rows: slice, band: Float32) -> None:
        here = covered[rows]
        index = np.flatnonzero(here) + rows.start * size
        normal[rows][here] = _normals(height, index, band[here])

    each_band(fill(shape, wide), tilt)
    albedo = np.empty((size, size, 3), dtype=np.float32)

    def dye(rows: slice, band: Float32) -> None:
        albedo[rows] = band
        hairy = hairs[rows] > 0.0
        albedo[rows][hairy] += hairs[rows][hairy][:, None] * (_HAIR - band[hairy])

    each_band(fill(colour, wide), dye)
    return HeadMaps(
        albedo=albedo,
        normal=normal,
        specular=fill(gloss.result(), wide),
        deep_scatter=fill(deep, wide),
    )
