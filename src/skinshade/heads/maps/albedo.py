"""Albedo and deep-scatter tint of the built-in head, from blood, melanin, fat and veins."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from .noise import sample_smooth
from .regions import SkinTexels, ramp, spot
from .texels import Float32

__all__ = ["HAIR", "Mole", "scattered_moles", "skin_colours"]

MOLES = 11
"""Number of moles on the face."""

HAIRLINE_MM = ((-100, -65, -38, -14, 14, 24, 48, 64, 80), (-52, -48, -28, 24, 14, 24, 50, 68, 76))
"""Depths z and heights y of points on the line at which the shaved hair begins, mm."""

SKIN = np.array([0.505, 0.302, 0.219], dtype=np.float32)
LIP = np.array([0.43, 0.175, 0.150], dtype=np.float32)
HAIR = np.array([0.030, 0.019, 0.012], dtype=np.float32)
# Change of the logarithm of the albedo for one unit of each pigment.
BLOOD = np.array([-0.06, -0.46, -0.40], dtype=np.float32)
MELANIN = np.array([-0.45, -0.72, -0.95], dtype=np.float32)
YELLOW = np.array([0.01, 0.02, -0.16], dtype=np.float32)
BLUE = np.array([-0.17, -0.14, -0.03], dtype=np.float32)


class Mole(NamedTuple):
    """Mole: its centre (3,) and radius in mm, and the pigment that it adds."""

    centre_mm: Float32
    radius_mm: float
    melanin: float


def scattered_moles(s: SkinTexels, rng: np.random.Generator) -> list[Mole]:
    """Return moles at random texels of the face that are neither on the lips nor on the ears."""
    plain = np.flatnonzero((np.abs(s.p[:, 0]) < 64.0) & (s.lips < 0.1) & (s.thin < 0.3))
    return [
        Mole(
            s.p[plain[int(rng.integers(len(plain)))]],
            float(rng.uniform(0.5, 1.35)),
            float(rng.uniform(0.5, 0.95)),
        )
        for _ in range(MOLES)
    ]


def skin_colours(s: SkinTexels, moles: Sequence[Mole], noise: Float32) -> tuple[Float32, Float32]:
    """Return the albedo without hairs and the deep-scatter tint, (N, 3) each.

    Parameters
    ----------
    s
        Texels of the skin.
    moles
        Moles from `scattered_moles`.
    noise
        Smooth volume of `skinshade.heads.maps.noise.smooth_volume`.
    """
    p = s.p
    coarse = sample_smooth(noise, p + 31.0, 26.0)
    medium = sample_smooth(noise, p - 57.0, 8.0)
    fine = sample_smooth(noise, p + 11.0, 2.6)
    finest = sample_smooth(noise, p + 77.0, 1.0)
    forehead = ramp(p[:, 1], 22.0, 42.0) * s.front
    hairline = np.interp(p[:, 2], *HAIRLINE_MM).astype(np.float32)
    scalp = ramp(p[:, 1] - hairline + 2.5 * medium + 3.0 * coarse, -5.0, 9.0)
    under_eye = spot(p, (29, -11, 74), (11, 4.5, 9))
    lid = spot(p, (31, 3, 77), (12, 7, 8))
    neck = ramp(p[:, 1], -108.0, -135.0)
    beard = ramp(p[:, 1], -44.0, -60.0) * ramp(p[:, 1], -128.0, -104.0)
    beard *= ramp(p[:, 2], 5.0, 30.0)
    beard *= 1.0 - 0.75 * spot(p, (30, -52, 80), (11, 13, 20))
    beard *= 1.0 - s.lips

    blood = 0.80 * s.red - 0.10 + 0.06 * coarse + 0.07 * medium * (0.7 + s.red) + 0.055 * fine
    blood += 0.22 * lid + 0.22 * under_eye - 0.10 * forehead - 0.10 * scalp + 0.05 * neck
    melanin = 0.030 * coarse + 0.025 * medium + 0.030 * fine + 0.018 * finest
    melanin += 0.16 * s.brow + 0.04 * forehead + 0.03 * scalp + 0.02 * neck + 0.06 * under_eye
    # Freckles are the peaks of a fine noise where a coarse noise is high.
    freckles = ramp(fine + 0.35 * finest, 2.05, 2.6) * ramp(coarse + 1.6 * s.red, 0.1, 1.5)
    melanin += 0.22 * freckles * (1.0 - s.lips)
    greatest = float(np.abs(finest).max(initial=0.0))
    for mole in moles:
        reach = 1.35 * mole.radius_mm + 0.15 * greatest
        near = np.flatnonzero(np.abs(p[:, 0] - mole.centre_mm[0]) < reach)
        gap = np.sqrt(np.sum((p[near] - mole.centre_mm) ** 2, axis=1)) + 0.15 * finest[near]
        melanin[near] += mole.melanin * ramp(gap, mole.radius_mm * 1.35, mole.radius_mm * 0.6)
    yellow = 0.28 * forehead + 0.15 * scalp + 0.15 * neck + 0.30 * under_eye + 0.08 * coarse
    stubble = 0.8 + 0.14 * fine + 0.12 * finest
    blue = 0.50 * under_eye + 0.55 * beard * stubble + 0.55 * scalp * stubble
    blue += 0.35 * spot(p, (15, 4, 78), (4.0, 8, 7))
    log = blood[:, None] * BLOOD + melanin[:, None] * MELANIN
    log += yellow[:, None] * YELLOW + blue[:, None] * BLUE
    albedo = SKIN * np.exp(log)
    lip = LIP * np.exp(0.10 * medium + 0.10 * fine + 0.05 * finest)[:, None]
    soft = np.clip(ramp(s.lips, 0.12, 0.85) * (0.80 + 0.05 * fine), 0.0, 0.92)[:, None]
    albedo += soft * (lip - albedo)

    vein_field = np.abs(sample_smooth(noise, p * np.float32(1.0) + 203.0, 17.0) + 0.30 * medium)
    veins = ramp(vein_field, 0.11, 0.02) * (0.25 + 0.75 * s.thin)
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
