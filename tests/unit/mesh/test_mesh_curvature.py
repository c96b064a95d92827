"""Mean curvature of shapes whose curvature is known."""

from itertools import pairwise

import numpy as np
import pytest

import shapes
import tolerances as tol
from skinshade.mesh import mesh_curvature

AXES = (3.0, 2.0, 1.0)

FINE = {
    "sphere, icosphere": lambda: shapes.sphere("icosphere", 5),
    "sphere, regular": lambda: shapes.sphere("regular", 128),
    "sphere, random": lambda: shapes.sphere("random", 16_000),
    "ellipsoid, icosphere": lambda: shapes.ellipsoid("icosphere", 5, AXES),
    "ellipsoid, regular": lambda: shapes.ellipsoid("regular", 128, AXES),
    "ellipsoid, random": lambda: shapes.ellipsoid("random", 16_000, AXES),
    "torus, regular": lambda: shapes.torus("regular", 192),
    "torus, random": lambda: shapes.torus("random", 16_000),
}
LADDERS = {
    "ellipsoid, icosphere": [lambda n=n: shapes.ellipsoid("icosphere", n, AXES) for n in (3, 4, 5)],
    "ellipsoid, regular": [lambda n=n: shapes.ellipsoid("regular", n, AXES) for n in (32, 64, 128)],
    "ellipsoid, random": [
        lambda n=n: shapes.ellipsoid("random", n, AXES) for n in (1000, 4000, 16_000)
    ],
    "torus, regular": [lambda n=n: shapes.torus("regular", n) for n in (48, 96, 192)],
    "torus, random": [lambda n=n: shapes.torus("random", n) for n in (1000, 4000, 16_000)],
}
EVERY_SHAPE = pytest.mark.parametrize("make", FINE.values(), ids=FINE)
EVERY_LADDER = pytest.mark.parametrize("ladder", LADDERS.values(), ids=LADDERS)


def curvature(shape, **options):
    return mesh_curvature(shape.positions, shape.faces, shape.normals, **options)


@EVERY_SHAPE
@pytest.mark.parametrize("smoothing", [0, 2])
def test_mean_curvature_is_within_two_percent(make, smoothing):
    shape = make()
    assert shape.rms_error(curvature(shape, smoothing=smoothing)) <= tol.CURVATURE_RMS.value


@EVERY_LADDER
@pytest.mark.parametrize("smoothing", [0, 2])
def test_the_error_decreases_with_the_size_of_the_triangles(ladder, smoothing):
    errors = [make().rms_error(curvature(make(), smoothing=smoothing)) for make in ladder]
    for coarse, fine in pairwise(errors):
        assert fine <= tol.CURVATURE_GAIN_A_LEVEL.value * coarse


@EVERY_SHAPE
def test_two_passes_are_the_default(make):
    shape = make()
    assert np.array_equal(curvature(shape), curvature(shape, smoothing=2))


@EVERY_SHAPE
def test_mean_curvature_with_computed_normals_is_within_its_tolerance(make):
    shape = make()
    own = mesh_curvature(shape.positions, shape.faces)
    assert shape.rms_error(own) <= tol.CURVATURE_RMS_OWN_NORMALS.value


@pytest.mark.parametrize("kind", ["icosphere", "regular", "random"])
@pytest.mark.parametrize("radius", [0.01, 1.0, 250.0])
@pytest.mark.parametrize("smoothing", [0, 5])
def test_a_sphere_is_exact_at_any_resolution(kind, radius, smoothing):
    ball = shapes.sphere(kind, {"icosphere": 2, "regular": 16, "random": 300}[kind], radius)
    error = np.abs(curvature(ball, smoothing=smoothing) * radius - 1.0).max()
    assert error <= tol.SPHERE_CURVATURE.value


def test_the_mean_curvature_of_a_tube_is_half_that_of_a_sphere():
    tube = shapes.cylinder(2.0, 6.0, 64, 30)
    assert np.allclose(curvature(tube, smoothing=0), 0.25, rtol=tol.SPHERE_CURVATURE.value)


def test_the_mean_curvature_of_a_plane_is_0():
    flat = shapes.square(3.0, 8)
    assert np.abs(curvature(flat)).max() == 0.0
    assert np.abs(mesh_curvature(flat.positions, flat.faces)).max() <= tol.ROUNDING_SUMS.value


def test_the_inner_circle_of_a_torus_has_its_known_mean_curvature():
    # The sum 1/r + cos v/(R + r cos v) at v = π is 0 for R = 2r, and negative for R < 2r.
    ring = shapes.torus("regular", 192, 2.0, 1.0)
    inside = np.isclose(ring.positions[:, 0] ** 2 + ring.positions[:, 1] ** 2, 1.0)
    assert np.abs(curvature(ring, smoothing=0)[inside]).max() <= tol.CURVATURE_RMS.value
    tight = shapes.torus("regular", 192, 1.5, 1.0)
    inside = np.isclose(tight.positions[:, 0] ** 2 + tight.positions[:, 1] ** 2, 0.25)
    assert (curvature(tight, smoothing=0)[inside] < -0.3).all()


@pytest.mark.parametrize(
    "make",
    [
        lambda: shapes.ellipsoid("icosphere", 5, AXES),
        lambda: shapes.sphere("icosphere", 5),
        lambda: shapes.torus("regular", 192),
    ],
    ids=["ellipsoid of 10,242 vertices", "sphere of 10,242", "torus of 12,288"],
)
@pytest.mark.parametrize("seed", [0, 1, 2])
def test_two_passes_reduce_one_degree_of_noise_to_ten_percent(make, seed):
    # About the 9,000 vertices of a scanned head; 1° on each of the two tangent components.
    shape = make()
    noise = np.random.default_rng(seed).normal(size=shape.normals.shape) * np.pi / 180.0
    normals = shape.normals + noise
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    rough = mesh_curvature(shape.positions, shape.faces, normals, smoothing=0)
    smooth = mesh_curvature(shape.positions, shape.faces, normals, smoothing=2)
    assert shape.rms_error(smooth) <= tol.CURVATURE_NOISE.value
    assert shape.rms_error(smooth) < 0.5 * shape.rms_error(rough)


# -- the method of 2014 ----------------------------------------------------------------------------


@pytest.mark.parametrize("radius", [0.5, 20.0])
@pytest.mark.parametrize("smoothing", [0, 3])
def test_the_2014_method_is_exact_on_a_sphere(radius, smoothing):
    ball = shapes.sphere("random", 500, radius)
    values = curvature(ball, method="edges", smoothing=smoothing)
    assert np.allclose(values, 1.0 / radius, rtol=tol.ROUNDING_SUMS.value)


@pytest.mark.parametrize("level", [3, 4, 5])
def test_the_2014_method_has_18_percent_error_on_an_ellipsoid_at_any_resolution(level):
    shape = shapes.ellipsoid("icosphere", level, AXES)
    error = shape.rms_error(curvature(shape, method="edges", smoothing=0))
    assert abs(error - 0.18) <= tol.EDGES_2014.value


def test_the_2014_method_is_the_mean_of_the_least_and_greatest_turn_per_length():
    # A fan around vertex 0, along whose edges the normal turns by known angles.
    positions = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [-1.0, 0.0, 0.0]])
    tilt = np.array([0.0, 0.1, 0.8, 0.3])
    normals = np.stack([np.sin(tilt), 0.0 * tilt, np.cos(tilt)], axis=1)
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    turn = 2.0 * np.sin(0.5 * tilt)
    ratios = turn[1] / 1.0, turn[2] / 2.0, turn[3] / 1.0
    value = mesh_curvature(positions, faces, normals, method="edges", smoothing=0)[0]
    assert value == pytest.approx(0.5 * (min(ratios) + max(ratios)), rel=tol.ROUNDING.value)


def test_the_2014_method_smooths_over_neighbours_without_the_vertex_itself():
    shape = shapes.ellipsoid("icosphere", 2, AXES)
    before = curvature(shape, method="edges", smoothing=0)
    after = curvature(shape, method="edges", smoothing=1)
    around = shape.faces[(shape.faces == 0).any(axis=1)]
    others = around[around != 0]
    assert after[0] == pytest.approx(before[others].mean(), rel=tol.ROUNDING.value)


def test_the_2014_method_gives_concave_surfaces_positive_curvature():
    ball = shapes.sphere("icosphere", 3)
    inward = mesh_curvature(ball.positions, ball.faces, -ball.normals, method="edges")
    assert np.allclose(inward, 1.0, rtol=tol.ROUNDING_SUMS.value)
