"""Compiled rays against their NumPy twin: closed bodies without leaks, hostile shapes, equal bytes."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import shapes
from native_twins import both, level, needs_library, numpy_twins, threads
from skinshade._core import native
from skinshade.mesh import mesh_thickness
from skinshade.mesh.compiled_rays import CompiledHierarchy
from skinshade.mesh.normals import tangent_frame
from skinshade.mesh.rays import Hierarchy, open_caster
from skinshade.mesh.thickness import _spirals
from tolerances import ROUNDING, ROUNDING_SUMS, THICKNESS_SHARED

pytestmark = needs_library

TWINS = pytest.mark.parametrize("caster", [CompiledHierarchy.of, Hierarchy], ids=["C", "NumPy"])


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=1)[:, None]


def random_rays(count, seed, reach=1.0):
    """Return origins in a cube of half width `reach`, and unit directions."""
    rng = np.random.default_rng(seed)
    return rng.uniform(-reach, reach, (count, 3)), unit(rng.normal(size=(count, 3)))


def assert_same_answers(positions, faces, origins, directions, limit):
    compiled, twin = CompiledHierarchy.of(positions, faces), Hierarchy(positions, faces)
    rays = origins, directions
    np.testing.assert_array_equal(compiled.exit_distances(*rays), twin.exit_distances(*rays))
    one, other = compiled.nearest(*rays), twin.nearest(*rays)
    np.testing.assert_array_equal(one.distances, other.distances)
    np.testing.assert_array_equal(one.faces, other.faces)
    np.testing.assert_array_equal(one.weights, other.weights)
    limits = np.full(len(origins), limit)
    blocked = compiled.occluded(*rays, limits)
    np.testing.assert_array_equal(blocked, twin.occluded(*rays, limits))
    np.testing.assert_array_equal(blocked, np.isfinite(one.distances) & (one.distances <= limit))


# -- the same answers as NumPy -----------------------------------------------------------------------


@pytest.mark.parametrize("size", [1e-30, 1.0, 1e30])
@pytest.mark.parametrize("kind", ["ellipsoid", "torus", "soup"])
def test_rays_have_the_hits_of_numpy(kind, size):
    if kind == "soup":
        corners = np.random.default_rng(5).normal(size=(1500, 3)) * 0.3
        positions, faces = corners, np.arange(1500).reshape(-1, 3)
    else:
        body = shapes.torus("random", 1500, 0.6, 0.3)
        if kind == "ellipsoid":
            body = shapes.ellipsoid("random", 1500, (1.0, 0.7, 0.5))
        positions, faces = body.positions, body.faces
    origins, directions = random_rays(600, 1)
    assert_same_answers(positions * size, faces, origins * size, directions, 0.5 * size)


@st.composite
def lattice_mesh(draw):
    """Corners on a lattice: degenerate, coincident and crossing faces."""
    count = draw(st.integers(3, 30))
    lattice = draw(st.lists(st.tuples(*[st.integers(-1, 1)] * 3), min_size=count, max_size=count))
    corner = st.integers(0, count - 1)
    faces = draw(st.lists(st.tuples(corner, corner, corner), min_size=1, max_size=60))
    return np.array(lattice, dtype=np.float64), np.array(faces, dtype=np.int64)


@settings(max_examples=60)
@given(lattice_mesh(), st.integers(0, 1000), st.sampled_from([1e-30, 1.0, 1e30]))
def test_rays_through_any_faces_have_the_hits_of_numpy(mesh, seed, size):
    positions, faces = mesh
    origins, directions = random_rays(40, seed, 2.0)
    # Along axes and through corners, from points of the lattice, too.
    axes = np.concatenate([np.eye(3), -np.eye(3), unit(np.sign(directions[:10]))])
    rng = np.random.default_rng(seed)
    origins = np.concatenate([origins, rng.integers(-2, 3, (len(axes), 3)).astype(float)])
    directions = np.concatenate([directions, axes])
    assert_same_answers(positions * size, faces, origins * size, directions, 1.5 * size)


@pytest.mark.parametrize("count", [1, 4, 5, 9, 300])
def test_coincident_faces_are_hit_and_the_least_index_counts(count):
    positions = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]])
    faces = np.tile([0, 1, 2], (count, 1))
    origins, directions = np.array([[0.2, 0.2, 0.0]]), np.array([[0.0, 0.0, 1.0]])
    hits = CompiledHierarchy.of(positions, faces).nearest(origins, directions)
    assert hits.faces.tolist() == [0]
    np.testing.assert_allclose(hits.weights, [[0.6, 0.2, 0.2]], rtol=ROUNDING.value)
    assert_same_answers(positions, faces, origins, directions, 1.0)


def test_faces_of_all_sizes_are_hit():
    """Sizes 2^0 to 2^-400 make a deep tree, most of which lies in one cell of the grid."""
    size = 2.0 ** -np.arange(400)
    corner = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]])
    positions = (corner * size[:, None, None]).reshape(-1, 3)
    faces = np.arange(len(positions)).reshape(-1, 3)
    origins, directions = np.zeros((30, 3)), unit(np.random.default_rng(0).uniform(0, 1, (30, 3)))
    assert_same_answers(positions, faces, origins, directions, 1.0)


def test_a_far_vertex_and_far_origins_keep_the_hits():
    body = shapes.sphere("random", 1000)
    positions = np.vstack([body.positions, [[1e7, 0.0, 0.0], [1e7, 1.0, 0.0], [1e7, 0.0, 1.0]]])
    faces = np.vstack([body.faces, [[1000, 1001, 1002]]])
    origins, directions = random_rays(300, 2)
    assert_same_answers(positions, faces, origins, directions, 0.5)
    assert_same_answers(
        body.positions, body.faces, origins - 1e6 * directions, directions, 1e6 + 0.5
    )


@TWINS
def test_rays_with_numbers_that_are_not_finite_hit_nothing(caster):
    body = shapes.sphere("icosphere", 1)
    origins = np.array([[np.nan, 0.0, 0.0], [0.0, 0.0, 0.0]])
    directions = np.array([[0.0, 0.0, 1.0], [0.0, 0.0, np.nan]])
    with np.errstate(invalid="ignore"):
        hits = caster(body.positions, body.faces).nearest(origins, directions)
    assert not np.isfinite(hits.distances).any()
    assert hits.faces.tolist() == [-1, -1]


def test_a_hierarchy_without_faces_has_no_hits():
    caster = CompiledHierarchy.of(np.zeros((3, 3)), np.zeros((0, 3), dtype=np.int64))
    assert caster.nearest(*random_rays(5, 0)).faces.tolist() == [-1] * 5


# -- no leaks, and analytic hits ---------------------------------------------------------------------


@TWINS
@pytest.mark.parametrize("kind", ["icosphere", "random"])
def test_no_ray_leaves_a_closed_body_through_an_edge_or_a_corner(caster, kind):
    body = shapes.sphere(kind, 3 if kind == "icosphere" else 700)
    rng = np.random.default_rng(4)
    corners = body.positions[body.faces]
    share = rng.uniform(0.0, 1.0, (len(corners), 1))
    targets = [body.positions, share * corners[:, 0] + (1.0 - share) * corners[:, 1]]
    targets += [0.5 * (corners[:, 1] + corners[:, 2])]
    for origin in (np.zeros(3), np.array([0.3, -0.2, 0.1]), np.array([0.0, 0.5, 0.0])):
        for target in targets:
            away = target - origin
            distance = caster(body.positions, body.faces).exit_distances(
                np.tile(origin, (len(target), 1)), unit(away)
            )
            np.testing.assert_allclose(
                distance, np.linalg.norm(away, axis=1), rtol=ROUNDING_SUMS.value
            )


@TWINS
def test_weights_give_the_point_on_the_nearest_face(caster):
    body = shapes.ellipsoid("random", 800, (1.0, 0.8, 0.6))
    origins, directions = random_rays(500, 3, 0.3)
    hits = caster(body.positions, body.faces).nearest(origins, directions)
    corners = body.positions[body.faces[hits.faces]]
    point = np.einsum("ij,ijk->ik", hits.weights, corners)
    expected = origins + hits.distances[:, None] * directions
    np.testing.assert_allclose(point, expected, atol=ROUNDING_SUMS.value)
    np.testing.assert_allclose(hits.weights.sum(axis=1), 1.0, rtol=ROUNDING.value)
    assert hits.weights.min() >= 0.0


@TWINS
def test_occlusion_ends_at_the_distance(caster):
    positions = np.array([[-1.0, -1.0, 2.0], [1.0, -1.0, 2.0], [0.0, 1.0, 2.0]])
    caster = caster(positions, np.array([[0, 1, 2]]))
    origins, directions = np.zeros((4, 3)), np.tile([0.0, 0.0, 1.0], (4, 1))
    limits = np.array([1.9, 2.0, np.inf, -1.0])
    assert caster.occluded(origins, directions, limits).tolist() == [False, True, True, False]


# -- sums of cones, and thickness --------------------------------------------------------------------


@pytest.mark.parametrize("count", [1, 7, 50])
def test_sums_over_eight_rays_at_once_are_those_of_single_rays(count):
    body = shapes.ellipsoid("random", 900, (1.0, 0.7, 0.5))
    faces = body.faces[30:]  # some rays leave through a hole
    caster = CompiledHierarchy.of(body.positions, faces)
    at = np.random.default_rng(0).choice(900, count)  # neighbours are far away: no common axes
    origins, normals = body.positions[at] - 1e-5 * body.normals[at], body.normals[at]
    sets = _spirals(12, 3, 80.0)
    sums = caster.exit_sums(origins, normals, sets)
    u, v = tangent_frame(normals)
    expected = np.zeros((count, 2))
    for ray in range(12):
        local = sets[np.arange(count) // 8 % 3, ray]
        inward = local[:, :1] * u + local[:, 1:2] * v - local[:, 2:] * normals
        distance = caster.exit_distances(origins, inward)
        hit = np.isfinite(distance)
        expected[hit, 0] += distance[hit] * local[hit, 2]
        expected[:, 1] += hit
    np.testing.assert_allclose(sums, expected, rtol=ROUNDING.value)
    np.testing.assert_array_equal(sums[:, 1], expected[:, 1])


def bumpy_ball(detail, height=0.1):
    """Return a ball with smooth bumps and, at one vertex, a spike."""
    ball = shapes.sphere("icosphere", detail)
    x, y, z = ball.positions.T
    radius = 1.0 + height * np.sin(4.0 * x + 1.0) * np.sin(3.0 * y) * np.sin(4.0 * z + 2.0)
    return ball.positions * radius[:, None], ball.faces


@pytest.mark.parametrize("rays", [8, 64])
def test_thickness_is_that_of_numpy(rays):
    positions, faces = bumpy_ball(3)
    positions[5] *= 1.3
    thickness, twin = both(lambda: mesh_thickness(positions, faces, rays=rays, tracing="builtin"))
    np.testing.assert_allclose(thickness, twin, rtol=ROUNDING_SUMS.value)


def test_shared_rays_give_the_thickness_of_4096_rays():
    positions, faces = bumpy_ball(5)
    normals = shapes.sphere("icosphere", 5).normals
    thickness = mesh_thickness(positions, faces, normals, tracing="builtin")
    at = np.random.default_rng(0).choice(len(positions), 200, replace=False)
    exact = mesh_thickness(
        positions, faces, normals[at], points=positions[at], rays=4096, tracing="builtin"
    )
    error = np.abs(thickness[at] / exact - 1.0)
    assert np.quantile(error, 0.95) <= THICKNESS_SHARED.value
    assert (error > 0.0).all()


def test_vertices_whose_neighbours_disagree_have_rays_of_their_own():
    positions, faces = bumpy_ball(4)
    tip = 100
    positions[tip] *= 1.5
    thickness = mesh_thickness(positions, faces, positions, tracing="builtin")
    near = np.unique(faces[(faces == tip).any(axis=1)])
    own = mesh_thickness(
        positions, faces, positions[near], points=positions[near], tracing="builtin"
    )
    np.testing.assert_allclose(thickness[near], own, rtol=ROUNDING.value)


def test_copies_of_a_vertex_have_equal_thickness_where_their_normals_are_equal():
    positions, faces = bumpy_ball(4)
    corners = faces.ravel()
    split = positions[corners], np.arange(len(corners)).reshape(-1, 3), positions[corners]
    thickness = mesh_thickness(*split, tracing="builtin")
    once = np.empty(len(positions))
    once[corners] = thickness
    np.testing.assert_array_equal(thickness, once[corners])


def test_vertices_with_other_normals_at_their_position_have_rays_of_their_own():
    ball = shapes.sphere("icosphere", 2)
    corners = ball.faces.ravel()
    positions, faces = ball.positions[corners], np.arange(len(corners)).reshape(-1, 3)
    p = positions[faces]
    normals = np.repeat(unit(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])), 3, axis=0)
    thickness = mesh_thickness(positions, faces, normals, tracing="builtin")
    own = mesh_thickness(positions, faces, normals, points=positions, tracing="builtin")
    np.testing.assert_array_equal(thickness, own)


# -- the same bytes ----------------------------------------------------------------------------------


def answers():
    """Return the results of all kernels for a body."""
    positions, faces = bumpy_ball(4)
    rays = random_rays(3000, 7)
    caster = open_caster(positions, faces, "builtin")
    hits = caster.nearest(*rays)
    return [
        caster.exit_distances(*rays),
        *(hits.distances, hits.faces, hits.weights),
        caster.occluded(*rays, np.full(3000, 0.4)),
        mesh_thickness(positions, faces, tracing="builtin"),
    ]


def test_rays_have_the_same_bytes_for_any_number_of_threads():
    with threads(1):
        expected = answers()
    for count in (2, 5):
        with threads(count):
            for result, other in zip(answers(), expected, strict=True):
                np.testing.assert_array_equal(result, other)


@pytest.mark.skipif(native.reason() != "compiled, x86-64-v3", reason="no second level")
def test_rays_have_the_same_bytes_for_all_levels_of_instructions():
    with level("v2"):
        expected = answers()
    with level("v3"):
        for result, other in zip(answers(), expected, strict=True):
            np.testing.assert_array_equal(result, other)


def test_the_builtin_caster_is_the_compiled_one_where_it_is_in_use():
    ball = shapes.sphere("icosphere", 1)
    for tracing in ("builtin", "auto"):
        caster = open_caster(ball.positions, ball.faces, tracing)
        assert isinstance(caster, CompiledHierarchy)
    with numpy_twins():
        assert isinstance(open_caster(ball.positions, ball.faces, "builtin"), Hierarchy)
