from dataclasses import replace

import numpy as np
import pytest

import shading_tolerances as tol
from shapes import square, unit_icosphere
from skinshade.mesh import Mesh
from skinshade.params.choices import TERM_VIEWS, View
from skinshade.rendering import RenderSettings, open_renderer
from skinshade.rendering.tone import display_values
from skinshade.scene import Camera, DirectionalLight, Environment, Material, Scene
from skinshade.shading.tonemap import filmic, srgb_from_linear

FRONT = DirectionalLight((0.0, 0.0, 1.0), (np.pi, np.pi, np.pi))
BACK = DirectionalLight((0.0, 0.0, -1.0), (np.pi, np.pi, np.pi))
MATERIAL = Material()
AHEAD = Camera((0.0, 0.0, 500.0), (0.0, 0.0, 0.0), 20.0)


def ball(radius, inside_out=False):
    u, faces = unit_icosphere(3)
    if inside_out:
        return Mesh.checked(radius * u, faces[:, ::-1], unit_mm=1.0, normals=-u)
    return Mesh.checked(radius * u, faces, unit_mm=1.0, normals=u)


def view(renderer, name, size=(32, 32), camera=AHEAD, **settings):
    """Colours (N, 3) of a view where the body covers whole pixels, and the picture itself."""
    picture = renderer.draw(camera, size, 1, RenderSettings(debug_view=name, **settings))
    return picture[picture[..., 3] == 1.0][:, :3].astype(np.float64), picture


@pytest.fixture(scope="module")
def lit():
    rim = DirectionalLight((0.7, 0.1, -0.7), (3.0, 2.0, 1.0))
    sky = Environment.studio()
    return open_renderer(Scene(ball(60.0), AHEAD, MATERIAL, (FRONT, rim), sky))


@pytest.fixture(scope="module")
def sheet():
    """A white sheet of 100 mm, upright, its texture upright on it."""
    plane = square(100.0, 8)
    uvs = plane.positions[:, :2] / 100.0 * (1.0, -1.0) + (0.0, 1.0)
    mesh = Mesh.checked(plane.positions - (50.0, 50.0, 0.0), plane.faces, unit_mm=1.0, uvs=uvs)
    white = replace(MATERIAL, albedo=np.ones((1, 1, 3), dtype=np.float32))
    return Scene(mesh, AHEAD, white, (FRONT,))


# 100 mm at 500 mm fill the picture exactly.
FULL = replace(AHEAD, vertical_fov_deg=2.0 * np.degrees(np.arctan(0.1)))


def test_every_view_is_finite_and_what_is_no_light_lies_within_0_and_1(lit):
    for name in list(View)[1:]:
        colour, picture = view(lit, name)
        assert np.isfinite(picture).all(), name
        assert colour.min() >= 0.0, name
        assert name in TERM_VIEWS or colour.max() <= 1.0, name
        assert np.allclose(picture[0, 0], [0.05, 0.05, 0.05, 0.0]), "the background stays"


@pytest.mark.parametrize("name", ["normal", "blurred-normal"])
def test_normals_are_shown_as_normal_maps_show_them(lit, name):
    normal = 2.0 * srgb_from_linear(view(lit, name)[0]) - 1.0
    assert np.abs(np.linalg.norm(normal, axis=1) - 1.0).max() <= tol.SHOWN.value
    assert normal[:, 2].min() > 0.0, "what is seen of a ball faces the eye"
    picture = 2.0 * srgb_from_linear(view(lit, name)[1][..., :3].astype(float)) - 1.0
    assert picture[16, 25, 0] > 0.4 > 0.1 > abs(picture[16, 25, 1]), "x to the right"
    assert picture[6, 16, 1] > 0.4 > 0.1 > abs(picture[6, 16, 0]), "y up"


@pytest.mark.parametrize(
    ("radius", "inside_out", "full"),
    [(3.0, False, 1.0), (20.0, False, 0.25), (20.0, True, -0.25), (5000.0, False, 0.001)],
)
def test_convex_is_shown_red_concave_blue_by_the_root_of_curvature(radius, inside_out, full):
    renderer = open_renderer(Scene(ball(radius, inside_out), AHEAD, MATERIAL))
    camera = Camera((0.0, 0.0, 4.0 * radius), (0.0, 0.0, 0.0), 10.0)
    colour, _ = view(renderer, "curvature", camera=camera)
    ends = np.array([0.85, 0.20, 0.10] if full > 0.0 else [0.10, 0.30, 0.85])
    truth = 0.92 + (ends - 0.92) * np.sqrt(abs(full))
    assert np.abs(srgb_from_linear(colour) - truth).max() <= tol.SHOWN.value


def test_thickness_is_shown_up_to_30_mm():
    camera = Camera((0.0, 0.0, 60.0), (0.0, 0.0, 0.0), 20.0)
    flat = Material().params
    narrow = replace(flat, deep_scatter_offset_mm=0.0, deep_scatter_filter_mm=0.0)
    scene = Scene(ball(8.0), camera, Material(params=narrow), (BACK,))
    renderer = open_renderer(scene)
    _, picture = view(renderer, "thickness", size=(33, 33), camera=camera)
    shown = srgb_from_linear(picture[..., 0].astype(float)) * 30.0
    assert shown[16, 16] == pytest.approx(16.0, abs=tol.SHADOW_TEXEL_MM.value)
    assert shown.max() <= 16.0 + tol.SHADOW_TEXEL_MM.value
    assert not view(renderer, "thickness", camera=camera, deep_scatter_taps=0)[0].any()


def test_shadow_is_white_in_light_and_black_behind_something():
    u, faces = unit_icosphere(2)
    plane = square(200.0, 8)
    points = np.concatenate([plane.positions - (100.0, 100.0, 40.0), 15.0 * u])
    mesh = Mesh.checked(
        points, np.concatenate([plane.faces, faces + len(plane.positions)]), unit_mm=1
    )
    slanted = DirectionalLight((-0.5, 0.0, 1.0), (1.0, 1.0, 1.0))
    _, picture = view(open_renderer(Scene(mesh, AHEAD, MATERIAL, (slanted,))), "shadow", (65, 65))
    # The shadow of the ball falls 20 mm to the right on the wall behind; 540 mm away it is smaller.
    pixel = np.tan(np.radians(10.0)) / 32.5
    column = int(32.5 + 20.0 / 540.0 / pixel + 3.0)
    assert picture[32, column, 0] <= 1e-3
    assert picture[32, 65 - column, 0] == 1.0
    assert picture[5, 5, 0] == 1.0


def test_without_a_lamp_nothing_is_in_shadow_and_nothing_is_thick():
    dark = open_renderer(Scene(ball(60.0), AHEAD, MATERIAL))
    assert (view(dark, "shadow")[0] == 1.0).all()
    assert not view(dark, "thickness")[0].any()


def test_the_albedo_view_is_the_texture_upright(sheet):
    texels = np.random.default_rng(2).random((4, 4, 3)).astype(np.float32)
    textured = replace(sheet, material=replace(MATERIAL, albedo=texels))
    _, picture = view(open_renderer(textured), "albedo", (12, 12), FULL)
    assert np.allclose(picture[1::3, 1::3, :3], texels, atol=1e-5)


def test_a_texture_repeats_beyond_its_edge(sheet):
    texels = np.random.default_rng(3).random((4, 4, 3)).astype(np.float32)
    twice = replace(sheet.mesh, uvs=2.0 * sheet.mesh.uvs - 0.5)
    textured = replace(sheet, mesh=twice, material=replace(MATERIAL, albedo=texels))
    _, picture = view(open_renderer(textured), "albedo", (24, 24), FULL)
    tiled = np.roll(np.tile(texels, (2, 2, 1)), (2, 2), axis=(0, 1))
    assert np.allclose(picture[1::3, 1::3, :3], tiled, atol=1e-5)


@pytest.mark.parametrize("tilt", [(0.4, 0.0), (0.0, 0.4), (-0.3, 0.2)])
@pytest.mark.parametrize("strength", [0.5, 1.0])
def test_a_normal_map_tilts_to_the_right_and_up(sheet, tilt, strength):
    n = np.array([*tilt, 1.0])
    texels = np.broadcast_to(n / np.linalg.norm(n), (4, 4, 3)).astype(np.float32)
    bumpy = replace(sheet, material=replace(MATERIAL, normal=texels)).with_params(
        normal_strength=strength
    )
    colour, _ = view(open_renderer(bumpy), "normal", camera=FULL)
    truth = n * (strength, strength, 1.0)
    found = 2.0 * srgb_from_linear(colour) - 1.0
    assert np.abs(found - truth / np.linalg.norm(truth)).max() <= tol.SHOWN.value


def test_a_map_of_gloss_and_reflectance_sets_the_highlight(sheet):
    def highlight(factor, gloss):
        texels = np.broadcast_to(np.array([factor, gloss], np.float32), (2, 2, 2))
        scene = replace(sheet, material=replace(MATERIAL, specular=texels))
        return view(open_renderer(scene), "specular", (33, 33), FULL)[1][16, 16, 0]

    assert highlight(0.0, 0.4) < 1e-6
    assert highlight(2.0, 0.4) == pytest.approx(2.0 * highlight(1.0, 0.4), rel=1e-4)
    same = view(open_renderer(sheet.with_params(gloss=0.6)), "specular", (33, 33), FULL)[1]
    assert highlight(1.0, 0.6) == pytest.approx(same[16, 16, 0], rel=1e-5)


def test_the_tint_of_what_comes_through_multiplies_it(sheet):
    tint = np.array([0.8, 0.4, 0.2], dtype=np.float32)
    lit = replace(sheet, lights=(BACK,))
    material = replace(sheet.material, deep_scatter=np.broadcast_to(tint, (2, 2, 3)))
    plain, tinted = (
        view(open_renderer(replace(lit, material=m)), "deep-scatter", camera=FULL)[0]
        for m in (sheet.material, material)
    )
    assert plain.min() > 0.0
    assert np.allclose(tinted, plain * tint, rtol=1e-5)


def test_what_is_shown_of_light_is_toned_and_of_geometry_is_not(sheet):
    light = np.random.default_rng(1).random((4, 4, 4)).astype(np.float32)
    scene = replace(sheet, exposure=2.0)
    rgb = light[..., :3].astype(float)
    settings = RenderSettings(debug_view="ambient")
    assert np.array_equal(display_values(light, scene, settings), filmic(2.0 * rgb))
    assert np.array_equal(
        display_values(light, scene, replace(settings, debug_view="picture")), filmic(2.0 * rgb)
    )
    plain = display_values(light, scene, RenderSettings(debug_view="normal"))
    assert np.array_equal(plain, srgb_from_linear(rgb))
    srgb = display_values(light, replace(scene, tone="srgb"), settings)
    assert np.array_equal(srgb, srgb_from_linear(2.0 * rgb))
