"""The shape operator: trace, eigenvalues and directions on shapes where they are known."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import shapes
import tolerances as tol
from skinshade.mesh import mesh_curvature, mesh_curvature_tensor
from skinshade.mesh.normals import tangent_frame
from skinshade.mesh.tensors import apply_symmetric, tensor_to_world

SHAPES = {
    "ellipsoid, icosphere": lambda: shapes.ellipsoid("icosphere", 5, (3.0, 2.0, 1.0)),
    "ellipsoid, regular": lambda: shapes.ellipsoid("regular", 128, (3.0, 2.0, 1.0)),
    "ellipsoid, random": lambda: shapes.ellipsoid("random", 16_000, (3.0, 2.0, 1.0)),
    "sphere, random": lambda: shapes.sphere("random", 4000),
    "torus, regular": lambda: shapes.torus("regular", 192),
    "torus, random": lambda: shapes.torus("random", 16_000),
    "cylinder": lambda: shapes.cylinder(1.0, 2.0, 96, 32),
}
EVERY_SHAPE = pytest.mark.parametrize("make", SHAPES.values(), ids=SHAPES)


def tensor(shape, **options):
    return mesh_curvature_tensor(shape.positions, shape.faces, shape.normals, **options)


def principal(t):
    mean, half = 0.5 * (t[:, 0] + t[:, 2]), 0.5 * (t[:, 0] - t[:, 2])
    root = np.hypot(half, t[:, 1])
    return mean + root, mean - root


@EVERY_SHAPE
def test_half_the_trace_is_the_mean_curvature(make):
    shape = make()
    t = tensor(shape, smoothing=0)
    mean = mesh_curvature(shape.positions, shape.faces, shape.normals, smoothing=0)
    assert np.allclose(0.5 * (t[:, 0] + t[:, 2]), mean, atol=tol.ROUNDING_SUMS.value)
    assert shapes.relative_rms(t[:, 0] + t[:, 2], 2.0 * shape.mean_curvature) <= (
        tol.CURVATURE_RMS.value
    )


@EVERY_SHAPE
def test_the_eigenvalues_are_the_principal_curvatures(make):
    shape = make()
    greater, lesser = principal(tensor(shape, smoothing=0))
    scale = np.sqrt(np.mean(shape.k_max**2))
    assert np.sqrt(np.mean((greater - shape.k_max) ** 2)) <= tol.PRINCIPAL_RMS.value * scale
    assert np.sqrt(np.mean((lesser - shape.k_min) ** 2)) <= tol.PRINCIPAL_RMS.value * scale


@pytest.mark.parametrize("axis_angle", [0.0, 0.4, 1.1])
def test_a_tube_is_curved_around_its_axis_and_not_along_it(axis_angle):
    turn = Rotation.from_euler("x", axis_angle).as_matrix()
    tube = shapes.cylinder(2.0, 4.0, 64, 24)
    normals = tube.normals @ turn.T
    t = mesh_curvature_tensor(tube.positions @ turn.T, tube.faces, normals, smoothing=0)
    axis = np.broadcast_to(turn @ (0.0, 0.0, 1.0), normals.shape)
    around = np.cross(axis, normals)
    world = tensor_to_world(t, normals)
    assert np.allclose(apply_symmetric(world, axis), 0.0, atol=tol.SPHERE_CURVATURE.value)
    assert np.allclose(
        apply_symmetric(world, around), 0.5 * around, atol=tol.SPHERE_CURVATURE.value
    )


def test_a_torus_has_its_principal_curvatures_across_and_along():
    ring = shapes.torus("regular", 192)
    x, y = ring.positions[:, 0], ring.positions[:, 1]
    along = np.stack([-y, x, 0.0 * x], axis=1) / np.hypot(x, y)[:, None]
    across = np.cross(ring.normals, along)
    world = tensor_to_world(tensor(ring, smoothing=0), ring.normals)
    error = apply_symmetric(world, across) - ring.k_max[:, None] * across
    assert np.sqrt(np.mean(error**2)) <= tol.PRINCIPAL_RMS.value
    error = apply_symmetric(world, along) - ring.k_min[:, None] * along
    assert np.sqrt(np.mean(error**2)) <= tol.PRINCIPAL_RMS.value


def test_smoothing_keeps_the_operator_in_the_tangent_plane():
    shape = shapes.ellipsoid("random", 1000, (3.0, 2.0, 1.0))
    t = tensor(shape, smoothing=10)
    world = tensor_to_world(t, shape.normals)
    assert np.abs(apply_symmetric(world, shape.normals)).max() <= tol.ROUNDING_SUMS.value


def test_two_passes_are_the_default():
    shape = shapes.torus("regular", 36)
    assert np.array_equal(tensor(shape), tensor(shape, smoothing=2))
    assert not np.array_equal(tensor(shape), tensor(shape, smoothing=1))


def test_smoothing_changes_the_operator_of_a_tube_only_by_its_turning():
    # From vertex to vertex, the operator of a tube turns by one step of the grid.
    tube = shapes.cylinder(1.0, 2.0, 96, 32)
    rough, smooth = tensor(tube, smoothing=0), tensor(tube, smoothing=4)
    assert np.abs(rough - smooth).max() <= tol.TUBE_TENSOR.value


def test_vertices_split_at_a_seam_have_the_tensor_of_the_unsplit_mesh():
    shape = shapes.ellipsoid("random", 600, (3.0, 2.0, 1.0))
    positions, faces, normals, original = shapes.split_seam(shape)
    split = mesh_curvature_tensor(positions, faces, normals)
    assert np.abs(split - tensor(shape)[original]).max() <= tol.ROTATION.value * np.abs(split).max()


@given(st.tuples(*[st.floats(-np.pi, np.pi)] * 3))
def test_the_operator_turns_with_the_surface(angles):
    turn = Rotation.from_euler("xyz", angles).as_matrix()
    shape = shapes.torus("regular", 36)
    before = tensor_to_world(tensor(shape), shape.normals)
    normals = shape.normals @ turn.T
    after = tensor_to_world(
        mesh_curvature_tensor(shape.positions @ turn.T, shape.faces, normals), normals
    )
    probe = np.broadcast_to([0.3, -0.5, 0.8], normals.shape)
    expected = apply_symmetric(before, probe @ turn) @ turn.T
    assert np.abs(apply_symmetric(after, probe) - expected).max() <= tol.ROTATION.value


@given(*[st.tuples(*[st.floats(-3.0, 3.0)] * 3)] * 2)
def test_the_world_tensor_is_the_symmetric_matrix_of_the_tangent_tensor(numbers, direction):
    length = np.linalg.norm(direction)
    normal = np.array([[0.0, 0.0, 1.0]]) if length < 0.1 else np.array([direction]) / length
    u, v = tangent_frame(normal)
    uu, uv, vv = numbers
    matrix = (
        uu * np.outer(u[0], u[0])
        + uv * (np.outer(u[0], v[0]) + np.outer(v[0], u[0]))
        + vv * np.outer(v[0], v[0])
    )
    world = tensor_to_world(np.array([numbers]), normal)
    assert np.allclose(world[0], matrix[np.triu_indices(3)], atol=tol.ROUNDING_SUMS.value)
    probe = np.array([[0.2, -1.0, 0.4]])
    assert np.allclose(apply_symmetric(world, probe)[0], matrix @ probe[0], atol=1e-9)
