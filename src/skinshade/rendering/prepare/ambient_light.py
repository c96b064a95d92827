"""Ambient light at the vertices: visible environment, light through the body, and bounced light.

Depth maps from evenly spread directions give, for each vertex, the visible part of the environment and
the thickness of the body along the directions behind the surface.
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
from ...scene import Light
from ...scene.camera import look_at, parallel
from ...shading.ambient import ambient_irradiance
from ...shading.deep_scatter import transmittance
from ...shading.image_light import PreconvolvedRadiance
from ...shading.skin import Skin
from .rasterizer import depth_maps
from .shadow_filter import WideFilter

__all__ = ["AmbientLight", "gather_ambient_light"]

DIRECTIONS = 80
MAP_SIZE = 224
"""Texels along a side of the depth map of a direction."""
LOBE_POWER = 12.0
"""Power of the lobe around each direction. The lobe is about as wide as the distance to the next one."""
BIAS_MM = 1.5
"""Distance by which vertices move towards a direction before the depth test: two texels for a head."""
BOUNCE_REACH_MM = 35.0
"""Standard deviation of the Gaussian over the surface that bounces light to a vertex: the distance from
chin to neck, or from nose to cheek."""

MOST_VOXELS = 1 << 21
"""Greatest number of voxels of the grid for bounced light: 16 MiB for each of its four values. A cube with a
side of 1.1 m has as many voxels of a quarter of the reach; larger bodies have larger voxels, because light
that bounces within 35 mm is a detail of theirs."""


@dataclass(frozen=True)
class AmbientLight:
    """Ambient light at the vertices.

    Attributes
    ----------
    visibility
        (V, 3) share of the environment's irradiance that arrives at the vertex, 0..1.
    through
        (V, 3) irradiance over π that passes through the body from behind.
    bounced
        (V, 3) irradiance over π from the body's own lit parts.
    thickness_mm
        (V,) mean thickness of the body along the directions behind the surface, mm.
    """

    visibility: FloatArray
    through: FloatArray
    bounced: FloatArray
    thickness_mm: FloatArray


def gather_ambient_light(
    mesh: Mesh,
    radiance_sh: FloatArray,
    preconvolved: PreconvolvedRadiance,
    lights: list[tuple[Light, WideFilter]],
    skin: Skin,
    mean_albedo: FloatArray,
    progress: Progress = silent,
) -> AmbientLight:
    """Gather ambient light from depth maps in `DIRECTIONS` directions.

    Parameters
    ----------
    mesh
        The body.
    radiance_sh, preconvolved
        Spherical harmonics (9, 3) and preconvolved reflections of the environment.
    lights
        Lights with their wide filters; their light bounces from the surface.
    skin
        Material.
    mean_albedo
        (3,) mean of the albedo map.
    progress
        Called with the name of the work and the fraction that is done.
    """
    points, normals = mesh.positions_mm, mesh.normals
    centre, body_radius = bounding_sphere(points)
    radius = 1.05 * body_radius
    directions = _lattice_directions(DIRECTIONS)
    radiance = preconvolved.sample(directions, np.full(DIRECTIONS, LOBE_POWER))
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
    arrived, unoccluded, through = total[:, 0:3], total[:, 3:6], total[:, 6:9]
    thickness, behind_weight = total[:, 9], total[:, 10]
    solid_angle = 4.0 / DIRECTIONS  # 4π/n over π
    visibility = np.where(unoccluded > 0.0, arrived / np.maximum(unoccluded, 1e-12), 1.0)
    channel_normals = np.repeat(normals[:, None], 3, axis=1)
    lit = ambient_irradiance(radiance_sh, channel_normals) * visibility
    lit += _direct(mesh, lights)
    return AmbientLight(
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
    """Return the contribution of one direction (V, 11).

    Columns: light that arrives (3), light that would arrive without occlusion (3), light through the
    body (3), thickness times weight, weight.
    """
    points, normals = mesh.positions_mm, mesh.normals
    view = look_at(centre + 2.0 * radius * direction, centre, np.roll(direction, 1))
    in_view = points @ view[:3, :3].T + view[:3, 3]
    clip = in_view @ parallel(radius, radius, 3.0 * radius)[:, :3].T
    clip[:, 3] = 1.0
    depth = -in_view[:, 2]
    nearest, facing_away = depth_maps(clip, depth, mesh.faces, (MAP_SIZE, MAP_SIZE))
    x, y = (0.5 * clip[:, 0] + 0.5) * MAP_SIZE, (0.5 - 0.5 * clip[:, 1]) * MAP_SIZE
    cosine = dot(normals, direction)
    result = np.zeros((points.shape[0], 11))
    facing = np.flatnonzero(cosine > 0.0)
    lit = _visible(facing_away, x[facing], y[facing], depth[facing] - BIAS_MM)
    result[facing, 3:6] = cosine[facing, None] * radiance
    result[facing, 0:3] = lit[:, None] * result[facing, 3:6]
    behind = np.flatnonzero(cosine < 0.0)
    column = np.clip(x[behind], 0, MAP_SIZE - 1).astype(np.int64)
    row = np.clip(y[behind], 0, MAP_SIZE - 1).astype(np.int64)
    weight = -cosine[behind]
    entry = np.minimum(nearest[row, column], depth[behind])
    # Depth of a surface at a grazing angle varies by this distance within a texel.
    depth_error = radius / MAP_SIZE * np.sqrt(1.0 - weight * weight) / np.maximum(weight, 0.1)
    thickness = depth[behind] - entry + depth_error
    transmitted = transmittance(thickness, skin.profile.albedo, skin.sigma_per_mm)
    result[behind, 6:9] = weight[:, None] * transmitted * radiance
    result[behind, 9], result[behind, 10] = weight * thickness, weight
    return result


def _direct(mesh: Mesh, lights: list[tuple[Light, WideFilter]]) -> FloatArray:
    """Return the irradiance over π of all lights at the vertices, (V, 3)."""
    total = np.zeros_like(mesh.positions)
    curvature = mesh_curvature(mesh.positions_mm, mesh.faces, mesh.normals)
    for light, wide_filter in lights:
        to_light, irradiance = light.at(mesh.positions_mm)
        lit = wide_filter.lit(mesh.positions_mm, mesh.normals, to_light, curvature)
        cosine = np.maximum(dot(mesh.normals, to_light), 0.0)
        total += (cosine * lit)[:, None] * irradiance / np.pi
    return total


def _bounced(mesh: Mesh, radiosity: FloatArray, visibility: FloatArray) -> FloatArray:
    """Return the irradiance over π from directions that the body occludes, (V, 3).

    In a deep cavity the occluding surface is as dark as the vertex itself; in an open hollow it is the
    lit surface nearby. The weight of the lit surface is the square root of the visible share of the sky.
    """
    mean = _averaged_nearby(mesh, radiosity)
    openness = np.clip(visibility.mean(axis=1, keepdims=True), 0.0, 1.0)
    nearby_weight = np.sqrt(openness)
    return (1.0 - openness) * (nearby_weight * mean + (1.0 - nearby_weight) * radiosity)


def _averaged_nearby(mesh: Mesh, values: FloatArray) -> FloatArray:
    """Return values (V, 3) blurred over the surface by `BOUNCE_REACH_MM`, on a grid of voxels."""
    points = mesh.positions_mm
    voxel = _voxel_mm(np.ptp(points, axis=0))
    coordinates = (points - points.min(axis=0)) / voxel
    cell = coordinates.astype(np.int64)
    shape = cell.max(axis=0) + 1
    cell_index = np.ravel_multi_index(tuple(cell.T), tuple(shape))
    area = corner_areas(points, mesh.faces, points.shape[0])
    weighted = np.concatenate([values * area[:, None], area[:, None]], axis=1)
    grids = [
        gaussian_filter(
            np.bincount(cell_index, column, int(shape.prod())).reshape(shape),
            BOUNCE_REACH_MM / voxel,
            mode="constant",
        )
        for column in weighted.T
    ]
    sampled = np.stack(
        [map_coordinates(grid, (coordinates - 0.5).T, order=1, mode="nearest") for grid in grids],
        axis=1,
    )
    return sampled[:, :3] / np.maximum(sampled[:, 3:], 1e-12)


def _voxel_mm(extent_mm: FloatArray) -> float:
    """Return the side of a voxel, mm, for a body of an extent (3,): a quarter of the reach, or more."""
    voxel = 0.25 * BOUNCE_REACH_MM
    # A long, thin body needs several steps, because an axis has at least one voxel.
    while (excess := float(np.prod(np.floor(extent_mm / voxel) + 1.0)) / MOST_VOXELS) > 1.0:
        voxel *= 1.01 * np.cbrt(excess)
    return voxel


def _lattice_directions(count: int) -> FloatArray:
    """Return unit vectors (count, 3) on a spherical Fibonacci lattice."""
    y = 1.0 - (2.0 * np.arange(count) + 1.0) / count
    angle = np.arange(count) * np.pi * (3.0 - np.sqrt(5.0))
    ring = np.sqrt(1.0 - y * y)
    return np.stack([ring * np.cos(angle), y, ring * np.sin(angle)], axis=1)


def _visible(depths: FloatArray, x: FloatArray, y: FloatArray, depth: FloatArray) -> FloatArray:
    """Return the share (N,) of the four nearest texels, bilinear, that lie at or behind a depth (N,)."""
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
