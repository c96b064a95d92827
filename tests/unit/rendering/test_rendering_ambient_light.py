import numpy as np
import pytest

import shading_tolerances as tol
from shapes import square, unit_icosphere
from skinshade.mesh import Mesh
from skinshade.params import SkinParams
from skinshade.params.choices import ShadowFilter
from skinshade.profile import Profile
from skinshade.rendering.prepare.ambient_light import gather_ambient_light
from skinshade.rendering.prepare.light_view import LightView
from skinshade.rendering.prepare.shadow_filter import build_filter
from skinshade.rendering.prepare.shadow_map import rasterize_shadow_map
from skinshade.scene import DirectionalLight, Environment
from skinshade.shading.deep_scatter import transmittance
from skinshade.shading.skin import Skin

RADIUS_MM = 80.0
SKIN = Skin.of(Profile.preset("skin-deon2007"), SkinParams())
GREY = np.full(3, 0.5)
EVEN = Environment.constant((0.5, 1.0, 2.0))


def lit(mesh, sky=EVEN, lamps=(), albedo=GREY, **options):
    width = SKIN.params.shadow_filter_width_mm
    maps = [rasterize_shadow_map(LightView.of(lamp, mesh), mesh) for lamp in lamps]
    filters = [build_filter(ShadowFilter.PERCENTAGE_CLOSER, each, width) for each in maps]
    lights = list(zip(lamps, filters, strict=True))
    radiance_sh, preconvolved = sky.radiance_sh(), sky.preconvolved()
    return gather_ambient_light(mesh, radiance_sh, preconvolved, lights, SKIN, albedo, **options)


def ball(level=3, inward=False):
    u, faces = unit_icosphere(level)
    n, f = (-u, faces[:, ::-1]) if inward else (u, faces)
    return Mesh.checked(RADIUS_MM * u, f, unit_mm=1.0, normals=n)


def bowl(opening):
    """The inside of a ball, open above the height that leaves this share of its area."""
    u, faces = unit_icosphere(4)
    kept = (u[faces][:, :, 2] <= 1.0 - 2.0 * opening).all(axis=1)
    return Mesh.checked(RADIUS_MM * u, faces[kept][:, ::-1], unit_mm=1.0, normals=-u)


@pytest.fixture(scope="module")
def around_ball():
    return lit(ball())


def test_a_convex_body_sees_all_of_the_sky_above_each_point_and_no_light_bounces(around_ball):
    assert np.allclose(around_ball.visibility, 1.0, atol=tol.ROUNDING_SUMS.value)
    assert np.abs(around_ball.bounced).max() <= tol.ROUNDING_SUMS.value


def test_a_sheet_sees_all_of_the_sky_on_its_side():
    plane = square(100.0, 6)
    found = lit(Mesh.checked(plane.positions, plane.faces, unit_mm=1.0))
    assert np.allclose(found.visibility, 1.0, atol=tol.ROUNDING_SUMS.value)


def test_a_closed_cavity_sees_nothing_of_it():
    found = lit(ball(4, inward=True))
    assert found.visibility.max() <= tol.CAVITY_LEAK.value
    assert (found.bounced <= tol.CAVITY_LEAK.value * np.array([0.5, 1.0, 2.0])).all()


@pytest.mark.parametrize("opening", [0.25, 0.5, 0.75])
def test_in_a_spherical_bowl_every_point_sees_as_much_as_is_open(opening):
    """Two parts of one sphere see one another by area alone."""
    mesh = bowl(opening)
    visibility = lit(mesh).visibility.mean(axis=1)
    deep = mesh.normals[:, 2] > 2.0 * opening - 1.0 + 0.15  # a rim's depth is uncertain
    share = visibility[deep]
    assert share.mean() == pytest.approx(opening, abs=tol.BOWL_MEAN.value)
    assert np.sqrt(np.mean((share - opening) ** 2)) <= tol.BOWL_RMS.value


def test_what_a_bowl_hides_is_lit_by_its_walls_and_the_brighter_the_more():
    dark, grey = (lit(bowl(0.5), albedo=np.full(3, a)).bounced for a in (0.0, 0.5))
    assert not dark.any()
    assert (grey > 0.0).all()
    # half the sky hidden by walls half lit: first bounces alone give 0.5·0.5·albedo of the sky
    middle = np.median(grey, axis=0) / np.array([0.5, 1.0, 2.0])
    assert np.allclose(middle, 0.5 * 0.5 * 0.5, rtol=tol.FIRST_BOUNCE.value)


def test_a_lamp_bounces_too():
    lamp = DirectionalLight((0.0, 0.0, 1.0), (3.0, 0.0, 0.0))
    plain, more = (lit(bowl(0.5), lamps=lamps).bounced for lamps in ((), (lamp,)))
    assert (more[:, 0] > plain[:, 0]).all()
    assert np.array_equal(more[:, 1:], plain[:, 1:])


def test_the_mean_way_through_a_ball_is_four_thirds_of_its_radius(around_ball):
    """Chords 2r·cos, weighted by the cosine over a hemisphere."""
    excess = around_ball.thickness_mm - 4.0 / 3.0 * RADIUS_MM
    assert abs(excess.mean()) <= tol.CHORD_TEXELS_MM.value
    assert np.abs(excess).max() <= 2.0 * tol.CHORD_TEXELS_MM.value


@pytest.mark.parametrize("thickness_mm", [2.0, 4.0])
def test_through_a_slab_comes_what_its_slanted_ways_let_through(thickness_mm):
    plane = square(160.0, 8)
    front, back = plane.positions, plane.positions - (0.0, 0.0, thickness_mm)
    faces = np.concatenate([plane.faces, plane.faces[:, ::-1] + len(front)])
    normals = np.repeat([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]], len(front), axis=0)
    slab = Mesh.checked(np.concatenate([front, back]), faces, unit_mm=1.0, normals=normals)
    middle = np.abs(slab.positions[:, :2] - 80.0).max(axis=1) < 41.0
    cosine = (np.arange(2000) + 0.5) / 2000.0
    passed = transmittance(thickness_mm / cosine, SKIN.profile.albedo, SKIN.sigma_per_mm)
    truth = 2.0 * (cosine[:, None] * passed).mean(axis=0) * (0.5, 1.0, 2.0)
    red = lit(slab).through[middle][:, 0]
    assert (red <= truth[0]).all(), "the uncertainty of depth is added"
    assert np.allclose(red, truth[0], rtol=tol.SLAB_THROUGH.value)


def test_the_sky_is_linear_and_its_colour_is_kept(around_ball):
    twice = lit(ball(), Environment.constant((1.0, 2.0, 4.0)))
    assert np.allclose(twice.through, 2.0 * around_ball.through, rtol=1e-5)
    assert np.allclose(twice.visibility, around_ball.visibility)
    assert (around_ball.through[:, 0] > around_ball.through[:, 1]).all(), "red goes farthest"


def test_progress_is_told_and_ends():
    said = []
    lit(ball(1), progress=lambda what, share: said.append((what, share)))
    assert said[0] == ("ambient light", 0.0)
    assert said[-1] == ("ambient light", 1.0)
    assert [share for _, share in said] == sorted(share for _, share in said)
