"""The grid of bounced light has a bounded number of voxels, whatever the unit of the body."""

import tracemalloc
from importlib.resources import files

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import skinshade as sk
import tolerances as tol
from shapes import unit_icosphere
from skinshade.mesh import Mesh
from skinshade.rendering.prepare import ambient_light
from skinshade.rendering.prepare.ambient_light import BOUNCE_REACH_MM, MOST_VOXELS

HEAD = files("skinshade") / "heads" / "assets" / "head.glb"
QUARTER_MM = 0.25 * BOUNCE_REACH_MM
BYTES_OF_A_GRID = 8 * MOST_VOXELS
RANDOM = np.random.default_rng(4)


def ball(radius_mm):
    points, faces = unit_icosphere(3)
    return Mesh.checked(points, faces, unit_mm=radius_mm, normals=points)


def averaged(mesh, values):
    return ambient_light._averaged_nearby(mesh, values)


def voxels(extent_mm):
    side = ambient_light._voxel_mm(np.asarray(extent_mm))
    return side, float(np.prod(np.floor(np.asarray(extent_mm) / side) + 1.0))


@given(st.lists(st.floats(0.0, 1000.0), min_size=3, max_size=3))
def test_a_voxel_of_a_body_of_up_to_a_metre_is_a_quarter_of_the_reach(extent_mm):
    assert voxels(extent_mm)[0] == QUARTER_MM


@given(
    st.lists(st.just(0.0) | st.floats(-3.0, 24.0).map(lambda p: 10.0**p), min_size=3, max_size=3)
)
def test_the_number_of_voxels_is_bounded_for_bodies_of_any_extent(extent_mm):
    side, count = voxels(extent_mm)
    assert side >= QUARTER_MM
    assert count <= MOST_VOXELS


@pytest.mark.parametrize("make", [lambda: ball(80.0), lambda: sk.load_mesh(HEAD)])
def test_the_bound_does_not_change_bodies_of_the_size_of_a_head(make, monkeypatch):
    mesh = make()
    values = RANDOM.random(mesh.positions.shape)
    bounded = averaged(mesh, values)
    monkeypatch.setattr(ambient_light, "MOST_VOXELS", 1 << 60)
    assert np.array_equal(averaged(mesh, values), bounded)


@pytest.mark.parametrize("radius_mm", [6500.0, 1e9])
def test_the_average_over_a_body_of_13_m_needs_no_more_memory_than_the_grids(radius_mm):
    mesh = ball(radius_mm)
    values = RANDOM.random(mesh.positions.shape)
    tracemalloc.start()
    result = averaged(mesh, values)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak <= 8 * BYTES_OF_A_GRID
    assert result.min() >= values.min() - tol.ROUNDING.value
    assert result.max() <= values.max() + tol.ROUNDING.value


def test_the_average_of_a_constant_is_the_constant_at_any_size():
    for radius_mm in (1.0, 80.0, 6500.0):
        mesh = ball(radius_mm)
        result = averaged(mesh, np.full(mesh.positions.shape, 0.25))
        assert np.allclose(result, 0.25, rtol=tol.ROUNDING_SUMS.value)


def test_a_body_of_13_m_is_drawn():
    camera = sk.Camera((0.0, 0.0, 40_000.0), (0.0, 0.0, 0.0))
    scene = sk.Scene(
        ball(6500.0), camera, sk.Material(), environment=sk.Environment.constant((1.0, 1.0, 1.0))
    )
    image = sk.render(scene, size=(16, 16), samples=1, backend="cpu")
    assert np.isfinite(image).all()
    assert image[8, 8, :3].min() > 0.0
