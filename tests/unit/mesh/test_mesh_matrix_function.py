"""Functions of the Laplacian: the bound of its eigenvalues, polynomials, and the shifted inverse."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.sparse import diags_array
from scipy.sparse.linalg import expm_multiply

import shapes
import tolerances as tol
from skinshade._core.errors import MeshError
from skinshade.mesh import chebyshev, diffuse_on_mesh, rational
from skinshade.mesh.chebyshev import chebyshev_factors
from skinshade.mesh.laplacian import Laplacian
from skinshade.profile import Profile

BALL = shapes.sphere("icosphere", 3, 10.0)
SMALL = shapes.ellipsoid("random", 150, (3.0, 2.0, 1.0))


def gaussian(*variances):
    """Return a profile with one Gaussian per channel."""
    return Profile.gaussians(variances_mm2=variances, weights=np.eye(3), albedo=0.5)


def eigenvalues(laplacian):
    """Return all eigenvalues of a Laplacian, and its modes with unit mass."""
    root = np.sqrt(laplacian.masses)
    squares, modes = np.linalg.eigh(laplacian.stiffness().toarray() / root / root[:, None])
    return squares, modes / root[:, None]


def exact(shape, field, profile):
    """Return a field (V,) after diffusion by all modes of a mesh without equal positions."""
    laplacian = Laplacian.of(shape.positions, shape.faces)
    squares, modes = eigenvalues(laplacian)
    response = profile.transfer(np.sqrt(np.maximum(squares, 0.0)))
    shares = modes.T @ (laplacian.masses * field)
    order = slice(None) if laplacian.point is None else laplacian.point
    return (modes @ (response * shares[:, None]))[order]


# -- the bound of the eigenvalues ------------------------------------------------------------------


@given(st.integers(0, 10_000), st.floats(0.0, 1.0))
def test_no_eigenvalue_exceeds_the_bound(seed, flatness):
    rng = np.random.default_rng(seed)
    shape = shapes.square(1.0, 4)
    positions = shape.positions + rng.normal(size=shape.positions.shape) * 0.3
    positions[:, 1] *= 1.0 - 0.999 * flatness
    laplacian = Laplacian.of(positions, shape.faces)
    assert eigenvalues(laplacian)[0].max() <= laplacian.greatest


def test_the_bound_of_equilateral_faces_is_the_greatest_eigenvalue_of_one():
    # A lattice of equilateral faces of side 2 has the greatest eigenvalue 6 / side².
    positions = np.array([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, np.sqrt(3.0), 0.0]])
    laplacian = Laplacian.of(positions, np.array([[0, 1, 2]]))
    assert laplacian.greatest == pytest.approx(1.5, rel=tol.MATRIX_FUNCTION.value)


def test_the_bound_is_near_the_greatest_eigenvalue_of_a_sphere():
    laplacian = Laplacian.of(BALL.positions, BALL.faces)
    assert (
        laplacian.greatest <= (1.0 + tol.EIGENVALUE_BOUND.value) * eigenvalues(laplacian)[0].max()
    )


# -- polynomials -----------------------------------------------------------------------------------


@pytest.mark.parametrize("tolerance", [1e-2, 1e-4, 1e-8, 1e-12])
@pytest.mark.parametrize("name", ["skin-deon2007", "skin1", "burley"])
@pytest.mark.parametrize("greatest", [1e-6, 0.1, 10.0, 1000.0])
def test_the_sum_of_polynomials_errs_by_less_than_the_tolerance(tolerance, name, greatest, burley):
    profile = burley if name == "burley" else Profile.preset(name)
    reach = float(profile.rms_radius_mm.max())
    factors = chebyshev_factors(profile.transfer, greatest, reach, tolerance)
    squares = greatest * np.linspace(0.0, 1.0, 5001) ** 2
    argument = 1.0 - 2.0 * squares / greatest
    values = np.polynomial.chebyshev.chebval(argument, factors).T
    assert np.abs(values - profile.transfer(np.sqrt(squares))).max() <= (
        tolerance + tol.ROUNDING.value
    )
    assert np.abs(factors.sum(axis=0) - 1.0).max() <= tol.ROUNDING.value


def test_narrow_channels_need_fewer_terms():
    factors = chebyshev_factors(gaussian(1.0, 4.0, 16.0).transfer, 100.0, np.sqrt(32.0), 1e-8)
    terms = [int(np.flatnonzero(channel).max()) for channel in factors.T]
    assert terms[0] < 0.6 * terms[1] < 0.36 * terms[2]


@pytest.mark.parametrize("greatest", [1e8, 1e30, 1e300, np.inf])
def test_a_profile_much_wider_than_the_edges_has_no_polynomial(greatest, deon):
    assert chebyshev_factors(deon.transfer, greatest, 1.66, 1e-8) is None


@pytest.mark.parametrize("variance", [0.01, 1.0, 30.0])
def test_a_gaussian_is_the_exponential_of_the_laplacian(variance):
    laplacian = Laplacian.of(BALL.positions, BALL.faces)
    field = np.maximum(BALL.normals @ (0.6, 0.0, 0.8), 0.0)
    order = slice(None) if laplacian.point is None else laplacian.point
    start = np.empty_like(field)
    start[order] = field
    matrix = diags_array(1.0 / laplacian.masses) @ laplacian.stiffness()
    expected = expm_multiply(-0.5 * variance * matrix, start)[order]
    profile = gaussian(variance, 1.0, 1.0)
    result = diffuse_on_mesh(BALL.positions, BALL.faces, field, profile, tolerance=1e-12)[:, 0]
    assert np.abs(result - expected).max() <= tol.ROUNDING_SUMS.value


def test_every_body_keeps_its_own_mean(deon):
    positions = np.concatenate([BALL.positions, SMALL.positions + 40.0])
    faces = np.concatenate([BALL.faces, SMALL.faces + len(BALL.positions)])
    field = np.random.default_rng(0).normal(size=len(positions))
    mass = Laplacian.of(positions, faces)
    weights = mass.masses if mass.point is None else mass.masses[mass.point]
    body = np.arange(len(positions)) < len(BALL.positions)
    for factor in (1.0, 1e3):
        result = diffuse_on_mesh(positions, faces, field, deon.scaled(factor), tolerance=1e-2)
        for own in (body, ~body):
            change = weights[own] @ (result - field[:, None])[own]
            assert np.abs(change).max() <= tol.ROUNDING_SUMS.value * weights[own].sum()


# -- the shifted inverse ---------------------------------------------------------------------------


@pytest.fixture
def only_inverse(monkeypatch):
    """Let no polynomial serve."""
    monkeypatch.setattr(chebyshev, "MOST_DEGREE", -1)


@pytest.mark.parametrize("name", ["skin-deon2007", "skin1", "burley"])
@pytest.mark.parametrize("factor", [0.3, 1.0, 30.0])
def test_the_shifted_inverse_is_the_transfer_function_too(name, factor, burley, only_inverse):
    profile = (burley if name == "burley" else Profile.preset(name)).scaled(factor)
    field = np.maximum(SMALL.normals @ (0.6, 0.0, 0.8), 0.0)
    result = diffuse_on_mesh(SMALL.positions, SMALL.faces, field, profile)
    assert np.abs(result - exact(SMALL, field, profile)).max() <= tol.MATRIX_FUNCTION.value


def test_both_methods_agree_on_a_larger_mesh(deon, monkeypatch):
    shape = shapes.torus("random", 3000)
    arguments = shape.positions, shape.faces, shape.normals, deon.scaled(0.2)
    polynomials = diffuse_on_mesh(*arguments)
    monkeypatch.setattr(chebyshev, "MOST_DEGREE", -1)
    assert np.abs(diffuse_on_mesh(*arguments) - polynomials).max() <= tol.MATRIX_FUNCTION.value


@pytest.mark.parametrize("unit", [1e-12, 1e-9, 1e-6, 1e-3])
def test_a_body_of_absurdly_small_unit_takes_its_mean_in_few_steps(unit, deon, monkeypatch):
    monkeypatch.setattr(rational, "MOST_STEPS", 60)
    positions = shapes.sphere("random", 3000, 100.0).positions * unit
    faces = shapes.sphere("random", 3000, 100.0).faces
    field = np.random.default_rng(0).normal(size=len(positions))
    mass = Laplacian.of(positions, faces).masses
    result = diffuse_on_mesh(positions, faces, field, deon)
    if unit < 1e-3:
        order = Laplacian.of(positions, faces).point
        weights = mass if order is None else mass[order]
        mean = weights @ field / weights.sum()
        assert np.abs(result - mean).max() <= tol.MATRIX_FUNCTION.value
    assert np.abs(result).max() < 1.0


@pytest.mark.parametrize("unit", [1e3, 1e6, 1e9])
def test_a_body_of_absurdly_great_unit_is_unchanged(unit, deon):
    field = np.random.default_rng(0).normal(size=len(BALL.positions))
    result = diffuse_on_mesh(BALL.positions * unit, BALL.faces, field, deon)
    assert np.abs(result - field[:, None]).max() <= 20.0 / unit**2 + tol.MATRIX_FUNCTION.value


def test_a_needle_beside_regular_faces_leaves_their_result(deon, monkeypatch):
    flat = shapes.square(20.0, 12)
    positions = flat.positions.copy()
    positions[80, :2] += (20.0 / 12.0 * (1.0 - 1e-7), 0.0)  # next to its neighbour
    field = np.cos(0.2 * positions[:, 0])
    profile = deon.scaled(0.5)
    result = diffuse_on_mesh(positions, flat.faces, field, profile)
    shape = shapes.Shape(positions, flat.faces, flat.normals, flat.k_max, flat.k_min)
    error = result - exact(shape, field, profile)
    mass = Laplacian.of(positions, flat.faces).masses[:, None]
    assert np.sqrt((mass * error**2).sum(axis=0) / (mass.T @ field**2)).max() <= 1e-8


def test_a_mesh_too_large_for_the_inverse_is_refused(deon, monkeypatch, only_inverse):
    monkeypatch.setattr(rational, "MOST_POINTS", 100)
    with pytest.raises(MeshError, match=r"150 points .* check the unit"):
        diffuse_on_mesh(SMALL.positions, SMALL.faces, np.zeros(150), deon)


def test_an_iteration_that_does_not_converge_is_refused(deon, monkeypatch, only_inverse):
    monkeypatch.setattr(rational, "MOST_STEPS", 12)
    with pytest.raises(MeshError, match="not converged in 12 steps"):
        diffuse_on_mesh(SMALL.positions, SMALL.faces, SMALL.normals[:, 0], deon, tolerance=1e-12)
