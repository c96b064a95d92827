"""Sun of an environment, as a light of its own."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from .._core.arrays import (
    LARGEST_LIGHT,
    FloatArray,
    FloatVector,
    ImageArray,
    IntArray,
    unit_vectors,
)
from ..shading.image_light import equirectangular_uv
from .environment import Environment
from .equirectangular import averaged, grid_directions, row_solid_angle
from .lights import DirectionalLight

__all__ = ["split_sun"]

RADIUS_DEG = 2.0
"""Radius of the disc that belongs to the sun: its radius of .27° and the glare of a lens around it."""
RADIUS_TEXELS = 1.5
"""Least radius of the disc, texels: the light of one point, resampled to four texels, is within it."""
LARGEST_RADIUS_DEG = 5.0
"""Greatest radius of the disc. Coarser images (fewer than 54 rows) do not tell a sun from a wide light."""
LEAST_SHARE = 0.01
"""Least share of the sun in the light of the sphere, by luminance. A lesser sun adds 4 % or less to the light
of an even sky on a surface that faces it, which is not worth the time and the 45 MB of a shadow map."""
MOST_BESIDE = 0.5
"""Greatest flux of the ring relative to that of the disc. The ring has three times the solid angle of the
disc. Relative to the disc, it has none of the light of a sun, and 3 times the light of the middle or the edge
of an even softbox."""
SEARCH_SIZE = (256, 128)
"""Greatest size of the image in which the brightest direction is searched. Noise of single pixels of a large
image is averaged there."""
ROUNDS = 3
"""Times that the disc is centred on its own light. The search has cells of 1.4°; a sun of 2° arrives at the
middle after two rounds."""
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])
"""Weights of linear Rec.709 in luminance [ITU-R BT.709]."""


@dataclass(frozen=True)
class _Texels:
    """Texels of an image around a direction; n of them.

    `row` and `column` are (n,) indices, `direction` (n, 3) unit vectors, `solid_angle` (n,) sr, `radiance`
    (n, 3).
    """

    row: IntArray
    column: IntArray
    direction: FloatArray
    solid_angle: FloatArray
    radiance: FloatArray


def split_sun(environment: Environment) -> tuple[DirectionalLight | None, Environment]:
    """Split an environment into its sun and the rest of its light.

    The sun is the light within 2° (1.5 texels in a coarse image) of the brightest direction, above the median
    of the ring around it, which is twice as wide. The rest is the environment with this disc lowered to the
    median. Sun and rest have the flux of the environment. An image has no sun

    * if the sun has less than 1 % of the light of the whole sphere, such as a bright pixel or an even sky;
    * if the light goes on around the disc, as that of a softbox does;
    * if the image is coarser than 108×54, or the irradiance of the sun is above 1e6.

    Parameters
    ----------
    environment
        The environment; its field `extract_sun` has no effect here.

    Returns
    -------
    sun
        Light from the mean direction of the disc's flux, with the irradiance of this flux, `scale` included;
        None if the environment has no sun.
    rest
        The environment without its sun, with the same scale; the environment itself if it has none.

    Examples
    --------
    >>> import numpy as np
    >>> import skinshade as sk
    >>> radiance = np.full((128, 256, 3), 0.2)
    >>> radiance[32, 192] = 5000.0  # 45° above +z
    >>> sun, sky = sk.split_sun(sk.Environment(radiance))
    >>> sun.to_light.round(2), sun.irradiance.round(2), f"{sky.radiance.max():.2f}"
    (array([-0.01,  0.7 ,  0.72]), array([2.16, 2.16, 2.16]), '0.20')
    """
    image = environment.radiance
    radius = _disc_radius(*image.shape[:2])
    if radius > np.radians(LARGEST_RADIUS_DEG):
        return None, environment
    width, height = SEARCH_SIZE
    coarse = averaged(image, (min(image.shape[1], width), min(image.shape[0], height)))
    centre = _brightest_direction(coarse)
    for _ in range(ROUNDS):
        texels = _texels_around(image, centre, 2.0 * radius)
        within = texels.direction @ centre >= np.cos(radius)
        median = np.median(texels.radiance[~within], axis=0).astype(np.float32)
        above = np.maximum(texels.radiance - median, 0.0) * texels.solid_angle[:, None]
        weight = above[within] @ LUMINANCE
        if not weight.sum() > 0.0:
            return None, environment
        centre = unit_vectors(weight @ texels.direction[within])
    flux = above[within].sum(axis=0)
    total = row_solid_angle(coarse.shape[0]) @ coarse.mean(axis=1)
    irradiance = environment.scale * flux
    if flux @ LUMINANCE < LEAST_SHARE * (total @ LUMINANCE):
        return None, environment
    if (above[~within] @ LUMINANCE).sum() > MOST_BESIDE * weight.sum():
        return None, environment
    if irradiance.max() > LARGEST_LIGHT:
        return None, environment
    rest = image.copy()
    own = texels.row[within], texels.column[within]
    rest[own] = np.minimum(rest[own], median)
    return DirectionalLight(centre, irradiance), replace(environment, radiance=rest)


def _disc_radius(height: int, width: int) -> float:
    """Return the radius of the sun's disc in an image, radians."""
    texel_deg = max(180.0 / height, 360.0 / width)
    return float(np.radians(max(RADIUS_DEG, RADIUS_TEXELS * texel_deg)))


def _brightest_direction(image: FloatArray) -> FloatVector:
    """Return the brightest direction (3,) of an image, averaged over cells of equal solid angle."""
    height, width = image.shape[:2]
    luminance = image @ LUMINANCE
    sine = np.sin((np.arange(height) + 0.5) / height * np.pi)
    for row, texels in enumerate(np.rint(np.minimum(1.0 / sine, width)).astype(int)):
        luminance[row] = _running_mean(luminance[row], texels)
    row, column = np.unravel_index(luminance.argmax(), luminance.shape)
    direction: FloatVector = grid_directions(height, width)[row, column]
    return direction


def _running_mean(values: FloatVector, width: int) -> FloatVector:
    """Return the means (N,) of `width` neighbours of values (N,) on a circle."""
    around = np.concatenate(
        [values[-(width // 2) or len(values) :], values, values[: (width - 1) // 2]]
    )
    sums = np.concatenate([[0.0], np.cumsum(around)])
    means: FloatVector = (sums[width:] - sums[:-width]) / width
    return means


def _texels_around(image: ImageArray, centre: FloatVector, radius: float) -> _Texels:
    """Return the texels of an image whose centres are within a radius, radians, of a direction (3,)."""
    height, width = image.shape[:2]
    u, v = equirectangular_uv(centre)
    polar = np.pi * float(v)
    first = max(int((polar - radius) / np.pi * height), 0)
    last = min(int((polar + radius) / np.pi * height) + 1, height)
    reach = np.pi  # of the azimuth: all around if the pole is within the radius
    if radius < polar < np.pi - radius:
        reach = np.arcsin(np.sin(radius) / np.sin(polar))
    half = min(int(reach / (2.0 * np.pi) * width) + 1, width // 2)
    middle = int(float(u) * width)
    columns = np.arange(middle - half, min(middle + half + 1, middle - half + width)) % width
    theta = (np.arange(first, last) + 0.5) / height * np.pi
    phi = ((columns + 0.5) / width - 0.5) * 2.0 * np.pi
    sine, cosine = np.sin(theta)[:, None], np.cos(theta)[:, None]
    direction = np.stack(
        np.broadcast_arrays(sine * np.cos(phi), cosine, sine * np.sin(phi)), axis=-1
    )
    row, column = np.nonzero(direction @ centre >= np.cos(radius))
    solid_angle = row_solid_angle(height) / width
    return _Texels(
        row + first,
        columns[column],
        direction[row, column],
        solid_angle[row + first],
        image[row + first, columns[column]].astype(np.float64),
    )
