"""Material of skin for shading: profile, parameters and tables."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np

from .._core.arrays import FloatArray, as_triple
from .._core.errors import ArgumentError
from ..lut import Lut
from ..params import ScatterParams, SkinParams
from ..params.choices import Boundary, Shading, SpecularModel
from ..profile import Profile
from .deep_scatter import default_sigma_per_mm
from .normals import NormalBlend
from .tables import ENGINE_LUTS, SkinTables

__all__ = ["Skin"]


@dataclass(frozen=True, repr=False)
class Skin:
    """Profile, parameters and tables that all pixels of a material share.

    Attributes
    ----------
    profile
        Diffusion profile, already scaled by ``params.scatter_scale``.
    params
        Parameters of the material.
    tables
        Lookup tables and normal blends.
    """

    profile: Profile
    params: SkinParams
    tables: SkinTables

    @classmethod
    def of(
        cls,
        profile: Profile,
        params: SkinParams,
        *,
        luts: Iterable[str] = ENGINE_LUTS,
        fetches: Iterable[int] = (3,),
    ) -> Skin:
        """Return the skin of a material and build its tables.

        Parameters
        ----------
        profile
            Diffusion profile as measured; ``params.scatter_scale`` scales it.
        params
            Parameters of the material.
        luts
            Names of the tables: ``ring``, ``sphere``, ``transfer``, ``shadow``, ``coat``, ``classic`` and
            ``classic_shadow``.
        fetches
            Numbers of normal map fetches, 2 or 3, whose weights are fitted.

        Raises
        ------
        ArgumentError
            If a name in `luts` is unknown.

        Examples
        --------
        >>> import skinshade as sk
        >>> skin = sk.Skin.of(sk.Profile.preset("skin-deon2007"), sk.SkinParams())
        >>> skin.lut("ring").values.shape
        (128, 512, 3)
        """
        scaled = profile.scaled(params.scatter_scale)
        return cls(scaled, params, SkinTables.build(scaled, params, luts, fetches))

    def including(self, luts: Iterable[str], fetches: Iterable[int] = ()) -> Skin:
        """Return the skin with additional tables (names `luts`) and weights (numbers `fetches`)."""
        return replace(self, tables=self.tables.including(luts, fetches))

    def with_params(self, params: SkinParams) -> Skin:
        """Return the skin with new parameters and the same tables.

        Parameters
        ----------
        params
            New parameters; those in `skinshade.shading.tables.BUILT_FOR` must have the same values.

        Raises
        ------
        ArgumentError
            If the tables do not fit the new parameters; the message names the parameter.
        """
        self.tables.check(params)
        return replace(self, params=params)

    def lut(self, name: str) -> Lut:
        """Return the table with this name in shaders.

        Raises
        ------
        ArgumentError
            If the skin was made without the table.
        """
        if name not in self.tables.luts:
            raise ArgumentError(
                f"the skin has no table {name!r}; make it with luts={(*self.tables.luts, name)}"
            )
        return self.tables.luts[name]

    def blend(self, fetches: int = 3) -> NormalBlend:
        """Return the weights for 2 or 3 fetches of the normal map.

        Raises
        ------
        ArgumentError
            If the skin was made without these weights.
        """
        if fetches not in self.tables.blends:
            raise ArgumentError(
                f"the skin has no weights of {fetches} fetches; make it with fetches=({fetches},)"
            )
        return self.tables.blends[fetches]

    def scatter_params(self, fetches: int = 3) -> ScatterParams:
        """Return the constants of the profile, the axes of the tables, and the weights for `fetches`.

        The axes of tables that the skin was made without have their default values.
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
            coat_reflectance=self.coat_reflectance,
            **{f"{name}_axes": lut.axes for name, lut in self.tables.luts.items()},
        )

    def transfer(self, k_per_mm: FloatArray) -> FloatArray:
        """Return the profile's T(k) (..., 3) at spatial frequencies `k_per_mm` (...), rad/mm."""
        return self.profile.kernel.transfer(k_per_mm)

    def specular_model(self, shading: Shading) -> SpecularModel:
        """Return the specular lobes under a `shading`; ``classic`` always has those of Blinn-Phong."""
        return SpecularModel.BLINN_PHONG if shading == Shading.CLASSIC else self.params.specular

    @property
    def boundary(self) -> Boundary:
        """Boundary through which scattered light leaves: that of the parameters, or else of the profile."""
        if self.params.boundary is not None:
            return self.params.boundary
        return Boundary(self.profile.closure) if self.profile.closure else Boundary.SMOOTH

    @property
    def coat_reflectance(self) -> float:
        """Reflectance at normal incidence that the coat's table was built for."""
        return self.tables.params.reflectance

    def __repr__(self) -> str:
        return f"Skin({self.profile!r}, tables {', '.join(self.tables.luts)})"

    @property
    def sigma_per_mm(self) -> FloatArray:
        """Decay of light that passes through the body, (3,), 1/mm."""
        default = default_sigma_per_mm(self.profile.rms_radius_mm)
        sigma = np.asarray(self.params.deep_scatter_sigma_per_mm)
        return np.where(sigma > 0.0, sigma, default)
