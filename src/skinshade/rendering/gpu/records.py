"""Constant blocks of the passes for cameras and lights."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..._core.arrays import FloatArray, as_triple
from ...params import FrameParams, LightParams
from ...scene import Camera, DirectionalLight, Light
from ..prepare.light_view import LightView
from ..prepare.parts import PreparedPart
from ..prepare.scene import PreparedScene

__all__ = ["frame_params", "light_params"]


def _quadruple(values: FloatArray) -> tuple[float, float, float, float]:
    x, y, z, w = (float(value) for value in values)
    return x, y, z, w


def frame_params(
    prepared: PreparedScene,
    part: PreparedPart,
    camera: Camera,
    size: tuple[int, int],
    *,
    samples: int,
    offset: tuple[float, float],
    exposure: float,
) -> FrameParams:
    """Return the block of a frame.

    Parameters
    ----------
    prepared, part, camera, size
        Scene, part that is drawn, camera of the view, and (width, height).
    samples
        Samples per pixel.
    offset
        Position of the sample within a pixel, 0..1 from the top left. The projection moves it to the
        pixel's centre, where the GPU samples.
    exposure
        Factor before the tone curve.
    """
    scene = prepared.scene
    matrix = camera.view_projection(size[0] / size[1])
    to_mm = np.linalg.inv(matrix)
    # All points of the far plane have one depth, so that rays towards them are linear over the screen.
    corners = ((0.0, 0.0, 1.0, 1.0), (1.0, 0.0, 1.0, 1.0), (0.0, 1.0, 1.0, 1.0))
    far_points = [to_mm @ np.array(corner) for corner in corners]
    middle, right, top = (point[:3] / point[3] for point in far_points)
    matrix[0] += matrix[3] * (1.0 - 2.0 * offset[0]) / size[0]
    matrix[1] -= matrix[3] * (1.0 - 2.0 * offset[1]) / size[1]
    environment = scene.environment
    harmonics = np.zeros((9, 3)) if prepared.radiance_sh is None else prepared.radiance_sh
    return FrameParams(
        clip_x=_quadruple(matrix[0]),
        clip_y=_quadruple(matrix[1]),
        clip_z=_quadruple(matrix[2]),
        clip_w=_quadruple(matrix[3]),
        radiance_sh=tuple(as_triple(coefficient) for coefficient in harmonics),
        eye_mm=as_triple(camera.position_mm),
        ray_across=as_triple(right - middle),
        ray_up=as_triple(top - middle),
        ray_ahead=as_triple(middle - camera.position_mm),
        background=as_triple(scene.background),
        footprint=float(1.0 / np.sqrt(samples)),
        sample_weight=1.0 / samples,
        uv_scale_mm=part.uv_scale_mm,
        environment_scale=1.0 if environment is None else float(environment.scale),
        exposure=exposure,
    )


def light_params(light: Light, light_view: LightView, filter_width_mm: float) -> LightParams:
    """Return the block of a light and its shadow map, given the width of the wide filter in mm."""
    view, projection = light_view.view, light_view.projection
    block = LightParams(
        view_x=_quadruple(view[0]),
        view_y=_quadruple(view[1]),
        view_z=_quadruple(view[2]),
        clip_x=_quadruple(projection[0]),
        clip_y=_quadruple(projection[1]),
        clip_w=_quadruple(projection[3]),
        irradiance=as_triple(light.irradiance),
        depth_mm=(light_view.middle_depth_mm, light_view.radius_mm),
        blur_texels=light_view.blur_texels(filter_width_mm),
    )
    if isinstance(light, DirectionalLight):
        return replace(block, direction=as_triple(light.to_light))
    axis = light.position_mm - light.target_mm
    distance = float(np.linalg.norm(axis))
    return replace(
        block,
        direction=as_triple(axis / distance),
        position_mm=as_triple(light.position_mm),
        cone_cosines=light.cone_cosines,
        near=1.0,
        target_distance_mm=distance,
    )
