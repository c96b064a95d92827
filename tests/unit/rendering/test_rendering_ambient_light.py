import numpy as np
import pytest

import shading_tolerances as tol
import skinshade as sk
from shapes import square, unit_icosphere
from skinshade.mesh import Mesh
from skinshade.mesh.ambient_transfer import share_sent_back
from skinshade.params import SkinParams
from skinshade.params.choices import AmbientForm, ShadowFilter
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
    colours = np.broadcast_to(albedo, mesh.positions.shape)
    return gather_ambient_light(mesh, sky, sky.radiance_sh(4), lights, SKIN, colours, **options)


def visibility(light):
    return light.arriving / light.unoccluded


def ball(level=3, inward=False):
    u, faces = unit_icosphere(level)
    n, f = (-u, faces[:, ::-1]) if inward else (u, faces)
    return Mesh.checked(RADIUS_MM * u, f, unit_mm=1.0, normals=n)


def open_share(mesh):
    """The share of the ball's area that a bowl lacks."""
    a, b, c = (mesh.positions[mesh.faces[:, corner]] for corner in range(3))
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()
    u, faces = unit_icosphere(4)
    a, b, c = (RADIUS_MM * u[faces[:, corner]] for corner in range(3))
    return 1.0 - area / (0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum())


def bowl(opening):
    """The inside of a ball, open above the height that leaves this share of its area."""
    u, faces = unit_icosphere(4)
    kept = (u[faces][:, :, 2] <= 1.0 - 2.0 * opening).all(axis=1)
    return Mesh.checked(RADIUS_MM * u, faces[kept][:, ::-1], unit_mm=1.0, normals=-u)


@pytest.fixture(scope="module")
def around_ball():
    return lit(ball())


def test_a_convex_body_sees_all_of_the_sky_above_each_point_and_no_light_bounces(around_ball):
    assert np.allclose(visibility(around_ball), 1.0, atol=tol.ROUNDING_SUMS.value)
    assert np.abs(around_ball.bounced).max() <= tol.ROUNDING_SUMS.value


def test_a_sheet_sees_all_of_the_sky_on_its_side():
    plane = square(100.0, 6)
    found = lit(Mesh.checked(plane.positions, plane.faces, unit_mm=1.0))
    assert np.allclose(visibility(found), 1.0, atol=tol.ROUNDING_SUMS.value)


def test_a_closed_cavity_sees_nothing_of_it():
    found = lit(ball(4, inward=True))
    assert visibility(found).max() <= tol.CAVITY_LEAK.value
    assert (found.bounced <= tol.CAVITY_LEAK.value * np.array([0.5, 1.0, 2.0])).all()


@pytest.mark.parametrize("opening", [0.25, 0.5, 0.75])
def test_in_a_spherical_bowl_every_point_sees_as_much_as_is_open(opening):
    """Two parts of one sphere see one another by area alone."""
    mesh = bowl(opening)
    seen = visibility(lit(mesh)).mean(axis=1)
    deep = mesh.normals[:, 2] > 2.0 * opening - 1.0 + 0.15  # a rim's depth is uncertain
    share = seen[deep]
    truth = open_share(mesh)
    assert share.mean() == pytest.approx(truth, abs=tol.BOWL_MEAN.value)
    assert np.sqrt(np.mean((share - truth) ** 2)) <= tol.BOWL_RMS.value


@pytest.mark.parametrize("opening", [0.25, 0.5, 0.75])
def test_light_bounces_in_a_spherical_bowl_as_in_an_integrating_sphere(opening):
    """All points see one another by area alone, so that the bounces are a geometric series."""
    mesh = bowl(opening)
    sent_back = share_sent_back(GREY[0])
    truth = open_share(mesh)
    series = truth * sum((sent_back * (1.0 - truth)) ** bounce for bounce in range(1, 5))
    deep = mesh.normals[:, 2] > 2.0 * opening - 1.0 + 0.15
    bounced = lit(mesh).bounced[deep].mean(axis=0) / np.array([0.5, 1.0, 2.0])
    assert np.allclose(bounced, series, rtol=tol.BOUNCES.value)


def test_a_lamp_bounces_too():
    lamp = DirectionalLight((0.0, 0.0, 1.0), (3.0, 0.0, 0.0))
    for form in AmbientForm:
        plain, more = (lit(bowl(0.5), lamps=lamps, form=form).bounced for lamps in ((), (lamp,)))
        assert (more[:, 0] >= plain[:, 0]).all()
        assert more[:, 0].mean() > 1.2 * plain[:, 0].mean()
        assert np.allclose(more[:, 1:], plain[:, 1:], rtol=1e-12)


@pytest.mark.parametrize("form", [AmbientForm.ORDER_2, AmbientForm.ORDER_4])
def test_harmonics_give_an_even_sky_the_light_of_the_sky_itself(form):
    static, by_harmonics = (lit(bowl(0.5), form=each) for each in (AmbientForm.STATIC, form))
    for name in ("arriving", "bounced", "through"):
        one, other = getattr(static, name), getattr(by_harmonics, name)
        assert np.allclose(one, other, atol=tol.ROUNDING_SUMS.value, rtol=1e-6)


def test_under_a_coloured_sky_harmonics_of_order_4_are_nearer_than_those_of_order_2():
    forms = {form: lit(bowl(0.5), Environment.studio(), form=form) for form in AmbientForm}
    truth = forms[AmbientForm.STATIC].arriving
    errors = {
        form: np.sqrt(np.square(light.arriving - truth).mean()) for form, light in forms.items()
    }
    assert errors[AmbientForm.ORDER_4] < errors[AmbientForm.ORDER_2] < 0.3 * truth.mean()


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
    assert np.allclose(red, truth[0], rtol=tol.SLAB_THROUGH.value)


def test_the_sky_is_linear_and_its_colour_is_kept(around_ball):
    twice = lit(ball(), Environment.constant((1.0, 2.0, 4.0)))
    assert np.allclose(twice.through, 2.0 * around_ball.through, rtol=1e-5)
    assert np.allclose(visibility(twice), visibility(around_ball))
    assert (around_ball.through[:, 0] >= 0.5 * around_ball.through[:, 1]).all(), "red goes farthest"


def test_progress_is_told_and_ends():
    said = []
    lit(ball(1), progress=lambda what, share: said.append((what, share)))
    assert said[0] == ("ambient light", 0.0)
    assert said[-1] == ("ambient light", 1.0)
    assert [share for _, share in said] == sorted(share for _, share in said)


def test_a_body_of_13_m_is_drawn():
    u, faces = unit_icosphere(3)
    camera = sk.Camera((0.0, 0.0, 40_000.0), (0.0, 0.0, 0.0))
    body = Mesh.checked(u, faces, unit_mm=6500.0, normals=u)
    scene = sk.Scene(body, camera, sk.Material(), environment=Environment.constant((1.0, 1.0, 1.0)))
    image = sk.render(scene, size=(16, 16), samples=1, backend="cpu")
    assert np.isfinite(image).all()
    assert image[8, 8, :3].min() > 0.0
