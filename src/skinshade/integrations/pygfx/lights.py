"""pygfx lights from skinshade's lights, with shadow maps that contain the body."""

from __future__ import annotations

import math

import pygfx
from numpy.typing import ArrayLike

from ..._core.arrays import FloatArray, as_floats, bounding_sphere
from ..._core.errors import ArgumentError
from ...mesh import Mesh
from ...scene import DirectionalLight, Light
from ...scene.lights import FULL_SHARE

__all__ = ["skin_light"]

OTHER_MATERIALS_BIAS = 0.002
"""Bias for pygfx's own materials, as a share of the map's depth range. Skin has its own bias."""


def skin_light(
    light: Light, mesh_or_bounds: Mesh | ArrayLike, *, cast_shadow: bool = True
) -> pygfx.Light:
    """Return the pygfx light that is equal to a light of skinshade, in a world in mm.

    The shadow map has the settings that `SkinMaterial` needs: it contains faces towards the light
    (``shadow.cull_mode = "back"``; by default, pygfx draws the far side), in the narrowest depth range
    that contains the body. pygfx replaces this range when ``angle`` or ``distance`` of a spot light
    changes; create a new light instead. ``shadow.bias`` is .002, for pygfx's own materials.

    `SkinMaterial` also accepts point lights of pygfx, but they have no deep scatter.

    Parameters
    ----------
    light
        `skinshade.DirectionalLight` or `skinshade.SpotLight`; irradiance stays in linear Rec.709.
    mesh_or_bounds
        Bodies that cast and receive shadows: a mesh, or the least and the greatest coordinates (2, 3), mm.
    cast_shadow
        Give the light a shadow map. Deep scatter needs it.

    Returns
    -------
    pygfx.DirectionalLight or pygfx.SpotLight
        Light with its shadow camera.

    Raises
    ------
    ArgumentError
        If the bounds are not (2, 3) finite numbers, or are empty.
    """
    middle, radius = _sphere(mesh_or_bounds)
    view, projection = light.view_and_projection(middle, radius)
    colour, strength = _colour(light.irradiance)
    if isinstance(light, DirectionalLight):
        result = pygfx.DirectionalLight(colour, strength, cast_shadow=cast_shadow)
        result.local.position = -view[:3, :3].T @ view[:3, 3]
        result.target.local.position = middle
        result.shadow.camera.width = result.shadow.camera.height = 2.0 / projection[0, 0]
        near = projection[2, 3] / projection[2, 2]
        far = near - 1.0 / projection[2, 2]
    else:
        axis = light.position_mm - light.target_mm
        result = pygfx.SpotLight(
            colour,
            strength * float(axis @ axis),
            cast_shadow=cast_shadow,
            decay=2,
            angle=math.radians(light.cone_deg),
            penumbra=1.0 - FULL_SHARE,
        )
        result.local.position = light.position_mm
        result.target.local.position = light.target_mm
        # pygfx computes the same expression, and replaces the depth range if the results are not equal.
        result.shadow.camera.fov = 180 / math.pi * 2 * result.angle
        result.shadow.camera.aspect = 1.0
        near = projection[2, 3] / projection[2, 2]
        far = projection[2, 3] / (1.0 + projection[2, 2])
    result.shadow.camera.depth_range = (float(near), float(far))
    result.shadow.cull_mode = "back"
    result.shadow.bias = OTHER_MATERIALS_BIAS
    return result


def _sphere(mesh_or_bounds: Mesh | ArrayLike) -> tuple[FloatArray, float]:
    """Return the middle (3,) and the radius of a sphere around a body, mm."""
    if isinstance(mesh_or_bounds, Mesh):
        points = mesh_or_bounds.positions_mm
    else:
        points = as_floats("bounds", mesh_or_bounds, (2, 3))
        if not (points[0] < points[1]).any() or (points[0] > points[1]).any():
            raise ArgumentError(
                f"bounds are {points[0]} and {points[1]} mm; give the least coordinates, then the greatest"
            )
    return bounding_sphere(points)


def _colour(irradiance: FloatArray) -> tuple[pygfx.Color, float]:
    """Return colour and intensity of a pygfx light with an irradiance (3,)."""
    strength = float(irradiance.max())
    if strength == 0.0:
        return pygfx.Color("#fff"), 0.0
    return pygfx.Color.from_physical(*(irradiance / strength).tolist()), strength
