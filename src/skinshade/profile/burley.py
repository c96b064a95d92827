"""Burley's normalised diffusion [Christensen2015], with an exact transfer function."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

from .._core.arrays import FloatArray
from .._core.errors import ArgumentError
from .dipole import fresnel_diffuse_reflectance

__all__ = ["BurleyKernel", "BurleyLength", "shape_length_mm", "skin_walk_mean_free_path_mm"]

BurleyLength = Literal[
    "shape",
    "mean-free-path-searchlight",
    "mean-free-path-diffuse",
    "diffuse-mean-free-path",
    "blender-skin-radius",
]
"""Kinds of length that renderers give for Burley's profile; they differ by factors of two."""
SKIN_WALK_IOR = 1.4
"""Index of refraction of skin in Blender's closure."""
BISECTIONS = 60
"""Halvings of 0..1: below the spacing of float64."""


def shape_length_mm(length_mm: FloatArray, kind: BurleyLength, albedo: FloatArray) -> FloatArray:
    """Return d (3,), the scale of the two exponentials, mm, from a length (3,) of a kind: d = l/s(A).

    The scalings s(A) are the fits of [Christensen2015]: equations 5 (searchlight), 6 (diffuse
    surface transmission) and 8 (diffuse mean free path). The radius of Blender's closure "random walk
    (skin)" is first converted by `skin_walk_mean_free_path_mm`.

    Raises
    ------
    ArgumentError
        If the kind is unknown.
    """
    if kind == "shape":
        return length_mm
    if kind == "mean-free-path-searchlight":
        return length_mm / (1.85 - albedo + 7.0 * np.abs(albedo - 0.8) ** 3)
    if kind == "mean-free-path-diffuse":
        return length_mm / (1.9 - albedo + 3.5 * (albedo - 0.8) ** 2)
    if kind == "diffuse-mean-free-path":
        return length_mm / (3.5 + 100.0 * (albedo - 0.33) ** 4)
    if kind == "blender-skin-radius":
        free_path_mm = skin_walk_mean_free_path_mm(length_mm, albedo)
        return shape_length_mm(free_path_mm, "mean-free-path-diffuse", albedo)
    raise ArgumentError(f"kind is {kind!r}; it must be one of {', '.join(get_args(BurleyLength))}")


def skin_walk_mean_free_path_mm(radius_mm: FloatArray, albedo: FloatArray) -> FloatArray:
    """Return the mean free path (3,) of the random walk of Blender's skin closure, mm.

    The closure takes its radius (3,) as the diffusion length of a medium whose reduced albedo α' gives the
    surface its albedo by the dipole of [Jensen2001]: mfp = radius √(3 (1 − α')).

    Parameters
    ----------
    radius_mm
        (3,) radius of the closure times its scale, mm.
    albedo
        (3,) albedo of the surface, 0..1.
    """
    return radius_mm * np.sqrt(3.0 * (1.0 - _reduced_albedo(albedo)))


def _reduced_albedo(albedo: FloatArray) -> FloatArray:
    """Return α' (3,) for which the dipole of [Jensen2001] has an albedo (3,), by bisection."""
    reflected = fresnel_diffuse_reflectance(SKIN_WALK_IOR)
    boundary = 4.0 / 3.0 * (1.0 + reflected) / (1.0 - reflected)
    low, high = np.zeros_like(albedo), np.ones_like(albedo)
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        s = np.sqrt(3.0 * (1.0 - middle))
        is_below = 0.5 * middle * (1.0 + np.exp(-boundary * s)) * np.exp(-s) < albedo
        low, high = np.where(is_below, middle, low), np.where(is_below, high, middle)
    return high


@dataclass(frozen=True)
class BurleyKernel:
    """Kernel (e^{−r/d} + e^{−r/3d})/(8πdr).

    Attributes
    ----------
    d_mm
        (3,) scale of the exponentials, mm.
    """

    d_mm: FloatArray

    @property
    def mean_square_radius_mm2(self) -> FloatArray:
        """(3,) second moment of R over the plane: 14 d², mm²."""
        return 14.0 * np.square(self.d_mm)

    def transfer(self, k_per_mm: FloatArray) -> FloatArray:
        """Return T(k) (..., 3) at spatial frequencies in rad/mm."""
        kd2 = np.square(k_per_mm[..., None] * self.d_mm)
        result: FloatArray = 0.25 / np.sqrt(1.0 + kd2) + 0.75 / np.sqrt(1.0 + 9.0 * kd2)
        return result

    def radial(self, r_mm: FloatArray) -> FloatArray:
        """Return R(r) (..., 3) per mm²; infinite at r = 0."""
        x = r_mm[..., None] / self.d_mm
        with np.errstate(divide="ignore"):
            result: FloatArray = (np.exp(-x) + np.exp(-x / 3.0)) / (8.0 * np.pi * self.d_mm**2 * x)
        return result

    def scaled(self, factor: float) -> BurleyKernel:
        """Return the kernel with every length multiplied by `factor`."""
        return BurleyKernel(self.d_mm * factor)
