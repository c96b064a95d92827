from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import shading_tolerances as tol
from shapes import square, unit_icosphere
from skinshade.mesh import Mesh
from skinshade.params.choices import ShadowFilter
from skinshade.rendering.prepare.light_view import MAP_SIZE, LightView
from skinshade.rendering.prepare.shadow_filter import build_filter
from skinshade.rendering.prepare.shadow_map import rasterize_shadow_map, thickness
from skinshade.scene import DirectionalLight, SpotLight
from skinshade.shading.shadow import smoothstep

ONES = np.ones(3)
ABOVE = DirectionalLight((0.0, 0.0, 1.0), ONES)
LAMP = SpotLight((0.0, 0.0, 700.0), (0.0, 0.0, 0.0), ONES, 45.0)
ALONG = np.linspace(-12.0, 12.0, 49)


def shadow_map_of(light, mesh):
    return rasterize_shadow_map(LightView.of(light, mesh), mesh)


@cache
def wall(reach):
    """A floor at z = 0, and 50 mm over its half x < 0 a roof."""
    plane = square(2.0 * reach, 2)
    floor = plane.positions - (reach, reach, 0.0)
    roof = plane.positions * (0.5, 1.0, 1.0) + (-reach, -reach, 50.0)
    faces = np.concatenate([plane.faces, plane.faces + len(floor)])
    return Mesh.checked(np.concatenate([floor, roof]), faces, unit_mm=1.0)


def across_edge(light, reach, width, edge_at=0.0, stretch=1.0, kind="percentage-closer"):
    """The filter along x on the floor around an edge, at `ALONG`·stretch from it."""
    points = np.zeros((ALONG.size, 3))
    points[:, 0], points[:, 1] = edge_at + stretch * ALONG, 0.3
    normals = np.tile([0.0, 0.0, 1.0], (ALONG.size, 1))
    to_light, _ = light.at(points)
    wide_filter = build_filter(ShadowFilter(kind), shadow_map_of(light, wall(reach)), width)
    return wide_filter.lit(points, normals, to_light, np.zeros(ALONG.size))


@pytest.mark.parametrize("light", [ABOVE, LAMP], ids=["parallel", "lamp"])
@pytest.mark.parametrize("reach", [60.0, 150.0, 400.0])
@pytest.mark.parametrize("width", [4.0, 10.0])
def test_past_a_straight_edge_the_filter_is_a_smoothstep_of_its_width_in_mm(light, reach, width):
    """Whatever a texel of the map is: 0.1 to 0.8 mm here."""
    found = across_edge(light, reach, width)
    assert np.abs(found - smoothstep(ALONG / width + 0.5)).max() <= tol.SHADOW_PROFILE.value
    assert (found[-0.5 * width - 1.0 > ALONG] == 0.0).all()
    assert (found[0.5 * width + 1.0 < ALONG] == 1.0).all()
    middle = ALONG[np.argmin(np.abs(found - 0.5))]
    assert abs(middle) <= 0.5, "the edge lies where the roof ends"


@pytest.mark.parametrize("light", [ABOVE, LAMP], ids=["parallel", "lamp"])
@pytest.mark.parametrize("reach", [60.0, 150.0])
@pytest.mark.parametrize("width", [4.0, 10.0])
def test_the_variance_filter_passes_for_the_same_smoothstep(light, reach, width):
    """A Gaussian is all but one; a lamp's texels are taken as in the body's middle."""
    found = across_edge(light, reach, width, kind="variance")
    assert np.abs(found - smoothstep(ALONG / width + 0.5)).max() <= tol.VARIANCE_PROFILE.value
    assert (found[-width > ALONG] < 0.01).all()
    assert (found[width < ALONG] > 0.99).all()


def test_the_width_is_measured_across_the_light():
    slanted = DirectionalLight((1.0, 0.0, 1.0), ONES)
    found = across_edge(slanted, 150.0, 8.0, edge_at=-50.0, stretch=np.sqrt(2.0))
    assert np.abs(found - smoothstep(ALONG / 8.0 + 0.5)).max() <= tol.SHADOW_PROFILE.value


@cache
def ball(level, radius=60.0):
    u, faces = unit_icosphere(level)
    return u, Mesh.checked(radius * u, faces, unit_mm=1.0, normals=u)


def filtered(light, u, mesh, radius=60.0):
    to_light, _ = light.at(mesh.positions_mm)
    kappa = np.full(len(u), 1.0 / radius)
    wide_filter = build_filter(ShadowFilter.PERCENTAGE_CLOSER, shadow_map_of(light, mesh), 8.0)
    found = wide_filter.lit(mesh.positions_mm, u, to_light, kappa)
    return found, (u * to_light).sum(axis=1)


@pytest.mark.parametrize(
    "light",
    [
        ABOVE,
        DirectionalLight((0.5, -0.3, 0.2), ONES),
        SpotLight((300.0, 90.0, 0.0), (0, 0, 0), ONES),
    ],
    ids=["above", "aslant", "lamp"],
)
def test_a_ball_casts_no_shadow_on_its_lit_side(light):
    found, cosine = filtered(light, *ball(4))
    assert found[cosine > 0.15].min() == 1.0
    assert found[cosine > 0.0].mean() > 0.99


def test_what_a_body_hides_from_the_light_is_dark():
    u, mesh = ball(3)
    both = np.concatenate([mesh.positions, 0.5 * mesh.positions - (0.0, 0.0, 200.0)])
    pair = Mesh.checked(both, np.concatenate([mesh.faces, mesh.faces + len(u)]), unit_mm=1.0)
    found, _ = filtered(ABOVE, np.concatenate([u, u]), pair)
    behind = found[len(u) :]
    assert behind.max() == 0.0


@settings(max_examples=5)
@given(st.floats(-1.0, 1.0), st.floats(-1.0, 1.0), st.floats(0.3, 1.0))
def test_thickness_of_a_ball_is_its_chord_along_the_light(x, y, z):
    u, mesh = ball(4)
    light = DirectionalLight((x, y, z), ONES)
    shadow_map = shadow_map_of(light, mesh)
    found = thickness(shadow_map, mesh.positions_mm, u, 0.0, 0.0, 8)
    cosine = u @ light.to_light
    steep = np.abs(cosine) > 0.4
    chord = np.maximum(-2.0 * 60.0 * cosine, 0.0)
    assert np.abs(found - chord)[steep].max() <= tol.CHORD_MM.value
    inside = thickness(shadow_map, 0.5 * mesh.positions_mm, u, 0.0, 0.0, 8)
    depth = 0.5 * 60.0 * (np.sqrt(4.0 - 1.0 + cosine**2) - cosine)
    assert np.abs(inside - depth).max() <= tol.CHORD_MM.value


@pytest.mark.parametrize("thickness_mm", [2.0, 10.0])
@pytest.mark.parametrize("degrees", [0.0, 40.0])
@pytest.mark.parametrize("taps", [8, 32])
def test_thickness_of_a_slab_grows_with_the_slant_of_the_light(thickness_mm, degrees, taps):
    plane = square(200.0, 2)
    front = plane.positions - (100.0, 100.0, 0.0)
    back = front - (0.0, 0.0, thickness_mm)
    faces = np.concatenate([plane.faces, plane.faces[:, ::-1] + len(front)])
    slab = Mesh.checked(np.concatenate([front, back]), faces, unit_mm=1.0)
    light = DirectionalLight((np.sin(np.radians(degrees)), 0.0, np.cos(np.radians(degrees))), ONES)
    x = np.linspace(-20.0, 20.0, 9)
    points = np.column_stack([x, 0.5 * x, np.full(9, -thickness_mm)])
    normals = np.tile([0.0, 0.0, -1.0], (9, 1))
    shadow_map = shadow_map_of(light, slab)
    chord = thickness_mm / np.cos(np.radians(degrees))
    for radius in (0.0, 5.0):
        # Taps around the point see the same mean depth, as far as their own mean is the middle.
        found = thickness(shadow_map, points, normals, 0.0, radius, taps)
        assert np.abs(found - chord).max() <= tol.SLAB_MM.value
    inwards = thickness(shadow_map, points, normals, 0.5, 0.0, taps)
    less = 0.5 / np.cos(np.radians(degrees))
    assert np.abs(inwards - (chord - less)).max() <= tol.SLAB_MM.value


def test_beyond_the_rim_of_a_sheet_taps_find_nothing():
    plane = square(100.0, 2)
    front, back = plane.positions, plane.positions - (0.0, 0.0, 6.0)
    faces = np.concatenate([plane.faces, plane.faces[:, ::-1] + len(front)])
    slab = Mesh.checked(np.concatenate([front, back]), faces, unit_mm=1.0)
    points = np.array([[0.0, 50.0, -6.0], [50.0, 50.0, -6.0]])
    normals = np.tile([0.0, 0.0, -1.0], (2, 1))
    rim, middle = thickness(shadow_map_of(ABOVE, slab), points, normals, 0.0, 4.0, 32)
    assert middle == pytest.approx(6.0, abs=1e-9)
    assert rim == pytest.approx(3.0, abs=0.7)


def test_lookups_outside_a_map_clamp_to_its_edge():
    """Floor and roof extend past a spot light's cone; the edge of a directional light's map is empty."""
    points, normals = (
        np.array([[-10.0, 0.0, 0.0], [-60.0, 0.0, 0.0]]),
        np.tile([0.0, 0.0, 1.0], (2, 1)),
    )
    narrow = SpotLight((0.0, 0.0, 700.0), (0.0, 0.0, 0.0), ONES, 2.0)
    found = thickness(shadow_map_of(narrow, wall(150.0)), points, normals, 0.0, 1.0, 8)
    assert np.abs(found - 50.0).max() <= tol.SLAB_MM.value
    parallel = shadow_map_of(ABOVE, wall(150.0))
    for depths in (parallel.nearest_mm, parallel.occluder_mm):
        rim = np.concatenate([depths[[0, -1]].ravel(), depths[:, [0, -1]].ravel()])
        assert np.isinf(rim).all()


@pytest.mark.parametrize("kind", ["percentage-closer", "variance"])
def test_up_to_the_rim_of_a_cone_that_the_body_fills_shadow_is_shadow(kind):
    """Beyond the rim the roof goes on, whatever the map sees there."""
    narrow = SpotLight((0.0, 0.0, 700.0), (0.0, 0.0, 0.0), ONES, 2.0)
    points = np.zeros((2, 3))
    points[:, 0] = -23.5, 23.5
    normals, to_light = np.tile([0.0, 0.0, 1.0], (2, 1)), narrow.at(points)[0]
    wide_filter = build_filter(ShadowFilter(kind), shadow_map_of(narrow, wall(150.0)), 10.0)
    shadowed, lit = wide_filter.lit(points, normals, to_light, np.zeros(2))
    assert shadowed <= tol.SHADOW_PROFILE.value
    assert lit == pytest.approx(1.0, abs=tol.SHADOW_PROFILE.value)


def test_the_extremes_that_spare_taps_do_not_change_the_filter():
    """Where the nearest or farthest depth within the reach decides, no tap is evaluated."""
    u, mesh = ball(3)
    shadow_map, kappa = shadow_map_of(LAMP, mesh), np.full(len(u), 1.0 / 60.0)
    to_light, _ = LAMP.at(mesh.positions_mm)
    for width in (1.0, 4.0, 8.0):
        wide_filter = build_filter(ShadowFilter.PERCENTAGE_CLOSER, shadow_map, width)
        all_taps = replace(wide_filter, reach=0)
        found, truth = (
            f.lit(mesh.positions_mm, u, to_light, kappa) for f in (wide_filter, all_taps)
        )
        assert np.allclose(found, truth, atol=1e-12)


def test_no_filter_is_wider_than_its_map():
    _, mesh = ball(3)
    wide = build_filter(ShadowFilter.PERCENTAGE_CLOSER, shadow_map_of(LAMP, mesh), 1e6)
    assert wide.reach == MAP_SIZE


@pytest.mark.slow
def test_a_lamp_amid_the_body_still_finds_its_shadows():
    """Where the plane of the lamp cuts the body, a texel of its map is as small as nothing."""
    u, mesh = ball(3)
    beside = SpotLight((100.0, 0.0, 0.0), (100.0, 0.0, -50.0), ONES, 40.0)
    found, _ = filtered(beside, u, mesh)
    assert found.min() >= 0.0
    assert found.max() <= 1.0
