"""skinshade's lights as pygfx's, with shadow maps that hold the body."""

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
"""Of the map's depth range: keeps what is drawn with pygfx's materials from shadowing itself."""


def skin_light(
    light: Light, mesh_or_bounds: Mesh | ArrayLike, *, cast_shadow: bool = True
) -> pygfx.Light:
    """Return a pygfx light that shines as one of skinshade's does, in a world in mm.

    What `SkinMaterial` needs of a shadow map is set: the side of a body that faces the light
    (``shadow.cull_mode = "back"``, pygfx's default is the far one), with a range of depth as narrow as
    the body allows. Who changes ``angle`` or ``distance`` of a spot light makes pygfx forget the range:
    make another light instead. pygfx's own materials need the ``shadow.bias`` of .002 that is set.

    pygfx's point lights light and shadow skin as well, but nothing of theirs comes through the body.

    Parameters
    ----------
    light
        `skinshade.DirectionalLight` or `skinshade.SpotLight`; irradiance is kept in linear Rec.709.
    mesh_or_bounds
        What casts and receives: a mesh, or (2, 3) its least and greatest coordinates, mm.
    cast_shadow
        Whether it has a shadow map, without which no light comes through the body either.

    Returns
    -------
    pygfx.DirectionalLight or pygfx.SpotLight

    Raises
    ------
    ArgumentError
        If the bounds are not (2, 3) finite numbers, or enclose nothing.
    """
    middle, reach = _sphere(mesh_or_bounds)
    view, projection = light.view_and_projection(middle, reach)
    colour, strength = _colour(light.irradiance)
    if isinstance(light, DirectionalLight):
        made = pygfx.DirectionalLight(colour, strength, cast_shadow=cast_shadow)
        made.local.position = -view[:3, :3].T @ view[:3, 3]
        made.target.local.position = middle
        made.shadow.camera.width = made.shadow.camera.height = 2.0 / projection[0, 0]
        near = projection[2, 3] / projection[2, 2]
        far = near - 1.0 / projection[2, 2]
    else:
        axis = light.position_mm - light.target_mm
        made = pygfx.SpotLight(
            colour,
            strength * float(axis @ axis),
            cast_shadow=cast_shadow,
            decay=2,
            angle=math.radians(light.cone_deg),
            penumbra=1.0 - FULL_SHARE,
        )
        made.local.position = light.position_mm
        made.target.local.position = light.target_mm
        # In pygfx's own words, to the last bit: for any other angle it sets the range again.
        made.shadow.camera.fov = 180 / math.pi * 2 * made.angle
        made.shadow.camera.aspect = 1.0
        near = projection[2, 3] / projection[2, 2]
        far = projection[2, 3] / (1.0 + projection[2, 2])
    made.shadow.camera.depth_range = (float(near), float(far))
    made.shadow.cull_mode = "back"
    made.shadow.bias = OTHER_MATERIALS_BIAS
    return made


def _sphere(mesh_or_bounds: Mesh | ArrayLike) -> tuple[FloatArray, float]:
    """Return the middle (3,) and the reach of a body, mm."""
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
    """Return a colour of pygfx's and the intensity that make an irradiance (3,)."""
    strength = float(irradiance.max())
    if strength == 0.0:
        return pygfx.Color("#fff"), 0.0
    return pygfx.Color.from_physical(*(float(each) / strength for each in irradiance)), strength
