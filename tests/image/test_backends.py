"""Whole pictures of the GPU compared with the CPU's: every setting, every view, head and scan."""

from __future__ import annotations

import gc
import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import shading_tolerances as tol
from gpu_device import adapter_or_skip
from skinshade.heads import builtin_head, head_scene, load_head
from skinshade.params.choices import Boundary, Shading, SpecularModel, Tier, View
from skinshade.rendering import RenderSettings, open_renderer
from skinshade.rendering.tone import display_values
from skinshade.scene import DirectionalLight, Environment, SpotLight

SIZE = (240, 200)


@pytest.fixture(scope="module")
def head():
    """The built-in head between a light in front and a spot light behind, on both backends."""
    adapter_or_skip()
    scene = head_scene(builtin_head(), yaw_deg=28.0, pitch_deg=4.0)
    centre = scene.mesh.positions_mm.mean(axis=0)
    behind = centre + np.array([250.0, 60.0, -350.0])
    spot = SpotLight(behind, centre, (9.0, 8.0, 7.0), 35.0)
    lights = (DirectionalLight.from_angles(-38.0, 26.0, 0.75), spot)
    return both(scene, lights=lights)


@pytest.fixture(scope="module")
def scan(data_dir):
    adapter_or_skip()
    folder = data_dir / "lps"
    scanned = load_head(
        folder / "LeePerrySmith.glb",
        unit_mm=50.35,
        albedo=folder / "color.jpg",
        normal_map=folder / "normal.jpg",
        flip_v=True,
    )
    sky = Environment.load(data_dir / "env" / "quarry_01_1k.hdr")
    return both(head_scene(scanned, yaw_deg=28.0), environment=sky)


def both(scene, **changes):
    scene = replace(scene, **changes)
    return scene, open_renderer(scene, "gpu"), open_renderer(scene, "cpu")


def assert_equal_pictures(pair, samples=1, **settings):
    scene, gpu, cpu = pair
    chosen = RenderSettings(**settings)
    pictures = [
        display_values(renderer.draw(scene.camera, SIZE, samples, chosen), scene, chosen) * 255.0
        for renderer in (gpu, cpu)
    ]
    difference = np.abs(pictures[0] - pictures[1])
    assert pictures[1].std() > 1.0, "the picture is not empty"
    assert difference.mean() <= tol.BACKENDS_MEAN.value
    assert np.percentile(difference.max(axis=2), 99.9) <= tol.BACKENDS_TAIL.value


@pytest.mark.slow
@pytest.mark.parametrize("shading", list(Shading))
def test_the_head_is_the_same_picture_in_every_shading(head, shading):
    assert_equal_pictures(head, shading=shading)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("specular", "boundary"),
    [(SpecularModel.GGX_TWO_LOBES, Boundary.BLENDER_SKIN), (SpecularModel.BLINN_PHONG, None)],
)
def test_the_head_is_the_same_picture_with_every_coat_and_boundary(head, specular, boundary):
    scene, _, _ = head
    assert_equal_pictures(both(scene.with_params(specular=specular, boundary=boundary)))


@pytest.mark.slow
@pytest.mark.parametrize("tier", list(Tier))
def test_the_head_is_the_same_picture_in_every_tier_of_geometry(head, tier):
    assert_equal_pictures(head, tier=tier, deep_scatter_taps=32)


@pytest.mark.slow
@pytest.mark.parametrize(
    "way",
    [
        {"shadow_filter": "variance"},
        {"normal_fetches": 2},
        {"deep_scatter_taps": 0},
        {"contact_shadow": False},
    ],
    ids=lambda way: next(iter(way)),
)
def test_the_head_is_the_same_picture_with_every_other_setting(head, way):
    assert_equal_pictures(head, **way)
    assert_equal_pictures(head, **way, shading="classic")


@pytest.mark.slow
@pytest.mark.parametrize("view", list(View)[1:])
def test_the_head_is_the_same_picture_in_every_debug_view(head, view):
    assert_equal_pictures(head, debug_view=view)


@pytest.mark.slow
@pytest.mark.parametrize(
    "way", [{"debug_view": "thickness"}, {"shadow_filter": "variance"}], ids=str
)
def test_a_cone_that_the_head_reaches_beyond_is_the_same(head, way):
    """Filters and taps extend past the edge of the light's map."""
    scene, *_ = head
    centre = scene.mesh.positions_mm.mean(axis=0)
    behind = centre + np.array([250.0, 60.0, -350.0])
    pair = both(scene, lights=(SpotLight(behind, centre, (9.0, 8.0, 7.0), 7.0),))
    assert_equal_pictures(pair, **way)


@pytest.mark.slow
def test_supersampling_and_seed_take_the_same_samples(head):
    assert_equal_pictures(head, samples=4, seed=3)


@pytest.mark.slow
def test_the_surroundings_behind_the_body_are_the_same(head):
    scene, *_ = head
    pair = both(scene, environment=replace(scene.environment, visible=True))
    assert_equal_pictures(pair, samples=2)


@pytest.mark.slow
@pytest.mark.parametrize("view", ["picture", "normal"])
@pytest.mark.parametrize("tone", ["filmic", "srgb"])
def test_what_the_device_shows_is_its_light_through_the_tone_curve(head, tone, view):
    scene, *_ = head
    gpu = open_renderer(replace(scene, tone=tone, exposure=0.7), "gpu")
    settings = RenderSettings(debug_view=view)
    linear = gpu.draw(scene.camera, SIZE, 1, settings)
    shown = gpu.draw_display(scene.camera, SIZE, 1, settings).astype(np.float64)
    assert (
        np.abs(shown - display_values(linear, gpu.scene, settings) * 255.0).max()
        <= tol.DISPLAY_BYTES.value
    )


@pytest.mark.slow
def test_multisampling_smooths_edges_and_shades_like_samples_do(head):
    """Edges come from other places in the pixel, highlights from one: compare where neither is."""
    scene, gpu, _ = head
    many = RenderSettings(antialiasing="multisampling")
    fast, slow = (gpu.draw(scene.camera, SIZE, 4, way) for way in (many, RenderSettings()))
    assert set(np.unique(fast[..., 3])) == {0.0, 0.25, 0.5, 0.75, 1.0}
    assert np.abs(fast[..., 3] - slow[..., 3]).max() <= 0.75
    shown = [display_values(image, scene, many) for image in (fast, slow)]
    difference = np.abs(shown[0] - shown[1]) * 255.0
    assert difference.mean() <= tol.MULTISAMPLED_MEAN.value
    inside = (fast[..., 3] == 1.0) & (slow[..., 3] == 1.0)
    assert np.median(difference.max(axis=2)[inside]) <= tol.MULTISAMPLED_MEDIAN.value


@pytest.mark.slow
@pytest.mark.parametrize("shading", list(Shading))
def test_the_scan_is_the_same_picture_in_every_shading(scan, shading):
    assert_equal_pictures(scan, shading=shading)


def test_the_sun_of_the_sky_lights_the_scan_on_both_backends(scan):
    _, gpu, cpu = scan
    for renderer in (gpu, cpu):
        assert len(renderer.prepared.lights) == len(renderer.prepared.shadow_maps) == 2
    assert np.array_equal(gpu.prepared.lights[1].irradiance, cpu.prepared.lights[1].irradiance)


@pytest.mark.slow
@pytest.mark.parametrize("view", ["blurred-normal", "curvature", "thickness", "shadow"])
def test_the_scan_is_the_same_picture_in_a_debug_view(scan, view):
    assert_equal_pictures(scan, debug_view=view)


@pytest.mark.slow
def test_after_the_first_frame_nothing_is_made_again(head, monkeypatch):
    scene, gpu, _ = head
    ways = (RenderSettings(), RenderSettings(antialiasing="multisampling"))
    for way in ways:
        gpu.draw(scene.camera, SIZE, 2, way)
        gpu.draw_display(scene.camera, SIZE, 2, way)
    made = []
    for name in (
        "create_bind_group",
        "create_buffer",
        "create_query_set",
        "create_render_pipeline",
        "create_sampler",
        "create_shader_module",
        "create_texture",
    ):
        one = getattr(gpu.device, name)

        def counted(*args, _one=one, _name=name, **kwargs):
            made.append(_name)
            return _one(*args, **kwargs)

        monkeypatch.setattr(gpu.device, name, counted)
    for turn in (10.0, 20.0, 30.0):
        for way in ways:
            gpu.draw(scene.camera.orbited(turn), SIZE, 2, way)
            gpu.draw_display(scene.camera.orbited(turn), SIZE, 2, way)
    assert made == []


def memory_mib():
    """What the process holds now, MiB."""
    gc.collect()
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="reads Linux's own count")
def test_a_turntable_takes_no_more_memory_from_frame_to_frame(head):
    scene, gpu, _ = head
    held = []
    for frame in range(24):
        gpu.draw_display(scene.camera.orbited(15.0 * frame), SIZE, 2, RenderSettings())
        held.append(memory_mib())
    frame_mib = SIZE[0] * SIZE[1] * 16 / 2**20
    assert max(held[12:]) - min(held[8:12]) <= 2.0 * frame_mib
