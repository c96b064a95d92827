"""The fitted shape operator is bounded by what the edges of a vertex resolve."""

from importlib.resources import files

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial import ConvexHull

import shapes
import skinshade as sk
import tolerances as tol
from skinshade.mesh import mesh_curvature, mesh_curvature_tensor, shape_operator, vertex_attributes
from skinshade.mesh.shape_operator import CONDITIONING, RESOLUTION, RESOLVED_TURN, ShapeOperator

AXES = (3.0, 2.0, 1.0)
HEAD = files("skinshade") / "heads" / "assets" / "head.glb"
EXPLODED = 20_000.0
"""Curvature times size of the mesh beyond which a fit counts as exploded."""


def convex_hull(points):
    """Return a convex body whose corners lie on the unit sphere, with the sphere's normals."""
    points = np.asarray(points, dtype=float)
    normals = points / np.linalg.norm(points, axis=1)[:, None]
    faces = shapes.outward(normals, ConvexHull(normals).simplices, normals)
    ones = np.ones(len(points))
    return shapes.Shape(normals, faces, normals, ones, ones)


CUBE = [[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
ORDINARY = {
    "tetrahedron": lambda: convex_hull([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]),
    "octahedron": lambda: convex_hull(np.vstack([np.eye(3), -np.eye(3)])),
    "cube": lambda: convex_hull(CUBE),
    "icosahedron": lambda: shapes.sphere("icosphere", 0),
    "ellipsoid of 12 vertices": lambda: shapes.ellipsoid("icosphere", 0, AXES),
    "sphere, icosphere": lambda: shapes.sphere("icosphere", 4),
    "sphere, regular": lambda: shapes.sphere("regular", 32),
    "sphere, random": lambda: shapes.sphere("random", 4000),
    "ellipsoid, icosphere": lambda: shapes.ellipsoid("icosphere", 4, AXES),
    "ellipsoid, regular": lambda: shapes.ellipsoid("regular", 64, AXES),
    "ellipsoid, random, coarse": lambda: shapes.ellipsoid("random", 20, AXES),
    "ellipsoid, random": lambda: shapes.ellipsoid("random", 16_000, AXES),
    "ellipsoid, stretched tenfold": lambda: shapes.ellipsoid("icosphere", 4, (10.0, 1.0, 1.0)),
    "torus, regular": lambda: shapes.torus("regular", 36),
    "torus, random": lambda: shapes.torus("random", 4000),
    "tube": lambda: shapes.cylinder(1.0, 2.0, 64, 24),
    "square": lambda: shapes.square(3.0, 8),
    "built-in head": lambda: sk.load_mesh(HEAD),
}


def size_of(positions):
    return float(np.linalg.norm(np.ptp(positions, axis=0)))


def greatest_principal(tensor):
    mean, half = 0.5 * (tensor[:, 0] + tensor[:, 2]), 0.5 * (tensor[:, 0] - tensor[:, 2])
    return np.abs(mean) + np.hypot(half, tensor[:, 1])


def fit_without_bounds(*mesh):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(shape_operator, "CONDITIONING", 1e30)
        patch.setattr(shape_operator, "RESOLVED_TURN", 1e30)
        return ShapeOperator.fit(*mesh)


@pytest.mark.parametrize("make", ORDINARY.values(), ids=ORDINARY)
@pytest.mark.parametrize("with_normals", [True, False])
def test_the_bounds_do_not_change_ordinary_meshes(make, with_normals):
    shape = make()
    mesh = shape.positions, shape.faces, shape.normals if with_normals else None
    bounded, plain = ShapeOperator.fit(*mesh), fit_without_bounds(*mesh)
    assert bounded.bounded_vertices == 0
    assert np.array_equal(bounded.mean(), plain.mean())
    assert np.array_equal(bounded.tensor(), plain.tensor())


def test_mean_and_tensor_of_one_fit_are_those_of_the_public_functions():
    shape = shapes.ellipsoid("random", 600, AXES)
    positions, faces, normals, _ = shapes.split_seam(shape)
    operator = ShapeOperator.fit(positions, faces, normals)
    for smoothing in (0, 2):
        mean = mesh_curvature(positions, faces, normals, smoothing=smoothing)
        tensor = mesh_curvature_tensor(positions, faces, normals, smoothing=smoothing)
        assert np.array_equal(operator.mean(smoothing), mean)
        assert np.array_equal(operator.tensor(smoothing), tensor)


def test_vertex_attributes_have_one_fit(monkeypatch, deon):
    fits = []
    fit = ShapeOperator.fit
    monkeypatch.setattr(ShapeOperator, "fit", lambda *mesh: fits.append(mesh) or fit(*mesh))
    ball = shapes.sphere("icosphere", 2, 30.0)
    mesh = sk.Mesh.checked(ball.positions, ball.faces, unit_mm=1.0, normals=ball.normals)
    attributes = vertex_attributes(mesh, deon)
    assert len(fits) == 1
    expected = mesh_curvature(mesh.positions_mm, mesh.faces, mesh.normals)
    assert np.array_equal(attributes["curvature"][:, 0], expected)


# -- fans ------------------------------------------------------------------------------------------


def fan(rim, normals, centre=(0.0, 0.0, 0.0)):
    """Return a closed fan of faces around a vertex: positions, faces and unit normals."""
    corner = np.arange(1, len(rim) + 1)
    faces = np.stack([0 * corner, corner, np.roll(corner, -1)], axis=1)
    normals = np.asarray(normals, dtype=float)
    unit = normals / np.linalg.norm(normals, axis=1)[:, None]
    return np.vstack([[centre], rim]), faces, unit


def on_circle(angles):
    return np.stack([np.cos(angles), np.sin(angles), 0.0 * np.asarray(angles)], axis=1)


def flat_fan_of_almost_parallel_edges():
    normals = [[0, 0, 1], [0, 0.3, 1], [0, -0.3, 1], [0, 0.3, 1], [0, -0.3, 1]]
    return fan(on_circle([0.0, 1e-5, np.pi, np.pi + 1e-5]), normals)


def fan_with_a_tiny_edge_between_unlike_normals():
    rim = on_circle(np.arange(6) * np.pi / 3.0)
    rim[0] *= 1e-6
    return fan(rim, [[0, 0, 1], [1, 0, 0], *[[0, 0, 1]] * 5])


def needle_fan():
    normals = np.stack([np.zeros(6), 0.3 * (-1.0) ** np.arange(6), np.ones(6)], axis=1)
    return fan(on_circle(np.arange(5) * 3e-6), normals)


def collinear_points_rounded_to_float32():
    rng = np.random.default_rng(2)
    along = np.array([-1.0, -0.7, -0.3, 0.3, 0.7, 1.0])[rng.permutation(6), None]
    line = np.array([1.0, 0.3, 0.2])
    rim = (1000.0 + along * line).astype(np.float32).astype(float)
    return fan(rim, [0, 0, 1] + 0.3 * rng.normal(size=(7, 3)), centre=[1000.0] * 3)


FANS = [
    flat_fan_of_almost_parallel_edges,
    fan_with_a_tiny_edge_between_unlike_normals,
    needle_fan,
    collinear_points_rounded_to_float32,
]


@pytest.mark.parametrize("make", FANS)
def test_degenerate_fans_explode_without_the_bounds_and_not_with_them(make):
    positions, faces, normals = make()
    size = size_of(positions)
    plain = fit_without_bounds(positions, faces, normals)
    assert greatest_principal(plain.fitted).max() * size > EXPLODED
    operator = ShapeOperator.fit(positions, faces, normals)
    assert 0 < operator.bounded_vertices <= len(positions)
    assert greatest_principal(operator.fitted).max() * size < 0.05 * EXPLODED
    for smoothing in (0, 2):
        tensor = mesh_curvature_tensor(positions, faces, normals, smoothing=smoothing)
        assert greatest_principal(tensor).max() * size < 0.05 * EXPLODED
        mean = mesh_curvature(positions, faces, normals, smoothing=smoothing)
        assert np.abs(mean).max() * size < 0.05 * EXPLODED


SPOKES = st.lists(
    st.tuples(
        st.sampled_from([0.0, np.pi]) | st.floats(0.0, 2.0 * np.pi),
        st.just(0.0) | st.floats(-1e-4, 1e-4),
        st.just(1.0) | st.floats(-6.0, 0.0).map(lambda power: 10.0**power),
        st.floats(-1e-6, 1e-6),
        st.tuples(st.floats(-2.0, 2.0), st.floats(-2.0, 2.0)),
    ),
    min_size=3,
    max_size=8,
)


def greatest_turn_and_shortest_edge(positions, faces, normals):
    """Return, for every vertex, the greatest turn per length and the shortest edge, in a loop."""
    turn, shortest = np.zeros(len(positions)), np.full(len(positions), np.inf)
    sides = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    lengths = np.linalg.norm(positions[sides[:, 0]] - positions[sides[:, 1]], axis=1)
    for (a, b), length in zip(sides, lengths, strict=True):
        if length > 0.0:
            ratio = np.linalg.norm(normals[a] - normals[b]) / length
            turn[[a, b]] = np.maximum(turn[[a, b]], ratio)
            shortest[[a, b]] = np.minimum(shortest[[a, b]], length)
    return turn, shortest, np.median(lengths[lengths > 0.0])


@given(SPOKES)
def test_the_bounds_hold_on_any_fan_and_only_shorten_the_tensor(spokes):
    angle, error, radius, height, tilt = (np.array(column) for column in zip(*spokes, strict=True))
    rim = on_circle(angle + error) * radius[:, None]
    rim[:, 2] = height * radius
    normals = [[0.0, 0.0, 1.0], *([x, y, 1.0] for x, y in tilt)]
    positions, faces, normals = fan(rim, normals)
    operator = ShapeOperator.fit(positions, faces, normals)
    plain = fit_without_bounds(positions, faces, normals)
    if len(operator.points) < len(positions):
        return  # vertices at one position share a normal
    fitted, before = operator.fitted[operator.group], plain.fitted[plain.group]
    turn, shortest, median = greatest_turn_and_shortest_edge(positions, faces, normals)
    shortest = np.maximum(shortest, RESOLUTION * median)
    limit = np.minimum(CONDITIONING * turn, RESOLVED_TURN / shortest)
    greatest = greatest_principal(fitted)
    assert (greatest <= limit * (1.0 + tol.ROUNDING_SUMS.value)).all()
    assert (greatest * median <= RESOLVED_TURN / RESOLUTION * (1.0 + tol.ROUNDING.value)).all()
    reduced = operator.bounded[operator.group]
    assert np.array_equal(fitted[~reduced], before[~reduced])
    factor = greatest / np.maximum(greatest_principal(before), 1e-300)
    assert (factor[reduced] < 1.0).all()
    gap = np.abs(fitted - factor[:, None] * before).max(axis=1)
    assert (gap[reduced] <= tol.ROUNDING.value * greatest[reduced]).all()


def test_bounded_vertices_are_counted_on_both_sides_of_a_seam():
    positions, faces, normals = fan_with_a_tiny_edge_between_unlike_normals()
    once = ShapeOperator.fit(positions, faces, normals).bounded_vertices
    corners = faces.ravel()
    split = ShapeOperator.fit(
        positions[corners], np.arange(corners.size).reshape(-1, 3), normals[corners]
    )
    counts = np.bincount(corners)
    whole = ShapeOperator.fit(positions, faces, normals)
    assert once > 0
    assert split.bounded_vertices == counts[whole.bounded[whole.group]].sum()
