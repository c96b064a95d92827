"""The built-in head drawn by pygfx with SkinMaterial, compared with the CPU renderer's picture."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

import shading_tolerances as tol
from gpu_device import adapter_or_skip
from skinshade.heads import builtin_head, head_scene
from skinshade.rendering import RenderSettings, open_renderer
from skinshade.scene import DirectionalLight, SpotLight
from skinshade.scene.images import read_image

pygfx = pytest.importorskip("pygfx", reason="the extra pygfx is not installed")
offscreen = pytest.importorskip("rendercanvas.offscreen", reason="rendercanvas is not installed")

from skinshade.integrations.pygfx import SkinMaterial, skin_geometry, skin_light  # noqa: E402

SIZE = (320, 320)
TIERS = ("scalar", "tensor")


@pytest.fixture(scope="module")
def head():
    """Scene without environment, and without maps that pygfx does not read; and pygfx's geometry."""
    adapter_or_skip()
    head = builtin_head()
    material = replace(head.material, specular=None, deep_scatter=None)
    portrait = head_scene(replace(head, material=material))
    scene = replace(portrait, environment=None, background=np.zeros(3))
    return scene, skin_geometry(head.mesh, material.profile)


def one_colour(scene):
    grey = np.full((1, 1, 3), 0.5, dtype=np.float32)
    return replace(scene, material=replace(scene.material, albedo=grey))


def draw_on_cpu(scene, shadows=True, **settings):
    """Return linear light and coverage (H, W, 4); without shadows the shadow maps are empty.

    pygfx has no contact shadow.
    """
    renderer = open_renderer(scene, "cpu")
    if not shadows:
        empty = []
        for shadow_map in renderer.prepared.shadow_maps:
            depths = np.full_like(shadow_map.nearest_mm, np.inf)
            empty.append(replace(shadow_map, nearest_mm=depths, occluder_mm=depths))
        renderer.prepared = replace(renderer.prepared, shadow_maps=empty)
    return renderer.draw(scene.camera, SIZE, 1, RenderSettings(contact_shadow=False, **settings))


def draw_in_pygfx(scene, geometry, tier, taps, shadows=True):
    """Return linear light and coverage (H, W, 4)."""
    skin = scene.material
    material = SkinMaterial(
        skin.profile,
        skin.params,
        tier=tier,
        deep_scatter_taps=taps,
        map=skin.albedo,
        normal_map=skin.normal,
    )
    root = pygfx.Scene()
    root.add(pygfx.Mesh(geometry, material, cast_shadow=shadows, receive_shadow=shadows))
    root.add(*(skin_light(light, scene.mesh) for light in scene.lights))
    camera = pygfx.PerspectiveCamera(scene.camera.vertical_fov_deg, depth_range=(50.0, 5000.0))
    camera.local.position = scene.camera.position_mm
    camera.look_at(scene.camera.target_mm)
    canvas = offscreen.OffscreenRenderCanvas(size=SIZE, pixel_ratio=1)
    renderer = pygfx.renderers.WgpuRenderer(canvas, ppaa="none", pixel_ratio=1)
    # pygfx's default of 8 bits is coarser than the differences that are compared.
    renderer._blender.texture_info["color"]["format"] = "rgba16float"
    renderer.render(root, camera, flush=False)
    return np.asarray(renderer.snapshot()).astype(np.float64)


def differences(image, expected):
    """Return the greatest difference of a channel (N,) at the pixels that both pictures cover."""
    covered = [picture[..., 3] > 0.5 for picture in (image, expected)]
    assert np.count_nonzero(covered[0] ^ covered[1]) <= tol.ENGINE_EDGES.value * covered[0].size
    both = covered[0] & covered[1]
    assert image[both][:, :3].std() > 0.05, "the picture is not of one colour"
    return np.abs(image - expected)[both][:, :3].max(axis=1)


@pytest.mark.slow
@pytest.mark.parametrize("tier", TIERS)
def test_without_shadows_the_pictures_are_equal(head, tier):
    scene, geometry = head
    scene = one_colour(scene)
    difference = differences(
        draw_in_pygfx(scene, geometry, tier, taps=0, shadows=False),
        draw_on_cpu(scene, shadows=False, tier=tier, deep_scatter_taps=0),
    )
    assert np.percentile(difference, 99.9) <= tol.PYGFX_TAIL.value
    assert difference.max() <= tol.PYGFX_WORST.value


@pytest.mark.slow
@pytest.mark.parametrize("tier", TIERS)
def test_with_shadow_and_deep_scatter_the_pictures_are_nearly_equal(head, tier):
    scene, geometry = head
    difference = differences(
        draw_in_pygfx(scene, geometry, tier, taps=8),
        draw_on_cpu(scene, tier=tier, deep_scatter_taps=8),
    )
    assert np.percentile(difference, 99) <= tol.PYGFX_SHADOW.value
    assert (difference > 4.0 / 255.0).mean() <= tol.PYGFX_SHADOW_SHARE.value


@pytest.mark.slow
@pytest.mark.parametrize("tier", TIERS)
def test_under_a_spot_light_the_pictures_are_equal(head, tier):
    scene, geometry = head
    points = scene.mesh.positions_mm
    middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
    colour = np.pi * np.array([1.5, 1.0, 0.75])
    lamp = SpotLight(middle + np.array([-250.0, 120.0, 260.0]), middle, colour, 32.0)
    scene = replace(one_colour(scene), lights=(lamp,))
    difference = differences(
        draw_in_pygfx(scene, geometry, tier, taps=8),
        draw_on_cpu(scene, tier=tier, deep_scatter_taps=8),
    )
    assert np.percentile(difference, 99.9) <= tol.PYGFX_SPOT.value


@pytest.mark.slow
def test_lit_from_behind_the_ears_glow_red_in_both_pictures(head):
    scene, geometry = head
    behind = DirectionalLight.from_angles(150.0, 5.0, 3.0)
    scene = replace(one_colour(scene), lights=(behind,))
    image = draw_in_pygfx(scene, geometry, "tensor", taps=32)
    expected = draw_on_cpu(scene, tier="tensor", deep_scatter_taps=32)
    red = [(picture[..., 0] > 3.0 * picture[..., 2] + 0.05).sum() for picture in (image, expected)]
    assert min(red) > 50
    assert abs(red[0] - red[1]) <= 0.05 * red[1]
    assert np.percentile(differences(image, expected), 99) <= tol.PYGFX_BEHIND.value


@pytest.mark.slow
def test_the_pygfx_example_draws_a_head(repository, tmp_path):
    adapter_or_skip()
    command = [sys.executable, "-W", "error", str(repository / "examples" / "pygfx_skin.py")]
    path = tmp_path / "head.png"
    done = subprocess.run([*command, str(path)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    picture = read_image(path)
    assert picture.shape == (480, 480, 3)
    forehead = picture[130, 220]
    assert forehead.sum() > 2.0 * picture[2, 2].sum()
    assert forehead[0] > forehead[1] > forehead[2]
