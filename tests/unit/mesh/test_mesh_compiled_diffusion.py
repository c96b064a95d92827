"""The compiled Laplacian and Chebyshev's recurrence against their NumPy twins."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import shapes
import tolerances as tol
from native_twins import both, level, needs_library, relative_gap, threads
from skinshade._core import native
from skinshade.mesh import compiled_tables, diffuse_on_mesh
from skinshade.mesh.chebyshev import chebyshev_factors, filtered
from skinshade.mesh.laplacian import LEAST_AREA, Laplacian
from skinshade.mesh.topology import face_areas

pytestmark = needs_library

BALL = shapes.sphere("random", 3000, 10.0)


def shuffled(shape, seed=0):
    """Return positions and faces of a shape in a random order."""
    rng = np.random.default_rng(seed)
    order = rng.permutation(len(shape.positions))
    number = np.argsort(order)
    return shape.positions[order], number[shape.faces][rng.permutation(len(shape.faces))]


def wheel(rim):
    """Return positions and faces of a vertex with many faces, some of which occur twice."""
    angle = np.arange(rim) * 2.0 * np.pi / rim
    positions = np.vstack([np.zeros(3), np.stack([np.cos(angle), np.sin(angle), angle], axis=1)])
    corner = 1 + np.random.default_rng(0).permutation(rim)
    faces = np.stack([np.zeros_like(corner), corner, corner % rim + 1], axis=1)
    return positions, np.concatenate([faces, faces[:5], faces[rim // 2 :, ::-1]])


def dense(laplacian):
    """Return the weights of the edges (V, V) between vertices, the masses (V,) and the bound."""
    matrix = laplacian.stiffness().toarray()
    index = np.arange(len(matrix)) if laplacian.point is None else laplacian.point
    return matrix[np.ix_(index, index)], laplacian.masses[index], laplacian.greatest


MESHES = {
    "sphere": lambda: (BALL.positions[:], BALL.faces),
    "random order": lambda: shuffled(BALL),
    "seam": lambda: shapes.split_seam(shapes.torus("random", 1000))[:2],
    "open": lambda: (lambda s: (s.positions, s.faces))(shapes.cylinder(1.0, 3.0, 30, 20)),
    "wheel of 40": lambda: wheel(40),
    "wheel of 300": lambda: wheel(300),
    "a face": lambda: (np.eye(3), np.array([[0, 1, 2]])),
    "a face and one with equal corners": lambda: (np.eye(3), np.array([[0, 1, 2], [1, 1, 2]])),
    "a needle": lambda: (
        np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1e-14, 0]]),
        np.array([[0, 1, 2], [0, 3, 1]]),
    ),
}


@pytest.mark.parametrize("disordered", [False, True])
@pytest.mark.parametrize("make", MESHES.values(), ids=MESHES)
def test_weights_masses_and_bounds_are_those_of_numpy(make, disordered, monkeypatch):
    monkeypatch.setattr(compiled_tables, "is_disordered", lambda faces: disordered)
    compiled, twin = both(lambda: dense(Laplacian.of(*make())))
    for value, expected in zip(compiled, twin, strict=True):
        assert relative_gap(value, expected) <= tol.NATIVE_LAPLACIAN.value


@given(
    st.lists(st.tuples(*[st.integers(0, 11)] * 3), min_size=1, max_size=60), st.integers(0, 1000)
)
def test_weights_of_any_faces_are_those_of_numpy(faces, seed):
    used, numbers = np.unique(faces, return_inverse=True)
    faces = numbers.reshape(-1, 3)
    # Every vertex has a face with an area.
    count = len(used)
    positions = np.random.default_rng(seed).normal(size=(count + 2, 3))
    own = np.stack([np.arange(count), np.full(count, count), np.full(count, count + 1)], axis=1)
    faces = np.concatenate([faces, own])
    compiled, twin = both(lambda: dense(Laplacian.of(positions, faces)))
    for value, expected in zip(compiled, twin, strict=True):
        assert relative_gap(value, expected) <= tol.NATIVE_LAPLACIAN.value


@pytest.mark.parametrize("name", ["sphere", "random order", "seam", "open", "a needle"])
def test_the_weights_of_both_ends_of_an_edge_are_the_same_number(name):
    matrix = Laplacian.of(*MESHES[name]()).stiffness()
    assert (matrix != matrix.T).nnz == 0


@pytest.mark.parametrize("make", MESHES.values(), ids=MESHES)
def test_every_edge_occurs_once_at_an_end(make):
    edges = Laplacian.of(*make()).edges
    start = np.repeat(np.arange(len(edges.firsts) - 1), np.diff(edges.firsts))
    assert len(np.unique(np.stack([start, edges.ends]), axis=1).T) == len(edges.ends)
    assert (start != edges.ends).all()


@pytest.mark.parametrize("columns", [1, 3, 4, 7])
@pytest.mark.parametrize("factor", [0.2, 1.0, 3.0])
def test_diffused_values_are_those_of_numpy(deon, columns, factor):
    shape, profile = shapes.torus("regular", 32), deon.scaled(0.1 * factor)
    values = np.random.default_rng(0).normal(size=(len(shape.positions), columns))
    result, twin = both(lambda: diffuse_on_mesh(shape.positions, shape.faces, values, profile))
    assert relative_gap(result, twin) <= tol.NATIVE_DIFFUSION.value


@pytest.mark.parametrize("terms", [2, 3, 4, 5, 6, 7, 20])
def test_polynomials_of_every_degree_are_those_of_numpy(terms):
    laplacian = Laplacian.of(BALL.positions, BALL.faces)
    factors = np.random.default_rng(terms).normal(size=(terms, 3))
    factors[terms // 2 :, 1] = 0.0
    values = BALL.normals
    result, twin = both(lambda: filtered(laplacian, factors, values, lambda done: None))
    assert relative_gap(result, twin) <= tol.NATIVE_DIFFUSION.value


# -- the same bytes --------------------------------------------------------------------------------


def results(make, profile):
    """Return all results of the kernels for a mesh."""
    positions, faces = make()
    laplacian = Laplacian.of(positions, faces)
    diffused = diffuse_on_mesh(positions, faces, positions, profile)
    edges = laplacian.edges
    return edges.firsts, edges.ends, edges.weights, laplacian.masses, laplacian.greatest, diffused


def assert_same_bytes(values, expected):
    for value, other in zip(values, expected, strict=True):
        assert np.array_equal(value, other)


@pytest.mark.parametrize("name", ["random order", "seam", "wheel of 300"])
def test_results_have_the_same_bytes_for_any_number_of_threads(name, deon):
    with threads(1):
        expected = results(MESHES[name], deon)
    for count in (2, 5):
        with threads(count):
            assert_same_bytes(results(MESHES[name], deon), expected)


@pytest.mark.skipif(native.reason() != "compiled, x86-64-v3", reason="no second level")
@pytest.mark.parametrize("name", ["random order", "seam", "wheel of 300"])
def test_results_have_the_same_bytes_for_all_levels_of_instructions(name, deon):
    with level("v2"):
        expected = results(MESHES[name], deon)
    with level("v3"):
        assert_same_bytes(results(MESHES[name], deon), expected)


def test_the_floor_of_areas_bounds_cotangents():
    positions, faces = MESHES["a needle"]()
    floor = LEAST_AREA * face_areas(positions, faces).max()
    weights = Laplacian.of(positions, faces).edges.weights
    assert np.abs(weights).max() <= 0.25 / floor * (1.0 + tol.ROUNDING.value)
    assert np.abs(weights).max() >= 0.2 / floor


def test_factors_reach_the_tolerance_in_few_terms(deon):
    greatest = Laplacian.of(BALL.positions, BALL.faces).greatest
    reach = float(deon.rms_radius_mm.max())
    loose, tight = (chebyshev_factors(deon.transfer, greatest, reach, t) for t in (1e-4, 1e-12))
    assert len(loose) < len(tight) < 40.0 * reach * np.sqrt(greatest)
