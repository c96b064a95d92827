"""Ambient light at the vertices: the sky's light, light through the body, and bounced light (MODEL §5)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..._core.arrays import FloatArray, dot
from ..._core.harmonics import MOST_ORDER, cosine_factors, harmonics
from ..._core.progress import Progress, silent
from ...mesh import Mesh, mesh_curvature
from ...mesh.ambient_rays import AmbientRays
from ...mesh.ambient_transfer import BOUNCES, share_sent_back
from ...params.choices import AmbientForm
from ...scene import Environment, Light
from ...shading.ambient import ambient_irradiance
from ...shading.deep_scatter import transmittance
from ...shading.skin import Skin
from .shadow_filter import WideFilter

__all__ = ["AmbientLight", "gather_ambient_light"]

LEAST_SHARE = 0.02
"""Least unoccluded irradiance by which the arriving light is divided, as a share of the sky's mean radiance.
Nine harmonics can be 0 or less where the sky is dark."""
LAMP_ORDER = 3
"""Greatest band of the harmonics in which the light of lamps bounces; a clamped cosine has no band 3."""


@dataclass(frozen=True)
class AmbientLight:
    """Ambient light at the vertices.

    Attributes
    ----------
    arriving
        (V, 3) irradiance over π that arrives from the sky.
    unoccluded
        (V, 3) irradiance over π that the sky's nine harmonics would have without occlusion, above 0.
    through
        (V, 3) irradiance over π that passes through the body from behind.
    bounced
        (V, 3) irradiance over π from the body's own lit parts.
    sky_harmonics
        (V, 9) harmonics of the directions in which the sky is visible, weighted by the cosine.
    """

    arriving: FloatArray
    unoccluded: FloatArray
    through: FloatArray
    bounced: FloatArray
    sky_harmonics: FloatArray


def gather_ambient_light(
    mesh: Mesh,
    environment: Environment,
    bands: FloatArray,
    lights: Sequence[tuple[Light, WideFilter]],
    skin: Skin,
    albedo: FloatArray,
    form: AmbientForm = AmbientForm.STATIC,
    progress: Progress = silent,
) -> AmbientLight:
    """Gather ambient light at the vertices of a mesh, before diffusion.

    Parameters
    ----------
    mesh
        Faces that hide the sky and reflect its light.
    environment
        The sky.
    bands
        (25, 3) harmonics of the sky's radiance.
    lights
        Lights with their wide filters; their light bounces from the surface.
    skin
        Material; its transmittance applies to light through the body.
    albedo
        (V, 3) diffuse albedo of the vertices.
    form
        Whether the sky's radiance itself reaches the vertices, or its harmonics of an order.
    progress
        Called with the name of the work and the fraction that is done.
    """
    rays = AmbientRays.cast(mesh.positions_mm, mesh.faces, mesh.normals, progress=progress)
    radiance_sh, nine = bands[: (form.order + 1) ** 2], bands[:9]
    sky = rays.visible_harmonics(max(form.order, LAMP_ORDER))
    reflectance = share_sent_back(np.clip(albedo, 0.0, 1.0))

    def bounced(light: FloatArray) -> FloatArray:
        return rays.bounced(light, reflectance, mesh.faces, BOUNCES)

    if form == AmbientForm.STATIC:
        exact = harmonics(mesh.normals, MOST_ORDER) @ (cosine_factors(MOST_ORDER)[:, None] * bands)
        arriving = np.maximum(rays.arriving(environment.means_around(rays.directions), exact), 0.0)
        from_body = bounced(arriving + _direct(mesh, lights))
    else:
        arriving = np.maximum(sky[:, : len(radiance_sh)] @ radiance_sh, 0.0)
        from_body = np.maximum(bounced(sky[:, : len(radiance_sh)] @ radiance_sh), 0.0)
        for light, _ in lights:
            from_body += np.maximum(bounced(_lamp_by_harmonics(mesh, light, sky)), 0.0)
    unoccluded = ambient_irradiance(nine, np.repeat(mesh.normals[:, None], 3, axis=1))
    least = LEAST_SHARE * np.maximum(nine[0] * np.sqrt(1.0 / (4.0 * np.pi)), 1e-30)
    passed = np.zeros((*rays.depth.shape, 3))
    leaves = np.isfinite(rays.depth) & (rays.depth > 0.0)
    depth = rays.depth[leaves].astype(np.float64)
    passed[leaves] = transmittance(depth, skin.profile.albedo, skin.sigma_per_mm)
    return AmbientLight(
        arriving,
        np.maximum(unoccluded, least),
        rays.through(passed, environment.means_around(rays.behind)),
        from_body,
        sky[:, :9],
    )


def _lamp_by_harmonics(mesh: Mesh, light: Light, sky: FloatArray) -> FloatArray:
    """Return the irradiance over π (V, 3) of a light by the harmonics `sky` (V, H) of its direction."""
    to_light, irradiance = light.at(mesh.positions_mm)
    count = (LAMP_ORDER + 1) ** 2
    shares = dot(sky[:, :count], harmonics(to_light, LAMP_ORDER))
    return shares[:, None] * irradiance


def _direct(mesh: Mesh, lights: Sequence[tuple[Light, WideFilter]]) -> FloatArray:
    """Return the irradiance over π of all lights at the vertices, (V, 3)."""
    total = np.zeros_like(mesh.positions)
    curvature = mesh_curvature(mesh.positions_mm, mesh.faces, mesh.normals)
    for light, wide_filter in lights:
        to_light, irradiance = light.at(mesh.positions_mm)
        lit = wide_filter.lit(mesh.positions_mm, mesh.normals, to_light, curvature)
        cosine = np.maximum(dot(mesh.normals, to_light), 0.0)
        total += (cosine * lit)[:, None] * irradiance / np.pi
    return total
