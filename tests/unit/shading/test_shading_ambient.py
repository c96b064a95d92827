"""Ambient light from nine spherical harmonics, and its visibility."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import shading_tolerances as tol
from skinshade.shading.ambient import (
    COSINE_BANDS,
    LEAST_HIDDEN,
    ambient_irradiance,
    ambient_normals,
    ambient_of_three,
    bounced_visibility,
    occluded_reflection,
    reflected_visibility,
    sh_basis,
    specular_visibility,
    transferred_irradiance,
)

VECTOR = hnp.arrays(float, 3, elements=st.floats(-1.0, 1.0)).filter(
    lambda v: np.linalg.norm(v) > 0.1
)
SEED = st.integers(0, 2**32 - 1)
COEFFICIENTS = hnp.arrays(float, (9, 3), elements=st.floats(-1.0, 1.0))
BAND = np.array([0, 1, 1, 1, 2, 2, 2, 2, 2])
CONSTANT = np.zeros((9, 3))
CONSTANT[0] = 40.0
"""Light so strong that no sum with `COEFFICIENTS` is negative, where results are clamped."""


def sphere_quadrature(count=24):
    """Return directions and weights, exact for polynomials up to degree 2·count − 1."""
    z, w = np.polynomial.legendre.leggauss(count)
    phi = (np.arange(2 * count) + 0.5) * np.pi / count
    r = np.sqrt(1.0 - z * z)
    d = np.stack(
        [np.outer(r, np.cos(phi)), np.outer(r, np.sin(phi)), np.outer(z, np.ones_like(phi))], -1
    )
    return d.reshape(-1, 3), np.repeat(w * np.pi / count, phi.size)


def one_normal(n):
    return np.tile(n / np.linalg.norm(n), (1, 3, 1))


def random_units(seed, count):
    vectors = np.random.default_rng(seed).normal(size=(count, 3))
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


def rotation_to(n):
    """Return an orthonormal frame whose last row is n."""
    n = n / np.linalg.norm(n)
    u = np.cross(n, np.eye(3)[np.argmin(np.abs(n))])
    u /= np.linalg.norm(u)
    return np.stack([u, np.cross(n, u), n])


def test_the_harmonics_are_orthonormal():
    d, w = sphere_quadrature()
    basis = sh_basis(d)
    assert np.abs(basis.T @ (w[:, None] * basis) - np.eye(9)).max() <= tol.QUADRATURE.value


def test_each_band_is_an_eigenspace_of_the_laplacian():
    """r^l Y_l is harmonic: its mean over any sphere is its value at the centre."""
    d, w = sphere_quadrature()
    for centre in np.eye(3)[[0, 2]] * 0.4:
        point = centre + 0.3 * d
        r = np.linalg.norm(point, axis=1)
        values = sh_basis(point / r[:, None]) * r[:, None] ** BAND
        at = sh_basis(centre[None] / 0.4)[0] * 0.4**BAND
        assert np.abs(w @ values / (4.0 * np.pi) - at).max() <= tol.QUADRATURE.value


@given(VECTOR, st.floats(0.0, 5.0))
def test_uniform_light_gives_every_normal_the_same_irradiance(n, level):
    constant = np.zeros((9, 3))
    constant[0] = level * np.sqrt(4.0 * np.pi)
    irradiance = ambient_irradiance(constant, one_normal(n))
    assert np.abs(irradiance - level).max() <= tol.ROUNDING_SUMS.value


@given(VECTOR, COEFFICIENTS)
def test_irradiance_is_the_integral_of_radiance_times_the_clamped_cosine(n, coefficients):
    z, w = np.polynomial.legendre.leggauss(16)
    z, w = 0.5 * (z + 1.0), 0.5 * w  # the upper half, on which the clamped cosine is smooth
    phi = (np.arange(24) + 0.5) * 2.0 * np.pi / 24
    r = np.sqrt(1.0 - z * z)
    local = np.stack(
        [np.outer(r, np.cos(phi)), np.outer(r, np.sin(phi)), np.outer(z, np.ones(24))], axis=-1
    )
    radiance = sh_basis(local.reshape(-1, 3) @ rotation_to(n)) @ coefficients
    weight = np.repeat(w * z, 24) * 2.0 * np.pi / 24
    truth = np.maximum(weight @ radiance / np.pi, 0.0)
    irradiance = ambient_irradiance(coefficients, one_normal(n))[0]
    assert np.abs(irradiance - truth).max() <= tol.QUADRATURE.value


def test_nine_harmonics_give_the_irradiance_of_a_sky_within_a_hundredth():
    """The claim of [Ramamoorthi2001], for a sky with a bright lobe above a constant."""
    d, w = sphere_quadrature(64)
    sky = 0.3 + np.maximum(d[:, 1], 0.0) ** 8
    coefficients = np.repeat((sh_basis(d).T @ (w * sky))[:, None], 3, axis=1)
    for n in np.random.default_rng(3).normal(size=(20, 3)):
        unit = n / np.linalg.norm(n)
        truth = w @ (sky * np.maximum(d @ unit, 0.0)) / np.pi
        irradiance = ambient_irradiance(coefficients, one_normal(unit))[0, 0]
        assert irradiance == pytest.approx(truth, rel=tol.NINE_HARMONICS.value)


@given(VECTOR, COEFFICIENTS, st.floats(0.1, 1.0))
def test_a_normal_of_length_x_multiplies_the_bands_by_1_x_and_x_cubed(n, sh, length):
    bands = [np.where((band == BAND)[:, None], sh, 0.0) for band in range(3)]
    for band, power in ((0, 0), (1, 1), (2, 3)):
        full, short, constant = (
            ambient_irradiance(CONSTANT + part, scale * one_normal(n))
            for part, scale in ((bands[band], 1.0), (bands[band], length), (0.0, 1.0))
        )
        error = (short - constant) - length**power * (full - constant)
        assert np.abs(error).max() <= tol.ROUNDING.value


@given(VECTOR, COEFFICIENTS, hnp.arrays(float, (1, 3, 3), elements=st.floats(0.0, 1.0)))
def test_band_transfer_multiplies_each_band_of_each_channel(n, sh, transfer):
    constant = ambient_irradiance(CONSTANT, one_normal(n))
    expected = constant * transfer[:, 0]
    for band in range(3):
        part = np.where((band == BAND)[:, None], sh, 0.0)
        of_band = ambient_irradiance(CONSTANT + part, one_normal(n)) - constant
        expected += of_band * transfer[:, band]
    irradiance = ambient_irradiance(CONSTANT + sh, one_normal(n), transfer)
    assert np.abs(irradiance - np.maximum(expected, 0.0)).max() <= tol.ROUNDING.value


@given(COEFFICIENTS, VECTOR)
def test_light_is_never_negative_and_channels_do_not_mix(sh, n):
    irradiance = ambient_irradiance(sh, one_normal(n))
    assert (irradiance >= 0.0).all()
    red = ambient_irradiance(sh * (1.0, 0.0, 0.0), one_normal(n))
    assert np.array_equal(red, irradiance * (1.0, 0.0, 0.0))


@given(hnp.arrays(np.int64, (3, 3), elements=st.integers(-9, 9)))
def test_other_ambient_light_is_evaluated_for_the_unit_normal_of_each_channel(vectors):
    unit = ambient_normals(vectors.astype(float))
    lengths = np.linalg.norm(unit, axis=1)
    assert np.all((np.abs(lengths - 1.0) <= tol.ROUNDING.value) | ~vectors.any(axis=1))
    assert np.allclose(unit * np.linalg.norm(vectors, axis=1)[:, None], vectors, atol=1e-15)
    red, green, blue = vectors
    assert ambient_of_three(red, green, blue).tolist() == [red[0], green[1], blue[2]]


@given(st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_bounced_light_only_adds_and_full_visibility_stays_full(visibility, albedo):
    bounced = float(bounced_visibility(np.array(visibility), np.array(albedo)))
    assert visibility <= bounced <= 1.0 + tol.BOUNCE_FIT.value
    assert bounced_visibility(np.array(1.0), np.array(albedo)) == pytest.approx(
        1.0, abs=tol.BOUNCE_FIT.value
    )


@given(st.floats(0.01, 0.99))
def test_a_brighter_albedo_bounces_more_light(visibility):
    bounced = bounced_visibility(np.full(5, visibility), np.linspace(0.1, 0.9, 5))
    assert np.all(np.diff(bounced) >= 0.0)


@given(st.floats(0.0, 1.0), st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_the_visibility_of_reflections_rises_with_that_of_the_sky(cosine, visibility, roughness):
    r = np.array(roughness)
    reflections = specular_visibility(np.array(cosine), np.array(visibility), r)
    assert 0.0 <= reflections <= 1.0
    full = specular_visibility(np.array(cosine), np.array(1.0), r)
    assert full == pytest.approx(1.0, abs=1e-15)
    assert specular_visibility(np.array(0.0), np.array(0.0), r) == 0.0
    more = specular_visibility(np.array(cosine), np.array(min(visibility + 0.1, 1.0)), r)
    assert more >= reflections


@given(seed=SEED, share=st.floats(0.0, 1.0))
def test_a_sky_that_is_evenly_hidden_is_visible_by_that_share_in_every_direction(seed, share):
    normal, direction = random_units(seed, 2)
    direction = direction * np.sign(normal @ direction)
    free = np.repeat(COSINE_BANDS, [1, 3, 5]) * sh_basis(normal)
    visible = reflected_visibility(share * free, normal, direction)
    assert visible == pytest.approx(share, abs=tol.ROUNDING_SUMS.value)


@given(seed=SEED, share=st.floats(0.0, 1.0))
def test_a_white_body_reflects_the_light_of_an_even_sky_from_hidden_directions_too(seed, share):
    normal, direction = random_units(seed, 2)
    free = np.repeat(COSINE_BANDS, [1, 3, 5]) * sh_basis(normal)
    bounced = np.full(3, max(1.0 - share, LEAST_HIDDEN))  # all that is hidden has radiance 1
    reflected = occluded_reflection(np.ones(3), bounced, share * free, normal, direction)
    assert np.allclose(reflected, 1.0, atol=tol.ROUNDING_SUMS.value)


@given(seed=SEED)
def test_transferred_light_is_the_product_of_both_sets_of_harmonics(seed):
    rng = np.random.default_rng(seed)
    transfer, sky = rng.normal(size=(5, 3, 9)), rng.normal(size=(9, 3))
    product = np.stack([transfer[:, c] @ sky[:, c] for c in range(3)], axis=1)
    assert np.allclose(transferred_irradiance(transfer, sky), np.maximum(product, 0.0))
