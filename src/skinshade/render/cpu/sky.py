"""Ambient light that reaches each vertex: past the body's other parts, and through the body.

Depth maps from evenly spread directions tell for each vertex what part of the environment it sees, and
how thick the body is towards the part that it does not face.
"""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter, map_coordinates

from ..._core.arrays import FloatArray, bounding_sphere, dot
from ..._core.progress import Progress, silent
from ...mesh import Mesh, mesh_curvature
from ...mesh.topology import corner_areas
from ...scene import Environment, Light
from ...scene.camera import look_at, parallel
from ...shading.ambient import ambient_irradiance
from ...shading.deep_scatter import transmittance
from ...shading.skin import Skin
from .raster import depth_maps
from .shadow_map import ShadowMap

__all__ = ["SkyLight", "sky_light"]

DIRECTIONS = 80
MAP_SIZE = 224
LOBE_POWER = 12.0
"""Each direction stands for a lobe about as wide as the distance to its neighbours."""
BIAS_MM = 1.5
BOUNCE_REACH_MM = 35.0
"""Standard deviation of what a hidden direction is taken to see: a chin's distance
from the neck, a nose's from the cheek."""


@dataclass(frozen=True)
class SkyLight:
    """Per vertex.

    Attributes
    ----------
    visibility
        (V, 3) share of the environment's irradiance that arrives, 0..1.
    through
        (V, 3) irradiance over π that arrives through the body from behind.
    bounced
        (V, 3) irradiance over π from the body's own lit parts.
    thickness_mm
        (V,) mean thickness towards the directions behind, mm.
    """

    visibility: FloatArray
    through: FloatArray
    bounced: FloatArray
    thickness_mm: FloatArray


def sky_light(
    mesh: Mesh,
    environment: Environment,
    lights: list[tuple[Light, ShadowMap]],
    skin: Skin,
    mean_albedo: FloatArray,
    progress: Progress = silent,
) -> SkyLight:
    """Gather `SkyLight` from depth maps in `DIRECTIONS` directions."""
    points, normals = mesh.positions_mm, mesh.normals
    centre, reach = bounding_sphere(points)
    radius = 1.05 * reach
    directions = _spread(DIRECTIONS)
    radiance = environment.preconvolved.sample(directions, np.full(DIRECTIONS, LOBE_POWER))
    total = np.zeros((points.shape[0], 11))
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        gathered = pool.map(
            lambda pair: _from_direction(mesh, centre, radius, skin, *pair),
            zip(directions, radiance, strict=True),
        )
        for index, part in enumerate(gathered):
            progress("ambient light", index / DIRECTIONS)
            total += part
    progress("ambient light", 1.0)
    arrived, open_sky, through = total[:, 0:3], total[:, 3:6], total[:, 6:9]
    thickness, behind_weight = total[:, 9], total[:, 10]
    solid_angle = 4.0 / DIRECTIONS  # 4π/n over π
    visibility = np.where(open_sky > 0.0, arrived / np.maximum(open_sky, 1e-12), 1.0)
    each_channel = np.repeat(normals[:, None], 3, axis=1)
    lit = ambient_irradiance(environment.radiance_sh, each_channel) * visibility
    lit += _direct(mesh, lights, skin.params.shadow_filter_width_mm)
    return SkyLight(
        visibility,
        through * solid_angle,
        _bounced(mesh, lit * mean_albedo, visibility),
        thickness / np.maximum(behind_weight, 1e-12),
    )


def _from_direction(
    mesh: Mesh,
    centre: FloatArray,
    radius: float,
    skin: Skin,
    direction: FloatArray,
    radiance: FloatArray,
) -> FloatArray:
    """One direction's share (V, 11): light arrived, an open sky's, light through, thickness, weight."""
    points, normals = mesh.positions_mm, mesh.normals
    view = look_at(centre + 2.0 * radius * direction, centre, np.roll(direction, 1))
    seen = points @ view[:3, :3].T + view[:3, 3]
    clip = seen @ parallel(radius, radius, 3.0 * radius)[:, :3].T
    clip[:, 3] = 1.0
    depth = -seen[:, 2]
    first, away = depth_maps(clip, depth, mesh.faces, (MAP_SIZE, MAP_SIZE))
    x, y = (0.5 * clip[:, 0] + 0.5) * MAP_SIZE, (0.5 - 0.5 * clip[:, 1]) * MAP_SIZE
    cosine = dot(normals, direction)
    result = np.zeros((points.shape[0], 11))
    facing = np.flatnonzero(cosine > 0.0)
    lit = _visible(away, x[facing], y[facing], depth[facing] - BIAS_MM)
    result[facing, 3:6] = cosine[facing, None] * radiance
    result[facing, 0:3] = lit[:, None] * result[facing, 3:6]
    behind = np.flatnonzero(cosine < 0.0)
    column = np.clip(x[behind], 0, MAP_SIZE - 1).astype(np.int64)
    row = np.clip(y[behind], 0, MAP_SIZE - 1).astype(np.int64)
    weight = -cosine[behind]
    wall = np.minimum(first[row, column], depth[behind])
    # A texel's depth is uncertain by as much as a grazing wall rises within it.
    uncertain = radius / MAP_SIZE * np.sqrt(1.0 - weight * weight) / np.maximum(weight, 0.1)
    thick = depth[behind] - wall + uncertain
    passed = transmittance(thick, skin.profile.albedo, skin.sigma_per_mm)
    result[behind, 6:9] = weight[:, None] * passed * radiance
    result[behind, 9], result[behind, 10] = weight * thick, weight
    return result


def _direct(
    mesh: Mesh, lights: list[tuple[Light, ShadowMap]], filter_width_mm: float
) -> FloatArray:
    """Irradiance over π of every light at the vertices, (V, 3)."""
    total = np.zeros_like(mesh.positions)
    curvature = mesh_curvature(mesh.positions_mm, mesh.faces, mesh.normals)
    for light, shadow_map in lights:
        to_light, irradiance = light.at(mesh.positions_mm)
        lit = shadow_map.shadow_filter(
            mesh.positions_mm, mesh.normals, to_light, curvature, filter_width_mm
        )
        cosine = np.maximum(dot(mesh.normals, to_light), 0.0)
        total += (cosine * lit)[:, None] * irradiance / np.pi
    return total


def _bounced(mesh: Mesh, radiosity: FloatArray, visibility: FloatArray) -> FloatArray:
    """Irradiance over π from directions that the body hides.

    In a deep cavity they see walls as dark as the point itself, across an open hollow the lit surface
    nearby: the wider the point's view, by its angle, the farther it sees.
    """
    mean = _averaged_nearby(mesh, radiosity)
    openness = np.clip(visibility.mean(axis=1, keepdims=True), 0.0, 1.0)
    across = np.sqrt(openness)
    return (1.0 - openness) * (across * mean + (1.0 - across) * radiosity)


def _averaged_nearby(mesh: Mesh, values: FloatArray) -> FloatArray:
    """Average (V, 3) over the surface within `BOUNCE_REACH_MM`, on a grid of voxels a quarter as wide."""
    voxel = 0.25 * BOUNCE_REACH_MM
    points = mesh.positions_mm
    place = (points - points.min(axis=0)) / voxel
    cell = place.astype(np.int64)
    shape = cell.max(axis=0) + 1
    at = np.ravel_multi_index(tuple(cell.T), tuple(shape))
    area = corner_areas(points, mesh.faces, points.shape[0])
    weighted = np.concatenate([values * area[:, None], area[:, None]], axis=1)
    grids = [
        gaussian_filter(
            np.bincount(at, column, int(shape.prod())).reshape(shape),
            BOUNCE_REACH_MM / voxel,
            mode="constant",
        )
        for column in weighted.T
    ]
    read = np.stack(
        [map_coordinates(grid, (place - 0.5).T, order=1, mode="nearest") for grid in grids], axis=1
    )
    return read[:, :3] / np.maximum(read[:, 3:], 1e-12)


def _spread(count: int) -> FloatArray:
    """Unit vectors on a spherical Fibonacci lattice."""
    y = 1.0 - (2.0 * np.arange(count) + 1.0) / count
    angle = np.arange(count) * np.pi * (3.0 - np.sqrt(5.0))
    ring = np.sqrt(1.0 - y * y)
    return np.stack([ring * np.cos(angle), y, ring * np.sin(angle)], axis=1)


def _visible(depths: FloatArray, x: FloatArray, y: FloatArray, depth: FloatArray) -> FloatArray:
    last = depths.shape[0] - 1
    x0, y0 = np.floor(x - 0.5), np.floor(y - 0.5)
    fx, fy = x - 0.5 - x0, y - 0.5 - y0
    total = np.zeros_like(x)
    for dy, wy in ((0, 1.0 - fy), (1, fy)):
        for dx, wx in ((0, 1.0 - fx), (1, fx)):
            row = np.clip(y0 + dy, 0, last).astype(np.int64)
            column = np.clip(x0 + dx, 0, last).astype(np.int64)
            total += wx * wy * (depths[row, column] >= depth)
    return total
