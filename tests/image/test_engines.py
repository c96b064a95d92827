"""The same head in foreign renderers: the examples' pictures beside our own, same light, same material."""

from __future__ import annotations

import importlib.util
from dataclasses import replace

import numpy as np
import pytest

import shading_tolerances as tol
from gpu_device import adapter_or_skip
from skinshade.render import RenderSettings
from skinshade.render.renderer import open_renderer
from skinshade.scene.heads import builtin_head, head_scene

SIZE = (320, 320)
WAY = RenderSettings(tier="tensor", deep_scatter_taps=0)


def example(repository, name):
    place = repository / "examples" / f"{name}.py"
    spec = importlib.util.spec_from_file_location(name, place)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def scene():
    mesh, skin = builtin_head()
    made = head_scene(mesh, replace(skin, specular=None, deep_scatter=None), yaw_deg=28.0)
    return replace(made, environment=None, background=np.zeros(3))


def ours(scene):
    """Our renderer's linear light, where nothing casts a shadow."""
    renderer = open_renderer(scene, "cpu")
    nothing = [
        (
            light,
            replace(
                found,
                first=np.full_like(found.first, np.inf),
                occluders=np.full_like(found.first, np.inf),
            ),
        )
        for light, found in renderer.prepared.shadow_maps
    ]
    renderer.prepared.__dict__["shadow_maps"] = nothing
    return renderer.draw(scene.camera, SIZE, 1, WAY)


def assert_same_head(found, want):
    both = (found[..., 3] == 1.0) & (want[..., 3] == 1.0)
    assert both.sum() > 0.2 * both.size, "the picture shows a head"
    assert (found[..., 3] != want[..., 3]).mean() <= tol.ENGINE_EDGES.value
    apart = np.abs(found[..., :3] - want[..., :3])[both].max(axis=1)
    assert apart.mean() <= tol.ENGINE_MEAN.value
    assert np.percentile(apart, 99.9) <= tol.ENGINE_TAIL.value


@pytest.mark.slow
def test_the_wgpu_example_draws_our_head(repository, scene):
    """It has no normal map, and samples colour without mips: so does ours, with one colour."""
    adapter_or_skip()
    plain = replace(scene.material, normal=None, albedo=np.full((2, 2, 3), 0.5, dtype=np.float32))
    bare = replace(scene, material=plain)
    assert_same_head(example(repository, "wgpu_skin").draw(bare, SIZE), ours(bare))


@pytest.mark.slow
def test_the_moderngl_example_draws_our_head_with_all_its_maps(repository, scene):
    pytest.importorskip("moderngl")
    assert_same_head(example(repository, "moderngl_skin").draw(scene, SIZE), ours(scene))
