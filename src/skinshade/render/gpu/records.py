"""Cameras and lights as the passes take them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..._core.arrays import FloatArray, as_triple
from ...params import FrameParams, LightParams
from ...scene import Camera, DirectionalLight, Light
from ..light_view import LightView
from ..prepared import PreparedScene

__all__ = ["frame_params", "light_params"]

Four = tuple[float, float, float, float]


def _four(values: FloatArray) -> Four:
    x, y, z, w = (float(each) for each in values)
    return x, y, z, w


def frame_params(
    prepared: PreparedScene,
    camera: Camera,
    size: tuple[int, int],
    *,
    samples: int,
    offset: tuple[float, float],
    exposure: float,
) -> FrameParams:
    """Return the record of a frame whose pixel centres are the samples at an offset."""
    scene = prepared.scene
    aspect = size[0] / size[1]
    matrix = camera.view_projection(aspect)
    rays = np.linalg.inv(matrix)
    # The far plane has one depth: rays to it are linear over the screen.
    far = [
        rays @ corner
        for corner in ([0.0, 0.0, 1.0, 1.0], [1.0, 0.0, 1.0, 1.0], [0.0, 1.0, 1.0, 1.0])
    ]
    middle, right, top = (point[:3] / point[3] for point in far)
    matrix[0] += matrix[3] * (1.0 - 2.0 * offset[0]) / size[0]
    matrix[1] -= matrix[3] * (1.0 - 2.0 * offset[1]) / size[1]
    environment = scene.environment
    harmonics = np.zeros((9, 3)) if environment is None else environment.radiance_sh
    return FrameParams(
        clip_x=_four(matrix[0]),
        clip_y=_four(matrix[1]),
        clip_z=_four(matrix[2]),
        clip_w=_four(matrix[3]),
        radiance_sh=tuple(as_triple(each) for each in harmonics),
        eye_mm=as_triple(camera.position_mm),
        ray_across=as_triple(right - middle),
        ray_up=as_triple(top - middle),
        ray_ahead=as_triple(middle - camera.position_mm),
        background=as_triple(scene.background),
        footprint=float(1.0 / np.sqrt(samples)),
        sample_weight=1.0 / samples,
        uv_scale_mm=prepared.uv_scale_mm if "normal" in prepared.textures else 1.0,
        environment_scale=1.0 if environment is None else float(environment.scale),
        exposure=exposure,
    )


def light_params(light: Light, seen: LightView, filter_width_mm: float) -> LightParams:
    """Return the record of a light and of what it sees."""
    view, projection = seen.view, seen.projection
    record = LightParams(
        view_x=_four(view[0]),
        view_y=_four(view[1]),
        view_z=_four(view[2]),
        clip_x=_four(projection[0]),
        clip_y=_four(projection[1]),
        clip_w=_four(projection[3]),
        irradiance=as_triple(light.irradiance),
        depth_mm=(seen.middle_depth_mm, seen.reach_mm),
        blur_texels=seen.blur_texels(filter_width_mm),
    )
    if isinstance(light, DirectionalLight):
        return replace(record, direction=as_triple(light.to_light))
    away = light.position_mm - light.target_mm
    distance = float(np.linalg.norm(away))
    return replace(
        record,
        direction=as_triple(away / distance),
        position_mm=as_triple(light.position_mm),
        cone_cosines=light.cone_cosines,
        near=1.0,
        target_distance_mm=distance,
    )
