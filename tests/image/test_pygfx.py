"""The built-in head drawn by pygfx with SkinMaterial, beside our own renderer: same light, same skin."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

import shading_tolerances as tol
from gpu_device import adapter_or_skip
from skinshade.render import RenderSettings
from skinshade.render.renderer import open_renderer
from skinshade.scene import DirectionalLight, SpotLight
from skinshade.scene.heads import builtin_head, head_scene
from skinshade.scene.images import read_image

pygfx = pytest.importorskip("pygfx", reason="the extra pygfx is not installed")
offscreen = pytest.importorskip("rendercanvas.offscreen", reason="rendercanvas is not installed")

from skinshade.integrations.pygfx import SkinMaterial, skin_geometry, skin_light  # noqa: E402

SIZE = (320, 320)
TIERS = ("scalar", "tensor")


@pytest.fixture(scope="module")
def head():
    """Scene without surroundings or a map that pygfx has no place for, its vertices, and pygfx's."""
    adapter_or_skip()
    mesh, skin = builtin_head()
    skin = replace(skin, specular=None, deep_scatter=None)
    scene = replace(head_scene(mesh, skin), environment=None, background=np.zeros(3))
    prepared = open_renderer(scene, "cpu").prepared.geometry
    return scene, prepared, skin_geometry(mesh, skin.profile)


def one_colour(scene):
    grey = np.full((1, 1, 3), 0.5, dtype=np.float32)
    return replace(scene, material=replace(scene.material, albedo=grey))


def ours(scene, prepared, shadows=True, **way):
    """(H, W, 4) linear light; without shadows the maps hold nothing, infinitely far."""
    renderer = open_renderer(scene, "cpu")
    renderer.prepared.__dict__["geometry"] = prepared
    if not shadows:
        nothing = {"cache": {}, "blurred": {}}
        for name in ("first", "occluders"):
            nothing[name] = np.full_like(renderer.prepared.shadow_maps[0][1].first, np.inf)
        renderer.prepared.__dict__["shadow_maps"] = [
            (light, replace(seen, **nothing)) for light, seen in renderer.prepared.shadow_maps
        ]
    return renderer.draw(scene.camera, SIZE, 1, RenderSettings(**way))


def theirs(scene, geometry, tier, taps, shadows=True):
    skin = scene.material
    material = SkinMaterial(
        skin.profile,
        skin.params,
        tier=tier,
        deep_scatter_taps=taps,
        map=skin.albedo,
        normal_map=skin.normal,
    )
    drawn = pygfx.Scene()
    drawn.add(pygfx.Mesh(geometry, material, cast_shadow=shadows, receive_shadow=shadows))
    drawn.add(*(skin_light(light, scene.mesh) for light in scene.lights))
    camera = pygfx.PerspectiveCamera(scene.camera.vertical_fov_deg, depth_range=(50.0, 5000.0))
    camera.local.position = scene.camera.position_mm
    camera.look_at(scene.camera.target_mm)
    canvas = offscreen.OffscreenRenderCanvas(size=SIZE, pixel_ratio=1)
    renderer = pygfx.renderers.WgpuRenderer(canvas, ppaa="none", pixel_ratio=1)
    # Eight bits of sRGB, pygfx's own, would hide what is compared.
    renderer._blender.texture_info["color"]["format"] = "rgba16float"
    renderer.render(drawn, camera, flush=False)
    return np.asarray(renderer.snapshot()).astype(np.float64)


def apart(ours, theirs):
    """Greatest difference of a channel at pixels that both cover; all but a few do, or neither."""
    covered = [each[..., 3] > 0.5 for each in (ours, theirs)]
    assert np.count_nonzero(covered[0] ^ covered[1]) <= tol.ENGINE_EDGES.value * covered[0].size
    both = covered[0] & covered[1]
    assert ours[both][:, :3].std() > 0.05, "the picture shows something"
    return np.abs(ours - theirs)[both][:, :3].max(axis=1)


@pytest.mark.slow
@pytest.mark.parametrize("tier", TIERS)
def test_without_shadows_the_light_is_the_same(head, tier):
    scene, prepared, geometry = head
    scene = one_colour(scene)
    found = apart(
        ours(scene, prepared, shadows=False, tier=tier, deep_scatter_taps=0),
        theirs(scene, geometry, tier, taps=0, shadows=False),
    )
    assert np.percentile(found, 99.9) <= tol.PYGFX_TAIL.value
    assert found.max() <= tol.PYGFX_WORST.value


@pytest.mark.slow
@pytest.mark.parametrize("tier", TIERS)
def test_with_shadow_and_light_through_the_body_it_nearly_is(head, tier):
    scene, prepared, geometry = head
    found = apart(
        ours(scene, prepared, tier=tier, deep_scatter_taps=8), theirs(scene, geometry, tier, taps=8)
    )
    assert np.percentile(found, 99) <= tol.PYGFX_SHADOW.value
    assert (found > 4.0 / 255.0).mean() <= tol.PYGFX_SHADOW_SHARE.value


@pytest.mark.slow
@pytest.mark.parametrize("tier", TIERS)
def test_a_spot_light_shines_and_shadows_as_ours(head, tier):
    scene, prepared, geometry = head
    points = scene.mesh.positions_mm
    middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
    colour = np.pi * np.array([1.5, 1.0, 0.75])
    lamp = SpotLight(middle + np.array([-250.0, 120.0, 260.0]), middle, colour, 32.0)
    scene = replace(one_colour(scene), lights=(lamp,))
    found = apart(
        ours(scene, prepared, tier=tier, deep_scatter_taps=8), theirs(scene, geometry, tier, taps=8)
    )
    assert np.percentile(found, 99.9) <= tol.PYGFX_SPOT.value


@pytest.mark.slow
def test_light_from_behind_comes_through_the_ears_alike(head):
    scene, prepared, geometry = head
    behind = DirectionalLight.from_angles(150.0, 5.0, 3.0)
    scene = replace(one_colour(scene), lights=(behind,))
    our_picture = ours(scene, prepared, tier="tensor", deep_scatter_taps=32)
    their_picture = theirs(scene, geometry, "tensor", taps=32)
    red = [
        (each[..., 0] > 3.0 * each[..., 2] + 0.05).sum() for each in (our_picture, their_picture)
    ]
    assert min(red) > 50
    assert abs(red[0] - red[1]) <= 0.05 * red[0]
    assert np.percentile(apart(our_picture, their_picture), 99) <= tol.PYGFX_BEHIND.value


@pytest.mark.slow
def test_the_example_draws_a_head(repository, tmp_path):
    adapter_or_skip()
    command = [sys.executable, "-W", "error", str(repository / "examples" / "pygfx_skin.py")]
    place = tmp_path / "head.png"
    done = subprocess.run([*command, str(place)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    picture = read_image(place)
    assert picture.shape == (480, 480, 3)
    forehead = picture[130, 220]
    assert forehead.sum() > 2.0 * picture[2, 2].sum()
    assert forehead[0] > forehead[1] > forehead[2]
