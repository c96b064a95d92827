"""Contact shadow of meshes: balls, folds beside diffused shadow rays, and pictures with and without it."""

from dataclasses import replace

import numpy as np
import pytest

import shading_tolerances as tol
from shapes import unit_icosphere
from skinshade._core.arrays import dot
from skinshade.heads import builtin_head, head_scene
from skinshade.mesh import Mesh, diffuse_on_mesh
from skinshade.mesh.rays import open_caster
from skinshade.profile import Profile
from skinshade.rendering import RenderSettings, open_renderer
from skinshade.rendering.prepare.light_view import LightView
from skinshade.rendering.prepare.shadow_map import contact, rasterize_shadow_map
from skinshade.scene import DirectionalLight
from skinshade.shading.contact import contact_shadow
from skinshade.shading.tables import build_shadow_lut

STEP_MM, HEAD_RADIUS_MM = 0.1, 280.0
FOLDS = {
    "groove": [(-14, 0), (-0.5, 0), (-0.5, -1), (0.5, -1), (0.5, 0), (14, 0)],
    "step": [(-14, 1), (0, 1), (0, 0), (14, 0)],
    "ledge": [(-14, 1), (0, 1), (0, 0.4), (-1, 0.4), (-1, 0), (14, 0)],
}
"""Sections (x, z) of folds of 1 mm in a plane, mm."""


@pytest.mark.parametrize("level", [3, 5], ids=["642 vertices", "10242 vertices"])
@pytest.mark.parametrize("radius_mm", [10.0, 100.0])
def test_a_ball_has_no_contact_shadow_however_coarse_it_is(level, radius_mm):
    positions, faces = unit_icosphere(level)
    mesh = Mesh.checked(positions * radius_mm, faces, unit_mm=1.0)
    light = DirectionalLight((-0.63, 0.45, 0.63), np.ones(3))
    shadow_map = rasterize_shadow_map(head_view(light, np.zeros(3)), mesh)
    corners = mesh.positions_mm[mesh.faces]
    weights = np.random.default_rng(2).dirichlet(np.ones(3), len(corners))
    points = np.einsum("fk,fkd->fd", weights, corners)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    to_light, _ = light.at(points)
    facing = dot(normals, to_light) > 0.0
    result = contact(shadow_map, points[facing], normals[facing], to_light[facing])
    assert result.min() >= 1.0 - tol.ROUNDING.value


def head_view(light, middle):
    """Return a view as wide as that of a head, with texels of .56 mm."""
    matrices = light.view_and_projection(middle, HEAD_RADIUS_MM)
    return LightView(*matrices, middle, HEAD_RADIUS_MM)


def extruded(section, stations):
    """Return positions and faces of a section (N, 2), in x and z, moved along y."""
    count = len(section)
    rows = [np.insert(section, 1, y, axis=1) for y in stations]
    first = np.arange(count - 1)
    starts = (first + row * count for row in range(len(rows) - 1))
    faces = [
        np.stack(
            [corner, corner + 1, corner + 1 + count, corner, corner + 1 + count, corner + count]
        )
        for corner in starts
    ]
    return np.concatenate(rows), np.concatenate(faces, axis=1).T.reshape(-1, 3)


def fine_section(corners):
    """Return points (N, 2) of a section every .1 mm, and their normals (N, 2)."""
    points, normals = [], []
    for start, end in zip(np.array(corners, float), np.array(corners, float)[1:], strict=False):
        along = end - start
        count = round(float(np.linalg.norm(along)) / STEP_MM)
        points.append(start + along * (np.arange(count) / count)[:, None])
        normals.append(np.tile([-along[1], along[0]] / np.linalg.norm(along), (count, 1)))
    return np.concatenate(points), np.concatenate(normals)


@pytest.mark.parametrize("name", list(FOLDS))
def test_contact_halves_the_error_of_light_in_folds_beside_diffused_shadow_rays(name):
    """The truth is light on the fold, cast by rays and diffused over the surface."""
    profile = Profile.preset("skin-deon2007")
    lut = build_shadow_lut(profile, size=(256, 64), width_mm=(8.0, 160.0), sharpening=8.0)
    section, flat_normals = fine_section(FOLDS[name])
    normals = np.insert(flat_normals, 1, 0.0, axis=1)
    positions, faces = extruded(section, STEP_MM * np.arange(4))
    corners = np.array(FOLDS[name], float)
    closed = np.concatenate([[(-14.0, -30.0)], corners, [(14.0, -30.0), (-14.0, -30.0)]])
    body = Mesh.checked(*extruded(closed, [-60.0, 60.0]), unit_mm=1.0)
    caster = open_caster(body.positions_mm, body.faces)
    row = positions[: len(section)]
    near = np.abs(section[:, 0]) < 4.0
    errors = []
    for elevation in np.radians([20.0, 35.0, 50.0, 70.0]):
        for azimuth in (0.0, np.pi):
            across = np.cos(elevation) * np.cos(azimuth)
            light = DirectionalLight((across, 0.0, np.sin(elevation)), np.ones(3))
            to_light = np.tile(light.to_light, (len(row), 1))
            cosine = np.maximum(dot(normals, to_light), 0.0)
            hidden = caster.occluded(row + 1e-3 * normals, to_light, np.full(len(row), 1e3))
            values = np.tile(np.stack([cosine * ~hidden, cosine], axis=1), (4, 1))
            diffused = diffuse_on_mesh(positions, faces, values, profile, tolerance=1e-4)
            truth, open_light = np.moveaxis(diffused[: len(row)], 1, 0)
            shadow_map = rasterize_shadow_map(head_view(light, np.array([0.2, 0.1, 0.3])), body)
            share = contact(shadow_map, row, normals, to_light)
            shadow = contact_shadow(lut, np.ones((len(row), 3)), share, 8.0)
            errors.append([open_light - truth, open_light * shadow - truth])
    without, with_contact = np.sqrt(np.square(np.array(errors)[:, :, near]).mean(axis=(0, 2)))
    assert (with_contact <= tol.CONTACT_FOLDS.value * without).all()


@pytest.fixture(scope="module")
def head():
    lit = head_scene(builtin_head(), yaw_deg=28.0, pitch_deg=4.0)
    scene = replace(lit, environment=None)
    return scene, open_renderer(scene, "cpu")


def picture(head, **settings):
    scene, renderer = head
    return renderer.draw(scene.camera, (96, 80), 1, RenderSettings(**settings))


@pytest.mark.parametrize("shading", ["transfer", "lambert"])
def test_contact_darkens_a_small_share_of_a_head(head, shading):
    with_contact = picture(head, shading=shading, debug_view="direct")
    without = picture(head, shading=shading, debug_view="direct", contact_shadow=False)
    change = (without - with_contact)[..., :3].max(axis=2)
    assert change.min() >= 0.0
    assert 0.001 < np.mean(change > 0.01) < 0.1


@pytest.mark.slow
def test_the_formulas_of_2014_have_no_contact_shadow(head):
    settings = RenderSettings(shading="classic")
    assert not settings.has_contact
    without = replace(settings, contact_shadow=False)
    scene, renderer = head
    first, second = renderer.draw_many(scene.camera, (96, 80), 1, [settings, without])
    assert (first == second).all()


def test_pictures_drawn_together_keep_their_own_contact_setting(head):
    scene, renderer = head
    both = [RenderSettings(contact_shadow=value) for value in (True, False)]
    together = renderer.draw_many(scene.camera, (96, 80), 1, both)
    alone = [picture(head, contact_shadow=value) for value in (True, False)]
    assert all((a == b).all() for a, b in zip(together, alone, strict=True))
    assert (together[0] != together[1]).any()
