"""A diffusion profile is its transfer function; everything else derives from it (MODEL §1)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Protocol, Self

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import FloatArray, as_floats, as_rgb
from .._core.errors import ArgumentError
from .burley import BurleyKernel, BurleyLength, shape_length_mm
from .dipole import DipoleKernel
from .gaussians import GaussianMixture, fit_gaussians
from .presets import preset_record
from .tabulated import TabulatedKernel

__all__ = ["DiffusionKernel", "Profile"]


class DiffusionKernel(Protocol):
    """What a kind of profile has to give."""

    @property
    def mean_square_radius_mm2(self) -> FloatArray:
        """(3,) second moment of R over the plane, mm²."""

    def transfer(self, k_per_mm: FloatArray) -> FloatArray:
        """Return T(k) (..., 3), T(0) = 1."""

    def radial(self, r_mm: FloatArray) -> FloatArray:
        """Return R(r) (..., 3) per mm²."""

    def scaled(self, factor: float) -> Self:
        """Return the kernel with every length multiplied by `factor`."""


@dataclass(frozen=True)
class Profile:
    """How light that enters a flat surface at a point leaves around it, per channel.

    Build one with `gaussians`, `burley`, `dipole`, `tabulated` or `preset`.

    Attributes
    ----------
    kernel
        The shape, normalised: its transfer function is 1 at k = 0.
    albedo
        (3,) diffuse albedo, the share of the light that leaves at all, 0..1.
    name, source
        What to call it, and the key of its source in ``REFERENCES.bib``.
    """

    kernel: DiffusionKernel
    albedo: FloatArray
    name: str = "custom"
    source: str = ""

    @classmethod
    def preset(cls, name: str) -> Profile:
        """Return one of the profiles that ship with skinshade.

        Parameters
        ----------
        name
            One of `skinshade.presets`.

        Raises
        ------
        ArgumentError
            If there is none of that name.
        """
        record = dict(preset_record(name))
        build: dict[str, Callable[..., Profile]] = {
            "gaussians": cls.gaussians,
            "dipole": cls.dipole,
            "burley": cls.burley,
        }
        kind, source = record.pop("kind"), record.pop("source")
        for note in ("about", "unit", "albedo_source"):
            record.pop(note, None)
        return replace(build[kind](**record), name=name, source=source)

    @classmethod
    def gaussians(
        cls, *, variances_mm2: ArrayLike, weights: ArrayLike, albedo: ArrayLike
    ) -> Profile:
        """Return a mixture of Gaussians.

        Parameters
        ----------
        variances_mm2
            (n,) variance of each along one axis, mm².
        weights
            (n, 3) non-negative; scaled so that each channel sums to 1.
        albedo
            (3,) or scalar, 0..1 (excluding 1).
        """
        return cls(GaussianMixture.checked(variances_mm2, weights), _albedo(albedo))

    @classmethod
    def burley(cls, *, length_mm: ArrayLike, kind: BurleyLength, albedo: ArrayLike) -> Profile:
        """Return Burley's normalised diffusion [Christensen2015].

        Parameters
        ----------
        length_mm
            (3,) or scalar, > 0.
        kind
            What the length is: ``shape`` (d itself), ``mean-free-path-searchlight``,
            ``mean-free-path-diffuse`` or ``diffuse-mean-free-path``. There is no default,
            because a wrong guess is wrong by a factor of two.
        albedo
            (3,) or scalar, 0..1 (excluding 1).
        """
        length = as_rgb("length_mm", length_mm)
        if (length <= 0.0).any():
            raise ArgumentError(f"length_mm is {length}; it must be positive")
        a = _albedo(albedo)
        return cls(BurleyKernel(shape_length_mm(length, kind, a)), a, source="Christensen2015")

    @classmethod
    def dipole(
        cls,
        *,
        sigma_s_prime_per_mm: ArrayLike,
        sigma_a_per_mm: ArrayLike,
        ior: float = 1.3,
        albedo: ArrayLike | None = None,
    ) -> Profile:
        """Return the dipole of diffusion theory [Jensen2001].

        Parameters
        ----------
        sigma_s_prime_per_mm, sigma_a_per_mm
            (3,) reduced scattering and absorption, 1/mm, > 0.
        ior
            Relative refractive index, 1..3.
        albedo
            (3,) or scalar; the dipole's own diffuse reflectance if not given.
        """
        scattering = as_rgb("sigma_s_prime_per_mm", sigma_s_prime_per_mm)
        absorption = as_rgb("sigma_a_per_mm", sigma_a_per_mm)
        for label, value in (("sigma_s_prime_per_mm", scattering), ("sigma_a_per_mm", absorption)):
            if (value <= 0.0).any():
                raise ArgumentError(f"{label} is {value}; it must be positive")
        kernel = DipoleKernel(
            scattering, absorption, float(as_floats("ior", ior, (), low=1.0, high=3.0))
        )
        a = kernel.albedo if albedo is None else albedo
        return cls(kernel, _albedo(a), source="Jensen2001")

    @classmethod
    def tabulated(cls, *, edges_mm: ArrayLike, flux: ArrayLike, albedo: ArrayLike) -> Profile:
        """Return a profile from the flux within annuli, measured or simulated.

        Parameters
        ----------
        edges_mm
            (bins + 1,) rising radii, mm.
        flux
            (3, bins) light that leaves within each annulus, any scale.
        albedo
            (3,) or scalar, 0..1 (excluding 1).
        """
        return cls(TabulatedKernel.checked(edges_mm, flux), _albedo(albedo))

    def transfer(self, k_per_mm: ArrayLike) -> FloatArray:
        """Return T(k), the 2-D Hankel transform of R, normalised to T(0) = 1.

        Parameters
        ----------
        k_per_mm
            (...) spatial frequency, rad/mm, ≥ 0.

        Returns
        -------
        (..., 3)
        """
        return self.kernel.transfer(as_floats("k_per_mm", k_per_mm, low=0.0))

    def radial(self, r_mm: ArrayLike) -> FloatArray:
        """Return R(r) (..., 3) per mm², which integrates to 1 over the plane; r (...) in mm, ≥ 0."""
        return self.kernel.radial(as_floats("r_mm", r_mm, low=0.0))

    def scaled(self, factor: float) -> Profile:
        """Return the profile with every length multiplied by `factor` (> 0).

        The same as multiplying curvatures by it: how a radius changes at run time without a new
        table.
        """
        f = float(as_floats("factor", factor, ()))
        if f <= 0.0:
            raise ArgumentError(f"factor is {factor}; it must be positive")
        return replace(self, kernel=self.kernel.scaled(f))

    @property
    def rms_radius_mm(self) -> FloatArray:
        """(3,) root of the mean square distance between entry and exit, mm."""
        return np.sqrt(self.kernel.mean_square_radius_mm2)

    @cached_property
    def mixture(self) -> GaussianMixture:
        """The Gaussians themselves, or the fit to any other profile (see `mixture_residual`)."""
        return self._fit[0]

    @property
    def mixture_residual(self) -> float:
        """Max |ΔT| between `mixture` and the profile up to kρ ≈ 150; 0 for a Gaussian mixture."""
        return self._fit[1]

    @cached_property
    def _fit(self) -> tuple[GaussianMixture, float]:
        if isinstance(self.kernel, GaussianMixture):
            return self.kernel, 0.0
        return fit_gaussians(self.kernel.transfer, self.rms_radius_mm)


def _albedo(value: ArrayLike) -> FloatArray:
    albedo = as_rgb("albedo", value, low=0.0, high=1.0)
    if (albedo >= 1.0).any():
        raise ArgumentError(
            f"albedo is {albedo}; it must be below 1, else nothing is ever absorbed"
        )
    return albedo
