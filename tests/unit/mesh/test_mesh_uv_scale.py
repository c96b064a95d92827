import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import shapes
import tolerances as tol
from skinshade._core.errors import ArgumentError, MeshError
from skinshade.mesh import mesh_uv_scale

FLAT = shapes.square(1.0, 7)
UVS = FLAT.positions[:, :2]


@given(st.floats(1e-3, 1e4), st.floats(1e-3, 10.0), st.floats(-np.pi, np.pi))
def test_a_uniform_map_has_its_scale_at_any_rotation(side, tile, angle):
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    scale = mesh_uv_scale(FLAT.positions * side, UVS @ turn * tile + 0.5, FLAT.faces)
    assert scale == pytest.approx(side / tile, rel=tol.ROUNDING_SUMS.value)


def test_the_scale_is_the_geometric_mean_over_triangles():
    positions = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [5, 0, 0], [13, 0, 0], [5, 8, 0]])
    uvs = np.array([[0.0, 0], [1, 0], [0, 1], [0, 0], [1, 0], [0, 1]])
    faces = np.array([[0, 1, 2], [3, 4, 5]])
    assert mesh_uv_scale(positions, uvs, faces) == pytest.approx(np.sqrt(1.0 * 8.0))
    thrice = np.concatenate([faces, faces[:1], faces[:1]])
    assert mesh_uv_scale(positions, uvs, thrice) == pytest.approx(8.0**0.25)


def test_the_scale_is_the_ratio_of_the_longest_edges():
    positions = np.array([[0.0, 0, 0], [3, 0, 0], [0, 4, 0]])
    uvs = np.array([[0.0, 0], [0.3, 0], [0, 0.4]])
    assert mesh_uv_scale(positions, uvs, [[0, 1, 2]]) == pytest.approx(5.0 / 0.5)
    uvs = np.array([[0.0, 0], [0.6, 0], [0, 0.1]])
    longest = np.hypot(0.6, 0.1)
    assert mesh_uv_scale(positions, uvs, [[0, 1, 2]]) == pytest.approx(5.0 / longest)


def test_the_order_of_corners_does_not_matter():
    positions = np.array([[0.0, 0, 0], [3, 0, 0], [0, 4, 0]])
    uvs = np.array([[0.0, 0], [0.6, 0], [0, 0.1]])
    scales = {mesh_uv_scale(positions, uvs, [np.roll([0, 1, 2], turn)]) for turn in range(3)}
    assert max(scales) == pytest.approx(min(scales), rel=tol.ROUNDING.value)


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_a_million_triangles_are_summed_in_float64(kind):
    # In float32 the sum of so many logarithms loses precision.
    faces = np.tile(FLAT.faces, (10_000, 1))
    scale = mesh_uv_scale((FLAT.positions * 1024.0).astype(kind), UVS.astype(kind), faces)
    one = mesh_uv_scale((FLAT.positions * 1024.0).astype(kind), UVS.astype(kind), FLAT.faces)
    assert len(faces) == 980_000
    assert scale == pytest.approx(one, rel=tol.ROUNDING.value)
    assert scale == pytest.approx(1024.0, rel=tol.FLOAT32.value)


def test_triangles_without_extent_are_left_out():
    positions = np.vstack([FLAT.positions, [[9.0, 9, 9]] * 3])
    uvs = np.vstack([UVS, [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]]])
    n = len(UVS)
    in_space = [[n, n + 1, n + 2]]
    in_uv = [[0, 0, 0]]
    faces = np.concatenate([FLAT.faces, in_space, in_uv])
    assert mesh_uv_scale(positions, uvs, faces) == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("positions", "uvs", "faces"),
    [
        (FLAT.positions, np.zeros_like(UVS), FLAT.faces),
        (np.zeros_like(FLAT.positions), UVS, FLAT.faces),
        (FLAT.positions, UVS, np.zeros((0, 3), int)),
    ],
    ids=["no map", "no surface", "no faces"],
)
def test_a_mesh_without_a_usable_triangle_is_refused(positions, uvs, faces):
    with pytest.raises(MeshError, match="unwrap the mesh first"):
        mesh_uv_scale(positions, uvs, faces)


@pytest.mark.parametrize(
    ("positions", "uvs", "faces", "complaint"),
    [
        (FLAT.positions, UVS[:-1], FLAT.faces, "uvs: shape"),
        (FLAT.positions, np.where(UVS == 0.0, np.nan, UVS), FLAT.faces, r"uvs\[0, 0\] is nan"),
        (FLAT.positions + np.inf, UVS, FLAT.faces, r"positions\[0, 0\] is inf"),
        (FLAT.positions, UVS, FLAT.faces + 60, r"faces\[.*\] is .*; there are 64 vertices"),
    ],
)
def test_malformed_arrays_are_refused(positions, uvs, faces, complaint):
    with pytest.raises(ArgumentError, match=complaint):
        mesh_uv_scale(positions, uvs, faces)
