"""What every pixel of a material shares: its profile's tables and weights."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .._core.arrays import FloatArray, as_triple
from .._core.errors import ArgumentError
from ..lut import Lut, build_curvature_lut, build_shadow_lut, build_transfer_lut
from ..lut.classic import classic_curvature_lut, classic_shadow_lut
from ..lut.spectral import DiffusionGeometry
from ..params import ScatterParams, SkinParams
from ..profile import Profile
from . import deep_scatter, normals, shadow
from .normals import NormalBlend

__all__ = ["ENGINE_LUTS", "LUTS", "Skin"]

TABLE_RADIUS_MM = (0.5, 4000.0)
"""Radii of curvature that the tables hold: from a lash line to what is flat for any profile."""
TABLE_SIZE = (512, 128)

TABLES_HOLD = ("scatter_scale", "shadow_filter_width_mm", "shadow_sharpening")
"""Parameters that the tables are made for."""

LUTS = {
    "ring": "ring",
    "sphere": "sphere",
    "transfer": "transfer_lut",
    "shadow": "shadow",
    "classic": "classic_curvature",
    "classic_shadow": "classic_shadow",
}
"""Tables by their names in shaders, where each is ``<name>_lut`` with ``<name>_axes``."""
ENGINE_LUTS = ("ring", "sphere", "transfer", "shadow")
"""Those that are not for comparison with 2014."""


@dataclass(frozen=True)
class Skin:
    """What is the same for every pixel of a material: tables and fitted weights, made when asked for.

    Attributes
    ----------
    profile
        Already scaled by ``params.scatter_scale``.
    params
        The numbers of the material.
    """

    profile: Profile
    params: SkinParams

    @classmethod
    def of(cls, profile: Profile, params: SkinParams) -> Skin:
        """Return the skin of a material.

        Parameters
        ----------
        profile
            As measured; ``params.scatter_scale`` scales it here.
        params
            The numbers of the material.
        """
        return cls(profile.scaled(params.scatter_scale), params)

    def with_params(self, params: SkinParams) -> Skin:
        """Return the same skin with other parameters, and with the tables it has.

        Parameters
        ----------
        params
            For which the tables hold.

        Raises
        ------
        ArgumentError
            Naming the parameter that needs other tables.
        """
        self.check_tables_hold(params)
        other = Skin(self.profile, params)
        made = {
            name: value for name, value in vars(self).items() if name not in ("profile", "params")
        }
        vars(other).update(made)
        return other

    def lut(self, name: str) -> Lut:
        """Return a table by its name in shaders, one of `LUTS`."""
        found: Lut = getattr(self, LUTS[name])
        return found

    def scatter_params(self, fetches: int = 3, luts: Sequence[str] = ENGINE_LUTS) -> ScatterParams:
        """Return what shaders take of the profile and of its tables.

        Parameters
        ----------
        fetches
            Of the normal map, 2 or 3.
        luts
            Names of the tables whose axes are wanted; the others keep their defaults and are not made.
        """
        blend = self.blend(fetches)
        weights, sigmas = np.zeros((3, 3)), np.zeros(2)
        weights[:, :fetches] = blend.weights
        sigmas[: fetches - 1] = blend.sigmas_mm
        return ScatterParams(
            albedo=as_triple(self.profile.albedo),
            rms_radius_mm=as_triple(self.profile.rms_radius_mm),
            sigma_per_mm=as_triple(self.sigma_per_mm),
            blend_red=as_triple(weights[0]),
            blend_green=as_triple(weights[1]),
            blend_blue=as_triple(weights[2]),
            normal_sigmas_mm=(float(sigmas[0]), float(sigmas[1])),
            **{f"{name}_axes": self.lut(name).axes for name in luts},
        )

    def check_tables_hold(self, params: SkinParams) -> None:
        """Raise if other parameters need other tables.

        Parameters
        ----------
        params
            That a shader is to take with the tables of these.

        Raises
        ------
        ArgumentError
            Naming the parameter.
        """
        for name in TABLES_HOLD:
            made_for, wanted = getattr(self.params, name), getattr(params, name)
            if made_for != wanted:
                raise ArgumentError(
                    f"{name}: the tables were made for {made_for}, not {wanted}; make a Skin of the new"
                    " parameters"
                )

    def transfer(self, k_per_mm: FloatArray) -> FloatArray:
        """Return the profile's T(k) (..., 3)."""
        return self.profile.kernel.transfer(k_per_mm)

    @cached_property
    def sphere(self) -> Lut:
        """Curvature table of the sphere, without energy gain."""
        return self._curvature_table("sphere")

    @cached_property
    def ring(self) -> Lut:
        """Curvature table of the ring, without energy gain."""
        return self._curvature_table("ring")

    @cached_property
    def transfer_lut(self) -> Lut:
        """T(k) as shaders look it up."""
        return build_transfer_lut(self.profile)

    @cached_property
    def shadow(self) -> Lut:
        """Shadow table for the material's filter, down to grazing light."""
        width = self.params.shadow_filter_width_mm
        return build_shadow_lut(
            self.profile,
            size=(512, 64),
            width_mm=(width, width / shadow.LEAST_COSINE),
            sharpening=self.params.shadow_sharpening,
        )

    @cached_property
    def classic_curvature(self) -> Lut:
        """Curvature table of 2014."""
        return classic_curvature_lut(self.profile, size=(512, 64))

    @cached_property
    def classic_shadow(self) -> Lut:
        """Shadow table of 2014."""
        return classic_shadow_lut(
            self.profile, size=(512, 64), sharpening=self.params.shadow_sharpening
        )

    def blend(self, fetches: int = 3) -> NormalBlend:
        """Return the weights of 2 or 3 normal fetches."""
        if fetches not in self._blends:
            self._blends[fetches] = normals.normal_blend(self.profile, fetches=fetches)
        return self._blends[fetches]

    @cached_property
    def _blends(self) -> dict[int, NormalBlend]:
        return {}

    @property
    def sigma_per_mm(self) -> FloatArray:
        """(3,) decay of light that comes through the body."""
        default = deep_scatter.default_sigma_per_mm(self.profile.rms_radius_mm)
        given = np.asarray(self.params.deep_scatter_sigma_per_mm)
        return np.where(given > 0.0, given, default)

    def _curvature_table(self, kernel: DiffusionGeometry) -> Lut:
        return build_curvature_lut(
            self.profile,
            size=TABLE_SIZE,
            radius_mm=TABLE_RADIUS_MM,
            kernel=kernel,
            energy_gain=False,
        )
