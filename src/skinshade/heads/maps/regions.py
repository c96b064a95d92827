"""Skin of the built-in head at texels: positions, normals and weights of regions."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from .texels import Float32, Int32, TexelFrame, Texels, spread

__all__ = ["SkinTexels", "ramp", "skin_texels", "spot"]

CHUNK = 1 << 14
"""Texels that are coloured at once."""


@dataclass(frozen=True)
class SkinTexels:
    """Positions, normals and weights at N texels.

    Attributes
    ----------
    p, n
        (N, 3) positions in mm, in the head's coordinates, and unit normals.
    lips, brow, thin, red
        (N,) weights 0..1: lips, eyebrows, thin cartilage, redness.
    front
        (N,) weight 0..1 of the front of the face.
    """

    p: Float32
    n: Float32
    lips: Float32
    brow: Float32
    thin: Float32
    red: Float32
    front: Float32

    def chunks(self) -> list[SkinTexels]:
        """Return the texels in groups whose arrays fit in the cache of a core."""
        arrays = [getattr(self, field.name) for field in fields(self)]
        starts = range(0, len(self.p), CHUNK)
        return [SkinTexels(*(a[start : start + CHUNK] for a in arrays)) for start in starts]


def ramp(value: Float32, low: float, high: float) -> Float32:
    """Return the smoothstep of a value: 0 at `low`, 1 at `high`."""
    t = np.clip((value - np.float32(low)) * np.float32(1.0 / (high - low)), 0.0, 1.0)
    return np.asarray(t * t * (3.0 - 2.0 * t), dtype=np.float32)


def spot(
    p: Float32,
    centre_mm: tuple[float, float, float],
    size_mm: tuple[float, float, float],
    *,
    both: bool = True,
) -> Float32:
    """Return a Gaussian around a point; by default it is mirrored to the other half of the head."""
    x = np.abs(p[:, 0]) if both else p[:, 0]
    d = ((x - centre_mm[0]) / size_mm[0]) ** 2
    d += ((p[:, 1] - centre_mm[1]) / size_mm[1]) ** 2
    d += ((p[:, 2] - centre_mm[2]) / size_mm[2]) ** 2
    return np.asarray(np.exp(-0.5 * d), dtype=np.float32)


def _widen(texels: Texels, rings: int) -> tuple[Texels, Int32, Int32]:
    """Add empty texels around the charts, with the face and the weights of the nearest covered texel.

    Returns
    -------
    wide, right, up
        All texels, and for each added texel the number of texels (M,) to the right and upwards from the
        nearest covered texel.
    """
    covered = np.zeros(texels.size**2, dtype=bool)
    covered[texels.index] = True
    target, source = spread(covered.reshape(texels.size, texels.size), rings)
    slot = np.zeros(texels.size**2, dtype=np.int32)
    slot[texels.index] = np.arange(len(texels.index), dtype=np.int32)
    nearest = slot[source]
    wide = Texels(
        texels.size,
        np.concatenate([texels.index, target]),
        np.concatenate([texels.face, texels.face[nearest]]),
        np.concatenate([texels.weight, texels.weight[nearest]]),
    )
    right = target % texels.size - source % texels.size
    return wide, right, source // texels.size - target // texels.size


def skin_texels(
    inner: Texels,
    rings: int,
    points: Float32,
    normals: Float32,
    regions: Float32,
    faces: Int32,
    frame: TexelFrame,
) -> tuple[SkinTexels, Texels]:
    """Return the skin at the texels of the charts and around them; positions are extrapolated linearly.

    Parameters
    ----------
    inner
        Texels that the charts cover.
    rings
        Width of the band of texels that is added around the charts.
    points, normals, regions, faces
        Positions (V, 3) in mm, unit normals (V, 3), weights (V, 4) and triangles (F, 3) of the mesh.
    frame
        Shape of the texels on the skin.
    """
    wide, right, up = _widen(inner, rings)
    stacked = wide.interpolate(np.concatenate([points, normals, regions], axis=1), faces)
    p = np.ascontiguousarray(stacked[:, :3])
    steps = frame.steps_mm[wide.face[len(inner.index) :]]
    p[len(inner.index) :] += right[:, None] * steps[:, 0] + up[:, None] * steps[:, 1]
    w = stacked[:, 6:]
    front = ramp(p[:, 2], 5.0, 60.0)
    return SkinTexels(p, stacked[:, 3:6], w[:, 0], w[:, 1], w[:, 2], w[:, 3], front), wide
