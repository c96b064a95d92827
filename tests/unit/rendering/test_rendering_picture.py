from dataclasses import replace

import numpy as np
import pytest

import shading_tolerances as tol
import skinshade as sk
from shapes import square, unit_icosphere
from skinshade.lut import build_coat_lut
from skinshade.mesh import Mesh
from skinshade.params.choices import TERM_VIEWS
from skinshade.profile import Profile
from skinshade.rendering import RenderSettings, open_renderer, render
from skinshade.scene import Camera, DirectionalLight, Environment, Material, Scene
from skinshade.shading.coat import coat

RADIUS_MM = 80.0
CAMERA = Camera((0.0, 0.0, 700.0), (0.0, 0.0, 0.0), 16.0)
KEY = DirectionalLight.from_angles(-40.0, 25.0, 1.0)
RIM = DirectionalLight((0.8, 0.1, -0.6), (0.5, 1.0, 2.0))
SIZE = (64, 48)
BLACK = (0.0, 0.0, 0.0)
MATERIAL = Material()


def ball(level=3, radius=RADIUS_MM):
    u, faces = unit_icosphere(level)
    return Mesh.checked(radius * u, faces, unit_mm=1.0, normals=u)


def scene(*lights, **changes):
    return Scene(ball(), **({"camera": CAMERA, "material": MATERIAL, "lights": lights} | changes))


def draw(source, size=SIZE, samples=1, camera=CAMERA, **settings):
    """Draw a scene or an open renderer."""
    renderer = open_renderer(source) if isinstance(source, Scene) else source
    return renderer.draw(camera, size, samples, RenderSettings(**settings))


@pytest.fixture(scope="module")
def lit():
    """A ball with a lamp, a rim light and a coloured sky, before black."""
    return open_renderer(
        scene(KEY, RIM, environment=Environment.studio(scale=0.5), background=BLACK)
    )


@pytest.fixture(scope="module")
def analytic():
    """Normals (H, W, 3) of the ball at the centres of the pixels, zero where it is missed."""
    width, height = SIZE
    tangent = np.tan(np.radians(8.0))
    x = (2.0 * np.arange(width) + 1.0 - width) / height * tangent
    y = (height - 2.0 * np.arange(height) - 1.0) / height * tangent
    ray = np.stack(np.broadcast_arrays(x, y[:, None], -1.0), axis=-1)
    ray /= np.linalg.norm(ray, axis=-1, keepdims=True)
    along = -ray[..., 2] * 700.0
    root = along**2 - 700.0**2 + RADIUS_MM**2
    point = ray * (along - np.sqrt(np.maximum(root, 0.0)))[..., None] + (0.0, 0.0, 700.0)
    return np.where((root > 0.0)[..., None], point / RADIUS_MM, 0.0)


def test_a_picture_has_the_size_and_type_that_were_promised():
    picture = sk.render(scene(KEY), size=(31, 17), samples=2)
    assert (picture.shape, picture.dtype) == ((17, 31, 4), np.float32)
    assert np.isfinite(picture).all()
    assert picture.min() >= 0.0
    assert picture[..., 3].max() <= 1.0


def test_the_package_the_function_and_an_opened_renderer_draw_the_same():
    one, settings = scene(KEY), RenderSettings(seed=5)
    pictures = [
        sk.render(one, size=SIZE, samples=3, settings=settings),
        render(one, size=SIZE, samples=3, settings=settings, backend="cpu"),
        open_renderer(one).draw(one.camera, SIZE, 3, settings),
    ]
    assert len({picture.tobytes() for picture in pictures}) == 1


def test_the_seed_decides_every_byte(lit):
    one, again, other = (draw(lit, samples=3, seed=seed) for seed in (4, 4, 5))
    assert one.tobytes() == again.tobytes()
    assert one.tobytes() != other.tobytes()


def test_one_sample_lies_in_the_middle_whatever_the_seed(lit):
    assert draw(lit, seed=1).tobytes() == draw(lit, seed=2).tobytes()


@pytest.mark.parametrize("samples", [1, 4, 7])
def test_alpha_counts_samples_and_adds_up_to_the_balls_outline(lit, samples):
    alpha = draw(lit, samples=samples)[..., 3]
    counted = alpha * samples
    assert np.abs(counted - np.rint(counted)).max() <= 1e-5
    assert alpha[24, 32] == 1.0
    assert alpha[0, 0] == 0.0
    radius = RADIUS_MM / np.sqrt(700.0**2 - RADIUS_MM**2) / np.tan(np.radians(8.0)) * 24.0
    assert alpha.sum() == pytest.approx(np.pi * radius**2, rel=tol.BALL_COVER.value)


def test_the_background_fills_what_the_ball_leaves():
    colour = np.array([0.25, 0.5, 2.0])
    plain, before = (draw(scene(KEY, background=b), samples=4) for b in (BLACK, colour))
    filled = plain[..., :3] + (1.0 - plain[..., 3:]) * colour
    assert np.abs(before[..., :3] - filled).max() <= tol.FLOAT32.value
    assert np.array_equal(before[..., 3], plain[..., 3])
    assert ((plain[..., 3] > 0.0) & (plain[..., 3] < 1.0)).any()


def test_a_visible_environment_stands_behind_upright():
    rows = np.linspace(1.0, 0.0, 64, dtype=np.float32)[:, None, None]
    sky = Environment(np.broadcast_to(rows, (64, 128, 3)).copy(), visible=True)
    picture = draw(scene(environment=sky), camera=replace(CAMERA, vertical_fov_deg=90.0))
    # Looking along −z: v = acos(y)/π from the top, and radiance 1 − v.
    y = np.tan(np.radians(45.0)) * (1.0 - 1.0 / 48.0)
    top = 1.0 - np.arccos(y / np.sqrt(1.0 + y * y + (1.0 / 48.0) ** 2)) / np.pi
    assert picture[0, 31, 0] == pytest.approx(top, abs=0.5 / 63.0)
    assert picture[-1, 31, 0] == pytest.approx(1.0 - top, abs=0.5 / 63.0)


@pytest.mark.parametrize("shading", ["lambert", "classic", "transfer"])
def test_the_terms_of_the_light_add_up_to_the_picture(lit, shading):
    picture = draw(lit, samples=2, shading=shading)
    views = [draw(lit, samples=2, shading=shading, debug_view=view) for view in TERM_VIEWS]
    total = np.sum([view[..., :3] for view in views], axis=0, dtype=np.float64)
    assert np.allclose(picture[..., :3], total, rtol=1e-5, atol=1e-6)
    assert all(np.array_equal(view[..., 3], picture[..., 3]) for view in views)
    given = {name for name, view in zip(TERM_VIEWS, views, strict=True) if view[..., :3].any()}
    nothing = {
        "lambert": {"deep-scatter", "ambient-deep-scatter"},
        "classic": {"ambient-deep-scatter"},
        "transfer": set(),
    }
    assert set(TERM_VIEWS) - given == nothing[shading]


@pytest.fixture(scope="module")
def lamps():
    """Renderers of the key, the rim, both, and a key three times brighter."""
    brighter = replace(KEY, irradiance=3.0 * KEY.irradiance)
    sets = {"key": (KEY,), "rim": (RIM,), "both": (KEY, RIM), "bright": (brighter,)}
    return {name: open_renderer(scene(*each, background=BLACK)) for name, each in sets.items()}


@pytest.mark.parametrize("shading", ["lambert", "classic", "transfer"])
def test_light_is_linear(lamps, shading):
    lit_by = {
        name: draw(each, shading=shading)[..., :3].astype(float) for name, each in lamps.items()
    }
    assert np.allclose(lit_by["bright"], 3.0 * lit_by["key"], rtol=1e-6, atol=1e-7)
    assert np.allclose(lit_by["both"], lit_by["key"] + lit_by["rim"], rtol=1e-6, atol=1e-7)


def test_the_sky_is_linear_too():
    sky = Environment.studio()
    one, twice = (
        draw(scene(environment=e, background=BLACK)) for e in (sky, replace(sky, scale=2.0))
    )
    assert np.allclose(twice[..., :3], 2.0 * one[..., :3], rtol=1e-5, atol=1e-6)
    assert one[..., :3].max() > 0.1


def test_lambert_is_albedo_times_the_cosine_under_the_coat(analytic):
    one = replace(scene(KEY, background=BLACK), mesh=ball(level=4))
    found = draw(one, shading="lambert", debug_view="direct")
    inside = analytic[..., 2] > 0.3
    assert (found[inside][:, 3] == 1.0).all()
    n = analytic[inside]
    view = np.array([0.0, 0.0, 700.0]) - RADIUS_MM * n
    view /= np.linalg.norm(view, axis=1)[:, None]
    params = one.material.params
    n_dot_v = (n * view).sum(axis=1)
    gloss, reflectance = (np.full(len(n), v) for v in (params.gloss, params.reflectance))
    lut = build_coat_lut(reflectance=params.reflectance)
    share = 1.0 - coat(lut, n_dot_v, gloss, reflectance, params.reflectance)[0]
    cosine = np.maximum(n @ KEY.to_light, 0.0)
    truth = (cosine * share)[:, None] * one.material.albedo[0, 0]
    assert np.abs(found[inside][:, :3] - truth).max() <= tol.FACETED_SHADING.value


def test_a_profile_narrower_than_anything_is_lambert(lit):
    dot = Profile.gaussians(variances_mm2=[1e-8], weights=[[1.0] * 3], albedo=(0.5, 0.4, 0.3))
    # White light leaves a white body alike in all directions.
    white = Material(profile=dot, albedo=np.ones((1, 1, 3), dtype=np.float32))
    one = scene(KEY, RIM, material=white, environment=Environment.studio(scale=0.5))
    renderer = open_renderer(one)
    lambert = draw(renderer, shading="lambert")
    for tier in ("scalar", "tensor", "diffused-normals"):
        same = draw(renderer, tier=tier)
        assert np.abs(same - lambert).max() <= tol.NO_SCATTER.value, tier
    skin, plain = draw(lit), draw(lit, shading="lambert")
    assert np.abs(skin - plain).max() > 4.0 * tol.NO_SCATTER.value


def test_a_white_ball_in_an_even_sky_cannot_be_seen():
    white = Material(albedo=np.ones((1, 1, 3), dtype=np.float32))
    sky = replace(Environment.constant((0.5, 1.0, 2.0)), visible=True)
    picture = draw(scene(environment=sky, material=white), shading="lambert", samples=2)
    assert np.abs(picture[..., :3] / (0.5, 1.0, 2.0) - 1.0).max() <= tol.FURNACE.value
    assert 0.3 < picture[..., 3].mean() < 0.9


def test_a_mirrored_scene_gives_the_mirrored_picture():
    left, right = (replace(KEY, to_light=KEY.to_light * (s, 1.0, 1.0)) for s in (1.0, -1.0))
    one, other = draw(scene(left)), draw(scene(right))
    assert np.abs(one - other[:, ::-1]).max() <= tol.MIRRORED_BALL.value
    assert one[:, :32].mean() > 1.2 * one[:, 32:].mean(), "light comes from the left"
    assert one[:24].mean() > 1.1 * one[24:].mean(), "and from above"


def test_another_unit_of_the_same_body_is_the_same_picture():
    cm = replace(ball(), positions=ball().positions / 10.0, unit_mm=10.0)
    one, other = draw(scene(KEY)), draw(replace(scene(KEY), mesh=cm))
    assert np.abs(one - other).max() <= tol.OTHER_UNIT.value


def test_a_sheet_seen_edge_on_is_not_there():
    plane = square(100.0, 4)
    sheet = Mesh.checked(plane.positions[:, [2, 0, 1]], plane.faces, unit_mm=1.0)
    picture = draw(replace(scene(KEY), mesh=sheet))
    assert not picture[..., 3].any()
