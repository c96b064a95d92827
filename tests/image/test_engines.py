"""The examples for wgpu and moderngl draw the picture of skinshade's renderer."""

from __future__ import annotations

import importlib.util
from dataclasses import replace

import numpy as np
import pytest

import shading_tolerances as tol
from gpu_device import adapter_or_skip
from skinshade.heads import builtin_head, head_scene
from skinshade.params.choices import Tier
from skinshade.rendering import RenderSettings, open_renderer

SIZE = (320, 320)
SETTINGS = RenderSettings(tier=Tier.TENSOR, deep_scatter_taps=0, contact_shadow=False)


def example(repository, name):
    path = repository / "examples" / f"{name}.py"
    spec = importlib.util.spec_from_file_location(name, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def scene():
    """The built-in head without an environment, and without maps that the examples do not read."""
    head = builtin_head()
    material = replace(head.material, specular=None, deep_scatter=None)
    portrait = head_scene(replace(head, material=material), yaw_deg=28.0)
    return replace(portrait, environment=None, background=np.zeros(3))


def draw_without_shadows(scene):
    """Return linear light and coverage (H, W, 4) of the CPU renderer with empty shadow maps."""
    renderer = open_renderer(scene, "cpu")
    empty = []
    for shadow_map in renderer.prepared.shadow_maps:
        depths = np.full_like(shadow_map.nearest_mm, np.inf)
        empty.append(replace(shadow_map, nearest_mm=depths, occluder_mm=depths))
    renderer.prepared = replace(renderer.prepared, shadow_maps=empty)
    return renderer.draw(scene.camera, SIZE, 1, SETTINGS)


def assert_equal_pictures(image, expected):
    both = (image[..., 3] == 1.0) & (expected[..., 3] == 1.0)
    assert both.sum() > 0.2 * both.size, "the head covers a fifth of the picture"
    assert (image[..., 3] != expected[..., 3]).mean() <= tol.ENGINE_EDGES.value
    difference = np.abs(image[..., :3] - expected[..., :3])[both].max(axis=1)
    assert difference.mean() <= tol.ENGINE_MEAN.value
    assert np.percentile(difference, 99.9) <= tol.ENGINE_TAIL.value


@pytest.mark.slow
def test_the_wgpu_example_draws_the_picture_of_the_renderer(repository, scene):
    """The example reads no normal map, and its albedo map has no mips: here it has one colour."""
    adapter_or_skip()
    plain = replace(scene.material, normal=None, albedo=np.full((2, 2, 3), 0.5, dtype=np.float32))
    bare = replace(scene, material=plain)
    image = example(repository, "wgpu_skin").draw(bare, SIZE)
    assert_equal_pictures(image, draw_without_shadows(bare))


@pytest.mark.slow
def test_the_moderngl_example_draws_the_picture_of_the_renderer(repository, scene):
    pytest.importorskip("moderngl")
    image = example(repository, "moderngl_skin").draw(scene, SIZE)
    assert_equal_pictures(image, draw_without_shadows(scene))
