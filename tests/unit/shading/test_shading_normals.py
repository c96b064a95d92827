"""Blurred normals: weights of the fetches, mip levels, and the diffusion of the mesh's normals."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from scipy.optimize import nnls

import shading_tolerances as tol
from skinshade.profile import Profile, presets
from skinshade.shading import normals
from skinshade.shading.normals import (
    BUMP_PERIODS_MM,
    add_mesh_diffusion,
    blend_normals,
    blur_level,
    normal_blend,
)

PUBLISHED_SIGMAS = (0.19, 1.13)
PUBLISHED = {
    "R": (0.121, 0.279, 0.600),
    "G": (0.225, 0.684, 0.091),
    "B": (0.380, 0.620, 0.0),
}
SHORT, LONG = BUMP_PERIODS_MM
BAND = np.geomspace(2.0 * np.pi / LONG, 2.0 * np.pi / SHORT, 200)
FETCHES = pytest.mark.parametrize("fetches", [2, 3])


@st.composite
def mixtures(draw):
    variances = draw(st.lists(st.floats(1e-4, 30.0), min_size=1, max_size=4))
    shape = (len(variances), 3)
    weights = draw(hnp.arrays(float, shape, elements=st.floats(0.01, 1.0)))
    return Profile.gaussians(variances_mm2=variances, weights=weights, albedo=0.5)


def response(blend, k=BAND):
    """Return the factor (n, 3) by which the mix multiplies relief of each frequency."""
    blurs = np.exp(-0.5 * np.square(k[:, None] * blend.sigmas_mm))
    return blend.weights[:, 0] + blurs @ blend.weights[:, 1:].T


def squared_error(profile, sigmas, weights):
    blurs = np.exp(-0.5 * np.square(BAND[:, None] * sigmas))
    return np.square(weights[0] + blurs @ weights[1:] - profile.transfer(BAND).T).sum(axis=-1)


@FETCHES
@given(profile=mixtures())
def test_weights_are_not_negative_and_sum_to_one(fetches, profile):
    blend = normal_blend(profile, fetches=fetches)
    assert blend.weights.shape == (3, fetches)
    assert blend.sigmas_mm.shape == (fetches - 1,)
    assert (blend.weights >= -tol.ROUNDING.value).all()
    assert np.abs(blend.weights.sum(axis=1) - 1.0).max() <= tol.ROUNDING.value
    assert (np.diff(blend.sigmas_mm, prepend=0.0) > 0.0).all()


def test_three_fetches_follow_the_skin_profile_over_the_band(deon):
    error = response(normal_blend(deon)) - deon.transfer(BAND)
    assert np.abs(error).max() <= tol.BLEND_RESIDUAL.value
    assert np.sqrt(np.mean(np.square(error), axis=0)).max() <= tol.BLEND_RESIDUAL_RMS.value


def test_three_fetches_of_skin_have_the_published_blurs_and_weights(deon):
    blend = normal_blend(deon)
    assert np.abs(blend.sigmas_mm / PUBLISHED_SIGMAS - 1.0).max() <= tol.BLEND_SIGMA.value
    assert np.abs(blend.weights - list(PUBLISHED.values())).max() <= tol.BLEND_WEIGHT.value


def test_three_fetches_fit_the_profile_no_worse_than_the_published_weights(deon):
    fitted = response(normal_blend(deon)) - deon.transfer(BAND)
    blurs = np.exp(-0.5 * np.square(BAND[:, None] * PUBLISHED_SIGMAS))
    weights = np.array(list(PUBLISHED.values()))
    published = weights[:, 0] + blurs @ weights[:, 1:].T - deon.transfer(BAND)
    assert np.square(fitted).sum() <= tol.BLEND_GRID.value * np.square(published).sum()


def test_two_fetches_of_skin_have_the_published_blur_and_weights(deon):
    blend = normal_blend(deon, fetches=2)
    assert blend.sigmas_mm[0] == pytest.approx(0.46, rel=tol.BLEND_SIGMA.value)
    assert np.abs(blend.weights[:, 1] - (0.87, 0.53, 0.37)).max() <= tol.TWO_FETCH_WEIGHT.value


@given(
    profile=mixtures(),
    simplex=hnp.arrays(float, (50, 3), elements=st.floats(1e-3, 1.0)),
)
def test_no_other_weights_of_the_same_blurs_fit_better(profile, simplex):
    blend = normal_blend(profile)
    error = np.array(
        [squared_error(profile, blend.sigmas_mm, w)[c] for c, w in enumerate(blend.weights)]
    )
    for weights in simplex / simplex.sum(axis=1, keepdims=True):
        other_error = squared_error(profile, blend.sigmas_mm, weights)
        assert (np.sqrt(error) <= np.sqrt(other_error) + tol.BLEND_OPTIMUM.value).all()


@FETCHES
def test_a_profile_narrower_than_any_relief_keeps_the_sharp_normal(fetches):
    opaque = Profile.gaussians(variances_mm2=[1e-6], weights=[[1.0, 1.0, 1.0]], albedo=0.5)
    error = response(normal_blend(opaque, fetches=fetches)) - 1.0
    assert np.abs(error).max() <= tol.BLEND_LIMIT.value


def test_a_profile_wider_than_any_relief_removes_all_of_it():
    wide = Profile.gaussians(variances_mm2=[400.0], weights=[[1.0, 1.0, 1.0]], albedo=0.5)
    assert np.abs(response(normal_blend(wide))).max() <= tol.BLEND_LIMIT.value


@pytest.mark.parametrize("name", presets())
def test_three_fetches_fit_a_preset_no_worse_than_two(name):
    profile = Profile.preset(name)
    two, three = (
        np.square(response(normal_blend(profile, fetches=n)) - profile.transfer(BAND)).sum()
        for n in (2, 3)
    )
    assert three <= two


def test_a_wave_of_relief_is_damped_by_the_transfer_function_of_the_profile(deon):
    blend = normal_blend(deon)
    x = np.linspace(0.0, 20.0, 401)
    for k in (1.5, 4.0, 12.0):
        fetched = np.zeros((x.size, 3, 3))
        fetched[..., 2] = 1.0
        for i, sigma in enumerate((0.0, *blend.sigmas_mm)):
            fetched[:, i, 0] = 0.3 * np.sin(k * x) * np.exp(-0.5 * (k * sigma) ** 2)
        blended = blend_normals(fetched, blend)
        truth = 0.3 * np.sin(k * x)[:, None] * deon.transfer(np.array(k))
        assert np.abs(blended[..., 0] - truth).max() <= 0.3 * tol.BLEND_RESIDUAL.value
        assert np.abs(blended[..., 2] - 1.0).max() <= tol.ROUNDING.value


UNIT = hnp.arrays(float, (3, 3), elements=st.floats(-1.0, 1.0)).filter(
    lambda v: np.linalg.norm(v, axis=1).min() > 0.1
)


@given(UNIT)
def test_equal_fetches_give_every_channel_the_same_normal(vectors):
    blend = normal_blend(Profile.preset("skin-deon2007"))
    for n in vectors / np.linalg.norm(vectors, axis=1)[:, None]:
        assert np.abs(blend_normals(np.stack([n, n, n]), blend) - n).max() <= tol.ROUNDING.value


@given(UNIT)
def test_a_blend_of_unit_normals_is_never_longer_than_one(vectors):
    blend = normal_blend(Profile.preset("skin-deon2007"))
    unit = vectors / np.linalg.norm(vectors, axis=1)[:, None]
    assert np.linalg.norm(blend_normals(unit, blend), axis=1).max() <= 1.0 + tol.ROUNDING.value


@given(UNIT)
def test_with_a_flat_map_or_an_undiffused_mesh_the_other_normal_is_the_result(vectors):
    normal = vectors[0] / np.linalg.norm(vectors[0])
    flat = np.tile(normal, (3, 1))
    assert np.abs(add_mesh_diffusion(flat, vectors, normal) - vectors).max() <= tol.ROUNDING.value
    undiffused = add_mesh_diffusion(vectors, np.tile(normal, (3, 1)), normal)
    assert np.abs(undiffused - vectors).max() <= tol.ROUNDING.value


def test_relief_multiplies_the_diffusion_of_the_mesh_by_its_length():
    normal, texture = np.array([0.0, 0.0, 1.0]), np.tile([0.0, 0.0, 0.5], (3, 1))
    mesh = np.tile([0.2, 0.0, 0.9], (3, 1))
    both = add_mesh_diffusion(texture, mesh, normal)
    assert np.allclose(both, [0.1, 0.0, 0.45], atol=tol.ROUNDING.value)


@given(st.floats(0.01, 10.0), st.floats(1.0, 1000.0), st.integers(4, 14), st.floats(0.0, 12.0))
def test_the_texels_of_a_blur_level_are_two_sigma_wide(sigma, scale, octave, hardware):
    size = 2**octave
    level = float(blur_level(sigma, scale, size, np.array(hardware)))
    assert level >= max(hardware, 0.0)
    if level > hardware and level > 0.0:
        assert scale / size * 2.0**level == pytest.approx(2.0 * sigma)
        assert blur_level(2.0 * sigma, scale, size, np.array(hardware)) == pytest.approx(level + 1)


def test_a_blur_narrower_than_a_texel_keeps_the_hardware_level():
    assert blur_level(1e-6, 100.0, 1024, np.array(0.0)) == 0.0
    assert blur_level(0.0, 100.0, 1024, np.array(3.5)) == 3.5


@given(
    hnp.arrays(np.float64, (12, 2), elements=st.floats(-1.0, 1.0)),
    hnp.arrays(np.float64, (12, 3), elements=st.floats(-1.0, 1.0)),
)
def test_two_factors_that_are_not_negative_fit_as_well_as_those_of_scipy(basis, target):
    factors = normals._nonnegative_pair(basis, target)
    assert (factors >= 0.0).all()
    for channel in range(3):
        residual = np.linalg.norm(basis @ factors[:, channel] - target[:, channel])
        assert residual <= nnls(basis, target[:, channel])[1] + tol.LEAST_SQUARES.value


@pytest.mark.parametrize("basis", [np.zeros((4, 2)), np.ones((4, 2)), np.eye(4)[:, :2]])
def test_columns_that_are_zero_parallel_or_orthogonal_are_fitted(basis):
    target = np.array([[1.0, -1.0], [2.0, 1.0], [3.0, 0.0], [4.0, 0.0]])
    factors = normals._nonnegative_pair(basis, target)
    for channel in range(2):
        expected = nnls(basis, target[:, channel])[1]
        assert np.isclose(
            np.linalg.norm(basis @ factors[:, channel] - target[:, channel]), expected
        )
