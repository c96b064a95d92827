"""Diffusion profiles: kernel and albedo per channel (MODEL §1)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal, Protocol, Self

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import FloatArray, FloatVector, as_floats, as_rgb
from .._core.errors import ArgumentError
from .._core.notebook import curves_svg, table_html
from .burley import BurleyKernel, BurleyLength, shape_length_mm
from .dipole import DipoleKernel
from .gaussians import GaussianMixture, fit_gaussians
from .presets import preset_record
from .tabulated import TabulatedKernel

__all__ = ["DiffusionKernel", "Profile"]

Closure = Literal["", "blender-skin"]
"""Closures of renderers that profiles are made from."""
PLOT_REACH = 3.0
"""Range of the plot in notebooks, in root mean square radii of the widest channel."""


class DiffusionKernel(Protocol):
    """Interface of a normalised diffusion kernel."""

    @property
    def mean_square_radius_mm2(self) -> FloatArray:
        """(3,) second moment of R over the plane, mm²."""

    def transfer(self, k_per_mm: FloatArray) -> FloatArray:
        """Return T(k) (..., 3) at spatial frequencies in rad/mm; T(0) = 1."""

    def radial(self, r_mm: FloatArray) -> FloatArray:
        """Return R(r) (..., 3) per mm²."""

    def scaled(self, factor: float) -> Self:
        """Return the kernel with every length multiplied by `factor`."""


@dataclass(frozen=True)
class Profile:
    """Diffusion profile: light that leaves a flat surface around its point of entry, per channel.

    Create one with `preset`, `gaussians`, `burley`, `dipole` or `tabulated`.

    Attributes
    ----------
    kernel
        Normalised kernel: its transfer function is 1 at k = 0.
    albedo
        (3,) diffuse albedo: the share of the light that leaves the surface, 0..1.
    name
        Name for people.
    source
        Key of its source in ``REFERENCES.bib``; empty if there is none.
    closure
        Closure of a renderer that the profile was made for, and from which light leaves the surface:
        ``blender-skin``, or empty for none.

    Examples
    --------
    >>> import skinshade as sk
    >>> sk.Profile.preset("skin-deon2007")
    Profile('skin-deon2007', rms_radius_mm=[1.663 0.369 0.223], albedo=[0.436 0.227 0.131])
    """

    kernel: DiffusionKernel
    albedo: FloatVector
    name: str = "custom"
    source: str = ""
    closure: Closure = ""

    @classmethod
    def preset(cls, name: str) -> Profile:
        """Return a profile that skinshade contains.

        Parameters
        ----------
        name
            Name from `skinshade.presets`.

        Raises
        ------
        ArgumentError
            If there is no preset of this name.
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
            (n,) variances along one axis, mm², > 0.
        weights
            (n, 3) weights ≥ 0; they are scaled to sum to 1 in every channel.
        albedo
            (3,) or scalar, 0..1 (excluding 1).

        Raises
        ------
        ArgumentError
            If a shape or value is not allowed.

        Examples
        --------
        >>> import skinshade as sk
        >>> profile = sk.Profile.gaussians(variances_mm2=[1.0], weights=[[1, 1, 1]], albedo=0.5)
        >>> profile.rms_radius_mm.round(3)
        array([1.414, 1.414, 1.414])
        """
        return cls(GaussianMixture.checked(variances_mm2, weights), _albedo(albedo))

    @classmethod
    def burley(cls, *, length_mm: ArrayLike, kind: BurleyLength, albedo: ArrayLike) -> Profile:
        """Return Burley's normalised diffusion [Christensen2015].

        Parameters
        ----------
        length_mm
            (3,) or scalar, mm, > 0.
        kind
            Kind of the length: ``shape`` (d itself), ``mean-free-path-searchlight``,
            ``mean-free-path-diffuse``, ``diffuse-mean-free-path`` or ``blender-skin-radius``, the radius of
            Blender's closure "random walk (skin)". There is no default, because they differ by factors of
            two.
        albedo
            (3,) or scalar, 0..1 (excluding 1).

        Raises
        ------
        ArgumentError
            If a value or the kind is not allowed.

        Examples
        --------
        >>> import skinshade as sk
        >>> sk.Profile.burley(length_mm=1.0, kind="shape", albedo=0.5).rms_radius_mm.round(3)
        array([3.742, 3.742, 3.742])
        """
        length = as_rgb("length_mm", length_mm)
        if (length <= 0.0).any():
            raise ArgumentError(f"length_mm is {length}; it must be positive")
        a = _albedo(albedo)
        kernel = BurleyKernel(shape_length_mm(length, kind, a))
        closure: Closure = "blender-skin" if kind == "blender-skin-radius" else ""
        return cls(kernel, a, source="Christensen2015", closure=closure)

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
            (3,) or scalar, 0..1 (excluding 1); the diffuse reflectance of the dipole if None.

        Raises
        ------
        ArgumentError
            If a value is not allowed.

        Examples
        --------
        >>> import skinshade as sk
        >>> skin = sk.Profile.dipole(
        ...     sigma_s_prime_per_mm=[0.74, 0.88, 1.01], sigma_a_per_mm=[0.032, 0.17, 0.48]
        ... )
        >>> skin.albedo.round(2)
        array([0.44, 0.23, 0.13])
        """
        scattering = as_rgb("sigma_s_prime_per_mm", sigma_s_prime_per_mm)
        absorption = as_rgb("sigma_a_per_mm", sigma_a_per_mm)
        for label, value in (("sigma_s_prime_per_mm", scattering), ("sigma_a_per_mm", absorption)):
            if (value <= 0.0).any():
                raise ArgumentError(f"{label} is {value}; it must be positive")
        kernel = DipoleKernel(
            scattering, absorption, float(as_floats("ior", ior, (), low=1.0, high=3.0))
        )
        if not np.isfinite(kernel.mean_square_radius_mm2).all():
            raise ArgumentError("sigma_s_prime_per_mm, sigma_a_per_mm: too small, or too different")
        a = kernel.albedo if albedo is None else albedo
        return cls(kernel, _albedo(a), source="Jensen2001")

    @classmethod
    def tabulated(cls, *, edges_mm: ArrayLike, flux: ArrayLike, albedo: ArrayLike) -> Profile:
        """Return a profile from measured or simulated flux within annuli.

        Parameters
        ----------
        edges_mm
            (bins + 1,) increasing radii, mm, ≥ 0.
        flux
            (3, bins) light that leaves within the annuli, in any unit, ≥ 0.
        albedo
            (3,) or scalar, 0..1 (excluding 1).

        Raises
        ------
        ArgumentError
            If a shape or value is not allowed.

        Examples
        --------
        >>> import skinshade as sk
        >>> disk = sk.Profile.tabulated(edges_mm=[0, 1], flux=[[1], [1], [1]], albedo=0.5)
        >>> disk.radial(0.5).round(3)  # 1/π per mm² within the radius of 1 mm
        array([0.318, 0.318, 0.318])
        """
        return cls(TabulatedKernel.checked(edges_mm, flux), _albedo(albedo))

    def equals(self, other: Profile) -> bool:
        """Return whether the `other` profile scatters alike: equal albedo, transfer function and closure."""
        if self.closure != other.closure or not np.array_equal(self.albedo, other.albedo):
            return False
        frequencies = np.geomspace(1e-3, 1e3, 64)
        return np.array_equal(self.transfer(frequencies), other.transfer(frequencies))

    def transfer(self, k_per_mm: ArrayLike) -> FloatArray:
        """Return T(k), the 2-D Hankel transform of R; T(0) = 1.

        Parameters
        ----------
        k_per_mm
            (...) spatial frequencies, rad/mm, ≥ 0.

        Returns
        -------
        (..., 3)

        Raises
        ------
        ArgumentError
            If a frequency is negative or not finite.

        Examples
        --------
        >>> import skinshade as sk
        >>> sk.Profile.preset("skin-deon2007").transfer(1.0).round(3)
        array([0.657, 0.969, 0.988])
        """
        return self.kernel.transfer(as_floats("k_per_mm", k_per_mm, low=0.0))

    def radial(self, r_mm: ArrayLike) -> FloatArray:
        """Return R(r) (..., 3) per mm², which integrates to 1 over the plane.

        Parameters
        ----------
        r_mm
            (...) distances from the point of entry, mm, ≥ 0.

        Raises
        ------
        ArgumentError
            If a distance is negative or not finite.
        """
        return self.kernel.radial(as_floats("r_mm", r_mm, low=0.0))

    def scaled(self, factor: float) -> Profile:
        """Return the profile with every length multiplied by `factor` (> 0).

        Multiplying curvatures by `factor` has the same effect on the shading, without new tables.

        Raises
        ------
        ArgumentError
            If the factor is not positive.
        """
        f = float(as_floats("factor", factor, ()))
        if f <= 0.0:
            raise ArgumentError(f"factor is {factor}; it must be positive")
        return replace(self, kernel=self.kernel.scaled(f))

    @property
    def rms_radius_mm(self) -> FloatVector:
        """(3,) root mean square distance between entry and exit, mm."""
        return np.sqrt(self.kernel.mean_square_radius_mm2)

    def gaussian_fit(self) -> tuple[GaussianMixture, float]:
        """Return the kernel as a mixture of Gaussians, and max |ΔT| up to kρ ≈ 150.

        A profile of Gaussians returns its own mixture and 0; other profiles are fitted, which takes
        some milliseconds.
        """
        if isinstance(self.kernel, GaussianMixture):
            return self.kernel, 0.0
        return fit_gaussians(self.kernel.transfer, self.rms_radius_mm)

    def __repr__(self) -> str:
        radius, albedo = self.rms_radius_mm.round(3), self.albedo.round(3)
        return f"Profile({self.name!r}, rms_radius_mm={radius}, albedo={albedo})"

    def _repr_html_(self) -> str:
        r_mm = np.linspace(1e-3, 1.0, 200) * PLOT_REACH * self.rms_radius_mm.max()
        density = 2.0 * np.pi * r_mm[:, None] * self.radial(r_mm)
        caption = f"2πr R(r): light over its distance from the entry, 0 to {r_mm[-1]:.3g} mm"
        rows = {
            "root mean square radius, mm": self.rms_radius_mm.round(3),
            "albedo": self.albedo.round(3),
            "kernel": type(self.kernel).__name__,
            "source": self.source or "none",
        }
        return table_html(f"Profile {self.name}", rows) + curves_svg(r_mm, density, caption)


def _albedo(value: ArrayLike) -> FloatArray:
    albedo = as_rgb("albedo", value, low=0.0, high=1.0)
    if (albedo >= 1.0).any():
        raise ArgumentError(f"albedo is {albedo}; it must be below 1: no light would be absorbed")
    return albedo
