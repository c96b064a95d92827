"""Light from the surroundings: an equirectangular image, its harmonics and its reflections."""

from __future__ import annotations

import os
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from .._core.arrays import (
    LARGEST_LIGHT,
    LARGEST_RADIANCE,
    FloatArray,
    ImageArray,
    as_floats,
    as_rgb,
)
from .._core.errors import ArgumentError, ImageFileError
from .._core.harmonics import harmonics
from ..shading.image_light import (
    LEVEL_SIZE,
    LOBE_POWERS,
    PreconvolvedRadiance,
    bilinear,
    equirectangular_uv,
)
from .equirectangular import averaged, grid_directions, row_solid_angle
from .images import read_linear

__all__ = ["Environment"]

BANDS = 64
"""Harmonics kept for reflections: a Phong lobe of power p needs about 2√(p+1) of them."""
WORK_SIZE = (256, 128)


@dataclass(frozen=True, repr=False)
class Environment:
    """Equirectangular image of radiance.

    Attributes
    ----------
    radiance
        (H, W, 3) linear, 0..1e9; u = ½ + atan2(z, x)/2π, v = acos(y)/π from the top.
    scale
        Factor on the radiance, 0..1e6.
    visible
        Show the environment behind the body.
    extract_sun
        Draw the sun of the image as a light with a shadow, see `skinshade.split_sun`. The background
        shows the image with its sun.

    Examples
    --------
    >>> import skinshade as sk
    >>> sk.Environment.studio(scale=0.5)
    Environment(256×128, scale=0.5, visible=False)
    """

    radiance: ImageArray
    scale: float = 1.0
    visible: bool = False
    extract_sun: bool = True

    def __post_init__(self) -> None:
        try:
            image = np.asarray(self.radiance, dtype=np.float32)
        except (TypeError, ValueError, OverflowError) as error:
            raise ArgumentError(
                f"environment radiance: not an array of numbers ({error})"
            ) from None
        if image.ndim != 3 or image.shape[2] != 3 or min(image.shape[:2]) < 2:
            raise ArgumentError(
                f"environment radiance: shape is {image.shape}; it must be (H, W, 3) with H and"
                " W 2 or more"
            )
        object.__setattr__(self, "radiance", image)
        if not (image.min() >= 0.0 and image.max() <= LARGEST_RADIANCE):  # false for NaN
            raise ArgumentError(
                f"environment radiance: values reach from {image.min():g} to {image.max():g}; all must be"
                f" finite, not negative, and {LARGEST_RADIANCE:g} or less"
            )
        as_floats("environment scale", self.scale, (), low=0.0, high=LARGEST_LIGHT)

    @classmethod
    def load(
        cls,
        path: str | os.PathLike[str],
        *,
        scale: float = 1.0,
        visible: bool = False,
        extract_sun: bool = True,
    ) -> Environment:
        """Read an equirectangular image.

        Parameters
        ----------
        path
            ``.hdr`` or ``.exr``, linear, or any other image, sRGB; negative values become 0.
        scale
            Factor on the radiance, 0..1e6.
        visible
            Show the environment behind the body.
        extract_sun
            Draw the sun of the image as a light with a shadow.

        Raises
        ------
        ImageFileError
            If the file cannot be read, or a value is above 1e9.
        """
        image = read_linear(path)
        np.maximum(image, 0.0, out=image)
        if image.max() > LARGEST_RADIANCE:
            raise ImageFileError(
                f"{path}: its radiance reaches {image.max():g}; the greatest is {LARGEST_RADIANCE:g}"
            )
        return cls(image, scale, visible, extract_sun)

    @classmethod
    def constant(cls, radiance: ArrayLike, *, scale: float = 1.0) -> Environment:
        """Return an environment with the same radiance in all directions.

        Parameters
        ----------
        radiance
            (3,) or scalar, linear, 0..1e9.
        scale
            Factor on the radiance, 0..1e6.

        Raises
        ------
        ArgumentError
            If a value is out of range, or the radiance is not one number or three.
        """
        colour = as_rgb("environment radiance", radiance, low=0.0, high=LARGEST_RADIANCE)
        return cls(
            np.ascontiguousarray(np.broadcast_to(colour.astype(np.float32), (16, 32, 3))), scale
        )

    @classmethod
    def studio(cls, *, scale: float = 1.0) -> Environment:
        """Return the built-in studio: a large soft key light, a fill light, a rim light and dark walls.

        Parameters
        ----------
        scale
            Factor on the radiance, 0..1e6.
        """
        height, width = WORK_SIZE[1], WORK_SIZE[0]
        directions = grid_directions(height, width)
        image = np.full((height, width, 3), 0.06) * (0.6 + 0.4 * directions[..., 1:2])
        image += np.array([0.05, 0.04, 0.03]) * np.maximum(-directions[..., 1:2], 0.0)
        panels = (
            ((-0.62, 0.45, 0.64), 0.50, (3.6, 3.4, 3.1)),  # key, warm, from the upper left
            ((0.85, 0.10, 0.50), 0.55, (0.42, 0.46, 0.55)),  # fill, cool
            ((0.55, 0.35, -0.75), 0.30, (2.6, 2.7, 2.9)),  # rim, from behind
            ((-0.75, 0.20, -0.60), 0.22, (1.2, 1.2, 1.2)),
        )
        for centre, radius, colour in panels:
            angle = np.arccos(
                np.clip(directions @ (np.array(centre) / np.linalg.norm(centre)), -1, 1)
            )
            edge = np.clip((radius - angle) / 0.12 + 0.5, 0.0, 1.0)[..., None]
            image += np.array(colour) * edge * edge * (3.0 - 2.0 * edge)
        return cls(image.astype(np.float32), scale)

    @cached_property
    def _coarse(self) -> FloatArray:
        """Radiance (H, W, 3) averaged to `WORK_SIZE`, on which sums over the sphere are taken."""
        return averaged(self.radiance, WORK_SIZE)

    def radiance_sh(self, order: int = 2) -> FloatArray:
        """Return the harmonics ((order + 1)², 3) of the radiance, in the order of ``sh_basis``.

        Parameters
        ----------
        order
            Greatest band, 0..4.
        """
        image = self._coarse
        height, width = image.shape[:2]
        directions = grid_directions(height, width).reshape(-1, 3)
        weights = np.repeat(row_solid_angle(height) / width, width)
        # The mean has one harmonic; a sum over texels would give it others.
        light = image.reshape(-1, 3)
        mean = weights @ light / weights.sum()
        result = np.einsum("nb,n,nc->bc", harmonics(directions, order), weights, light - mean)
        result[0] += np.sqrt(4.0 * np.pi) * mean
        return self.scale * result

    def means_around(self, directions: FloatArray) -> FloatArray:
        """Return the mean radiance (S, D, 3) of the cells of sets (S, D, 3) of evenly spread directions.

        The cell of a direction has the texels that are nearer to it than to the others of its set.
        """
        image = self._coarse
        height, width = image.shape[:2]
        texels = grid_directions(height, width).reshape(-1, 3)
        weights = np.repeat(row_solid_angle(height) / width, width)
        light = weights[:, None] * image.reshape(-1, 3)
        result = np.empty(directions.shape)
        for means, own in zip(result, directions, strict=True):
            nearest = np.concatenate(
                [(rows @ own.T).argmax(axis=1) for rows in np.array_split(texels, height // 8)]
            )
            flux = [np.bincount(nearest, column, len(own)) for column in light.T]
            covered = np.bincount(nearest, weights, len(own))
            means[:] = self.scale * np.stack(flux, axis=1) / np.maximum(covered, 1e-12)[:, None]
        return result

    def preconvolved(self) -> PreconvolvedRadiance:
        """Return reflections at every roughness, by damping harmonics, which is smooth at any power."""
        image = self._coarse
        # Quadrature over the half of the sphere on which the lobe is not 0.
        nodes, weights = np.polynomial.legendre.leggauss(2 * BANDS)
        nodes = 0.5 + 0.5 * nodes
        levels = []
        analysis, synthesis = _zonal_machinery(image.shape[0], LEVEL_SIZE[1])
        spectrum = np.fft.rfft(image, axis=1)[:, : BANDS + 1] / image.shape[1]
        for power in LOBE_POWERS:
            lobe = nodes**power
            damping = np.polynomial.legendre.legvander(nodes, BANDS).T @ (weights * lobe)
            damping /= weights @ lobe
            rows = np.zeros((LEVEL_SIZE[1], LEVEL_SIZE[0] // 2 + 1, 3), dtype=np.complex128)
            for m in range(min(BANDS, LEVEL_SIZE[0] // 2) + 1):
                coefficients = analysis[m] @ spectrum[:, m]
                rows[:, m] = synthesis[m].T @ (damping[m:, None] * coefficients)
            smooth = np.fft.irfft(rows * LEVEL_SIZE[0], n=LEVEL_SIZE[0], axis=1)
            smooth = _shifted_to_centres(smooth, image.shape[1])
            levels.append(np.maximum(smooth, 0.0) * self.scale)
        return PreconvolvedRadiance(np.stack(levels).astype(np.float32))

    def sample(self, directions: FloatArray) -> FloatArray:
        """Return radiance (..., 3) from unit directions (..., 3), bilinear."""
        u, v = equirectangular_uv(directions)
        image = self.radiance[None]
        return self.scale * bilinear(image, np.zeros(u.shape, dtype=np.int64), u, v)

    def __repr__(self) -> str:
        height, width = self.radiance.shape[:2]
        return f"Environment({width}×{height}, scale={self.scale:g}, visible={self.visible})"


def _zonal_machinery(rows_in: int, rows_out: int) -> tuple[list[FloatArray], list[FloatArray]]:
    """Return matrices (l, rows) from rows to harmonics of each order m, and back."""
    x_in = np.cos((np.arange(rows_in) + 0.5) / rows_in * np.pi)
    x_out = np.cos((np.arange(rows_out) + 0.5) / rows_out * np.pi)
    weights = row_solid_angle(rows_in)
    analysis = [table * weights for table in _associated_legendre(x_in)]
    return analysis, _associated_legendre(x_out)


def _associated_legendre(x: FloatArray) -> list[FloatArray]:
    """Return orthonormal P_l^m for m = 0..BANDS, l = m..BANDS, as (l, rows) for each m."""
    sine = np.sqrt(1.0 - x * x)
    diagonal = np.full_like(x, np.sqrt(1.0 / (4.0 * np.pi)))
    tables = []
    for m in range(BANDS + 1):
        table = np.zeros((BANDS - m + 1, x.size))
        table[0] = diagonal
        if m < BANDS:
            table[1] = np.sqrt(2.0 * m + 3.0) * x * diagonal
        for degree in range(m + 2, BANDS + 1):
            a = np.sqrt((4.0 * degree**2 - 1.0) / (degree**2 - m**2))
            b = np.sqrt(((degree - 1.0) ** 2 - m**2) / (4.0 * (degree - 1.0) ** 2 - 1.0))
            table[degree - m] = a * (x * table[degree - m - 1] - b * table[degree - m - 2])
        tables.append(table)
        diagonal = np.sqrt((2.0 * m + 3.0) / (2.0 * m + 2.0)) * sine * diagonal
    return tables


def _shifted_to_centres(rows: FloatArray, width_in: int) -> FloatArray:
    """Return rows turned by the difference between the column centres of both grids."""
    width_out = rows.shape[1]
    turn = (0.5 / width_out - 0.5 / width_in) * np.arange(width_out // 2 + 1)
    phase = np.exp(2j * np.pi * turn)[None, :, None]
    return np.fft.irfft(np.fft.rfft(rows, axis=1) * phase, n=width_out, axis=1)
