from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import shapes
import tolerances as tol
from skinshade.mesh.normals import tangent_frame, vertex_normals, vertex_tangents

FINE = {
    "ellipsoid, icosphere": (lambda: shapes.ellipsoid("icosphere", 5, (3.0, 2.0, 1.0)), 0.05),
    "ellipsoid, regular": (lambda: shapes.ellipsoid("regular", 128, (3.0, 2.0, 1.0)), 0.08),
    "ellipsoid, random": (
        lambda: shapes.ellipsoid("random", 16_000, (3.0, 2.0, 1.0)),
        tol.NORMALS_DEG.value,
    ),
    "sphere, random": (lambda: shapes.sphere("random", 16_000), 0.03),
    "torus, random": (lambda: shapes.torus("random", 16_000), 0.2),
    "torus, regular": (lambda: shapes.torus("regular", 192), 0.03),
}
DIRECTIONS = st.tuples(*[st.floats(-1.0, 1.0)] * 3).filter(lambda d: np.linalg.norm(d) > 0.1)


def degrees_apart(a, b):
    return np.degrees(2.0 * np.arcsin(np.clip(0.5 * np.linalg.norm(a - b, axis=1), 0.0, 1.0)))


@pytest.mark.parametrize(("make", "limit_deg"), FINE.values(), ids=FINE)
def test_computed_normals_are_near_those_of_the_surface(make, limit_deg):
    shape = make()
    degrees = degrees_apart(vertex_normals(shape.positions, shape.faces), shape.normals)
    assert np.sqrt(np.mean(degrees**2)) <= limit_deg


def test_the_error_of_normals_decreases_with_the_size_of_the_triangles():
    def error(level):
        shape = shapes.ellipsoid("icosphere", level, (3.0, 2.0, 1.0))
        degrees = degrees_apart(vertex_normals(shape.positions, shape.faces), shape.normals)
        return np.sqrt(np.mean(degrees**2))

    errors = [error(level) for level in (2, 3, 4, 5)]
    assert all(fine < 0.35 * coarse for coarse, fine in pairwise(errors))


def test_normals_are_unit_vectors_and_follow_the_winding():
    shape = shapes.torus("random", 2000)
    normals = vertex_normals(shape.positions, shape.faces)
    assert np.allclose(np.linalg.norm(normals, axis=1), 1.0, rtol=tol.ROUNDING.value)
    assert np.allclose(vertex_normals(shape.positions, shape.faces[:, ::-1]), -normals)


@given(st.floats(1e-5, 1e5), st.tuples(*[st.floats(-10, 10)] * 3))
def test_normals_are_invariant_under_scaling_and_translation(factor, shift):
    shape = shapes.ellipsoid("icosphere", 2, (3.0, 2.0, 1.0))
    before = vertex_normals(shape.positions, shape.faces)
    after = vertex_normals((shape.positions + shift) * factor, shape.faces)
    assert np.abs(after - before).max() <= tol.ROTATION.value


def test_vertices_split_at_a_seam_have_the_normal_of_the_unsplit_mesh():
    shape = shapes.ellipsoid("icosphere", 3, (3.0, 2.0, 1.0))
    positions, faces, _, original = shapes.split_seam(shape)
    whole = vertex_normals(shape.positions, shape.faces)
    assert np.abs(vertex_normals(positions, faces) - whole[original]).max() <= tol.ROTATION.value


@given(DIRECTIONS)
def test_a_frame_is_orthonormal_and_right_handed(direction):
    n = np.array([direction]) / np.linalg.norm(direction)
    u, v = tangent_frame(n)
    axes = np.concatenate([u, v, n])
    assert np.allclose(axes @ axes.T, np.eye(3), atol=tol.ROUNDING.value)
    assert np.allclose(np.cross(u, v), n, atol=tol.ROUNDING.value)


@pytest.mark.parametrize("z", [1.0, -1.0])
def test_a_frame_exists_at_both_poles(z):
    u, v = tangent_frame(np.array([[0.0, 0.0, z]]))
    assert np.allclose(np.cross(u, v), [[0.0, 0.0, z]])


# -- tangents: u goes right and v goes down in the image of a normal map ---------------------------

QUAD = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
QUAD_FACES = np.array([[0, 1, 2], [0, 2, 3]])
UP = np.tile([0.0, 0.0, 1.0], (4, 1))


def uvs_of_quad(u_along, v_along):
    return np.stack([QUAD @ u_along, QUAD @ v_along], axis=1)


@pytest.mark.parametrize(
    ("u_along", "v_along", "sign"),
    [
        ([1, 0, 0], [0, -1, 0], 1.0),  # upright
        ([0, 1, 0], [1, 0, 0], 1.0),  # turned by 90°
        ([-1, 0, 0], [0, 1, 0], 1.0),  # upside down
        ([-1, 0, 0], [0, -1, 0], -1.0),  # mirrored
        ([1, 0, 0], [0, 1, 0], -1.0),  # v upwards
    ],
)
@pytest.mark.parametrize("stretch", [(1.0, 1.0), (0.01, 3.0)])
def test_tangents_of_a_quad_follow_its_texture_axes(u_along, v_along, sign, stretch):
    uvs = uvs_of_quad(u_along, v_along) * stretch
    tangents = vertex_tangents(QUAD, UP, uvs, QUAD_FACES)
    assert np.allclose(tangents[:, :3], u_along, atol=tol.ROUNDING.value)
    assert (tangents[:, 3] == sign).all()
    bitangent = tangents[:, 3:] * np.cross(UP, tangents[:, :3])
    assert np.allclose(bitangent, -np.array(v_along), atol=tol.ROUNDING.value)


def test_tangents_of_a_sphere_run_along_the_parallels():
    # u increases with longitude and v from the north pole down, as on a map of the world.
    ball = shapes.sphere("icosphere", 4)
    x, y, z = ball.positions.T
    longitude, polar = np.arctan2(y, x), np.arccos(z)
    uvs = np.stack([longitude / (2 * np.pi), polar / np.pi], axis=1)
    seam = (np.ptp(uvs[ball.faces, 0], axis=1) > 0.5) | (np.abs(z[ball.faces]) > 0.9).any(axis=1)
    faces = ball.faces[~seam]
    used = np.unique(faces)
    inner = used[(np.abs(z[used]) < 0.8) & (np.abs(longitude[used]) < 2.8)]
    tangents = vertex_tangents(ball.positions, ball.normals, uvs, faces)[inner]
    n = ball.normals[inner]
    east = np.stack([-np.sin(longitude), np.cos(longitude), 0 * z], axis=1)[inner]
    north = np.cross(n, east)
    assert np.abs(np.einsum("ij,ij->i", tangents[:, :3], n)).max() <= tol.ROUNDING.value
    assert np.allclose(np.linalg.norm(tangents[:, :3], axis=1), 1.0)
    assert degrees_apart(tangents[:, :3], east).max() <= tol.TANGENT_DEG.value
    bitangent = tangents[:, 3:] * np.cross(n, tangents[:, :3])
    assert (np.einsum("ij,ij->i", bitangent, north) > 0.99).all()


def test_mirrored_quads_of_one_mesh_have_opposite_handedness():
    # Two quads side by side; the left one is the mirror image of the right one.
    positions = np.concatenate([QUAD, QUAD * (-1, 1, 1)])
    faces = np.concatenate([QUAD_FACES, QUAD_FACES[:, ::-1] + 4])
    uvs = np.tile(uvs_of_quad([1, 0, 0], [0, -1, 0]), (2, 1))
    tangents = vertex_tangents(positions, np.tile(UP, (2, 1)), uvs, faces)
    assert tangents[:4, 3].tolist() == [1.0] * 4
    assert tangents[4:, 3].tolist() == [-1.0] * 4
    assert np.allclose(tangents[4:, 0], -1.0)


@pytest.mark.parametrize("uvs", [np.zeros((4, 2)), np.stack([np.arange(4.0)] * 2, axis=1)])
def test_tangents_of_degenerate_uvs_are_unit_vectors(uvs):
    tangents = vertex_tangents(QUAD, UP, uvs, QUAD_FACES)
    assert np.allclose(np.linalg.norm(tangents[:, :3], axis=1), 1.0)
    assert np.allclose(tangents[:, 2], 0.0)
    assert (np.abs(tangents[:, 3]) == 1.0).all()
