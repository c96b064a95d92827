"""Lookup tables of a material, built before any thread or device needs them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import partial

from .._core.arrays import FloatArray
from .._core.errors import ArgumentError
from ..lut import Lut, build_coat_lut, build_shadow_lut, build_transfer_lut, curvature_lut
from ..lut.classic import classic_curvature_lut, classic_shadow_lut
from ..lut.spectral import DiffusionGeometry
from ..params import SkinParams
from ..profile import Profile
from .energy import energy_gain as gain_of
from .normals import NormalBlend, normal_blend
from .shadow import LEAST_COSINE

__all__ = ["ENGINE_LUTS", "LUTS", "SkinTables", "build_curvature_lut"]

RADIUS_MM = (0.5, 4000.0)
"""Radii in the curvature tables: from the line of the lashes to a radius that is flat for any profile."""
CURVATURE_SIZE = (512, 128)
"""Columns and rows of the curvature tables."""
SHADOW_SIZE = (512, 64)
"""Columns and rows of the shadow tables and of the curvature table of 2014."""

BUILT_FOR = ("scatter_scale", "shadow_filter_width_mm", "shadow_sharpening")
"""Parameters that the values of the tables depend on."""


def build_curvature_lut(
    profile: Profile,
    *,
    size: tuple[int, int] = (512, 512),
    radius_mm: tuple[float, float] = (1.0, 100.0),
    kernel: str = DiffusionGeometry.SPHERE,
    energy_gain: bool = True,
) -> Lut:
    """Return a table of diffuse light over N·L (columns, −1..1) and curvature (rows, linear in its root).

    Parameters
    ----------
    profile
        Diffusion profile; only the energy gain depends on its albedo.
    size
        (width, height) of the table, texels, 2..16384.
    radius_mm
        Least and greatest radius of curvature, mm.
    kernel
        ``sphere``, which conserves energy and fits a head, or ``ring``, a cylinder lit across its axis,
        which the tensor tier of `skinshade.shading.direct` uses.
    energy_gain
        Whether to multiply by the energy gain of a curved body. Turn it off if the shader multiplies by
        the gain.

    Returns
    -------
    Lut
        Table whose values at the texel centres are within 1e-6 of the integral.

    Raises
    ------
    ArgumentError
        If a size or a radius is out of range, or the kernel is unknown.

    Examples
    --------
    >>> import skinshade as sk
    >>> lut = sk.build_curvature_lut(sk.Profile.preset("skin-deon2007"), size=(64, 32))
    >>> lut.sample(1.0, 0.1).round(3)  # facing the light, on a radius of 10 mm
    array([1.08 , 1.017, 1.007])
    """
    gain = None
    if energy_gain:
        gain = partial(_gain_of_rows, profile)
    return curvature_lut(profile, size=size, radius_mm=radius_mm, kernel=kernel, gain=gain)


def _gain_of_rows(profile: Profile, curvature_per_mm: FloatArray) -> FloatArray:
    """Return the energy gain (n, 3) for the curvature (n,) of each row."""
    return gain_of(profile.albedo, profile.rms_radius_mm, curvature_per_mm[:, None])


def _curvature(kernel: DiffusionGeometry, profile: Profile, params: SkinParams) -> Lut:
    return curvature_lut(profile, size=CURVATURE_SIZE, radius_mm=RADIUS_MM, kernel=kernel)


def _transfer(profile: Profile, params: SkinParams) -> Lut:
    return build_transfer_lut(profile)


def _shadow(profile: Profile, params: SkinParams) -> Lut:
    width = params.shadow_filter_width_mm
    return build_shadow_lut(
        profile,
        size=SHADOW_SIZE,
        width_mm=(width, width / LEAST_COSINE),
        sharpening=params.shadow_sharpening,
    )


def _classic(profile: Profile, params: SkinParams) -> Lut:
    return classic_curvature_lut(profile, size=SHADOW_SIZE)


def _classic_shadow(profile: Profile, params: SkinParams) -> Lut:
    return classic_shadow_lut(profile, size=SHADOW_SIZE, sharpening=params.shadow_sharpening)


def _coat(profile: Profile, params: SkinParams) -> Lut:
    return build_coat_lut(reflectance=params.reflectance)


LUTS: dict[str, Callable[[Profile, SkinParams], Lut]] = {
    "ring": partial(_curvature, DiffusionGeometry.RING),
    "sphere": partial(_curvature, DiffusionGeometry.SPHERE),
    "transfer": _transfer,
    "shadow": _shadow,
    "classic": _classic,
    "classic_shadow": _classic_shadow,
    "coat": _coat,
}
"""Functions that build the tables, by name. In shaders, a table is ``<name>_lut`` with ``<name>_axes``."""
ENGINE_LUTS = ("ring", "sphere", "transfer", "shadow", "coat")
"""Names of the tables that engines need; the others are for comparison with the system of 2014."""


@dataclass(frozen=True)
class SkinTables:
    """Lookup tables and normal blends of one material.

    Attributes
    ----------
    profile
        Profile that the tables were built for, already scaled by ``params.scatter_scale``.
    params
        Parameters that the tables were built for.
    luts
        Tables by name, each a key of `LUTS`.
    blends
        Weights of the fetches of the normal map, by the number of fetches.
    """

    profile: Profile
    params: SkinParams
    luts: Mapping[str, Lut]
    blends: Mapping[int, NormalBlend]

    @classmethod
    def build(
        cls,
        profile: Profile,
        params: SkinParams,
        luts: Iterable[str] = ENGINE_LUTS,
        fetches: Iterable[int] = (3,),
    ) -> SkinTables:
        """Return new tables.

        Parameters
        ----------
        profile
            Diffusion profile, already scaled by ``params.scatter_scale``.
        params
            Parameters of the material.
        luts
            Names of the tables.
        fetches
            Numbers of normal map fetches, 2 or 3.

        Raises
        ------
        ArgumentError
            If a name in `luts` is unknown.
        """
        return cls(profile, params, {}, {}).including(luts, fetches)

    def including(self, luts: Iterable[str], fetches: Iterable[int] = ()) -> SkinTables:
        """Return these tables and additional ones; existing tables are not built again.

        Raises
        ------
        ArgumentError
            If a name in `luts` is unknown.
        """
        added_luts, added_blends = {}, {}
        for name in luts:
            if name not in LUTS:
                raise ArgumentError(f"there is no table {name!r}; there are {', '.join(LUTS)}")
            if name not in self.luts:
                added_luts[name] = LUTS[name](self.profile, self.params)
        for count in fetches:
            if count not in self.blends:
                added_blends[count] = normal_blend(self.profile, fetches=count)
        if not added_luts and not added_blends:
            return self
        return replace(
            self, luts={**self.luts, **added_luts}, blends={**self.blends, **added_blends}
        )

    def check(self, params: SkinParams) -> None:
        """Check that the tables fit other parameters.

        Raises
        ------
        ArgumentError
            If a parameter needs new tables; the message names the parameter.
        """
        for name in BUILT_FOR:
            built, value = getattr(self.params, name), getattr(params, name)
            if built != value:
                raise ArgumentError(
                    f"{name} is {value}, but the tables were built for {built}; make a Skin with the"
                    " new parameters"
                )
