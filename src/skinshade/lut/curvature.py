"""The curvature table: diffused light over N·L and curvature (MODEL §2) [Penner2010]."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .._core.arrays import FloatArray
from .._core.version import __version__
from ..profile import Profile
from .spectral import DiffusionGeometry, diffuse_grid
from .table import Axis, Lut, checked_range, checked_size

__all__ = ["curvature_lut"]


def curvature_lut(
    profile: Profile,
    *,
    size: tuple[int, int] = (512, 512),
    radius_mm: tuple[float, float] = (1.0, 100.0),
    kernel: str = DiffusionGeometry.SPHERE,
    gain: Callable[[FloatArray], FloatArray] | None = None,
) -> Lut:
    """Tabulate diffuse light over N·L (columns, −1..1) and curvature (rows, linear in its root).

    Parameters
    ----------
    profile
        Any profile.
    size
        (width, height) in texels, 2..16384.
    radius_mm
        Least and greatest radius of curvature, mm.
    kernel
        ``sphere``, which conserves energy, or ``ring``, a cylinder lit across its axis.
    gain
        Function from curvature (m,), 1/mm, to factors (m, 3) of the rows; no factors if None.

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
    least, greatest = checked_range("radius_mm", radius_mm)
    geometry = DiffusionGeometry.of(kernel, "kernel")
    columns = Axis("n_dot_l", "1", -1.0, 1.0)
    rows = Axis("curvature", "1/mm", 1.0 / greatest, 1.0 / least, "sqrt")
    curvature = rows.centres(height)
    light = diffuse_grid(profile, columns.centres(width), curvature, geometry)
    if gain is not None:
        light *= gain(curvature)[:, None, :]
    provenance = {
        "profile": profile.name,
        "rms_radius_mm": profile.rms_radius_mm.tolist(),
        "albedo": profile.albedo.tolist(),
        "kernel": geometry.value,
        "energy_gain": gain is not None,
        "version": __version__,
    }
    return Lut(light.astype(np.float32), "curvature", columns, rows, provenance)
