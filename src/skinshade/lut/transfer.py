"""Tables of transfer functions, for shaders."""

from __future__ import annotations

import numpy as np

from .._core.version import __version__
from ..profile import Profile
from .table import Axis, Lut, checked_size

__all__ = ["build_transfer_lut"]


def build_transfer_lut(
    profile: Profile,
    *,
    size: tuple[int, int] = (2048, 2),
    k_per_mm: tuple[float, float] = (0.0, 16.0),
) -> Lut:
    """Tabulate T(k), the share of contrast that diffusion leaves at a spatial frequency.

    Parameters
    ----------
    profile
        Any profile.
    size
        (width, height) in texels, 2..16384; all rows are equal.
    k_per_mm
        Least and greatest spatial frequency, rad/mm.

    Returns
    -------
    Lut
        Columns in equal steps of √k: T changes fastest at small k.

    Raises
    ------
    ArgumentError
        If a size or frequency is out of range.

    Examples
    --------
    >>> import skinshade as sk
    >>> sk.build_transfer_lut(sk.Profile.preset("marble")).sample(0.0, 0.0).round(2)
    array([1., 1., 1.])
    """
    width, height = checked_size(size)
    columns = Axis("k", "rad/mm", *k_per_mm, spacing="sqrt")
    values = profile.transfer(columns.centres(width)).astype(np.float32)
    provenance = {
        "profile": profile.name,
        "rms_radius_mm": profile.rms_radius_mm.tolist(),
        "albedo": profile.albedo.tolist(),
        "version": __version__,
    }
    return Lut(
        np.repeat(values[None], height, axis=0),
        "transfer",
        columns,
        Axis("any", "1", 0.0, 1.0),
        provenance,
    )
