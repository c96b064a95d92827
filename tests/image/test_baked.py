"""The scan, baked: the picture from its attributes is the picture from the raw file."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh

import shading_tolerances as tol
from gltf_validator import assert_valid
from skinshade.baking import BakeSettings, bake
from skinshade.heads import Head, head_scene
from skinshade.mesh import attributes as module
from skinshade.mesh import load_mesh
from skinshade.rendering import RenderSettings, open_renderer
from skinshade.rendering.tone import display_values
from skinshade.scene import Material

SIZE = (160, 200)


@pytest.fixture(scope="module")
def baked_scan(data_dir, tmp_path_factory):
    """The scan with everything that can be baked."""
    output = tmp_path_factory.mktemp("baked") / "scan.glb"
    settings = BakeSettings(unit_mm=50.35, tensor=True, thickness=True)
    bake(data_dir / "lps" / "LeePerrySmith.glb", output, settings)
    return output


@pytest.fixture(scope="module")
def pair(data_dir, baked_scan):
    """The raw scan, and what is read of the baked one without being told its unit."""
    raw = data_dir / "lps" / "LeePerrySmith.glb"
    return load_mesh(raw, unit_mm=50.35), load_mesh(baked_scan)


@pytest.mark.slow
def test_the_picture_of_the_baked_scan_is_that_of_the_raw_one(pair, monkeypatch):
    raw, baked = pair
    settings = RenderSettings(tier="tensor")
    shown = []
    for mesh in (raw, baked):
        if mesh is baked:  # from its attributes alone
            monkeypatch.delattr(module, "ShapeOperator")
        scene = head_scene(Head(mesh, Material()), yaw_deg=28.0)
        picture = open_renderer(scene, "cpu").draw(scene.camera, SIZE, 1, settings)
        shown.append(display_values(picture, scene, settings))
    assert shown[0].std() > 0.05
    assert np.abs(shown[0] - shown[1]).max() <= tol.BAKED_PICTURE.value


@pytest.mark.slow
def test_pygfx_draws_the_same_of_both(pair):
    pytest.importorskip("pygfx")
    from skinshade.integrations.pygfx import skin_geometry

    raw, baked = (skin_geometry(mesh) for mesh in pair)
    assert np.array_equal(raw.positions.data, baked.positions.data)
    apart = np.abs(raw.skin_attributes.data - baked.skin_attributes.data).max()
    assert apart <= tol.BAKED_ATTRIBUTES.value


def test_the_baked_scan_is_valid(baked_scan):
    assert_valid(baked_scan)


def test_trimesh_reads_what_was_baked(baked_scan, data_dir):
    (found,) = trimesh.load_scene(baked_scan, process=False).geometry.values()
    (raw,) = trimesh.load_scene(
        data_dir / "lps" / "LeePerrySmith.glb", process=False
    ).geometry.values()
    assert np.array_equal(found.vertices, raw.vertices)
    assert np.array_equal(found.faces, raw.faces)
    thickness = found.vertex_attributes["_THICKNESS"][:, 0]
    # An ear is some millimetres thick, a head a hand's breadth and more.
    low, middle, high = np.percentile(thickness, [1.0, 50.0, 99.0])
    assert 0.5 < low < 12.0 < middle < high < 400.0
