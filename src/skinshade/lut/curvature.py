"""The curvature table: diffused light over N·L and curvature (MODEL §2) [Penner2010]."""

from __future__ import annotations

import numpy as np

from .._core.arrays import as_floats
from .._core.errors import ArgumentError
from .._core.version import __version__
from ..profile import Profile
from ..profile.energy import energy_gain as gain_of
from .spectral import DiffusionGeometry, diffuse_grid
from .table import Axis, Lut, checked_size

__all__ = ["build_curvature_lut"]


def build_curvature_lut(
    profile: Profile,
    *,
    size: tuple[int, int] = (512, 512),
    radius_mm: tuple[float, float] = (1.0, 100.0),
    kernel: DiffusionGeometry = "sphere",
    energy_gain: bool = True,
) -> Lut:
    """Tabulate diffuse light over N·L (columns, −1..1) and curvature (rows, linear in its root).

    Parameters
    ----------
    profile
        Any profile; its albedo enters through the energy gain alone.
    size
        (width, height) in texels, 2..16384.
    radius_mm
        Least and greatest radius of curvature, mm.
    kernel
        ``sphere`` conserves energy and fits a head; ``ring`` is the cylinder of the 2010 talk, and
        what the tensor tier of `skinshade.shading.direct` looks up.
    energy_gain
        Multiply by `skinshade.profile.energy.energy_gain`. Leave it off where the shader does so.

    Returns
    -------
    Lut
        Within 1e-6 of the integral at the texel centres.

    Raises
    ------
    ArgumentError
        If a size or radius is out of range, or the kernel unknown.
    """
    width, height = checked_size(size)
    least, greatest = as_floats("radius_mm", radius_mm, (2,))
    if not 0.0 < least < greatest:
        raise ArgumentError(f"radius_mm is ({least:g}, {greatest:g}); needs 0 < least < greatest")
    if kernel not in ("sphere", "ring"):
        raise ArgumentError(f"kernel is {kernel!r}; it must be sphere or ring")
    columns = Axis("n_dot_l", "1", -1.0, 1.0)
    rows = Axis("curvature", "1/mm", 1.0 / greatest, 1.0 / least, "sqrt")
    curvature = rows.centres(height)
    light = diffuse_grid(profile, columns.centres(width), curvature, kernel)
    if energy_gain:
        light *= gain_of(profile.albedo, profile.rms_radius_mm, curvature[:, None])[:, None, :]
    provenance = {
        "profile": profile.name,
        "rms_radius_mm": profile.rms_radius_mm.tolist(),
        "albedo": profile.albedo.tolist(),
        "kernel": kernel,
        "energy_gain": energy_gain,
        "version": __version__,
    }
    return Lut(light.astype(np.float32), "curvature", columns, rows, provenance)
