"""Burley's normalised diffusion [Christensen2015], with an exact transfer function."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

from .._core.arrays import FloatArray
from .._core.errors import ArgumentError

__all__ = ["BurleyKernel", "BurleyLength", "shape_length_mm"]

BurleyLength = Literal[
    "shape", "mean-free-path-searchlight", "mean-free-path-diffuse", "diffuse-mean-free-path"
]
"""Kinds of length that renderers give for Burley's profile; they differ by factors of two."""


def shape_length_mm(length_mm: FloatArray, kind: BurleyLength, albedo: FloatArray) -> FloatArray:
    """Return d (3,), the scale of the two exponentials, mm, from a length (3,) of a kind: d = l/s(A).

    The scalings s(A) are the fits of [Christensen2015]: equations 5 (searchlight), 6 (diffuse
    surface transmission) and 8 (diffuse mean free path).

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
    raise ArgumentError(f"kind is {kind!r}; it must be one of {', '.join(get_args(BurleyLength))}")


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
