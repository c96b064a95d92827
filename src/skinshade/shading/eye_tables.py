"""Tables of light on the iris, integrated over the cornea with both of its surfaces (docs/eyes.md §3)."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from .._core.arrays import FloatArray, FloatVector, dot
from .._core.cache import content_hash, load_cached, store_cached
from .._core.errors import ArgumentError
from .._core.harmonics import harmonics
from .._core.version import __version__
from ..lut import Axis, Lut
from ..params import EyeParams, EyePlaceParams
from .ambient import COSINE_BANDS
from .eye_light import (
    EYE_COLUMNS,
    EYE_LEAST_COSINE,
    EYE_ROWS,
    EYE_SLICES,
    EYE_WARP,
)
from .eye_rays import PARTS, quasirandom_parts, through_cornea

__all__ = ["EYE_LUTS", "TABLES_HOLD", "EyeLuts", "build_eye_lut", "eye_place"]

EYE_LUTS = ("lamp", "surroundings")
"""Names of the tables. In shaders and files, a table is ``eye_<name>_lut``."""
TABLES_HOLD = (
    "sclera_radius_mm",
    "limbus_radius_mm",
    "limbus_width_mm",
    "cornea_radius_mm",
    "cornea_asphericity",
    "tear_index",
    "aqueous_index",
    "iris_depth_mm",
    "iris_slope",
    "iris_radius_mm",
)
"""Parameters that the tables depend on. The tables end on the cone of the iris, so the pupil is not one."""
LAMP_ANGLE = np.radians(3.0)
"""Half angle of the lamp of the table; the bright folds of a point's light would be finer than the table."""
LAMP_RAYS, ENTRY_GRID = 48, 72
"""Directions of a part, and side of the grid of entries of each of them, for the table of a lamp."""
SKY_RAYS = 1 << 16
"""Rays of a part for the table of the surroundings."""
SMOOTHING = 0.2
"""Weight of second differences in the table of the surroundings, over that of the texel next to the axis."""
RADII = 32
"""Distances from the axis in the table of the surroundings."""


@dataclass(frozen=True)
class EyeLuts:
    """Tables of the light on the iris of an eye.

    Attributes
    ----------
    lamp
        Light of a lamp, and where it entered: argument of `skinshade.shading.eye_light.eye_light`.
    surroundings
        Factors of the light of surroundings: argument of `skinshade.shading.eye_light.eye_ambient`.

    Examples
    --------
    >>> import skinshade as sk
    >>> luts = sk.build_eye_lut()
    >>> luts.save("eye")
    >>> sk.EyeLuts.load("eye").lamp.values.shape
    (256, 32, 3)
    """

    lamp: Lut
    surroundings: Lut

    def __post_init__(self) -> None:
        for name in EYE_LUTS:
            lut: Lut = getattr(self, name)
            if lut.kind != f"eye-{name}":
                raise ArgumentError(f"{name}: kind is {lut.kind!r}; it must be 'eye-{name}'")

    def by_name(self) -> dict[str, Lut]:
        """Return the tables by the names of `EYE_LUTS`."""
        return {"lamp": self.lamp, "surroundings": self.surroundings}

    def check(self, params: EyeParams) -> None:
        """Check that the tables fit the parameters `params` of an eye.

        Raises
        ------
        ArgumentError
            If a parameter needs new tables; the message names the parameter.
        """
        for name in TABLES_HOLD:
            built, value = self.lamp.provenance.get(name), getattr(params, name)
            if built != value:
                raise ArgumentError(
                    f"{name} is {value}, but the tables of the eye were built for {built}; call"
                    " build_eye_lut with the new parameters"
                )

    def save(self, folder: str | os.PathLike[str], suffix: str = ".exr") -> None:
        """Write the tables into a folder, as ``eye_lamp_lut`` and ``eye_surroundings_lut`` with a suffix.

        Raises
        ------
        ArgumentError, OutputError
            If the suffix is not one of `Lut.save`, or a file cannot be written.
        """
        target = Path(folder)
        target.mkdir(parents=True, exist_ok=True)
        for name in EYE_LUTS:
            getattr(self, name).save(target / f"eye_{name}_lut{suffix}")

    @classmethod
    def load(cls, folder: str | os.PathLike[str], suffix: str = ".exr") -> EyeLuts:
        """Return the tables of a folder that `save` wrote.

        Parameters
        ----------
        folder
            Folder with the two files.
        suffix
            Suffix of the files.

        Raises
        ------
        LutFileError, ArgumentError
            If a file is missing or corrupt, or holds another table.
        """
        return cls(*(Lut.load(Path(folder) / f"eye_{name}_lut{suffix}") for name in EYE_LUTS))


def eye_place(luts: Mapping[str, Lut], placement: EyePlaceParams | None = None) -> EyePlaceParams:
    """Return the placement of an eye with the axes of its tables.

    Parameters
    ----------
    luts
        Tables by name, of `EyeLuts.by_name`.
    placement
        Placement of the eye; in the origin, with the lids' default opening, if None.
    """
    return replace(
        EyePlaceParams() if placement is None else placement,
        lamp_axes=luts["lamp"].axes,
        surroundings_axes=luts["surroundings"].axes,
    )


def build_eye_lut(params: EyeParams | None = None) -> EyeLuts:
    """Return the tables of the light on the iris of an eye, for lamps and for surroundings.

    Parameters
    ----------
    params
        Parameters of the eye; the defaults if None. The pupil, the maps and the roughness do not matter.

    Returns
    -------
    EyeLuts
        The same on every call: rays start at the points of a fixed sequence. The values are kept in the
        user's cache.

    Examples
    --------
    >>> import numpy as np
    >>> import skinshade as sk
    >>> from skinshade.shading.eye_light import eye_light
    >>> luts = sk.build_eye_lut()
    >>> middle, ahead = np.array([0.0, 0.0, 9.4]), np.array([0.0, 0.0, 1.0])
    >>> float(eye_light(luts.lamp, middle, ahead)[0].round(1))  # the cornea collects light
    1.2
    """
    chosen = EyeParams() if params is None else params
    name = content_hash("eye-1", *(float(getattr(chosen, field)) for field in TABLES_HOLD))
    arrays = load_cached(name)
    if arrays is None or set(arrays) != set(EYE_LUTS):
        lamp, surroundings = _lamp_values(chosen), _surroundings_values(chosen)
        arrays = {"lamp": lamp.astype(np.float32), "surroundings": surroundings.astype(np.float32)}
        store_cached(name, arrays)
    rim = chosen.iris_radius_mm
    provenance = {
        **{field: getattr(chosen, field) for field in TABLES_HOLD},
        "version": __version__,
    }
    wide, step = rim * EYE_COLUMNS / (EYE_COLUMNS - 1.0), rim / (RADII - 1.0)
    axes = {
        "lamp": (
            Axis("x", "mm", -wide, wide),
            Axis("row of y, in slices of the angle", "1", 0.0, EYE_SLICES * EYE_ROWS),
        ),
        "surroundings": (
            Axis("r", "mm", -0.5 * step, rim + 0.5 * step),
            Axis("bands, tilt", "1", -0.5, 1.5),
        ),
    }
    return EyeLuts(
        Lut(np.asarray(arrays["lamp"]), "eye-lamp", *axes["lamp"], provenance),
        Lut(
            np.asarray(arrays["surroundings"]),
            "eye-surroundings",
            *axes["surroundings"],
            provenance,
        ),
    )


# -- tables ----------------------------------------------------------------------------------------


def _mass(count: int, low: float, high: float) -> FloatArray:
    """Return the integrals (count, count) of products of the hat functions of evenly spaced nodes."""
    step = (high - low) / (count - 1.0)
    diagonal = np.full(count, 2.0 / 3.0)
    diagonal[[0, -1]] = 1.0 / 3.0
    beside = np.full(count - 1, 1.0 / 6.0)
    return step * (np.diag(diagonal) + np.diag(beside, 1) + np.diag(beside, -1))


def _hats(position: FloatArray, count: int) -> list[tuple[FloatArray, FloatArray]]:
    """Return the node and the value of both hat functions at positions (n,) in units of the spacing."""
    low = np.clip(np.floor(position), 0.0, count - 2.0)
    weight = position - low
    return [(low, 1.0 - weight), (low + 1.0, weight)]


def _lamp_values(params: EyeParams) -> FloatArray:
    """Return the values (slices·rows, columns, 3) of the table of a lamp.

    The irradiance is the function of least squared error among those that interpolate linearly between the
    slices and the texels. The entry is the mean of that of the light around a texel.
    """
    rim, outer = params.iris_radius_mm, params.limbus_radius_mm + params.limbus_width_mm
    slices, rows, columns = int(EYE_SLICES), int(EYE_ROWS), int(EYE_COLUMNS)
    least = -((-EYE_LEAST_COSINE) ** EYE_WARP)
    sums = np.zeros((3, slices * rows * columns))
    side = (np.arange(ENTRY_GRID) + 0.5) / ENTRY_GRID
    grid_x, grid_y = (grid.reshape(1, -1) for grid in np.meshgrid(side, side))
    for u in quasirandom_parts(LAMP_RAYS, 4):
        warped = least + (1.0 - least) * u[0]
        cosine = np.sign(warped) * np.abs(warped) ** (1.0 / EYE_WARP)
        light = _lamp_directions(cosine, u[1], u[2])
        # Each direction has the grid of entries at another shift.
        x = outer * (2.0 * ((grid_x + u[3][:, None]) % 1.0) - 1.0).ravel()
        y = outer * (2.0 * ((grid_y + u[4][:, None]) % 1.0) - 1.0).ravel()
        light, level = np.repeat(light, grid_x.size, axis=0), np.repeat(u[0], grid_x.size)
        inside = x * x + y * y < outer * outer
        x, y, light, level = x[inside], y[inside], light[inside], level[inside]
        hit_x, hit_y, flux = through_cornea(params, x, y, light)
        used = (flux > 0.0) & (np.abs(hit_x) < rim) & (np.abs(hit_y) < rim)
        hit_x, hit_y, flux = hit_x[used], hit_y[used], flux[used]
        moved = (flux, flux * x[used], flux * y[used] * np.sign(hit_y))
        for k, weight_k in _hats(level[used] * (slices - 1.0), slices):
            for j, weight_j in _hats(np.abs(hit_y) / rim * (rows - 1.0), rows):
                for i, weight_i in _hats((hit_x / rim + 1.0) * 0.5 * (columns - 1.0), columns):
                    index = ((k * rows + j) * columns + i).astype(np.int64)
                    weight = weight_k * weight_j * weight_i
                    for total, part in zip(sums, moved, strict=True):
                        total += np.bincount(index, part * weight, total.size)
    area = 4.0 * outer * outer / (PARTS * LAMP_RAYS * ENTRY_GRID**2)
    loads = sums.reshape(3, slices, rows, columns)
    cone = np.sqrt(1.0 + params.iris_slope**2)
    energy = loads[0] * area / (2.0 * cone)  # both halves fall on one
    for axis, mass in enumerate(
        (_mass(slices, 0.0, 1.0), _mass(rows, 0.0, rim), _mass(columns, -rim, rim))
    ):
        load = np.moveaxis(energy, axis, 0)
        first = 1 if axis == 0 else 0  # no light at the greatest angle
        solved = np.zeros((len(mass), load[0].size))
        solved[first:] = np.linalg.solve(
            mass[first:, first:], load[first:].reshape(-1, load[0].size)
        )
        energy = np.moveaxis(solved.reshape(load.shape), 0, axis)
    entry = _filled(loads[1:], loads[0])
    entry[1, :, 0, :] = 0.0
    # Straight light has no side: the slice is equal on both.
    energy[-1] = 0.5 * (energy[-1] + energy[-1, :, ::-1])
    entry[0, -1] = 0.5 * (entry[0, -1] - entry[0, -1, :, ::-1])
    entry[1, -1] = 0.5 * (entry[1, -1] + entry[1, -1, :, ::-1])
    table = np.stack([np.maximum(energy, 0.0), entry[0], entry[1]], axis=-1)
    return table.reshape(slices * rows, columns, 3)


def _lamp_directions(cosine: FloatArray, u: FloatArray, v: FloatArray) -> FloatArray:
    """Return unit vectors (n, 3) to points u, v (n,) of a lamp at an angle of a cosine (n,) to the gaze."""
    sine = np.sqrt(np.maximum(1.0 - cosine * cosine, 0.0))
    polar = LAMP_ANGLE * np.sqrt(u)
    a, b = np.sin(polar) * np.cos(2.0 * np.pi * v), np.sin(polar) * np.sin(2.0 * np.pi * v)
    c = np.cos(polar)
    return np.stack([sine * c + cosine * a, b, cosine * c - sine * a], axis=-1)


def _filled(sums: FloatArray, weights: FloatArray) -> FloatArray:
    """Return the means sums/weights of grids; a texel without light takes that of the nearest with light."""
    from scipy.ndimage import distance_transform_edt

    lit = weights > 1e-3 * weights.max()
    means = sums / np.where(lit, weights, 1.0)
    nearest = distance_transform_edt(~lit, return_distances=False, return_indices=True)
    result: FloatArray = means[:, *nearest]
    return result


def _surroundings_values(params: EyeParams) -> FloatArray:
    """Return the values (2, radii, 3) of the table of surroundings: factors of the bands, and the tilt."""
    outer, rim = params.limbus_radius_mm + params.limbus_width_mm, params.iris_radius_mm
    sums = np.zeros((9, RADII))
    for u in quasirandom_parts(SKY_RAYS, 2):
        z = EYE_LEAST_COSINE + (1.0 - EYE_LEAST_COSINE) * u[0]
        sine, phi = np.sqrt(1.0 - z * z), 2.0 * np.pi * u[1]
        light = np.stack([sine * np.cos(phi), sine * np.sin(phi), z], axis=-1)
        x = outer * u[2]
        hit_x, hit_y, flux = through_cornea(params, x, np.zeros_like(x), light)
        r = np.hypot(hit_x, hit_y)
        used = (flux > 0.0) & (r < rim)
        hit_x, hit_y, r, light = hit_x[used], hit_y[used], r[used], light[used]
        flux = flux[used] * 2.0 * u[2][used]  # the area of rings grows with their radius
        cosine, turned = hit_x / r, hit_y / r
        around = np.stack(
            [
                light[:, 0] * cosine + light[:, 1] * turned,
                light[:, 1] * cosine - light[:, 0] * turned,
                light[:, 2],
            ],
            axis=-1,
        )
        values = harmonics(around, 2)
        for i, weight in _hats(r / rim * (RADII - 1.0), RADII):
            index = i.astype(np.int64)
            for total, value in zip(sums, values.T, strict=True):
                total += np.bincount(index, flux * weight * value, RADII)
    solid_angle = 2.0 * np.pi * (1.0 - EYE_LEAST_COSINE)
    scale = (
        solid_angle * outer * outer / (PARTS * SKY_RAYS)
    )  # π of the area over π of the irradiance
    cone = np.sqrt(1.0 + params.iris_slope**2)
    response = np.linalg.solve(_radial_mass(rim), sums.T * (scale / cone))
    # Few rays meet the axis. Every response is even there, and that to one side of it is 0.
    response[0] = (4.0 * response[1] - response[2]) / 3.0
    response[0, 3] = 0.0
    return _band_factors(response)


def _radial_mass(rim: float) -> FloatArray:
    """Return the integrals of products of hat functions of the radius over a disk, and a little more.

    The addition penalises the second differences of a solution as little as decides at the few texels near
    the axis, which few rays meet.
    """
    nodes, weights = np.polynomial.legendre.leggauss(3)
    step = rim / (RADII - 1.0)
    mass = np.zeros((RADII, RADII))
    for cell in range(RADII - 1):
        for node, weight in zip(0.5 + 0.5 * nodes, 0.5 * weights, strict=True):
            hats = np.array([1.0 - node, node])
            ring = 2.0 * np.pi * (cell + node) * step * step * weight
            mass[cell : cell + 2, cell : cell + 2] += ring * np.outer(hats, hats)
    second = np.diff(np.eye(RADII), 2, axis=0)
    return mass + 2.0 * np.pi * step * step * SMOOTHING * second.T @ second


def _band_factors(response: FloatArray) -> FloatArray:
    """Return the table (2, n, 3) for harmonics (n, 9) of the response of points on +x.

    Bands 0 and 1 are exact; band 2 is its part that is symmetrical around the tilted normal.
    """
    tilt = np.arctan2(response[:, 3], response[:, 2])
    normal: FloatArray = np.stack([np.sin(tilt), np.zeros_like(tilt), np.cos(tilt)], axis=-1)
    own = harmonics(normal, 2)
    table = np.zeros((2, len(response), 3))
    for band, part in enumerate((slice(0, 1), slice(1, 4), slice(4, 9))):
        size: FloatVector = dot(own[:, part], own[:, part]) * COSINE_BANDS[band]
        table[0, :, band] = dot(response[:, part], own[:, part]) / size
    table[1, :, 0] = tilt
    return table
