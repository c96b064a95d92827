"""Shape of an eye and refraction by its cornea (docs/eyes.md §1, §2).

Lengths are in mm, in the frame of the eye: origin in the centre of the sclera, z along the gaze, y up.
Three vectors hold the parameters. ``cornea`` has the height of the apex, the radius at the apex, the
asphericity and the index of refraction. ``limbus`` has its radius, half its width, the radius of the sclera,
and 0. ``iris`` has the height of the tip of the cone, the slope, and the radii of the iris and the pupil.
`skinshade.EyeParams` has the three as properties.
"""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray, dot, unit_vectors

__all__ = [
    "eye_cornea",
    "eye_cornea_hit",
    "eye_height",
    "eye_iris_hit",
    "eye_iris_parallax",
    "eye_iris_uv",
    "eye_limbal_opacity",
    "eye_normal",
]

LEAST_ROOT = 1e-6
"""Least radicand of the surfaces, which keeps slopes finite outside the range of a surface."""
LEAST_FORWARD = 1e-4
"""Least coefficient of the quadratic of a cone, for rays that are nearly parallel to it."""
LEAST_FACING = 0.1
"""Least cosine between a refracted ray and the normal of the relief of the iris."""


def smoothstep(t: FloatArray) -> FloatArray:
    """Return the cubic 3t² − 2t³, for t (...) clamped to 0..1."""
    clamped = np.clip(t, 0.0, 1.0)
    result: FloatArray = clamped * clamped * (3.0 - 2.0 * clamped)
    return result


def eye_cornea(
    cornea_radius_mm: FloatArray,
    cornea_asphericity: FloatArray,
    refraction_index: FloatArray,
    limbus: FloatArray,
) -> FloatArray:
    """Return the argument ``cornea`` (..., 4) of the other functions, from the fields of the block of an eye.

    Parameters
    ----------
    cornea_radius_mm, cornea_asphericity, refraction_index
        (...) fields of `skinshade.EyeParams`.
    limbus
        (..., 4) radius of the limbus, half its width, radius of the sclera, mm; 0.
    """
    r = limbus[..., 0]
    root = _root(1.0 - (1.0 + cornea_asphericity) * (r / cornea_radius_mm) ** 2)
    sag = r * r / (cornea_radius_mm * (1.0 + root))
    apex = _root(limbus[..., 2] ** 2 - r * r) + sag
    parts = np.broadcast_arrays(apex, cornea_radius_mm, cornea_asphericity, refraction_index)
    return np.stack(parts, axis=-1)


def eye_height(r_mm: FloatArray, cornea: FloatArray, limbus: FloatArray) -> FloatArray:
    """Return the height z (...) of the front of an eye, mm, at a distance (...) from the axis.

    The front is a conic, the sclera behind it a sphere, and a cubic with equal values and slopes between
    them.

    Examples
    --------
    >>> import numpy as np
    >>> import skinshade as sk
    >>> from skinshade.shading.eye import eye_height
    >>> eye = sk.EyeParams()
    >>> eye_height(np.array([0.0, 5.9, 12.0]), eye.cornea, eye.limbus).round(2)
    array([12.99, 10.51,  0.  ])
    """
    return _profile(r_mm, cornea, limbus)[0]


def eye_normal(position_mm: FloatArray, cornea: FloatArray, limbus: FloatArray) -> FloatArray:
    """Return the unit normals (..., 3) of an eye at positions (..., 3) on it, mm.

    They depend on the distance from the axis alone, so that a coarse mesh does not show in reflections.
    """
    x, y, z = position_mm[..., 0], position_mm[..., 1], position_mm[..., 2]
    r = np.sqrt(x * x + y * y)
    slope_over_r = _profile(r, cornea, limbus)[1]
    front = np.stack([-slope_over_r * x, -slope_over_r * y, np.ones_like(r)], axis=-1)
    in_front = (z > 0.0) & (r < limbus[..., 0] + limbus[..., 1])
    return unit_vectors(np.where(in_front[..., None], front, position_mm))


def eye_cornea_hit(origin_mm: FloatArray, direction: FloatArray, cornea: FloatArray) -> FloatArray:
    """Return the first point of the cornea's conic on rays, mm, and 1; the origin and 0 if there is none.

    It serves meshes without a bulge: the origin is a point of the mesh, also inside the cornea.

    Parameters
    ----------
    origin_mm
        (..., 3) origins of the rays.
    direction
        (..., 3) unit directions, into the eye.
    cornea
        (..., 4) shape of the cornea.

    Returns
    -------
    (..., 4)
    """
    radius, q = cornea[..., 1], 1.0 + cornea[..., 2]
    s = cornea[..., 0] - origin_mm[..., 2]
    dz = direction[..., 2]
    across = dot(origin_mm[..., :2], direction[..., :2])
    a = 1.0 - (1.0 - q) * dz * dz
    b = across + dz * (radius - q * s)
    c = dot(origin_mm[..., :2], origin_mm[..., :2]) - 2.0 * radius * s + q * s * s
    radicand = b * b - a * c
    meets = (radicand >= 0.0) & (b < 0.0)
    distance = np.where(meets, c / np.maximum(_root(radicand) - b, LEAST_ROOT), 0.0)
    hit = origin_mm + distance[..., None] * direction
    return np.concatenate([hit, meets[..., None].astype(np.float64)], axis=-1)


def eye_limbal_opacity(r_mm: FloatArray, limbus: FloatArray) -> FloatArray:
    """Return the opacity (...) of the limbus at distances (...) from the axis: 0 in the cornea, 1 beyond."""
    inner, width = limbus[..., 0] - limbus[..., 1], 2.0 * limbus[..., 1]
    return smoothstep((r_mm - inner) / width)


def eye_iris_hit(
    position_mm: FloatArray,
    normal: FloatArray,
    view: FloatArray,
    cornea: FloatArray,
    iris: FloatArray,
) -> FloatArray:
    """Return the points (..., 3) of the iris' cone, mm, that are visible through points of the cornea.

    One refraction stands for those at both surfaces of the cornea.

    Parameters
    ----------
    position_mm
        (..., 3) points of the cornea.
    normal
        (..., 3) unit normals, of `eye_normal`.
    view
        (..., 3) unit vectors from the cornea to the viewer, or to a light.
    cornea, iris
        (..., 4) parameters.

    Examples
    --------
    >>> import numpy as np
    >>> import skinshade as sk
    >>> from skinshade.shading.eye import eye_height, eye_iris_hit, eye_normal
    >>> eye = sk.EyeParams()
    >>> edge = np.array([2.26, 0.0, eye_height(np.array(2.26), eye.cornea, eye.limbus)])
    >>> normal = eye_normal(edge, eye.cornea, eye.limbus)
    >>> hit = eye_iris_hit(edge, normal, np.array([0.0, 0.0, 1.0]), eye.cornea, eye.iris)
    >>> hit.round(2)  # a pupil of 2 mm looks 13 % larger
    array([2.01, 0.  , 9.28])
    """
    eta = 1.0 / cornea[..., 3]
    c = np.maximum(dot(normal, view), 0.0)
    bend = eta * c - np.sqrt(np.maximum(1.0 - eta * eta * (1.0 - c * c), 0.0))
    d = bend[..., None] * normal - eta[..., None] * view
    slope, h = iris[..., 1], iris[..., 0] - position_mm[..., 2]
    m2 = slope * slope
    dz, p = d[..., 2], position_mm[..., :2]
    a = dz * dz - m2 * dot(d[..., :2], d[..., :2])
    b = h * dz + m2 * dot(p, d[..., :2])
    e = h * h - m2 * dot(p, p)
    # The discriminant b² − ae as a product, which does not cancel for a flat iris.
    apart = h[..., None] * d[..., :2] + dz[..., None] * p
    cross = d[..., 0] * p[..., 1] - d[..., 1] * p[..., 0]
    root = np.abs(slope) * np.sqrt(np.maximum(dot(apart, apart) - m2 * cross * cross, 0.0))
    far, near = (b + root) / np.maximum(a, LEAST_FORWARD), e / np.maximum(b + root, LEAST_ROOT)
    return position_mm + np.where(slope < 0.0, near, far)[..., None] * d


def eye_iris_uv(
    hit_mm: FloatArray, iris: FloatArray, pupil_in_map: FloatArray, iris_uv: FloatArray
) -> FloatArray:
    """Return the coordinates (..., 2) of points of the iris in its map, v down.

    The fibres between pupil and rim stretch with the pupil.

    Parameters
    ----------
    hit_mm
        (..., 3) points of the iris.
    iris
        (..., 4) parameters.
    pupil_in_map
        (...) radius of the pupil in the map over that of the iris.
    iris_uv
        (..., 4) centre and radius of the iris in the map, and turns counterclockwise.
    """
    x, y = hit_mm[..., 0], hit_mm[..., 1]
    r = np.sqrt(x * x + y * y)
    pupil = iris[..., 3]
    fibre = np.minimum((r - pupil) / np.maximum(iris[..., 2] - pupil, LEAST_ROOT), 1.0)
    inside = pupil_in_map * r / np.maximum(pupil, LEAST_ROOT)
    radius = np.where(r < pupil, inside, pupil_in_map + (1.0 - pupil_in_map) * fibre)
    scale = iris_uv[..., 2] * radius / np.maximum(r, LEAST_ROOT)
    angle = 2.0 * np.pi * iris_uv[..., 3]
    turned_x = np.cos(angle) * x - np.sin(angle) * y
    turned_y = np.sin(angle) * x + np.cos(angle) * y
    return np.stack(
        [iris_uv[..., 0] + scale * turned_x, iris_uv[..., 1] - scale * turned_y], axis=-1
    )


def eye_iris_parallax(
    hit_mm: FloatArray, direction: FloatArray, iris_normal: FloatArray, height_mm: FloatArray
) -> FloatArray:
    """Return points (..., 3) of the relief of the iris, mm, by one step towards the viewer.

    Parameters
    ----------
    hit_mm
        (..., 3) points of the cone.
    direction
        (..., 3) unit directions of the refracted rays, into the eye.
    iris_normal
        (..., 3) unit normals of the cone.
    height_mm
        (...) height of the relief above the cone.
    """
    facing = np.maximum(-dot(direction, iris_normal), LEAST_FACING)
    return hit_mm - direction * (height_mm / facing)[..., None]


def _root(value: FloatArray) -> FloatArray:
    result: FloatArray = np.sqrt(np.maximum(value, LEAST_ROOT))
    return result


def _profile(
    r_mm: FloatArray, cornea: FloatArray, limbus: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return the height (...) of the front, mm, and its derivative over r, divided by r, 1/mm."""
    inner, outer = limbus[..., 0] - limbus[..., 1], limbus[..., 0] + limbus[..., 1]
    width = outer - inner
    conic, conic_slope = _conic(r_mm, cornea)
    sphere = _root(limbus[..., 2] ** 2 - r_mm * r_mm)
    z0, inner_slope = _conic(inner, cornea)
    z1 = _root(limbus[..., 2] ** 2 - outer * outer)
    m0, m1 = width * inner * inner_slope, -width * outer / z1
    t = np.clip((r_mm - inner) / width, 0.0, 1.0)
    # Cubic Hermite: values z0, z1 and derivatives m0, m1 over t.
    c2, c3 = 3.0 * (z1 - z0) - 2.0 * m0 - m1, 2.0 * (z0 - z1) + m0 + m1
    blend = z0 + t * (m0 + t * (c2 + t * c3))
    blend_slope = (m0 + t * (2.0 * c2 + t * (3.0 * c3))) / (width * np.maximum(r_mm, LEAST_ROOT))
    in_cornea, in_sclera = r_mm < inner, r_mm >= outer
    height = np.where(in_cornea, conic, np.where(in_sclera, sphere, blend))
    slope = np.where(in_cornea, conic_slope, np.where(in_sclera, -1.0 / sphere, blend_slope))
    return height, slope


def _conic(r_mm: FloatArray, cornea: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the height (...) of the conic and its derivative over r, divided by r."""
    radius = cornea[..., 1]
    root = _root(1.0 - (1.0 + cornea[..., 2]) * (r_mm / radius) ** 2)
    height = cornea[..., 0] - r_mm * r_mm / (radius * (1.0 + root))
    return height, -1.0 / (radius * root)
