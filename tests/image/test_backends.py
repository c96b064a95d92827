"""Whole pictures of the GPU beside the CPU's: every way to shade, every view, head and scan."""

from __future__ import annotations

import numpy as np
import pytest

import shading_tolerances as tol
from gpu_device import adapter_or_skip
from skinshade.render import DEBUG_VIEWS, RenderSettings
from skinshade.render.renderer import SHADINGS, TIERS, display, open_renderer
from skinshade.scene import DirectionalLight, Environment, SpotLight
from skinshade.scene.heads import builtin_head, head_scene, model

SIZE = (240, 200)


@pytest.fixture(scope="module")
def head():
    """The built-in head between a lamp in front and a spot behind, as both backends hold it."""
    adapter_or_skip()
    mesh, skin = builtin_head()
    scene = head_scene(mesh, skin, yaw_deg=28.0, pitch_deg=4.0)
    centre = scene.mesh.positions_mm.mean(axis=0)
    behind = centre + np.array([250.0, 60.0, -350.0])
    spot = SpotLight(behind, centre, (9.0, 8.0, 7.0), 35.0)
    lamps = (DirectionalLight.from_angles(-38.0, 26.0, 0.75), spot)
    return both(scene, lights=lamps)


@pytest.fixture(scope="module")
def scan(data_dir):
    adapter_or_skip()
    folder = data_dir / "lps"
    mesh, skin = model(
        folder / "LeePerrySmith.glb",
        unit_mm=50.35,
        albedo=folder / "color.jpg",
        normal_map=folder / "normal.jpg",
        flip_v=True,
    )
    sky = Environment.load(data_dir / "env" / "quarry_01_1k.hdr")
    return both(head_scene(mesh, skin, yaw_deg=28.0), environment=sky)


def both(scene, **changes):
    from dataclasses import replace

    scene = replace(scene, **changes)
    gpu, cpu = open_renderer(scene, "gpu"), open_renderer(scene, "cpu")
    # What does not depend on the backend need not be made twice.
    gpu.prepared.__dict__.update(cpu.prepared.__dict__)
    return scene, gpu, cpu


def assert_equal_pictures(pair, samples=1, **settings):
    scene, gpu, cpu = pair
    way = RenderSettings(**settings)
    shown = [
        display(each.draw(scene.camera, SIZE, samples, way), scene, way) * 255.0
        for each in (gpu, cpu)
    ]
    apart = np.abs(shown[0] - shown[1])
    assert shown[1].std() > 1.0, "the picture shows something"
    assert apart.mean() <= tol.BACKENDS_MEAN.value
    assert np.percentile(apart.max(axis=2), 99.9) <= tol.BACKENDS_TAIL.value


@pytest.mark.slow
@pytest.mark.parametrize("shading", SHADINGS)
def test_the_head_is_the_same_picture_in_every_shading(head, shading):
    assert_equal_pictures(head, shading=shading)


@pytest.mark.slow
@pytest.mark.parametrize("tier", TIERS)
def test_the_head_is_the_same_picture_in_every_tier_of_geometry(head, tier):
    assert_equal_pictures(head, tier=tier, deep_scatter_taps=32)


@pytest.mark.slow
@pytest.mark.parametrize("view", DEBUG_VIEWS)
def test_the_head_is_the_same_picture_in_every_debug_view(head, view):
    assert_equal_pictures(head, debug_view=view)


@pytest.mark.slow
def test_supersampling_and_seed_take_the_same_samples(head):
    assert_equal_pictures(head, samples=4, seed=3)


@pytest.mark.slow
@pytest.mark.parametrize("shading", SHADINGS)
def test_the_scan_is_the_same_picture_in_every_shading(scan, shading):
    assert_equal_pictures(scan, shading=shading)


@pytest.mark.slow
@pytest.mark.parametrize("view", ["blurred-normal", "curvature", "thickness", "shadow"])
def test_the_scan_is_the_same_picture_in_a_debug_view(scan, view):
    assert_equal_pictures(scan, debug_view=view)


@pytest.mark.slow
def test_after_the_first_frame_nothing_is_made_again(head, monkeypatch):
    scene, gpu, _ = head
    way = RenderSettings()
    gpu.draw(scene.camera, SIZE, 1, way)
    made = []
    for name in ("create_texture", "create_render_pipeline", "create_buffer", "create_bind_group"):
        one = getattr(gpu.device, name)

        def counted(*args, _one=one, _name=name, **kwargs):
            made.append(_name)
            return _one(*args, **kwargs)

        monkeypatch.setattr(gpu.device, name, counted)
    for turn in (10.0, 20.0, 30.0):
        gpu.draw(scene.camera.orbited(turn), SIZE, 1, way)
    assert made == []
