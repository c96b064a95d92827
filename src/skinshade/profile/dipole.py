"""Dipole of diffusion theory [Jensen2001]. It is inaccurate within one mean free path of the entry."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._core.arrays import FloatArray

__all__ = ["DipoleKernel", "fresnel_diffuse_reflectance"]


def fresnel_diffuse_reflectance(ior: float) -> float:
    """Return the share of diffuse light that the boundary reflects inwards [Jensen2001]; 0 for `ior` ≤ 1."""
    if ior <= 1.0:
        return 0.0
    return -1.440 / ior**2 + 0.710 / ior + 0.668 + 0.0636 * ior


@dataclass(frozen=True)
class DipoleKernel:
    """Kernel of a real source below the surface and a virtual source above it.

    Attributes
    ----------
    sigma_s_prime_per_mm, sigma_a_per_mm
        (3,) reduced scattering and absorption, 1/mm.
    ior
        Refractive index of the medium relative to the outside.
    """

    sigma_s_prime_per_mm: FloatArray
    sigma_a_per_mm: FloatArray
    ior: float

    @property
    def sigma_tr_per_mm(self) -> FloatArray:
        """(3,) effective transport coefficient √(3σ_a σ_t'), 1/mm."""
        return np.sqrt(
            3.0 * self.sigma_a_per_mm * (self.sigma_a_per_mm + self.sigma_s_prime_per_mm)
        )

    @property
    def depths_mm(self) -> tuple[FloatArray, FloatArray]:
        """(3,) distances z_r and z_v of the sources from the surface, mm."""
        reflected = fresnel_diffuse_reflectance(self.ior)
        mismatch = (1.0 + reflected) / (1.0 - reflected)
        z_r = 1.0 / (self.sigma_a_per_mm + self.sigma_s_prime_per_mm)
        return z_r, z_r * (1.0 + 4.0 / 3.0 * mismatch)

    @property
    def albedo(self) -> FloatArray:
        """(3,) total diffuse reflectance ½α'(e^{−z_r σ_tr} + e^{−z_v σ_tr})."""
        alpha = self.sigma_s_prime_per_mm / (self.sigma_a_per_mm + self.sigma_s_prime_per_mm)
        return 0.5 * alpha * self._pair(self.sigma_tr_per_mm)

    @property
    def mean_square_radius_mm2(self) -> FloatArray:
        """(3,) second moment of R over the plane: 2Σz e^{−zσ_tr}/(σ_tr Σe^{−zσ_tr}), mm²."""
        s = self.sigma_tr_per_mm
        z_r, z_v = self.depths_mm
        moment = z_r * np.exp(-z_r * s) + z_v * np.exp(-z_v * s)
        return 2.0 * moment / (s * self._pair(s))

    def transfer(self, k_per_mm: FloatArray) -> FloatArray:
        """Return T(k) (..., 3) at spatial frequencies in rad/mm."""
        s = self.sigma_tr_per_mm
        return self._pair(np.sqrt(np.square(k_per_mm)[..., None] + s**2)) / self._pair(s)

    def radial(self, r_mm: FloatArray) -> FloatArray:
        """Return R(r) (..., 3) per mm², which integrates to 1 over the plane."""
        s = self.sigma_tr_per_mm
        total = np.zeros((*r_mm.shape, 3))
        for z in self.depths_mm:
            distance = np.sqrt(np.square(r_mm)[..., None] + z**2)
            total += z * (1.0 + s * distance) * np.exp(-s * distance) / (2.0 * np.pi * distance**3)
        return total / self._pair(s)

    def scaled(self, factor: float) -> DipoleKernel:
        """Return the kernel with every length multiplied by `factor`."""
        return DipoleKernel(
            self.sigma_s_prime_per_mm / factor, self.sigma_a_per_mm / factor, self.ior
        )

    def _pair(self, q_per_mm: FloatArray) -> FloatArray:
        z_r, z_v = self.depths_mm
        return np.exp(-z_r * q_per_mm) + np.exp(-z_v * q_per_mm)
