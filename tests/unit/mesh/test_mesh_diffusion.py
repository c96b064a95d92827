"""Diffusion over surfaces whose harmonics are known."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import shapes
import tolerances as tol
from skinshade.mesh import diffuse_on_mesh, mesh_diffused_normals
from skinshade.mesh.topology import corner_areas
from skinshade.profile import Profile, presets

BALL = shapes.sphere("icosphere", 4, 10.0)
SMALL = shapes.ellipsoid("random", 150, (3.0, 2.0, 1.0))


def gaussian(*variances):
    """Return a profile with one Gaussian per channel."""
    return Profile.gaussians(variances_mm2=variances, weights=np.eye(3), albedo=0.5)


def diffused(shape, values, profile):
    return diffuse_on_mesh(shape.positions, shape.faces, values, profile)


def mass(shape):
    return corner_areas(shape.positions, shape.faces, len(shape.positions))


# -- the matrix function ---------------------------------------------------------------------------


def cotangent_laplacian(shape):
    """Return the dense matrix from the angles of the faces: ½(cot α + cot β) per edge."""
    count = len(shape.positions)
    matrix = np.zeros((count, count))
    for face in shape.faces:
        for corner in range(3):
            apex, i, j = np.roll(face, -corner)
            a, b = (
                shape.positions[i] - shape.positions[apex],
                shape.positions[j] - shape.positions[apex],
            )
            half = 0.5 / np.tan(np.arccos(a @ b / (np.linalg.norm(a) * np.linalg.norm(b))))
            matrix[[i, j], [j, i]] -= half
            matrix[[i, j], [i, j]] += half
    return matrix


@pytest.mark.parametrize("name", ["skin-deon2007", "skin1", "burley"])
def test_diffusion_is_the_transfer_function_of_the_laplacian(name, burley):
    profile = burley if name == "burley" else Profile.preset(name)
    weight = np.sqrt(mass(SMALL))
    symmetric = cotangent_laplacian(SMALL) / weight / weight[:, None]
    squares, modes = np.linalg.eigh(symmetric)
    field = np.maximum(SMALL.normals @ (0.6, 0.0, 0.8), 0.0)
    response = profile.transfer(np.sqrt(np.maximum(squares, 0.0)))
    expected = (modes @ (response * (modes.T @ (weight * field))[:, None])) / weight[:, None]
    assert np.abs(diffused(SMALL, field, profile) - expected).max() <= tol.MATRIX_FUNCTION.value


# -- harmonics -------------------------------------------------------------------------------------

HARMONICS = {
    "l = 1, x": (1, lambda x, y, z: x),
    "l = 1, z": (1, lambda x, y, z: z),
    "l = 2, xy": (2, lambda x, y, z: x * y),
    "l = 2, 3z² − 1": (2, lambda x, y, z: 3.0 * z * z - 1.0),
    "l = 3, xyz": (3, lambda x, y, z: x * y * z),
}


@pytest.mark.parametrize(("degree", "harmonic"), HARMONICS.values(), ids=HARMONICS)
def test_harmonics_of_a_sphere_are_multiplied_by_the_transfer_function(degree, harmonic):
    profile = gaussian(1.0, 8.0, 30.0)
    values = harmonic(*BALL.normals.T)
    decay = profile.transfer(np.sqrt(degree * (degree + 1.0)) / 10.0)
    error = diffused(BALL, values, profile) - decay * values[:, None]
    assert np.abs(error).max() <= tol.EIGENFUNCTION.value * np.abs(values).max()


@pytest.mark.parametrize("name", [*presets(), "burley", "tabulated"])
def test_every_kind_of_profile_multiplies_a_harmonic_by_its_transfer_function(name, burley):
    rings = Profile.tabulated(edges_mm=[0.0, 1.0, 3.0, 9.0], flux=np.eye(3) + 0.2, albedo=0.5)
    profile = {"burley": burley, "tabulated": rings}.get(name) or Profile.preset(name)
    values = BALL.normals[:, 0] * BALL.normals[:, 1]
    decay = profile.transfer(np.sqrt(6.0) / 10.0)
    error = diffused(BALL, values, profile) - decay * values[:, None]
    assert np.abs(error).max() <= tol.EIGENFUNCTION.value * np.abs(values).max()


@pytest.mark.parametrize("waves", [1, 2, 4])
@pytest.mark.parametrize("rows", [0, 1, 3])
def test_waves_on_a_tube_are_multiplied_by_t_of_their_total_frequency(waves, rows):
    # A tube is flat and periodic; no flux passes its open ends, so cosines are modes along it.
    radius, height = 5.0, 12.0
    tube = shapes.cylinder(radius, height, 96, 60)
    angle = np.arctan2(tube.positions[:, 1], tube.positions[:, 0])
    along = rows * np.pi / height
    values = np.cos(waves * angle) * np.cos(along * tube.positions[:, 2])
    profile = gaussian(0.2, 1.0, 4.0)
    decay = profile.transfer(np.hypot(waves / radius, along))
    error = diffused(tube, values, profile) - decay * values[:, None]
    assert np.abs(error).max() <= tol.EIGENFUNCTION.value


def test_a_wave_on_a_square_is_multiplied_by_t_as_on_a_plane():
    side = 10.0
    flat = shapes.square(side, 90)
    k = 3.0 * np.pi / side
    values = np.cos(k * flat.positions[:, 0]) * np.cos(k * flat.positions[:, 1])
    profile = gaussian(0.1, 0.5, 1.5)
    decay = profile.transfer(np.sqrt(2.0) * k)
    error = diffused(flat, values, profile) - decay * values[:, None]
    assert np.abs(error).max() <= tol.EIGENFUNCTION.value


def test_the_error_decreases_with_the_size_of_the_triangles():
    def error(level):
        ball = shapes.sphere("icosphere", level, 10.0)
        values = ball.normals[:, 0] * ball.normals[:, 1]
        decay = np.exp(-0.5 * 20.0 * 6.0 / 100.0)
        return np.abs(diffused(ball, values, gaussian(20.0, 1.0, 1.0))[:, 0] - decay * values).max()

    coarse, fine = error(2), error(3)
    assert fine <= 0.4 * coarse


# -- conservation and symmetry ---------------------------------------------------------------------

VARIANCES = st.tuples(*[st.floats(1e-3, 50.0)] * 3).filter(lambda v: len(set(v)) == 3)
FIELDS = hnp.arrays(np.float64, len(SMALL.positions), elements=st.floats(-1.0, 1.0))


@settings(max_examples=20)
@given(VARIANCES, FIELDS, st.floats(0.01, 100.0))
def test_constants_and_integrals_are_preserved(variances, field, level):
    profile = gaussian(*variances)
    even = diffused(SMALL, np.full(len(field), level), profile)
    assert np.abs(even - level).max() <= tol.CONSERVED.value * abs(level)
    before, after = mass(SMALL) @ field, mass(SMALL) @ diffused(SMALL, field, profile)
    assert np.abs(after - before).max() <= tol.CONSERVED.value * mass(SMALL) @ np.abs(field) + 1e-12


@settings(max_examples=20)
@given(VARIANCES, FIELDS, FIELDS, st.floats(-3.0, 3.0))
def test_diffusion_is_linear_and_self_adjoint(variances, u, v, factor):
    profile = gaussian(*variances)
    hu, hv, both = (diffused(SMALL, x, profile) for x in (u, v, u + factor * v))
    scale = tol.SELF_ADJOINT.value * (1.0 + abs(factor))
    assert np.abs(both - hu - factor * hv).max() <= scale
    weight = mass(SMALL)[:, None]
    assert np.abs((weight * u[:, None] * hv - weight * v[:, None] * hu).sum(axis=0)).max() <= (
        tol.SELF_ADJOINT.value * weight.sum()
    )


@settings(max_examples=10)
@given(st.floats(0.01, 5.0), FIELDS)
def test_two_steps_equal_one_of_twice_the_variance(variance, field):
    profile = gaussian(variance, 2.0 * variance, 1.0)
    once = diffused(SMALL, field, profile)
    twice = diffused(SMALL, once[:, 0], profile)
    assert np.abs(twice[:, 0] - once[:, 1]).max() <= tol.SEMIGROUP.value


@settings(max_examples=10)
@given(factor=st.floats(0.1, 10.0), field=FIELDS)
def test_only_the_ratio_of_lengths_matters(factor, field, deon):
    one = diffuse_on_mesh(SMALL.positions, SMALL.faces, field, deon)
    other = diffuse_on_mesh(SMALL.positions * factor, SMALL.faces, field, deon.scaled(factor))
    assert np.abs(one - other).max() <= tol.SELF_ADJOINT.value


def test_diffusion_by_a_mixture_is_the_sum_over_its_lobes():
    field = SMALL.normals[:, 0] ** 2
    parts = diffused(SMALL, field, gaussian(0.1, 1.0, 5.0))
    weights = np.array([[0.2, 1.0, 0.0], [0.3, 0.0, 0.5], [0.5, 0.0, 0.5]])
    mixed = Profile.gaussians(variances_mm2=[0.1, 1.0, 5.0], weights=weights, albedo=0.5)
    assert np.abs(diffused(SMALL, field, mixed) - parts @ weights).max() <= tol.ROUNDING_SUMS.value


@pytest.mark.parametrize("shape", [(), (2,), (2, 3)])
def test_channels_are_the_last_axis(shape, deon):
    values = np.broadcast_to(SMALL.normals[:, 0].reshape(-1, *[1] * len(shape)), (150, *shape))
    result = diffused(SMALL, values, deon)
    assert result.shape == (150, *shape, 3)
    single = diffused(SMALL, SMALL.normals[:, 0], deon)
    flat = result.reshape(150, -1, 3)
    assert all(np.allclose(flat[:, i], single, atol=1e-12) for i in range(flat.shape[1]))


def test_values_diffuse_across_a_seam(deon):
    positions, faces, normals, original = shapes.split_seam(SMALL)
    values = np.maximum(normals[:, 0], 0.0)
    split = diffuse_on_mesh(positions, faces, values, deon)
    whole = diffused(SMALL, np.maximum(SMALL.normals[:, 0], 0.0), deon)
    assert np.abs(split - whole[original]).max() <= tol.ROUNDING_SUMS.value


def test_progress_increases_from_0_to_1(deon):
    fractions = []
    diffuse_on_mesh(
        SMALL.positions,
        SMALL.faces,
        SMALL.normals,
        deon,
        progress=lambda what, fraction: fractions.append(fraction),
    )
    assert fractions[0] == 0.0
    assert fractions[-1] == 1.0
    assert len(fractions) > 2
    assert fractions == sorted(fractions)


@pytest.mark.parametrize("tolerance", [1e-2, 1e-4, 1e-6, 1e-10])
@pytest.mark.parametrize("field_name", ["half", "point"])
def test_the_error_is_below_the_tolerance(deon, tolerance, field_name):
    # A step at the equator, and the worst case: a field that is 1 at one vertex.
    values = (
        np.heaviside(BALL.normals[:, 2], 0.5)
        if field_name == "half"
        else np.eye(1, len(BALL.normals))[0]
    )
    approximate, exact = (
        diffuse_on_mesh(BALL.positions, BALL.faces, values, deon, tolerance=t)
        for t in (tolerance, 1e-12)
    )
    weight = mass(BALL)
    error = np.sqrt(weight @ np.square(approximate - exact))
    assert error.max() <= tol.MATRIX_FUNCTION_SLACK.value * tolerance * np.sqrt(weight @ values**2)


# -- normals ---------------------------------------------------------------------------------------


def test_diffused_normals_of_a_sphere_have_the_length_of_its_first_harmonic(deon):
    result = mesh_diffused_normals(BALL.positions, BALL.faces, BALL.normals, deon)
    assert result.shape == (len(BALL.positions), 3, 3)
    length = np.linalg.norm(result, axis=-1)
    mixture, _ = deon.gaussian_fit()
    truth = (mixture.weights * np.exp(-mixture.variances_mm2 / 100.0)[:, None]).sum(axis=0)
    assert np.abs(length / truth - 1.0).max() <= tol.DIFFUSED_NORMALS.value
    direction = result / length[..., None]
    assert np.abs(direction - BALL.normals[:, None, :]).max() <= tol.DIFFUSED_NORMALS.value


@pytest.mark.parametrize("level", [1.0, 0.5, -2.0, 3.7])
@pytest.mark.parametrize("cells", [1, 2, 8])
def test_a_constant_on_a_plane_is_unchanged(deon, level, cells):
    flat = shapes.square(1.0, cells)
    even = diffused(flat, np.full(len(flat.positions), level), deon)
    assert np.abs(even - level).max() <= tol.CONSERVED.value * abs(level)


def test_a_very_wide_profile_makes_the_values_of_a_triangle_equal(deon):
    positions = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    result = diffuse_on_mesh(positions, [[0, 1, 2]], [3.0, 0.0, 0.0], deon.scaled(1e3))
    assert np.abs(result - 1.0).max() <= tol.CONSERVED.value


def test_a_field_of_zeros_remains_zero(deon):
    assert (diffused(SMALL, np.zeros(150), deon) == 0.0).all()


def test_diffused_normals_of_a_plane_are_unchanged(deon):
    flat = shapes.square(10.0, 12)
    result = mesh_diffused_normals(flat.positions, flat.faces, flat.normals, deon)
    assert np.abs(result - flat.normals[:, None, :]).max() <= tol.CONSERVED.value
